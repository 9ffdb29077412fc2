// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// A survey made by hand: stands, ways and flight lines, with instruments of a catalogue.

#ifndef heliosSurveyEdit_h
#define heliosSurveyEdit_h

#include "heliosLegSettings.h"
#include "vtkHeliosScannerSurveyModule.h" // For export macro

#include <string>
#include <utility>
#include <vector>

namespace helios
{

/// What can be chosen from, each by what a survey refers to it by (file.xml#id).
struct Catalogue
{
  std::vector<std::pair<std::string, PlatformData>> Platforms;
  std::vector<std::pair<std::string, ScannerData>> Scanners;
};

/// The platforms and scanners of the XML files of asset directories (and of their folders Assets), and
/// of more files, as a survey in a folder refers to them. What has errors is left out.
VTKHELIOSSCANNERSURVEY_EXPORT Catalogue ReadCatalogue(
  const std::vector<std::string>& assetDirectories, const std::vector<std::string>& files,
  const std::string& surveyFolder);

/// A number that can be set, and what it can be.
struct EditRange
{
  std::string Name;
  std::string Label;
  std::string Unit;
  double Low = 0.0;
  double High = 0.0;
  std::vector<double> Choices; ///< one of these; empty: all between
};

/// A leg, and what it stands or flies above.
struct EditLeg
{
  LegSettings Settings;
  double Ground = 0.0; ///< [m], z of what was clicked
};

/**
 * Plain data, which the functions below change. One platform carries one scanner on all legs. The
 * position of a leg of a moving platform is Height above its ground.
 */
struct SurveyEdit
{
  std::string Name = "survey";
  std::string Scene;     ///< file.xml#id, or a mesh
  std::string SceneText; ///< a <scene> in place of that; empty: none
  std::string Platform;  ///< file.xml#id
  std::string Scanner;   ///< file.xml#id
  vtkIdType Seed = -1;   ///< negative: that of Attributes, or none
  std::vector<std::pair<std::string, std::string>> Attributes; ///< more of the <survey>
  std::string Children;                                        ///< more elements of it
  PlatformData PlatformModel;
  ScannerData ScannerModel;
  std::vector<EditLeg> Legs;
  LegSettings Settings;  ///< of legs to come
  double Height = 50.0;  ///< [m], above ground
  double Overlap = 30.0; ///< [%], of strips
  bool HasArea = false;  ///< the legs are flight lines over it
  Vec3 Corners[2];       ///< [m], of the area

  bool IsMoving() const { return this->PlatformModel.Type != PlatformType::Static; }
};

/// Where strips lie [m], and along which axis (0: x, 1: y) they are flown.
struct FlightLines
{
  int Axis = 0;
  double Spacing = 0.0;
  std::vector<std::pair<Vec3, Vec3>> Lines; ///< to and fro
};

/**
 * Strips over a rectangle along its longer side, at a height above the higher corner [m], with a half
 * scan angle in (0, 89] [deg] and an overlap in [0, 95] [%]: 2 h tan(a) (1 - overlap) apart, the
 * fewest that cover it, about its middle.
 */
VTKHELIOSSCANNERSURVEY_EXPORT FlightLines MakeFlightLines(
  const Vec3& corner, const Vec3& opposite, double height, double scanAngle, double overlap);

/// What an instrument on a platform has to set, and between what limits.
VTKHELIOSSCANNERSURVEY_EXPORT std::vector<EditRange> FindRanges(const SurveyEdit& edit);

///@{
/// A number of FindRanges() by its name; NaN, or false, where there is no such name. It is made what the
/// instrument can do, for all legs: the text says what was changed; empty: nothing.
VTKHELIOSSCANNERSURVEY_EXPORT double GetSetting(const SurveyEdit& edit, const std::string& name);
VTKHELIOSSCANNERSURVEY_EXPORT std::string SetSetting(
  SurveyEdit& edit, const std::string& name, double value);
///@}

/// The settings of one leg made what the instrument can do; says what was changed.
VTKHELIOSSCANNERSURVEY_EXPORT std::string ClampSettings(
  const SurveyEdit& edit, LegSettings& settings);

///@{
/// Another platform, or instrument: settings are those it begins with.
VTKHELIOSSCANNERSURVEY_EXPORT void ChoosePlatform(
  SurveyEdit& edit, const std::string& reference, const PlatformData& platform);
VTKHELIOSSCANNERSURVEY_EXPORT void ChooseScanner(
  SurveyEdit& edit, const std::string& reference, const ScannerData& scanner);
///@}

///@{
/// Legs by the places that they stand or fly above [m]; onGround: wherever the ground comes to be.
VTKHELIOSSCANNERSURVEY_EXPORT void AddLeg(SurveyEdit& edit, const Vec3& place, bool onGround);
VTKHELIOSSCANNERSURVEY_EXPORT void MoveLeg(
  SurveyEdit& edit, std::size_t leg, const Vec3& place, bool onGround);
VTKHELIOSSCANNERSURVEY_EXPORT void RemoveLeg(SurveyEdit& edit, std::size_t leg);
VTKHELIOSSCANNERSURVEY_EXPORT void SetArea(
  SurveyEdit& edit, const Vec3& corner, const Vec3& opposite);
///@}

/// What a survey that was read comes to, to be saved in a folder. Says in words what of it cannot be
/// changed by hand and is left out; empty: nothing.
VTKHELIOSSCANNERSURVEY_EXPORT std::string EditSurvey(const SurveyData& survey,
  const Catalogue& catalogue, const std::string& surveyFolder,
  const std::vector<std::string>& assetDirectories, SurveyEdit& edit);

} // namespace helios

#endif
