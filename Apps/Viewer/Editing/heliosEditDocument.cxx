// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosEditDocument.h"

#include "heliosMessages.h"
#include "heliosPlannerScan.h"
#include "heliosStatus.h"
#include "heliosSurveyDocument.h"
#include "vtkHeliosSurvey.h"

#include <filesystem>
#include <memory>

namespace fs = std::filesystem;

namespace helios
{

namespace
{

std::string MakeAbsolute(const std::string& path)
{
  return fs::absolute(path).lexically_normal().string();
}

/// Returns the id of a scanner, without that of its channel.
std::string GetScannerId(const ScannerData& scanner)
{
  return scanner.Id.substr(0, scanner.Id.find(", channel "));
}

/// Returns the settings that resolve to the scan of a leg.
LegSettings Unresolve(const SurveyData& survey, std::size_t leg)
{
  const LegData& data = survey.Legs[leg];
  const ScanData& scan = data.Scans.front();
  const Optics type = survey.GetScanner(leg).Type;
  LegSettings settings = MakeSettings(scan);
  settings.Leg = data;
  settings.Leg.Scans.clear();
  settings.Scan = scan;
  settings.Scan.HeadRotateStart -= scan.HeadRotateSpeed * scan.WarmUpTime;
  if (type != Optics::RotatingMirror)
  {
    settings.VerticalAngleMin = LegSettings::NotGiven;
    settings.VerticalAngleMax = LegSettings::NotGiven;
  }
  if (type == Optics::RisleyPrisms || type == Optics::SpinningChannels)
  {
    settings.ScanAngle = LegSettings::NotGiven;
  }
  if (type == Optics::RisleyPrisms || type == Optics::FiberArray)
  {
    settings.ScanFrequency = LegSettings::NotGiven;
  }
  return settings;
}

/// Returns the settings of a leg on a static platform.
LegSettings MakeStill(const LegSettings& settings)
{
  LegSettings still = settings;
  still.Leg = LegData();
  still.Leg.Strip = settings.Leg.Strip;
  still.Leg.Position = settings.Leg.Position;
  still.Leg.Crs = settings.Leg.Crs;
  still.Leg.OnGround = settings.Leg.OnGround;
  still.Leg.Active = settings.Leg.Active;
  still.Leg.TrajectoryTimeInterval = settings.Leg.TrajectoryTimeInterval;
  still.Leg.MaximumDuration = settings.Leg.MaximumDuration;
  return still;
}

/// Returns the document of an edited survey: that of its file, with other legs.
std::unique_ptr<SurveyDocument> MakeDocument(vtkObject* owner, const SurveyEdit& edit,
  const std::string& fileName, const std::vector<std::string>& assetDirectories)
{
  auto document = std::make_unique<SurveyDocument>(owner, fileName);
  document->SetAssetDirectories(assetDirectories);
  document->SetNeeds(AssetNeed::Required, AssetNeed::Required);
  const SurveyPlace survey{ SurveyItem::Survey };
  if (!edit.File.empty() && document->Load(edit.File))
  {
    document->Set(survey, "basePlatform", "");
    document->RemoveAllLegs();
  }
  document->SetComment(" A survey made by hand, written by vtkHelios. ");
  document->Set(survey, "name", edit.Name);
  document->SetSceneText(edit.SceneText);
  document->SetSources(
    edit.SceneText.empty() ? edit.Scene : std::string(), edit.Platform, edit.Scanner);
  edit.Seed < 0 ? false : document->Set(survey, "seed", std::to_string(edit.Seed));
  for (const EditLeg& leg : edit.Legs)
  {
    document->AddLeg(edit.IsMoving() ? leg.Settings : MakeStill(leg.Settings), "");
  }
  return document;
}

} // namespace

//------------------------------------------------------------------------------
std::string EditSurvey(const SurveyData& survey, SurveyEdit& edit)
{
  MessageBuilder left;
  edit = SurveyEdit();
  edit.Name = survey.Name;
  edit.File = survey.FileName;
  edit.Scene = MakeAbsolute(survey.Scene.File) + "#" + survey.Scene.Id;
  edit.PlatformModel = survey.Platforms.front();
  edit.ScannerModel = survey.Scanners.front();
  edit.Platform = MakeAbsolute(edit.PlatformModel.File) + "#" + edit.PlatformModel.Id;
  edit.Scanner = MakeAbsolute(edit.ScannerModel.File) + "#" + GetScannerId(edit.ScannerModel);
  std::size_t count = 0;
  for (std::size_t i = 0; i < survey.Legs.size(); ++i)
  {
    const LegData& data = survey.Legs[i];
    const bool isKept = data.Platform == 0 && data.Scanner == 0 &&
      edit.PlatformModel.Type != PlatformType::Interpolated && (i == 0 || !data.StartsTrajectory);
    if (isKept && !data.Scans.empty())
    {
      EditLeg leg;
      leg.Settings = Unresolve(survey, i);
      leg.Ground = data.Position[2] - (edit.IsMoving() ? edit.Height : 0.0);
      edit.Legs.push_back(leg);
      ++count;
    }
  }
  if (count < survey.Legs.size())
  {
    left
      << survey.Legs.size() - count << " of " << survey.Legs.size()
      << " legs are left out: those of other platforms, scanners, trajectories or trajectory files";
  }
  if (!survey.Legs.empty() && !survey.Legs.front().Scans.empty())
  {
    edit.Settings = edit.Legs.empty() ? Unresolve(survey, 0) : edit.Legs.front().Settings;
    edit.Settings.Leg.Trajectory = TrajectoryFileData();
    edit.Settings.Leg.Active = true;
    edit.Settings.Leg.Strip.clear();
    edit.Settings.Leg.Crs.clear();
  }
  return left.str();
}

//------------------------------------------------------------------------------
bool ReadEdit(const SurveyEdit& edit, const std::string& fileName,
  const std::vector<std::string>& assetDirectories, vtkHeliosSurvey* survey)
{
  return survey->ReadDocument(MakeDocument(survey, edit, fileName, assetDirectories), survey);
}

//------------------------------------------------------------------------------
Status SaveSurvey(const SurveyEdit& edit, const std::string& fileName,
  const std::vector<std::string>& assetDirectories, Messages& log)
{
  const auto document = MakeDocument(nullptr, edit, fileName, assetDirectories);
  document->Resolve(nullptr);
  if (document->HasError())
  {
    log.Error(document->GetLastError());
    return Status::Error(
      fileName + ": not written: the survey could not be run: " + document->GetLastError());
  }
  return document->Write(fileName);
}

} // namespace helios
