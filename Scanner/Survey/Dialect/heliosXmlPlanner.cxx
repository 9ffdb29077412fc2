// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosXmlPlanner.h"

#include "heliosAssets.h"
#include "heliosEpochs.h"
#include "heliosMessages.h"
#include "heliosPartMotions.h"
#include "heliosPlannerScan.h"
#include "heliosXmlCheck.h"
#include "heliosXmlFilter.h"
#include "heliosXmlLeg.h"
#include "heliosXmlPlatform.h"
#include "heliosXmlRules.h"
#include "heliosXmlScanner.h"
#include "heliosXmlScene.h"
#include "heliosXmlSurvey.h"

#include <algorithm>
#include <filesystem>

namespace helios
{
namespace fs = std::filesystem;

namespace
{

constexpr double NotGiven = std::numeric_limits<double>::quiet_NaN();

/// Settings with limits that are not given.
PlannerSettings MakeSettings()
{
  PlannerSettings settings;
  settings.RangeMin = settings.RangeMax = NotGiven;
  settings.ElevationMin = settings.ElevationMax = NotGiven;
  return settings;
}

const std::string& Either(const std::string& first, const std::string& second)
{
  return first.empty() ? second : first;
}

/// Names parts: "part car", "parts a, b, c and 4 more".
std::string NameParts(const std::vector<std::string>& names)
{
  constexpr std::size_t Most = 3;
  std::vector<std::string> shown(names.begin(), names.begin() + std::min(Most, names.size()));
  if (names.size() > Most)
  {
    shown.push_back(std::to_string(names.size() - Most) + " more");
  }
  return (names.size() == 1 ? "part " : "parts ") + JoinChoices(shown);
}

/// Reads one file.
class PlannerReader
{
public:
  PlannerReader(const PlannerRequest& request, Assets& assets, Messages& log)
    : Request(request)
    , Files(assets)
    , Log(log)
    , ErrorsBefore(log.GetNumberOfErrors())
  {
  }

  void ReadPlanner(const XmlElement& planner, PlannerData& data);
  void ReadSurvey(PlannerData& data);
  void ReadScene(const XmlElement& scene, PlannerData& data);

private:
  void ReadSettings(const XmlElement& planner, PlannerSettings& settings);
  void CheckLimits(const XmlElement& planner, const PlannerSettings& settings);
  void ReadPlatformOf(const XmlElement& element, PlannerData& data);
  void ReadScannerOf(const XmlElement& element, PlannerData& data);
  XmlElement FindAsset(const XmlElement& from, const char* tag, const std::string& asked);
  void Conclude(const LegSettings& settings, PlannerData& data);
  void CheckPlatform(const PlatformData& platform);
  void CheckHeight(PlannerData& data);
  void WarnOfScene(const SceneData& scene);
  void SelectParts(PlannerData& data);
  bool HasError() const { return this->Log.GetNumberOfErrors() > this->ErrorsBefore; }

  const PlannerRequest& Request;
  Assets& Files;
  Messages& Log;
  int ErrorsBefore;
};

//------------------------------------------------------------------------------
void PlannerReader::ReadPlanner(const XmlElement& planner, PlannerData& data)
{
  planner.CheckNames();
  data.Kind = "planner";
  const std::string name = planner.GetText("name");
  const std::string id = planner.GetText("id");
  data.Survey.Name = MakeFolderName(!name.empty() ? name : !id.empty() ? id : data.Survey.Name);
  this->ReadSettings(planner, data.Settings);
  this->CheckLimits(planner, data.Settings);
  const XmlElement scene =
    this->Request.HasScene ? XmlElement() : this->FindAsset(planner, "scene", "");
  if (scene)
  {
    data.Survey.Scene = helios::ReadScene(scene, this->Files);
  }
  this->ReadPlatformOf(this->FindAsset(planner, "platform", this->Request.Platform), data);
  this->ReadScannerOf(this->FindAsset(planner, "scanner", this->Request.Scanner), data);
  LegSettings settings;
  settings.Leg.Where = planner.Where();
  if (const XmlElement child = planner.GetChild("scannerSettings"))
  {
    settings = ReadScannerSettings(child, this->Files);
  }
  this->Conclude(settings, data);
}

//------------------------------------------------------------------------------
void PlannerReader::ReadSettings(const XmlElement& planner, PlannerSettings& settings)
{
  settings.Method = "reduce";
  planner.ReadStored(settings);
  if (!planner.Has("gridSizePSPy_m"))
  {
    settings.PositionStep[1] = settings.PositionStep[0];
  }
  if (!planner.Has("gridSizeVTP_m"))
  {
    settings.TestPointStep = settings.PositionStep[0];
  }
  settings.GroundOnly = settings.GroundOnly == "1" ? "true"
    : settings.GroundOnly == "0"                   ? "false"
                                                   : settings.GroundOnly;
}

//------------------------------------------------------------------------------
void PlannerReader::CheckLimits(const XmlElement& planner, const PlannerSettings& settings)
{
  const auto check = [&](const char* lowName, double low, const char* highName, double high)
  {
    MessageBuilder text;
    text << planner.Where() << ": " << lowName << "=\"" << low << "\" is not below " << highName
         << "=\"" << high << "\", so nothing is visible; give a smaller one";
    if (low >= high) // false for NaN: not given
    {
      this->Log.Error(text.str());
    }
  };
  check("rangeMin_m", settings.RangeMin, "rangeMax_m", settings.RangeMax);
  check("elevationMin_deg", settings.ElevationMin, "elevationMax_deg", settings.ElevationMax);
}

//------------------------------------------------------------------------------
void PlannerReader::ReadSurvey(PlannerData& data)
{
  Assets assets(this->Log, this->Request.AssetDirectories);
  SurveyData survey = helios::ReadSurvey(assets.Load(this->Request.FileName), assets, this->Log);
  if (this->HasError())
  {
    return;
  }
  data.Kind = "survey";
  std::size_t leg = 0;
  while (leg + 1 < survey.Legs.size() && !survey.Fires(leg))
  {
    ++leg;
  }
  const XmlElement root = this->Files.Load(this->Request.FileName)->GetRoot();
  const XmlElement element = root.GetChild("survey");
  const PlatformData platform = survey.GetPlatform(leg);
  const ScannerData scanner = survey.GetScanner(leg);
  const bool keepsScanner = this->Request.Scanner.empty();
  const LegSettings settings =
    keepsScanner ? MakeSettings(survey.Legs[leg].Scans.front()) : LegSettings();
  data.Survey = std::move(survey);
  data.Survey.Platforms = { platform };
  data.Survey.Scanners = { scanner };
  if (!this->Request.Platform.empty())
  {
    this->ReadPlatformOf(this->FindAsset(element, "platform", this->Request.Platform), data);
  }
  if (!keepsScanner)
  {
    this->ReadScannerOf(this->FindAsset(element, "scanner", this->Request.Scanner), data);
  }
  this->Conclude(settings, data);
}

//------------------------------------------------------------------------------
void PlannerReader::ReadScene(const XmlElement& scene, PlannerData& data)
{
  if (!this->Request.HasScene)
  {
    data.Survey.Scene = helios::ReadScene(scene, this->Files);
  }
  this->ReadPlatformOf(this->FindAsset(scene, "platform",
                         Either(this->Request.Platform, this->Request.DefaultPlatform)),
    data);
  this->ReadScannerOf(
    this->FindAsset(scene, "scanner", Either(this->Request.Scanner, this->Request.DefaultScanner)),
    data);
  LegSettings settings;
  settings.Leg.Where = scene.Where();
  this->Conclude(settings, data);
}

//------------------------------------------------------------------------------
/// Returns the asset named by the caller, else by the element.
XmlElement PlannerReader::FindAsset(
  const XmlElement& from, const char* tag, const std::string& asked)
{
  if (!asked.empty())
  {
    static const std::string scene = "scene"; // without a file
    return this->Files.FindElement(
      tag, { tag, asked, Either(this->Request.FileName, scene) }, from.GetDocument());
  }
  const bool isScene = from.GetTag() == "scene";
  if (!isScene && from.Has(tag))
  {
    return this->Files.FindElement(tag, from, tag);
  }
  this->Log.Error(from.Where() + ": " +
    (isScene ? std::string("a scene has no ") + tag + ", and none was given; give one, "
             : "<" + from.GetTag() + "> has no attribute " + tag + "; add " + tag + "=") +
    "\"file.xml#id\"");
  return {};
}

//------------------------------------------------------------------------------
void PlannerReader::ReadPlatformOf(const XmlElement& element, PlannerData& data)
{
  data.Survey.Platforms = { element ? ReadPlatform(element) : PlatformData() };
}

//------------------------------------------------------------------------------
void PlannerReader::ReadScannerOf(const XmlElement& element, PlannerData& data)
{
  const int before = this->Log.GetNumberOfErrors();
  data.Survey.Scanners = { element ? ReadScanner(element, this->Files) : ScannerData() };
  if (element && this->Log.GetNumberOfErrors() == before)
  {
    CheckScanner(data.Survey.Scanners.front(), this->Log);
  }
}

//------------------------------------------------------------------------------
void PlannerReader::Conclude(const LegSettings& settings, PlannerData& data)
{
  if (this->HasError())
  {
    return; // avoids consequential errors
  }
  const PlatformData& platform = data.Survey.Platforms.front();
  const ScannerData& scanner = data.Survey.Scanners.front();
  this->CheckPlatform(platform);
  data.Settings.HasScannerLimits = data.Settings.HasScannerLimits || this->Request.UseScannerLimits;
  if (this->HasError() || !ResolveScan(settings, this->Request, data, this->Log))
  {
    return;
  }
  ResolveLimits(data, this->Log);
  data.Instrument = FindInstrument(platform, scanner);
  this->CheckHeight(data);
  data.SceneReference = this->Request.HasScene
    ? std::string()
    : MakeReference(data.Survey.Scene.File, data.Survey.Scene.Id);
  data.PlatformReference = MakeReference(platform.File, platform.Id);
  data.ScannerReference = MakeReference(scanner.File, scanner.Id);
  this->WarnOfScene(data.Survey.Scene);
  data.Survey = MakeEpoch(data.Survey, 0);
  this->SelectParts(data);
}

//------------------------------------------------------------------------------
/// Warns of parts of a scene that a plan ignores.
void PlannerReader::WarnOfScene(const SceneData& scene)
{
  const int epochs = CountEpochs(scene);
  if (epochs > 1)
  {
    this->Log.Warning(scene.Where + ": the scene swaps parts: the plan uses the first of its " +
      std::to_string(epochs) + " epochs");
  }
  for (const PartData& part : scene.Parts)
  {
    if (part.IsTurbid())
    {
      this->Log.Warning(part.Where + ": part " + part.Name +
        " is turbid and hides nothing in a plan; for an opaque part, give intersectionMode fixed "
        "or scaled");
    }
  }
}

//------------------------------------------------------------------------------
/// Leaves out the parts that move, unless they are asked for; warns of either.
void PlannerReader::SelectParts(PlannerData& data)
{
  SceneData& scene = data.Survey.Scene;
  data.Settings.HasMovingParts = data.Settings.HasMovingParts || this->Request.UseMovingParts;
  const std::set<std::size_t> moving = FindMoving(scene.Parts);
  if (moving.empty())
  {
    return;
  }
  std::vector<std::string> names;
  std::vector<PartData> others;
  for (std::size_t i = 0; i < scene.Parts.size(); ++i)
  {
    moving.count(i) > 0 ? names.push_back(scene.Parts[i].Name) : others.push_back(scene.Parts[i]);
  }
  const std::string who = NameParts(names);
  if (data.Settings.HasMovingParts)
  {
    this->Log.Warning(
      scene.Where + ": the plan has " + who + ", which move, where they are at the start");
  }
  else if (others.empty())
  {
    this->Log.Error(scene.Where + ": all parts of the scene move (" + who +
      "), and a plan leaves them out; set UseMovingParts (--moving-parts) to plan with them where "
      "they are at the start");
  }
  else
  {
    this->Log.Warning(scene.Where + ": the plan leaves out " + who +
      ", which move; set UseMovingParts (--moving-parts) to plan with them where they are at the "
      "start");
    scene.Parts = others;
  }
}

//------------------------------------------------------------------------------
void PlannerReader::CheckPlatform(const PlatformData& platform)
{
  if (platform.Type != PlatformType::Static)
  {
    this->Log.Error(platform.Where + ": platform " + platform.Name +
      " moves, but positions are planned for a static one; give a platform of "
      "type=\"static\", such as platforms.xml#tripod");
  }
}

//------------------------------------------------------------------------------
void PlannerReader::CheckHeight(PlannerData& data)
{
  if (data.Settings.ScannerHeight > 0.0)
  {
    return;
  }
  data.Settings.ScannerHeight = data.Instrument[2];
  if (data.Settings.ScannerHeight < 1e-6)
  {
    MessageBuilder text;
    text << data.Survey.Platforms.front().Where << ": platform "
         << data.Survey.Platforms.front().Name << " carries the scanner "
         << data.Settings.ScannerHeight
         << " m above the scan position, but the height must be above 0; give it a <scannerMount> "
            "with a larger z, or give scannerHeight_m";
    this->Log.Error(text.str());
  }
}

void WarnOfSeveral(const std::vector<XmlElement>& elements, Messages& log)
{
  if (elements.size() > 1)
  {
    log.Warning(elements[1].Where() + ": of several <" + elements[1].GetTag() +
      "> in one file only the first is used");
  }
}

} // namespace

//------------------------------------------------------------------------------
PlannerData ReadPlanner(const PlannerRequest& request, Messages& log)
{
  PlannerData data;
  data.Settings = MakeSettings();
  data.Survey.FileName = request.FileName;
  data.Survey.Name = MakeFolderName(fs::path(request.FileName).stem().string());
  Assets assets(log, request.AssetDirectories);
  PlannerReader reader(request, assets, log);
  if (request.FileName.empty())
  {
    data.Survey.Name = "plan";
    const auto document =
      XmlDocument::Make("scene", "<document><scene id=\"scene\"/></document>", log);
    reader.ReadScene(document->GetRoot().GetChild("scene"), data);
    return data;
  }
  if (!MakeMeshDocument(request.FileName, {}).empty())
  {
    std::error_code ignored;
    if (!fs::is_regular_file(request.FileName, ignored))
    {
      log.Error(request.FileName + ": no such file; give the name of an existing mesh");
      return data;
    }
    const std::string text =
      MakeMeshDocument(fs::absolute(request.FileName).string(), data.Survey.Name);
    const auto document = XmlDocument::Make(request.FileName, text, log);
    reader.ReadScene(document->GetRoot().GetChild("scene"), data);
    data.SceneReference.clear();
    return data;
  }
  const XmlDocument* document = assets.Load(request.FileName);
  if (!document)
  {
    return data;
  }
  const std::vector<XmlElement> planners = document->GetRoot().GetChildren("surveyPlanner");
  const std::vector<XmlElement> scenes = document->GetRoot().GetChildren("scene");
  if (!planners.empty())
  {
    WarnOfSeveral(planners, log);
    reader.ReadPlanner(planners.front(), data);
  }
  else if (document->GetRoot().GetChild("survey"))
  {
    reader.ReadSurvey(data);
  }
  else if (!scenes.empty())
  {
    WarnOfSeveral(scenes, log);
    reader.ReadScene(scenes.front(), data);
  }
  else
  {
    log.Error(document->GetRoot().Where() +
      ": the file has nothing to plan; give one with a <surveyPlanner>, <survey> or <scene>, or a "
      "mesh (" +
      GetMeshEndings() + ")");
  }
  return data;
}

//------------------------------------------------------------------------------
void CheckPlanner(const XmlElement& planner, Assets& assets, Messages& log)
{
  PlannerData data;
  data.Settings = MakeSettings();
  const PlannerRequest request;
  PlannerReader(request, assets, log).ReadPlanner(planner, data);
  CheckSurveyNames(data.Survey, planner.Where(), log);
}

//------------------------------------------------------------------------------
std::string MakeReference(const std::string& file, const std::string& id)
{
  return file + "#" + id;
}

} // namespace helios
