// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosXmlSurvey.h"

#include "heliosAssets.h"
#include "heliosLegSettings.h"
#include "heliosMessages.h"
#include "heliosXmlScanner.h"
#include "heliosXmlScene.h"

#include <algorithm>
#include <filesystem>

namespace helios
{

namespace
{

/// How deep templates of templates may go: deeper they go round in circles.
constexpr int DeepestTemplate = 32;

/// A name that is fit for a folder.
std::string MakeFolderName(std::string name)
{
  const auto isUnfit = [](char c)
  { return c == '/' || c == '\\' || static_cast<unsigned char>(c) < 0x20; };
  std::replace_if(name.begin(), name.end(), isUnfit, '_');
  return name == "." || name == ".." ? "survey" : name;
}

/// Reads one <survey>.
class SurveyReader
{
public:
  SurveyReader(Assets& assets, Messages& log)
    : Files(assets)
    , Log(log)
  {
  }

  void Read(const XmlElement& survey, SurveyData& data);

private:
  void ReadName(const XmlElement& survey, SurveyData& data);
  void ReadReferences(const XmlElement& survey, SurveyData& data);
  XmlElement FindRequired(const XmlElement& survey, const char* tag);
  void ReadLegs(const XmlElement& survey, SurveyData& data);
  LegSettings ReadLeg(const XmlElement& leg);
  void ReadPlatformSettings(const XmlElement& element, LegSettings& settings, int depth);
  void ReadScannerSettings(const XmlElement& element, LegSettings& settings, int depth);
  XmlElement FindTemplate(const XmlElement& element, int depth);

  Assets& Files;
  Messages& Log;
};

//------------------------------------------------------------------------------
void SurveyReader::Read(const XmlElement& survey, SurveyData& data)
{
  survey.CheckNames();
  this->ReadName(survey, data);
  data.RayCaster = survey.GetText("rayCaster");
  this->ReadReferences(survey, data);
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
    this->Log.Warning(survey.Where() + ": name=\"" + given +
      "\" is no name for a folder; the survey is called \"" + data.Name + "\"");
  }
}

//------------------------------------------------------------------------------
void SurveyReader::ReadReferences(const XmlElement& survey, SurveyData& data)
{
  const XmlElement scanner = this->FindRequired(survey, "scanner");
  if (scanner)
  {
    data.Scanner = ReadScanner(scanner);
  }
  OverrideScanner(survey, data.Scanner);
  if (survey.GetText("platform") == "interpolated")
  {
    this->Log.Error(survey.Where() + ": platform=\"interpolated\" comes with a later version; " +
      "platforms that exist now are of type static or linearpath");
  }
  else if (const XmlElement platform = this->FindRequired(survey, "platform"))
  {
    data.Platform = ReadPlatform(platform);
  }
  const XmlElement scene = this->FindRequired(survey, "scene");
  if (scene)
  {
    data.Scene = ReadScene(scene, this->Files);
  }
}

//------------------------------------------------------------------------------
XmlElement SurveyReader::FindRequired(const XmlElement& survey, const char* tag)
{
  if (survey.Has(tag))
  {
    return this->Files.FindElement(tag, survey, tag);
  }
  this->Log.Error(
    survey.Where() + ": <survey> has no attribute " + tag + "; add " + tag + "=\"file.xml#id\"");
  return {};
}

//------------------------------------------------------------------------------
void SurveyReader::ReadLegs(const XmlElement& survey, SurveyData& data)
{
  std::vector<LegSettings> legs;
  for (const XmlElement& leg : survey.GetChildren("leg"))
  {
    legs.push_back(this->ReadLeg(leg));
  }
  const std::size_t least = data.IsMoving() ? 2 : 1;
  if (legs.size() < least)
  {
    this->Log.Error(survey.Where() + ": survey " + data.Name + " has " +
      std::to_string(legs.size()) + " <leg>; " +
      (data.IsMoving() ? "a moving platform needs two, from where to where" : "add one"));
  }
  if (this->Log.HasError())
  {
    return; // What follows from an error is none of its own.
  }
  CheckScanner(data.Scanner, this->Log);
  for (std::size_t i = 0; i < legs.size() && !this->Log.HasError(); ++i)
  {
    AddLeg(legs[i], i + 1 == legs.size(), data, this->Log);
  }
}

//------------------------------------------------------------------------------
LegSettings SurveyReader::ReadLeg(const XmlElement& leg)
{
  LegSettings settings;
  settings.Leg.Where = leg.Where();
  leg.CheckNames();
  const XmlElement platform = leg.GetChild("platformSettings");
  if (platform)
  {
    this->ReadPlatformSettings(platform, settings, 0);
  }
  const XmlElement scanner = leg.GetChild("scannerSettings");
  if (scanner)
  {
    settings.Leg.Where = scanner.Where();
    this->ReadScannerSettings(scanner, settings, 0);
  }
  leg.Read("maxDuration_s", settings.Leg.MaximumDuration);
  return settings;
}

//------------------------------------------------------------------------------
void SurveyReader::ReadPlatformSettings(const XmlElement& element, LegSettings& settings, int depth)
{
  element.CheckNames();
  const XmlElement base = this->FindTemplate(element, depth);
  if (base)
  {
    this->ReadPlatformSettings(base, settings, depth + 1);
  }
  LegData& leg = settings.Leg;
  element.ReadVector(leg.Position);
  element.Read("crs", leg.Crs);
  element.Read("onGround", leg.OnGround);
  element.Read("movePerSec_m", leg.Speed);
}

//------------------------------------------------------------------------------
void SurveyReader::ReadScannerSettings(const XmlElement& element, LegSettings& settings, int depth)
{
  element.CheckNames();
  const XmlElement base = this->FindTemplate(element, depth);
  if (base)
  {
    this->ReadScannerSettings(base, settings, depth + 1);
  }
  LegData& leg = settings.Leg;
  element.Read("active", leg.Active);
  element.Read("pulseFreq_hz", settings.PulseFrequency);
  element.Read("scanFreq_hz", settings.ScanFrequency);
  element.Read("scanAngle_deg", settings.ScanAngle);
  element.Read("verticalAngleMin_deg", settings.VerticalAngleMin);
  element.Read("verticalAngleMax_deg", settings.VerticalAngleMax);
  element.Read("headRotatePerSec_deg", leg.HeadRotateSpeed);
  element.Read("headRotateStart_deg", leg.HeadRotateStart);
  element.Read("headRotateStop_deg", leg.HeadRotateStop);
  element.Read("beamDivergenceRad", settings.BeamDivergence);
  element.Read("beamDivergence_rad", settings.BeamDivergence);
  element.Read("trajectoryTimeInterval_s", leg.TrajectoryTimeInterval);
  element.Read("maxDuration_s", leg.MaximumDuration);
  element.Read("verticalResolution_deg", settings.VerticalResolution);
  element.Read("horizontalResolution_deg", settings.HorizontalResolution);
  element.Read("opticsWarmupPhase_s", leg.WarmUpTime);
}

//------------------------------------------------------------------------------
XmlElement SurveyReader::FindTemplate(const XmlElement& element, int depth)
{
  if (!element.Has("template"))
  {
    return {};
  }
  if (depth < DeepestTemplate)
  {
    return this->Files.FindElement(element.GetTag().c_str(), element, "template");
  }
  this->Log.Error(element.Where() + ": template=\"" + element.GetText("template") +
    "\" goes round in circles; let the last template have none");
  return {};
}

} // namespace

//------------------------------------------------------------------------------
SurveyData ReadSurvey(
  const std::string& fileName, const std::vector<std::string>& assetDirectories, Messages& log)
{
  SurveyData data;
  data.FileName = fileName;
  Assets assets(log, assetDirectories);
  const XmlDocument* document = assets.Load(fileName);
  if (!document)
  {
    return data;
  }
  const std::vector<XmlElement> surveys = document->GetRoot().GetChildren("survey");
  if (surveys.empty())
  {
    log.Error(document->GetRoot().Where() + ": the file has no <survey>; give a file that has one");
    return data;
  }
  if (surveys.size() > 1)
  {
    log.Warning(surveys[1].Where() + ": of several surveys in one file only the first is used");
  }
  SurveyReader(assets, log).Read(surveys.front(), data);
  data.Documents = assets.GetDocumentPaths();
  return data;
}

} // namespace helios
