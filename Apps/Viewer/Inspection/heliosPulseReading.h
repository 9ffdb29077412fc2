// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// The record of one pulse, as plain numbers: its waveform, echoes, Gaussians and sub-rays.

#ifndef heliosPulseReading_h
#define heliosPulseReading_h

#include "heliosPose.h"
#include "heliosSimulation.h"

#include <cstdint>
#include <limits>
#include <string>
#include <vector>

class vtkPolyData;

namespace helios::viewer
{

class SceneView;

/// An echo of the pulse; unknown values: NaN, ids -1, counts and classes 0.
struct PulseEcho
{
  Vec3 Position; ///< [m]
  int ReturnNumber = 0;
  int NumberOfReturns = 0;
  int Class = 0;
  int Part = -1;
  double GpsTime = std::numeric_limits<double>::quiet_NaN();        ///< [s]
  double Range = std::numeric_limits<double>::quiet_NaN();          ///< [m]
  double Amplitude = std::numeric_limits<double>::quiet_NaN();      ///< [W]
  double Width = std::numeric_limits<double>::quiet_NaN();          ///< [ns], two-way
  double IncidenceAngle = std::numeric_limits<double>::quiet_NaN(); ///< [deg]
};

/// Power exp(-(R - Range)^2 / (2 Sigma^2)).
struct PulseGaussian
{
  double Range; ///< [m], of its centre
  double Power; ///< [W]
  double Sigma; ///< [m]
};

/// End point of a sub-ray.
struct SubRayHit
{
  Vec3 Position; ///< [m]
  double Weight; ///< fraction of the pulse's energy
  int Part;      ///< -1: unknown
};

struct PulseReading
{
  std::int64_t Pulse = -1;
  Vec3 Origin{ 0.0, 0.0, 0.0 }; ///< [m]
  Vec3 Direction{ 0.0, 0.0, 1.0 };
  bool HasOrigin = false;
  double PulseLength = 0.0;    ///< [ns], full width at half maximum; 0: unknown
  double BinSize = 0.0;        ///< [ns], two-way
  std::vector<double> Ranges;  ///< [m], of the samples
  std::vector<double> Samples; ///< [W]
  std::vector<PulseEcho> Echoes;
  std::vector<PulseGaussian> Gaussians; ///< fitted to the samples, sorted by range
  std::vector<SubRayHit> SubRays;
  std::string Problem; ///< with the waveform, as text
};

/// Converts [m] to [ns], two-way.
double GetTwoWayTime(double range);

/**
 * Extracts a pulse from a record; its outputs may be null. The parts of sub-rays are the parts of
 * the scene's cells. Gaussians below 1 % of the largest sample are dropped.
 */
PulseReading ReadPulse(const PulseRecord& record, std::int64_t pulse, const SceneView* scene);

} // namespace helios::viewer

#endif
