// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// What is to be planned, and how: what a reader makes of a file. No trace of its form.

#ifndef heliosPlannerData_h
#define heliosPlannerData_h

#include "heliosSurveyData.h"

#include <string>
#include <vector>

namespace helios
{

/// What the caller of a reader asks for; empty and 0: what the file says.
struct PlannerRequest
{
  std::string FileName;
  std::vector<std::string> AssetDirectories;
  std::string Platform;        ///< file.xml#id
  std::string Scanner;         ///< file.xml#id
  std::string DefaultPlatform; ///< of scenes, which name none
  std::string DefaultScanner;
  bool UseScannerLimits = false;
  double Resolution = 0.0;     ///< [deg]
  double PulseFrequency = 0.0; ///< [Hz]
};

struct PlannerData
{
  std::string Kind = "scene"; ///< what the file was: planner, survey or scene
  SurveyData Survey;          ///< scene, platform, scanner, and a leg that turns by a circle
  std::string SceneReference; ///< empty: the file is a mesh
  std::string PlatformReference;
  std::string ScannerReference;
  Vec3 Instrument{ 0.0, 0.0, 0.0 }; ///< [m], from the platform to where the beam leaves

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
  bool TakesEnclosed = false;          ///< places that are closed all around
  double ScannerHeight = 0.0;          ///< [m]
  double HitTolerance = 0.05;          ///< [m]
  bool SeesBefore = true;              ///< what a ray ends behind is seen
  bool HasScannerLimits = false;       ///< those of the scanner, where not given
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
