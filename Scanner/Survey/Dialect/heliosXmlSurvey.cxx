// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosXmlSurvey.h"

#include "heliosAssets.h"
#include "heliosLegSettings.h"
#include "heliosMessages.h"
#include "heliosXmlLeg.h"
#include "heliosXmlPlatform.h"
#include "heliosXmlScanner.h"
#include "heliosXmlScene.h"

#include <algorithm>
#include <filesystem>
#include <map>
#include <set>
#include <utility>

namespace helios
{

namespace
{

/// Reads one <survey>.
class SurveyReader
{
public:
  SurveyReader(Assets& assets, Messages& log, SurveyElements& elements)
    : Files(assets)
    , Log(log)
    , Elements(elements)
  {
  }

  void Read(const XmlElement& survey, SurveyData& data);

private:
  void ReadName(const XmlElement& survey, SurveyData& data);
  void ReadScene(const XmlElement& survey, SurveyData& data);
  void ReadLegs(const XmlElement& survey, SurveyData& data);
  void ReadLeg(const XmlElement& leg, SurveyData& data);
  void ReadScan(const XmlElement& scan, SurveyData& data);
  void AddLeg(
    const XmlElement& element, const LegSettings& base, const XmlElement& from, SurveyData& data);
  void ReadGiven(SurveyData& data);
  std::size_t FindScanner(const XmlElement& from, SurveyData& data);
  std::size_t FindPlatform(const XmlElement& from, SurveyData& data);
  std::size_t AddScanner(const XmlElement& element, SurveyData& data);
  std::size_t AddPlatform(const XmlElement& element, SurveyData& data);
  XmlElement FindRequired(const XmlElement& from, const char* tag);
  PlatformData MakeInterpolated();
  void Resolve(SurveyData& data);
  bool IsGood(std::size_t leg, const SurveyData& data) const;

  Assets& Files;
  Messages& Log;
  SurveyElements& Elements;
  XmlElement Survey;
  std::map<std::string, XmlElement> References; // found before, by tag and text
  std::map<const void*, std::size_t> Scanners;  // by their element; null: none was found
  std::map<const void*, std::size_t> Platforms;
  Vec3 Origin{ 0.0, 0.0, 0.0 }; // origin of the following legs
  bool StartsScan = false;
  std::set<std::size_t> BadScanners; // with errors of their own
  std::set<std::size_t> BadPlatforms;
  std::set<std::size_t> BadLegs;
};

//------------------------------------------------------------------------------
void SurveyReader::Read(const XmlElement& survey, SurveyData& data)
{
  this->Survey = survey;
  survey.CheckNames();
  this->ReadName(survey, data);
  survey.ReadStored(data);
  this->ReadScene(survey, data);
  this->ReadGiven(data);
  this->ReadLegs(survey, data);
}

//------------------------------------------------------------------------------
void SurveyReader::ReadName(const XmlElement& survey, SurveyData& data)
{
  const std::string given = survey.GetText("name");
  const std::string stem = std::filesystem::path(data.FileName).stem().string();
  data.Name = MakeFolderName(given.empty() ? stem : given);
  if (!given.empty() && data.Name != given)
  {
    this->Log.Warning(survey.Where("name") + ": name=\"" + given +
      "\" is not a valid folder name; the survey is called \"" + data.Name + "\"");
  }
}

//------------------------------------------------------------------------------
void SurveyReader::ReadScene(const XmlElement& survey, SurveyData& data)
{
  const AssetNeed need = this->Files.Scene;
  const bool isRead =
    need == AssetNeed::Required || (need == AssetNeed::Optional && survey.Has("scene"));
  this->Elements.Scene = isRead ? this->FindRequired(survey, "scene") : XmlElement();
  this->Elements.Parts.clear();
  if (this->Elements.Scene)
  {
    data.Scene = helios::ReadScene(this->Elements.Scene, this->Files, &this->Elements.Parts);
  }
}

//------------------------------------------------------------------------------
/// Reads the scanners and platforms that were given first, in their order.
void SurveyReader::ReadGiven(SurveyData& data)
{
  for (const XmlElement& element : std::exchange(this->Elements.Scanners, {}))
  {
    this->AddScanner(element, data);
  }
  for (const XmlElement& element : std::exchange(this->Elements.Platforms, {}))
  {
    this->AddPlatform(element, data);
  }
}

//------------------------------------------------------------------------------
XmlElement SurveyReader::FindRequired(const XmlElement& from, const char* tag)
{
  if (from.Has(tag))
  {
    const std::string reference = std::string(tag) + " " + from.GetText(tag);
    const auto known = this->References.find(reference);
    return known != this->References.end()
      ? known->second
      : this->References[reference] = this->Files.FindElement(tag, from, tag);
  }
  this->Log.Error(from.Where() + ": <" + from.GetTag() + "> has no attribute " + tag + "; add " +
    tag + "=\"file.xml#id\"");
  return {};
}

//------------------------------------------------------------------------------
std::size_t SurveyReader::FindScanner(const XmlElement& from, SurveyData& data)
{
  return this->AddScanner(this->FindRequired(from, "scanner"), data);
}

//------------------------------------------------------------------------------
/// The scanner of an element, read once.
std::size_t SurveyReader::AddScanner(const XmlElement& element, SurveyData& data)
{
  const auto known = this->Scanners.find(element.GetIdentity());
  if (known != this->Scanners.end())
  {
    return known->second;
  }
  const int before = this->Log.GetNumberOfErrors();
  ScannerData scanner = element ? ReadScanner(element, this->Files) : ScannerData();
  OverrideScanner(this->Survey, scanner);
  FindModel(element, this->Files, scanner.Model);
  if (element && this->Log.GetNumberOfErrors() == before)
  {
    CheckScanner(scanner, this->Log);
  }
  if (!element || this->Log.GetNumberOfErrors() != before)
  {
    this->BadScanners.insert(data.Scanners.size());
  }
  data.Scanners.push_back(scanner);
  this->Elements.Scanners.push_back(element);
  return this->Scanners[element.GetIdentity()] = data.Scanners.size() - 1;
}

//------------------------------------------------------------------------------
std::size_t SurveyReader::FindPlatform(const XmlElement& from, SurveyData& data)
{
  const bool isInterpolated = from.GetText("platform") == "interpolated";
  return this->AddPlatform(
    isInterpolated ? this->Survey : this->FindRequired(from, "platform"), data);
}

//------------------------------------------------------------------------------
/// The platform of an element, read once; of <survey>: the interpolated one.
std::size_t SurveyReader::AddPlatform(const XmlElement& from, SurveyData& data)
{
  const void* const identity = from.GetIdentity();
  const bool isInterpolated = identity == this->Survey.GetIdentity();
  const XmlElement element = isInterpolated ? XmlElement() : from;
  const auto known = this->Platforms.find(identity);
  if (known != this->Platforms.end())
  {
    return known->second;
  }
  const int before = this->Log.GetNumberOfErrors();
  PlatformData platform = isInterpolated ? this->MakeInterpolated()
    : element                            ? ReadPlatform(element)
                                         : PlatformData();
  OverridePlatform(this->Survey, platform);
  FindModel(element, this->Files, platform.Model);
  if ((!element && !isInterpolated) || this->Log.GetNumberOfErrors() != before)
  {
    this->BadPlatforms.insert(data.Platforms.size());
  }
  data.Platforms.push_back(platform);
  this->Elements.Platforms.push_back(from);
  return this->Platforms[identity] = data.Platforms.size() - 1;
}

//------------------------------------------------------------------------------
/// Makes the platform that plays trajectories from files, with mount and noise of another platform.
PlatformData SurveyReader::MakeInterpolated()
{
  PlatformData platform;
  if (this->Survey.Has("basePlatform"))
  {
    const XmlElement base = this->Files.FindElement("platform", this->Survey, "basePlatform");
    platform = base ? ReadPlatform(base) : platform;
    FindModel(base, this->Files, platform.Model);
  }
  platform.Type = PlatformType::Interpolated;
  platform.Where = this->Survey.Where();
  platform.Name = platform.Name.empty() ? "interpolated" : platform.Name;
  return platform;
}

//------------------------------------------------------------------------------
void SurveyReader::ReadLegs(const XmlElement& survey, SurveyData& data)
{
  for (const XmlElement& child : survey.GetChildren())
  {
    if (child.GetTag() == "origin")
    {
      child.CheckNames();
      this->Origin = Vec3(0.0, 0.0, 0.0);
      child.ReadVector(this->Origin);
    }
    else if (child.GetTag() == "scan")
    {
      this->ReadScan(child, data);
    }
    else if (child.GetTag() == "leg")
    {
      this->ReadLeg(child, data);
    }
  }
  if (data.Settings.empty())
  {
    this->Log.Error(survey.Where() + ": survey " + data.Name + " has 0 <leg>; add one");
    data.Scanners.empty() ? void(this->FindScanner(survey, data)) : void(); // may have errors, too
    data.Platforms.empty() ? void(this->FindPlatform(survey, data)) : void();
  }
  this->Resolve(data);
}

//------------------------------------------------------------------------------
void SurveyReader::ReadLeg(const XmlElement& leg, SurveyData& data)
{
  this->AddLeg(leg, {}, leg, data);
}

//------------------------------------------------------------------------------
/// Reads a <scan> of the Java program's planner: a platform and a scanner with their own legs.
void SurveyReader::ReadScan(const XmlElement& scan, SurveyData& data)
{
  scan.CheckNames();
  this->StartsScan = true;
  LegSettings settings;
  if (const XmlElement turn = scan.GetChild("scannerRotation"))
  {
    turn.CheckNames();
    turn.Read("start", settings.Scan.HeadRotateStart);
    turn.Read("end", settings.Scan.HeadRotateStop);
  }
  const std::size_t scanner = this->FindScanner(scan, data);
  settings.ScanFrequency = data.Scanners[scanner].ScanFrequencyMax;
  settings.Scan.HeadRotateSpeed = std::copysign(data.Scanners[scanner].HeadRotateSpeedMax,
    settings.Scan.HeadRotateStop - settings.Scan.HeadRotateStart);
  for (const XmlElement& leg : scan.GetChildren("leg"))
  {
    this->AddLeg(leg, settings, scan, data);
    if (this->BadScanners.count(scanner) > 0)
    {
      this->BadLegs.insert(data.Settings.size() - 1); // its head rotation depends on the scanner
    }
  }
}

//------------------------------------------------------------------------------
/// Adds a leg with the scanner and platform named by it, its parent or the survey.
void SurveyReader::AddLeg(
  const XmlElement& element, const LegSettings& base, const XmlElement& from, SurveyData& data)
{
  const int before = this->Log.GetNumberOfErrors();
  LegSettings settings = helios::ReadLeg(element, base, this->Files);
  if (this->Log.GetNumberOfErrors() != before)
  {
    this->BadLegs.insert(data.Settings.size());
  }
  LegData& leg = settings.Leg;
  leg.Position += this->Origin;
  leg.Scanner = this->FindScanner(from.Has("scanner") ? from : this->Survey, data);
  leg.Platform = this->FindPlatform(from.Has("platform") ? from : this->Survey, data);
  leg.StartsTrajectory = this->StartsScan;
  this->StartsScan = false;
  data.Settings.push_back(settings);
}

//------------------------------------------------------------------------------
void SurveyReader::Resolve(SurveyData& data)
{
  StartLegs(data);
  std::vector<std::size_t> good;
  for (std::size_t leg = 0; leg < data.Legs.size(); ++leg)
  {
    if (this->IsGood(leg, data))
    {
      good.push_back(leg);
      CheckPath(data, leg, this->Log);
      if (this->Files.Trajectories == AssetNeed::Required && NeedsTrajectory(data, leg))
      {
        this->Log.Error(data.Legs[leg].Where +
          ": platform=\"interpolated\" needs a trajectory; add trajectory=\"file\" to "
          "<platformSettings>");
      }
    }
  }
  for (const std::size_t leg : good)
  {
    if (this->BadScanners.count(data.Legs[leg].Scanner) == 0)
    {
      ResolveLeg(data.Settings[leg], leg, data, this->Log);
    }
    else
    {
      CheckLegAlone(data.Settings[leg], leg, data, this->Log);
    }
  }
}

//------------------------------------------------------------------------------
/// Returns whether a leg and its platform have no errors of their own, so that further errors are
/// reported.
bool SurveyReader::IsGood(std::size_t leg, const SurveyData& data) const
{
  return this->BadLegs.count(leg) == 0 && this->BadPlatforms.count(data.Legs[leg].Platform) == 0;
}

} // namespace

//------------------------------------------------------------------------------
std::string MakeFolderName(std::string name)
{
  const auto isUnfit = [](char c)
  { return c == '/' || c == '\\' || static_cast<unsigned char>(c) < 0x20; };
  std::replace_if(name.begin(), name.end(), isUnfit, '_');
  return name == "." || name == ".." ? "survey" : name;
}

//------------------------------------------------------------------------------
SurveyData ReadSurvey(
  const XmlDocument* document, Assets& assets, Messages& log, SurveyElements* elements)
{
  SurveyElements others;
  SurveyData data;
  if (!document)
  {
    return data;
  }
  data.FileName = document->GetPath();
  const std::vector<XmlElement> surveys = document->GetRoot().GetChildren("survey");
  if (surveys.empty())
  {
    const bool isPlanner = static_cast<bool>(document->GetRoot().GetChild("surveyPlanner"));
    log.Error(document->GetRoot().Where() + ": the file has no <survey>; " +
      (isPlanner ? "vtkhelios plan creates one from its <surveyPlanner>"
                 : "give a file that has one"));
    return data;
  }
  if (surveys.size() > 1)
  {
    log.Warning(surveys[1].Where() + ": of several surveys in one file only the first is used");
  }
  SurveyReader(assets, log, elements ? *elements : others).Read(surveys.front(), data);
  data.Documents = assets.GetDocumentPaths();
  return data;
}

//------------------------------------------------------------------------------
void ReadSurvey(const XmlElement& element, Assets& assets, Messages& log, SurveyData& data)
{
  SurveyElements elements;
  SurveyReader(assets, log, elements).Read(element, data);
}

} // namespace helios
