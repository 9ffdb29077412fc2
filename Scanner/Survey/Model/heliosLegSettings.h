// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Adapts the settings of a leg to its scanner.

#ifndef heliosLegSettings_h
#define heliosLegSettings_h

#include "heliosSurveyData.h"

#include <limits>

namespace helios
{

class Messages;

/// The settings of a leg in its file; NaN: not given.
struct LegSettings
{
  static constexpr double NotGiven = std::numeric_limits<double>::quiet_NaN();

  LegData Leg;   ///< with all settings that need no conversion
  ScanData Scan; ///< likewise its head and its warm-up
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
 * Resolves the settings of a leg for each channel of its scanner. The survey has its scanners,
 * platforms and all legs but for these. Angles and speeds beyond the scanner's limits are clipped
 * with a warning; settings that cannot run are errors. A leg that fires no pulses is not checked.
 */
void ResolveLeg(const LegSettings& settings, std::size_t leg, SurveyData& survey, Messages& log);

/// Checks a leg whose scanner has errors of its own, so only for errors that do not depend on it.
void CheckLegAlone(
  const LegSettings& settings, std::size_t leg, const SurveyData& survey, Messages& log);

} // namespace helios

#endif
