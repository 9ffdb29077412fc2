// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Adapts the settings of a leg to its scanner.

#ifndef heliosLegSettings_h
#define heliosLegSettings_h

#include "heliosSurveyData.h"
#include "vtkHeliosScannerSurveyModule.h" // For export macro

namespace helios
{

class Messages;

/**
 * Resolves the settings of a leg for each channel of its scanner. The survey has its scanners,
 * platforms and all legs but for these. Angles and speeds beyond the scanner's limits are clipped
 * with a warning; settings that cannot run are errors. A leg that fires no pulses is not checked.
 */
void ResolveLeg(const LegSettings& settings, std::size_t leg, SurveyData& survey, Messages& log);

/// Makes the legs of a survey from their settings; ResolveLeg() is still to be called.
void StartLegs(SurveyData& survey);

/// Checks that a moving platform has somewhere to go, or a trajectory.
void CheckPath(const SurveyData& survey, std::size_t leg, Messages& log);

/// Returns whether a leg starts a flight along a trajectory that no file gives: it needs an input.
VTKHELIOSSCANNERSURVEY_EXPORT bool NeedsTrajectory(const SurveyData& survey, std::size_t leg);

/// Checks a leg whose scanner has errors of its own, so only for errors that do not depend on it.
void CheckLegAlone(
  const LegSettings& settings, std::size_t leg, const SurveyData& survey, Messages& log);

} // namespace helios

#endif
