// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Interactive survey editing: scan positions, trajectories and flight lines, with instruments of a
// catalogue.

#ifndef heliosSurveyEdit_h
#define heliosSurveyEdit_h

#include "heliosLegSettings.h"

#include <string>
#include <utility>
#include <vector>

namespace helios
{

/// A number that can be set, and its range.
struct EditRange
{
  std::string Name;
  std::string Label;
  std::string Unit;
  double Low = 0.0;
  double High = 0.0;
  std::vector<double> Choices; ///< one of these; empty: the whole range
};

/// A leg, and the ground below it.
struct EditLeg
{
  LegSettings Settings;
  double Ground = 0.0; ///< [m], z of the point clicked
};

/// The begin and the end of a flight line [m].
using FlightLine = std::pair<Vec3, Vec3>;

/**
 * Plain data, changed by the functions below. One platform carries one scanner on all legs. The
 * position of a leg of a moving platform is Height above its ground.
 */
struct SurveyEdit
{
  std::string Name = "survey";
  std::string Scene;     ///< file.xml#id, or a mesh
  std::string SceneText; ///< a <scene> used instead; empty: none
  std::string Platform;  ///< file.xml#id
  std::string Scanner;   ///< file.xml#id
  std::string File;      ///< a survey that has all else; empty: none
  vtkIdType Seed = -1;   ///< negative: that of File, or none
  PlatformData PlatformModel;
  ScannerData ScannerModel;
  std::vector<EditLeg> Legs;
  LegSettings Settings;  ///< settings of new legs
  double Height = 50.0;  ///< [m], above ground
  double Overlap = 30.0; ///< [%], of strips
  bool HasArea = false;  ///< the legs are flight lines over it
  Vec3 Corners[2];       ///< [m], of the area

  bool IsMoving() const { return this->PlatformModel.Type != PlatformType::Static; }
};

/// Returns the settings of an instrument on a platform, and their limits.
std::vector<EditRange> FindRanges(const SurveyEdit& edit);

/// @{
/// Returns or set a number of FindRanges() by its name; NaN, or false, if the name does not exist.
/// The value is adapted to the instrument, for all legs: the text lists the changes; empty: none.
double GetSetting(const SurveyEdit& edit, const std::string& name);
std::string SetSetting(SurveyEdit& edit, const std::string& name, double value);
///@}

/// Adapts the settings of one leg to the instrument; returns the changes as text.
std::string ClampSettings(const SurveyEdit& edit, LegSettings& settings);

/// Sets the height that the legs are flown at: their ground is below them.
void SetFlownHeight(SurveyEdit& edit, double height);

///@{
/// Selects another platform or instrument, with its default settings.
void ChoosePlatform(SurveyEdit& edit, const std::string& reference, const PlatformData& platform);
void ChooseScanner(SurveyEdit& edit, const std::string& reference, const ScannerData& scanner);
///@}

///@{
/// Legs by their positions, or the points below them [m]; onGround: z follows the ground.
void AddLeg(SurveyEdit& edit, const Vec3& place, bool onGround);
void MoveLeg(SurveyEdit& edit, std::size_t leg, const Vec3& place, bool onGround);
void RemoveLeg(SurveyEdit& edit, std::size_t leg);
/// Replaces all legs by flight lines, which fire, and the turns between them.
void SetLines(SurveyEdit& edit, const std::vector<FlightLine>& lines);
///@}

} // namespace helios

#endif
