// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// How a scanner samples its beam and processes the received signal: plain data.

#ifndef heliosReceiverData_h
#define heliosReceiverData_h

#include "heliosTolerances.h"
#include "vtkHeliosInstrumentData.h"

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

/// Mechanical misalignments of a panoramic scanner, see vtkHeliosPanoramicErrorModel.
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

/// The instrument, how its beams are sampled, and its errors.
struct ReceiverData : vtkHeliosInstrumentData
{
  std::string Where;                               ///< the last place read
  int NumberOfCircles = 0;                         ///< circles of fixed sub-rays; 0: adaptive
  double RangeTolerance = DefaultRangeTolerance;   ///< [m]
  double EnergyTolerance = DefaultEnergyTolerance; ///< relative
  std::string EchoDetector;                        ///< its name; empty: the default
  ErrorExpressions Errors;
  PanoramicErrorData Panoramic;
};

} // namespace helios

#endif
