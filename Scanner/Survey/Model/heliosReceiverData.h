// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// How a scanner samples its beam and processes the received signal: plain data.

#ifndef heliosReceiverData_h
#define heliosReceiverData_h

#include "heliosTolerances.h"

#include <string>

namespace helios
{

/// Errors as expressions of an angle [rad] or, for the noise factor, of a range [m]; empty: none.
struct ErrorExpressions
{
  std::string Range;                 ///< [m]
  std::string Deflection;            ///< [rad]
  std::string Head;                  ///< [rad]
  double HeadZeroSinThreshold = 0.0; ///< [deg], of the angle from multiples of pi
  std::string RangeNoiseFactor;

  /// Their names in messages: file:line and the attribute.
  std::string RangeName, DeflectionName, HeadName, RangeNoiseFactorName;

  bool IsEmpty() const
  {
    return this->Range.empty() && this->Deflection.empty() && this->Head.empty() &&
      this->RangeNoiseFactor.empty();
  }
};

/// Mechanical misalignments of a panoramic scanner, as of vtkHeliosPanoramicErrorModel.
struct PanoramicErrorData
{
  double BeamOffset[2] = { 0.0, 0.0 }; ///< along y, z of the head [m]
  double TransitOffset = 0.0;          ///< [m]
  double MirrorOffset = 0.0;           ///< [m]
  double VerticalIndexOffset = 0.0;    ///< [deg]
  double BeamTilt[2] = { 0.0, 0.0 };   ///< towards y, z of the head [deg]
  double MirrorTilt = 0.0;             ///< [deg]
  double TransitTilt = 0.0;            ///< [deg]
  double RangeOffset = 0.0;            ///< [m]

  bool IsEmpty() const
  {
    return this->BeamOffset[0] == 0.0 && this->BeamOffset[1] == 0.0 && this->TransitOffset == 0.0 &&
      this->MirrorOffset == 0.0 && this->VerticalIndexOffset == 0.0 && this->BeamTilt[0] == 0.0 &&
      this->BeamTilt[1] == 0.0 && this->MirrorTilt == 0.0 && this->TransitTilt == 0.0 &&
      this->RangeOffset == 0.0;
  }
};

struct ReceiverData
{
  std::string Where;                               ///< the last place read
  int NumberOfCircles = 0;                         ///< of sub-rays, fixed; 0: adaptive
  double RangeTolerance = DefaultRangeTolerance;   ///< [m]
  double EnergyTolerance = DefaultEnergyTolerance; ///< relative
  double BinSize = 0.25;                           ///< [ns]
  double MaximumLength = 0.0;       ///< [ns], of a waveform; 0: as the target requires
  int NumberOfBins = 0;             ///< of a waveform; 0: as many as needed
  double PeakWindow = 0.0;          ///< [ns], either side of a peak; 0: none
  std::string PulseShape;           ///< gaussian, helios, sampled; empty: the default
  std::string PulseFile;            ///< of a sampled pulse
  std::string EchoDetector;         ///< its name; empty: the default
  std::string ReturnSelection;      ///< all, first, last, strongest, firstAndLast; empty: all
  double DetectorNoise = 0.0;       ///< [W]
  double Saturation = 0.0;          ///< [W]; 0: none
  double DeadTime = 0.0;            ///< [ns]
  double PhotonEfficiency = 0.3;    ///< of a photon-counting receiver, like the next two
  double DarkCountRate = 0.0;       ///< [Hz]
  double TimeJitter = 0.0;          ///< [ns]
  double SolarIrradiance = 0.0;     ///< [W/m^2/nm]
  double FilterBandwidth = 1.0;     ///< [nm]
  double FieldOfView = 1e-3;        ///< [rad], full angle
  double Extinction = -1.0;         ///< [1/m]; negative: from the visibility
  int MaximumSpecularEvents = 8;    ///< of a path behind mirrors and glass
  double LeastSpecularShare = 1e-4; ///< of its energy
  double LidarRatio = 0.0;          ///< of the air [sr]; 0: no backscatter
  double DropletDiameter = 0.0;     ///< [m]; 0: no single drops
  std::string Weather;              ///< see ParseWeather()
  double BeamQualityFactor = 0.0;   ///< M2; 0: no waist
  double AccuracyPerMeter = 0.0;    ///< [m/m]
  double AccuracyAtThreshold = 0.0; ///< [m]
  double AngleAccuracy = 0.0;       ///< [rad]
  ErrorExpressions Errors;
  PanoramicErrorData Panoramic;
};

} // namespace helios

#endif
