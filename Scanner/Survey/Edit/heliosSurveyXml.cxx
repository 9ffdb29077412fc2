// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosSurveyXml.h"

#include "heliosMessages.h"
#include "heliosStatus.h"
#include "heliosSurveyDocument.h"
#include "vtkHeliosSurvey.h"

#include <memory>

namespace helios
{

namespace
{

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
