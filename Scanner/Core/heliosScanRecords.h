// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// The results of a chunk of pulses, before they become VTK data.

#ifndef heliosScanRecords_h
#define heliosScanRecords_h

#include "heliosPose.h"
#include "heliosScatteredProfile.h"

#include <vtkType.h>

#include <array>
#include <vector>

namespace helios
{

struct EchoRecord
{
  Vec3 Point;
  double Time;
  vtkIdType PulseId;
  vtkIdType CellId;
  double Range;
  double Amplitude;
  double Width;
  double Deviation;
  double ScanAngle;
  double Incidence; // [deg]
  int Channel;
  int MaterialId;
  int PartId;
  int Classification;
  unsigned char ReturnNumber;
  unsigned char NumberOfReturns;
  unsigned char ScanDirection; ///< flags of the pulse; 0 unless requested
  unsigned char EdgeOfFlightLine;
};

/// Truth of the echo with the same index.
struct TruthRecord
{
  Vec3 Point;
  Vec3 Normal;
  int SpecularEvents; ///< mirrors and glass before its path's end
};

/// Shift and rotation of the part, and velocity of the true point, of the echo with the same index.
struct MotionRecord
{
  Pose Part;
  Vec3 Velocity;
};

/// Red, green, blue, [0..1], of the echo with the same index.
using ColorRecord = std::array<float, 3>;

struct PulseRecord
{
  Vec3 Origin;
  Vec3 Direction;
  double Time;
  vtkIdType PulseId;
  double ScanAngle;
  int Channel;
  bool Hit;
};

struct SubRayRecord
{
  Vec3 Point;
  vtkIdType PulseId;
  vtkIdType CellId;
  double Weight;
  double Range;
  double Incidence; // [deg]
};

struct WaveformRecord
{
  Vec3 Origin;
  Vec3 Direction;
  double Time;
  vtkIdType PulseId;
  double StartTime; // [ns]
  vtkIdType Count;  // samples
  int Channel;
};

/// The results of a chunk (heliosScanRun.h), in the order of the pulses.
struct ChunkResult
{
  std::vector<EchoRecord> Echoes;
  std::vector<TruthRecord> Truths; // empty if not requested
  std::vector<double> Velocities;  // likewise: radial ones [m/s]
  std::vector<MotionRecord> Motions;
  std::vector<ColorRecord> Colors;       // likewise
  std::vector<ScatteredPower> Scattered; // likewise: of light scattered more than once
  std::vector<PulseRecord> Pulses;
  std::vector<SubRayRecord> SubRays;
  std::vector<WaveformRecord> Waveforms;
  std::vector<float> Samples;

  /// Keeps the memory.
  void Clear()
  {
    this->Echoes.clear();
    this->Truths.clear();
    this->Velocities.clear();
    this->Motions.clear();
    this->Colors.clear();
    this->Scattered.clear();
    this->Pulses.clear();
    this->SubRays.clear();
    this->Waveforms.clear();
    this->Samples.clear();
  }
};

} // namespace helios

#endif
