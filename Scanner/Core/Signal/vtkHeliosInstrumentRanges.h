// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// The valid ranges of values of an instrument, in the units of vtkHeliosInstrumentData: the scanner and
// detectors check them, and so do attributes of surveys, unless files are stricter.

#ifndef vtkHeliosInstrumentRanges_h
#define vtkHeliosInstrumentRanges_h

#include "vtkType.h" // For an unlimited range

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
constexpr vtkHeliosValueRange AtmosphericVisibility = { 1e-3, VTK_DOUBLE_MAX };
constexpr vtkHeliosValueRange AtmosphericExtinction = { -1.0, 1e3 };
constexpr vtkHeliosValueRange AtmosphericLidarRatio = { 0.0, 1e6 };
constexpr vtkHeliosValueRange DropletDiameter = { 0.0, 0.05 };
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
constexpr int LargestNumberOfReturns = 255;

} // namespace vtkHeliosInstrumentRanges

#endif
