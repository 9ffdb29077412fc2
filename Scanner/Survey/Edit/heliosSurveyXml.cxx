// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosSurveyXml.h"

#include "heliosMessages.h"
#include "heliosPartFile.h"
#include "heliosStatus.h"
#include "heliosSurveyDocument.h"
#include "heliosXmlFilter.h"
#include "heliosXmlText.h"
#include "vtkHeliosSurvey.h"

namespace helios
{

namespace
{

constexpr const char* SceneId = "scene";

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
    const LegSettings settings = edit.IsMoving() ? leg.Settings : MakeStill(leg.Settings);
    SetStored(node.append_child("platformSettings"), settings);
    SetStored(node.append_child("scannerSettings"), settings);
    SetAttribute(node, "stripId", settings.Leg.Strip);
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
bool ReadEdit(const SurveyEdit& edit, const std::string& fileName,
  const std::vector<std::string>& assetDirectories, vtkHeliosSurvey* survey)
{
  auto document = std::make_unique<SurveyDocument>(survey);
  document->SetAssetDirectories(assetDirectories);
  document->SetNeeds(AssetNeed::Required, AssetNeed::Required);
  return document->Load(fileName, MakeSurveyText(edit)) &&
    survey->ReadDocument(std::move(document), survey);
}

//------------------------------------------------------------------------------
Status SaveSurvey(const SurveyEdit& edit, const std::string& fileName,
  const std::vector<std::string>& assetDirectories, Messages& log)
{
  const std::string text = MakeSurveyText(edit);
  SurveyDocument document(nullptr);
  document.SetAssetDirectories(assetDirectories);
  document.SetNeeds(AssetNeed::Required, AssetNeed::Required);
  document.Load(fileName, text);
  document.Resolve(nullptr);
  if (document.HasError())
  {
    log.Error(document.GetLastError());
    return Status::Error(
      fileName + ": not written: the survey could not be run: " + document.GetLastError());
  }
  return WriteWhole(fileName, text);
}

} // namespace helios
