// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// A planning task as read from a file, independent of the file format.

#ifndef heliosPlannerData_h
#define heliosPlannerData_h

#include "heliosPlannerSettings.h"
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
  bool UseMovingParts = false;
  double Resolution = 0.0;     ///< [deg]
  double PulseFrequency = 0.0; ///< [Hz]
  bool HasScene = false;       ///< the caller has a scene: the file's is not read
};

struct PlannerData
{
  std::string Kind = "scene"; ///< kind of the file: planner, survey or scene
  SurveyData Survey;          ///< scene, platform, scanner, and a leg with a full rotation
  std::string SceneReference; ///< empty: a mesh, or the scene of the caller
  std::string PlatformReference;
  std::string ScannerReference;
  Vec3 Instrument{ 0.0, 0.0, 0.0 }; ///< [m], from the platform to the beam origin
  PlannerSettings Settings;
};

} // namespace helios

#endif
