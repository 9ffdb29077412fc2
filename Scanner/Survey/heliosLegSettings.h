// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// What a leg asks for, made what its scanner can do.

#ifndef heliosLegSettings_h
#define heliosLegSettings_h

#include "heliosSurveyData.h"

#include <limits>

namespace helios
{

class Messages;

/// The settings of a leg as its file gives them; NaN: not given.
struct LegSettings
{
  static constexpr double NotGiven = std::numeric_limits<double>::quiet_NaN();

  LegData Leg;   ///< with everything that is taken as it is
  ScanData Scan; ///< so is its head, and its warm-up
  double PulseFrequency = NotGiven;
  double ScanFrequency = NotGiven;
  double ScanAngle = NotGiven;
  double VerticalAngleMin = NotGiven;
  double VerticalAngleMax = NotGiven;
  double BeamDivergence = NotGiven;
  double VerticalResolution = 0.0;   ///< [deg], 0: not given
  double HorizontalResolution = 0.0; ///< [deg], 0: not given
};

/**
 * Makes of what a leg of a survey asks for what each channel of its scanner does. The survey has its
 * scanners, platforms and all legs but for these. Angles and speeds beyond those of the scanner are
 * clipped with a warning; what cannot run is an error. A leg that fires no pulse is not checked.
 */
void ResolveLeg(const LegSettings& settings, std::size_t leg, SurveyData& survey, Messages& log);

/// Checks a leg whose scanner is not known, since it has errors of its own: what is wrong whatever
/// the scanner can do.
void CheckLegAlone(
  const LegSettings& settings, std::size_t leg, const SurveyData& survey, Messages& log);

} // namespace helios

#endif
