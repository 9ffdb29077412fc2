// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// A planning task as read from a file, independent of the file format.

#ifndef heliosPlannerData_h
#define heliosPlannerData_h

#include "heliosSurveyData.h"

#include <string>
#include <vector>

namespace helios
{

/// The options of a reader's caller; empty and 0: as in the file.
struct PlannerRequest
{
  std::string FileName;
  std::vector<std::string> AssetDirectories;
  std::string Platform;        ///< file.xml#id
  std::string Scanner;         ///< file.xml#id
  std::string DefaultPlatform; ///< for scenes, which name none
  std::string DefaultScanner;
  bool UseScannerLimits = false;
  double Resolution = 0.0;     ///< [deg]
  double PulseFrequency = 0.0; ///< [Hz]
};

struct PlannerData
{
  std::string Kind = "scene"; ///< of the file: planner, survey or scene
  SurveyData Survey;          ///< scene, platform, scanner, and a leg with a full rotation
  std::string SceneReference; ///< empty: the file is a mesh
  std::string PlatformReference;
  std::string ScannerReference;
  Vec3 Instrument{ 0.0, 0.0, 0.0 }; ///< [m], from the platform to the beam origin

  std::string Method; ///< empty: not given
  std::string RemoveOrder = "viewshedSize";
  std::string RemoveFirst = "smallest";
  double MinimumCoverage = 100.0; ///< [%]
  std::string CoverageOf = "coverable";
  double PositionStep[2] = { 0.0, 0.0 }; ///< [m], 0: not given
  double TestPointStep = 0.0;            ///< [m], 0: not given
  std::string TestLines = "all";
  double MaximumSlope = 15.0; ///< [deg]
  std::string GroundOnly = "auto";
  bool TakesEnclosed = false;          ///< enclosed places count
  double ScannerHeight = 0.0;          ///< [m]
  double HitTolerance = 0.05;          ///< [m]
  bool SeesBefore = true;              ///< points before the end of a ray are seen
  bool HasScannerLimits = false;       ///< use those of the scanner, if not given
  double RangeMin = 0.0;               ///< [m]
  double RangeMax = VTK_DOUBLE_MAX;    ///< [m]
  double ElevationMin = -90.0;         ///< [deg]
  double ElevationMax = 90.0;          ///< [deg]
  double MaximumIncidenceAngle = 90.0; ///< [deg]
  double MinimumPointDensity = 0.0;    ///< [1/m^2]
  bool UseAreas = false;
  double MinimumOverlap = 0.0; ///< [%]
  double TimeLimit = 300.0;    ///< [s]
};

} // namespace helios

#endif
