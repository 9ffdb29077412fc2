// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosSurveyXml.h"

#include "heliosAssets.h"
#include "heliosMessages.h"
#include "heliosRunJournal.h"
#include "heliosXmlPlanner.h"
#include "heliosXmlSurvey.h"
#include "heliosXmlText.h"

#include <filesystem>

namespace fs = std::filesystem;

namespace helios
{

namespace
{

constexpr const char* SceneId = "scene";

std::string ToText(bool value)
{
  return value ? "true" : "false";
}

/// Adds the scene to the file if it is a mesh, or was edited.
std::string AddScene(pugi::xml_node root, const SurveyEdit& edit)
{
  pugi::xml_document document;
  const std::string mesh =
    edit.SceneText.empty() ? MakeMeshDocument(edit.Scene, SceneId) : std::string();
  if (!edit.SceneText.empty() && document.load_string(edit.SceneText.c_str()))
  {
    return root.append_copy(document.document_element()).attribute("id").value();
  }
  if (!mesh.empty() && document.load_string(mesh.c_str()))
  {
    root.append_copy(document.document_element().first_child());
    return SceneId;
  }
  return edit.Scene;
}

void AddPlatformSettings(pugi::xml_node node, const LegData& leg, bool isMoving)
{
  const LegData usual;
  SetAttribute(node, "x", leg.Position[0]);
  SetAttribute(node, "y", leg.Position[1]);
  SetAttribute(node, "z", leg.Position[2]);
  SetAttribute(node, "crs", leg.Crs);
  SetAttribute(node, "onGround", ToText(leg.OnGround));
  if (!isMoving)
  {
    return;
  }
  SetAttribute(node, "movePerSec_m", leg.Speed);
  SetAttribute(node, "stopAndTurn", ToText(leg.StopAndTurn));
  if (leg.SmoothTurn != usual.SmoothTurn)
  {
    SetAttribute(node, "smoothTurn", ToText(leg.SmoothTurn));
  }
  if (leg.SlowsDown != usual.SlowsDown)
  {
    SetAttribute(node, "slowdownEnabled", ToText(leg.SlowsDown));
  }
  SetAttribute(node, "yawAtDeparture_deg", leg.YawAtDeparture);
}

void AddScannerSettings(pugi::xml_node node, const LegSettings& settings)
{
  const ScanData& scan = settings.Scan;
  SetAttribute(node, "active", ToText(settings.Leg.Active));
  SetAttribute(node, "pulseFreq_hz", settings.PulseFrequency);
  SetAttribute(node, "scanFreq_hz", settings.ScanFrequency);
  SetAttribute(node, "scanAngle_deg", settings.ScanAngle);
  SetAttribute(node, "verticalAngleMin_deg", settings.VerticalAngleMin);
  SetAttribute(node, "verticalAngleMax_deg", settings.VerticalAngleMax);
  SetAttribute(node, "beamDivergence_rad", settings.BeamDivergence);
  const auto setIfNotZero = [node](const char* name, double value)
  { SetAttribute(node, name, value != 0.0 ? value : LegSettings::NotGiven); };
  setIfNotZero("headRotatePerSec_deg", scan.HeadRotateSpeed);
  setIfNotZero("headRotateStart_deg", scan.HeadRotateStart);
  setIfNotZero("headRotateStop_deg", scan.HeadRotateStop);
  setIfNotZero("verticalResolution_deg", settings.VerticalResolution);
  setIfNotZero("horizontalResolution_deg", settings.HorizontalResolution);
  setIfNotZero("opticsWarmupPhase_s", scan.WarmUpTime);
  setIfNotZero("trajectoryTimeInterval_s", settings.Leg.TrajectoryTimeInterval);
  if (settings.Leg.MaximumDuration >= 0.0)
  {
    SetAttribute(node, "maxDuration_s", settings.Leg.MaximumDuration);
  }
}

void AddSurvey(pugi::xml_node survey, const SurveyEdit& edit, const std::string& scene)
{
  SetAttribute(survey, "name", edit.Name);
  SetAttribute(survey, "scene", scene);
  SetAttribute(survey, "platform", edit.Platform);
  SetAttribute(survey, "scanner", edit.Scanner);
  for (const auto& attribute : edit.Attributes)
  {
    if (attribute.first != "seed" || edit.Seed < 0)
    {
      SetAttribute(survey, attribute.first.c_str(), attribute.second);
    }
  }
  SetAttribute(survey, "seed", edit.Seed < 0 ? "" : std::to_string(edit.Seed));
  pugi::xml_document more;
  if (more.load_string(edit.Children.c_str(), pugi::parse_default | pugi::parse_fragment))
  {
    for (const pugi::xml_node child : more.children())
    {
      survey.append_copy(child);
    }
  }
  for (const EditLeg& leg : edit.Legs)
  {
    pugi::xml_node node = survey.append_child("leg");
    SetAttribute(node, "stripId", leg.Settings.Leg.Strip);
    AddPlatformSettings(node.append_child("platformSettings"), leg.Settings.Leg, edit.IsMoving());
    AddScannerSettings(node.append_child("scannerSettings"), leg.Settings);
  }
}

} // namespace

//------------------------------------------------------------------------------
std::string MakeSurveyText(const SurveyEdit& edit)
{
  pugi::xml_document document;
  pugi::xml_node root = StartDocument(document, " A survey made by hand, written by vtkHelios. ");
  const std::string scene = AddScene(root, edit);
  AddSurvey(root.append_child("survey"), edit, scene);
  return ToXmlText(document);
}

//------------------------------------------------------------------------------
SurveyData ReadSurveyText(const std::string& fileName, const std::string& text,
  const std::vector<std::string>& assetDirectories, Messages& log)
{
  Assets assets(log, assetDirectories);
  return ReadSurvey(assets.Add(XmlDocument::Make(fileName, text, log)), assets, log);
}

//------------------------------------------------------------------------------
std::string SaveSurvey(const SurveyEdit& edit, const std::string& fileName,
  const std::vector<std::string>& assetDirectories, Messages& log)
{
  const std::string text = MakeSurveyText(edit);
  const int before = log.GetNumberOfErrors();
  ReadSurveyText(fileName, text, assetDirectories, log);
  if (log.GetNumberOfErrors() != before)
  {
    return fileName + ": not written: the survey could not be run: " + log.GetLastError();
  }
  return WriteWhole(fileName, text);
}

//------------------------------------------------------------------------------
std::string ReferTo(const std::string& path, const std::string& folder,
  const std::vector<std::string>& assetDirectories)
{
  const fs::path whole = fs::absolute(path).lexically_normal();
  std::vector<std::string> bases = assetDirectories;
  bases.push_back(folder.empty() ? "." : folder);
  for (const std::string& base : bases)
  {
    // A trailing slash of the folder would make its last part empty.
    const fs::path way = whole.lexically_relative(fs::absolute(base + "/.").lexically_normal());
    if (!way.empty() && way != "." && *way.begin() != "..")
    {
      return way.string();
    }
  }
  return whole.string();
}

} // namespace helios
