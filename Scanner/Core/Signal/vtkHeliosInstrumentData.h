// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// The data sheet of a laser scanner as plain values with their defaults and valid ranges:
// vtkHeliosInstrument, which documents them, holds them, detectors read theirs, and attributes of
// surveys are stored in them. Scanner, detectors and attributes have these ranges, unless files are
// stricter.

#ifndef vtkHeliosInstrumentData_h
#define vtkHeliosInstrumentData_h

#include "vtkType.h" // For an unlimited range

#include <string> // For names

struct vtkHeliosInstrumentData
{
  // pulse
  double PulseLength = 4.0;       ///< [ns], full width at half maximum
  int PulseShape = 0;             ///< vtkHeliosInstrument::PulseShapes
  std::string PulseFile;          ///< file of a sampled pulse
  double AveragePower = 4.0;      ///< [W]
  double Wavelength = 1064.0;     ///< [nm]
  double BeamQualityFactor = 0.0; ///< M2; 0: no waist

  // receiver
  double OpticalEfficiency = 0.99;
  double ReceiverDiameter = 0.15;     ///< [m]
  double BinSize = 0.25;              ///< [ns]
  double MaximumWaveformLength = 0.0; ///< [ns]; 0: as the target requires
  int NumberOfBins = 0;               ///< bins of a waveform; 0: as many as needed
  double DetectorNoise = 0.0;         ///< [W]
  double SaturationPower = 0.0;       ///< [W]; 0: none
  double SolarIrradiance = 0.0;       ///< [W/m^2/nm]
  double FilterBandwidth = 1.0;       ///< [nm]
  double FieldOfView = 1e-3;          ///< [rad], full angle

  // air, and paths behind mirrors and glass
  double AtmosphericVisibility = 23.0; ///< [km]
  double AtmosphericExtinction = -1.0; ///< [1/m]; negative: from the visibility
  double AtmosphericLidarRatio = 0.0;  ///< [sr]; 0: no backscatter
  double DropletDiameter = 0.0;        ///< [m]; 0: no single drops
  std::string Weather;                 ///< such as "fog 0.2"
  int MaximumSpecularEvents = 8;
  double LeastSpecularShare = 1e-4; ///< share of the energy

  // light scattered more than once
  int ScatteringOrders = 1;  ///< the most scatterings of light; 1: none but the first
  int ScatteringPaths = 128; ///< paths of light of a pulse
  int ScatteringPhase = 0;   ///< vtkHeliosInstrument::ScatteringPhases, of turbid voxels

  // accuracy
  double RangeAccuracy = 0.0;            ///< [m]
  double RangeAccuracyPerMeter = 0.0;    ///< [m/m]
  double RangeAccuracyAtThreshold = 0.0; ///< [m]
  double AngleAccuracy = 0.0;            ///< [rad]

  // echoes
  double RangeMin = 0.0;            ///< [m]
  double RangeMax = VTK_DOUBLE_MAX; ///< [m]
  int ReturnSelection = 0;          ///< vtkHeliosInstrument::ReturnSelections
  int MaximumNumberOfReturns = 0;   ///< 0: all
  int MTAZone = 0;                  ///< that echoes are taken for; 0: the true one

  // echo detectors
  double DetectionThreshold = 1e-13; ///< [W]
  double DeadTime = 0.0;             ///< [ns]
  double PeakWindow = 0.0;           ///< [ns], either side of a peak; 0: none
  double PhotonEfficiency = 0.3;     ///< property of photon counting, like the next two
  double DarkCountRate = 0.0;        ///< [Hz]
  double TimeJitter = 0.0;           ///< [ns]
};

struct vtkHeliosValueRange
{
  double Low;
  double High;
};

namespace vtkHeliosInstrumentRanges
{

constexpr double AboveZero = 1e-300; // for a range open at zero

constexpr vtkHeliosValueRange PulseLength = { 1e-3, 1e6 };
constexpr vtkHeliosValueRange BinSize = { 1e-4, 1e3 };
constexpr vtkHeliosValueRange MaximumWaveformLength = { 0.0, 1e12 };
constexpr vtkHeliosValueRange NumberOfBins = { 0.0, 1e8 };
constexpr vtkHeliosValueRange AveragePower = { 0.0, 1e12 };
constexpr vtkHeliosValueRange Wavelength = { 200.0, 20000.0 };
constexpr vtkHeliosValueRange OpticalEfficiency = { AboveZero, 1.0 };
constexpr vtkHeliosValueRange ReceiverDiameter = { AboveZero, 100.0 };
constexpr vtkHeliosValueRange AtmosphericVisibility = { 1e-3, 1e300 };
constexpr vtkHeliosValueRange AtmosphericExtinction = { -1.0, 1e3 };
constexpr vtkHeliosValueRange AtmosphericLidarRatio = { 0.0, 1e6 };
constexpr vtkHeliosValueRange DropletDiameter = { 0.0, 0.05 };
constexpr vtkHeliosValueRange MaximumSpecularEvents = { 0.0, 64.0 };
constexpr vtkHeliosValueRange LeastSpecularShare = { 0.0, 1.0 };
constexpr vtkHeliosValueRange ScatteringOrders = { 1.0, 64.0 };
constexpr vtkHeliosValueRange ScatteringPaths = { 8.0, 65536.0 };
constexpr vtkHeliosValueRange DetectorNoise = { 0.0, 1e6 };
constexpr vtkHeliosValueRange SaturationPower = { 0.0, 1e6 };
constexpr vtkHeliosValueRange SolarIrradiance = { 0.0, 1e6 };
constexpr vtkHeliosValueRange FilterBandwidth = { 0.0, 1e6 };
constexpr vtkHeliosValueRange FieldOfView = { 0.0, 1.0 };
constexpr vtkHeliosValueRange RangeAccuracy = { 0.0, 1e3 };
constexpr vtkHeliosValueRange RangeAccuracyPerMeter = { 0.0, 1.0 };
constexpr vtkHeliosValueRange RangeAccuracyAtThreshold = { 0.0, 1e3 };
constexpr vtkHeliosValueRange AngleAccuracy = { 0.0, 0.1 };
constexpr vtkHeliosValueRange Range = { 0.0, VTK_DOUBLE_MAX }; // RangeMin and RangeMax

// echoes and their detectors
constexpr vtkHeliosValueRange DetectionThreshold = { 0.0, 1e6 };
constexpr vtkHeliosValueRange DeadTime = { 0.0, 1e6 };
constexpr vtkHeliosValueRange PeakWindow = { 0.0, 1e6 };
constexpr vtkHeliosValueRange PhotonEfficiency = { 0.0, 1.0 };
constexpr vtkHeliosValueRange DarkCountRate = { 0.0, 1e10 };
constexpr vtkHeliosValueRange TimeJitter = { 0.0, 1e3 };
constexpr vtkHeliosValueRange MTAZone = { 0.0, 1000.0 };
constexpr int LargestNumberOfReturns = 255;

} // namespace vtkHeliosInstrumentRanges

#endif
