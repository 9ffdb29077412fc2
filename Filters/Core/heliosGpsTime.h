// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// GPS time, UTC and Unix time.

#ifndef heliosGpsTime_h
#define heliosGpsTime_h

#include "heliosStatus.h"
#include "vtkHeliosFiltersCoreModule.h" // For export macro

#include <string>

namespace helios
{

/// GPS time [s], since 6 January 1980 00:00 UTC, of a Unix time [s]: 18 s more than elapsed in UTC
/// since 2017, by the leap seconds.
VTKHELIOSFILTERSCORE_EXPORT double UnixToGpsTime(double unixTime);

/// The inverse; a leap second itself has the Unix time of the second after it.
VTKHELIOSFILTERSCORE_EXPORT double GpsToUnixTime(double gpsTime);

/**
 * Parses a time as GPS time [s], from 1980 on: "2026-07-01 12:00:00" or "2026-07-01T12:00:00Z" (UTC,
 * with decimals of the second), "2026-07-01T14:00:00+02:00", Unix seconds as "1782907200", and GPS
 * seconds as "gps:1467..." An error tells what is expected.
 */
VTKHELIOSFILTERSCORE_EXPORT Status ParseGpsTime(const std::string& text, double& gpsTime);

} // namespace helios

#endif
