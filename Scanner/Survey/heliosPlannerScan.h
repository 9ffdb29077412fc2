// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// How the scanner of a plan scans: where it is on its platform, what it sees, how fast it turns.

#ifndef heliosPlannerScan_h
#define heliosPlannerScan_h

#include "heliosLegSettings.h"
#include "heliosPlannerData.h"

namespace helios
{

class Messages;

/**
 * From the point that a platform stands on to where the beam leaves [m], the platform facing north.
 * A beam that leaves beside the axis of the head goes round that point.
 */
Vec3 FindInstrument(const PlatformData& platform, const ScannerData& scanner);

/// The settings that come to what a leg does.
LegSettings MakeSettings(const ScanData& scan);

/**
 * Resolves the leg of a plan: a whole circle, as finely as is asked for and the scanner can, where the
 * settings say nothing else. False after an error.
 */
bool ResolveScan(
  LegSettings settings, const PlannerRequest& request, PlannerData& data, Messages& log);

/// Takes ranges and field of view of the scanner for the limits that are not given (NaN), or none.
void ResolveLimits(PlannerData& data, Messages& log);

} // namespace helios

#endif
