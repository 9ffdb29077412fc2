// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// The settings of a planning task, in the words and units of the file.

#ifndef heliosPlannerSettings_h
#define heliosPlannerSettings_h

#include <limits>
#include <string>

namespace helios
{

struct PlannerSettings
{
  std::string Method; ///< reduce, bestcoverage, greedy, best, optimal; empty: not given
  std::string RemoveOrder = "viewshedSize"; ///< or meanIncidenceAngle
  std::string RemoveFirst = "smallest";     ///< or largest
  double MinimumCoverage = 100.0;           ///< [%]
  std::string CoverageOf = "coverable";     ///< or all
  double PositionStep[2] = { 0.0, 0.0 };    ///< [m], 0: not given
  double TestPointStep = 0.0;               ///< [m], 0: not given
  std::string TestLines = "all";            ///< or vertical, horizontal
  double MaximumSlope = 15.0;               ///< [deg]
  std::string GroundOnly = "auto";          ///< or true, false, open
  bool TakesEnclosed = false;               ///< enclosed places count
  double ScannerHeight = 0.0;               ///< [m]
  double HitTolerance = 0.05;               ///< [m]
  bool SeesBefore = true;                   ///< points before the end of a ray are seen
  /// uses the limits of the scanner, if not given
  bool HasScannerLimits = false;
  bool HasMovingParts = false;                          ///< where they are at the start
  double RangeMin = 0.0;                                ///< [m]
  double RangeMax = std::numeric_limits<double>::max(); ///< [m]
  double ElevationMin = -90.0;                          ///< [deg]
  double ElevationMax = 90.0;                           ///< [deg]
  double MaximumIncidenceAngle = 90.0;                  ///< [deg]
  double MinimumPointDensity = 0.0;                     ///< [1/m^2]
  bool UseAreas = false;
  double MinimumOverlap = 0.0; ///< [%]
  double TimeLimit = 300.0;    ///< [s]
};

} // namespace helios

#endif
