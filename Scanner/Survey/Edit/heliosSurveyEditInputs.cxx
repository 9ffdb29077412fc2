// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Inputs of survey editing: catalogues, and existing surveys.
#include "heliosAssets.h"
#include "heliosMessages.h"
#include "heliosPlannerScan.h"
#include "heliosSurveyEdit.h"
#include "heliosXmlPlatform.h"
#include "heliosXmlScanner.h"
#include "vtkHeliosDialect.h"

#include <algorithm>
#include <filesystem>
#include <set>

namespace fs = std::filesystem;

namespace helios
{

namespace
{

void FindXmlFiles(const fs::path& folder, std::vector<std::string>& files)
{
  std::vector<std::string> found;
  std::error_code ignored;
  for (fs::directory_iterator entry(folder, ignored), end; entry != end; entry.increment(ignored))
  {
    if (vtkHeliosDialect::IsDocument(entry->path().string()))
    {
      found.push_back(entry->path().string());
    }
  }
  std::sort(found.begin(), found.end());
  files.insert(files.end(), found.begin(), found.end());
}

std::string MakeAbsolute(const std::string& path)
{
  return fs::absolute(path).lexically_normal().string();
}

std::string MakeWhole(const std::string& path)
{
  std::error_code ignored;
  const fs::path whole = fs::weakly_canonical(fs::absolute(path), ignored);
  return whole.empty() ? path : whole.string();
}

/// Returns the id of a scanner, without that of its channel.
std::string GetScannerId(const ScannerData& scanner)
{
  return scanner.Id.substr(0, scanner.Id.find(", channel "));
}

/// The items read without error, by reference.
template <typename T, typename ReadT>
void AddEntries(const XmlElement& root, const char* tag, const std::string& reference, ReadT read,
  const Assets& assets, std::vector<std::pair<std::string, T>>& entries)
{
  Messages& log = root.GetMessages();
  for (const XmlElement& element : root.GetChildren(tag))
  {
    const int before = log.GetNumberOfErrors();
    T entry = read(element);
    FindModel(element, assets, entry.Model);
    if (log.GetNumberOfErrors() == before && element.Has("id"))
    {
      entries.emplace_back(reference + "#" + element.GetText("id"), entry);
    }
  }
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

} // namespace

//------------------------------------------------------------------------------
Catalogue ReadCatalogue(
  const std::vector<std::string>& assetDirectories, const std::vector<std::string>& files)
{
  std::vector<std::string> all;
  for (const std::string& folder : assetDirectories)
  {
    for (const char* below : { "", "Assets", "data", "data/Assets" })
    {
      FindXmlFiles(fs::path(folder) / below, all);
    }
  }
  all.insert(all.end(), files.begin(), files.end());
  Messages log(nullptr);
  Assets assets(log, assetDirectories);
  Catalogue catalogue;
  std::set<std::string> seen;
  for (const std::string& file : all)
  {
    std::error_code ignored;
    const bool isNew = fs::is_regular_file(file, ignored) && seen.insert(MakeWhole(file)).second;
    const XmlDocument* document = isNew ? assets.Load(file) : nullptr;
    if (document)
    {
      const std::string name = MakeAbsolute(file);
      AddEntries(document->GetRoot(), "platform", name, ReadPlatform, assets, catalogue.Platforms);
      const auto readScanner = [&assets](const XmlElement& element)
      { return ReadScanner(element, assets); };
      AddEntries(document->GetRoot(), "scanner", name, readScanner, assets, catalogue.Scanners);
    }
  }
  return catalogue;
}

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
  if (!edit.Legs.empty())
  {
    edit.Settings = edit.Legs.front().Settings;
    edit.Settings.Leg.Active = true;
    edit.Settings.Leg.Strip.clear();
    edit.Settings.Leg.Crs.clear();
  }
  return left.str();
}

} // namespace helios
