// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// How the scanner of a plan scans: its pose on the platform, its field of view, its rotation speed.

#ifndef heliosPlannerScan_h
#define heliosPlannerScan_h

#include "heliosLegSettings.h"
#include "heliosPlannerData.h"
#include "vtkHeliosScannerSurveyModule.h" // For export macro

namespace helios
{

class Messages;

/**
 * Returns the offset from the platform to the beam origin [m], with the platform facing north. A
 * beam origin off the head axis rotates about that point.
 */
Vec3 FindInstrument(const PlatformData& platform, const ScannerData& scanner);

/// Returns the settings that give the scan of a leg.
VTKHELIOSSCANNERSURVEY_EXPORT LegSettings MakeSettings(const ScanData& scan);

/**
 * Resolves the leg of a plan: a full circle at the requested resolution, or the finest of the
 * scanner, unless the settings say otherwise. False after an error.
 */
bool ResolveScan(
  LegSettings settings, const PlannerRequest& request, PlannerData& data, Messages& log);

/// Sets limits that are not given (NaN) to range and field of view of the scanner, or to none.
void ResolveLimits(PlannerData& data, Messages& log);

} // namespace helios

#endif
