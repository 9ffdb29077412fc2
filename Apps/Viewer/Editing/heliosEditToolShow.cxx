// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// The initial state of an edited survey, and its display.
#include "heliosEditTool.h"

#include "heliosEditArea.h"
#include "heliosEditDocument.h"
#include "heliosErrorText.h"
#include "heliosHud.h"
#include "heliosMessages.h"
#include "heliosSceneView.h"
#include "heliosSimulation.h"
#include "heliosViewer.h"
#include "heliosXmlValue.h"
#include "vtkHeliosDialect.h"
#include "vtkHeliosSurvey.h"

#include <vtkMath.h>
#include <vtkNew.h>

#include <json/json.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

namespace fs = std::filesystem;

namespace helios::viewer
{

namespace
{

constexpr int HeightSamples = 10; // places of a leg

/// Returns the platform of a leg, facing the next one or away from the last.
Pose FindPose(const SurveyEdit& edit, std::size_t leg)
{
  const Vec3 here = edit.Legs[leg].Settings.Leg.Position;
  const bool isLast = leg + 1 == edit.Legs.size();
  const std::size_t other = isLast ? (leg > 0 ? leg - 1 : 0) : leg + 1;
  const Vec3 way = (edit.Legs[other].Settings.Leg.Position - here) * (isLast ? -1.0 : 1.0);
  const bool isTurned = edit.IsMoving() && std::hypot(way[0], way[1]) > 0.0;
  const double heading = isTurned ? vtkMath::DegreesFromRadians(std::atan2(-way[0], way[1])) : 0.0;
  return { here, AxisAngle({ 0.0, 0.0, 1.0 }, heading) };
}

/// Trajectories and positions for PlatformView.
std::vector<SimulatedLeg> MakeTrajectories(const SurveyEdit& edit)
{
  std::vector<SimulatedLeg> trajectories;
  for (std::size_t i = 0; i < edit.Legs.size(); ++i)
  {
    SimulatedLeg leg;
    leg.Leg = static_cast<int>(i);
    leg.Positions.push_back(FindPose(edit, i).Position);
    trajectories.push_back(leg);
    if (edit.IsMoving() && i + 1 < edit.Legs.size())
    {
      leg.IsMoving = true;
      leg.Positions.push_back(FindPose(edit, i + 1).Position);
      trajectories.push_back(leg);
    }
  }
  return trajectories;
}

} // namespace

//------------------------------------------------------------------------------
/// Returns the source files of the shown data.
std::vector<std::string> EditTool::GetDocuments() const
{
  std::vector<std::string> files = this->Owner.GetOptions().Inputs;
  if (vtkHeliosSurvey* survey = this->Owner.GetSurvey())
  {
    const SurveyData& data = survey->GetData();
    files.insert(files.end(), data.Documents.begin(), data.Documents.end());
    for (const PartData& part : data.Scene.Parts)
    {
      files.insert(files.end(), part.Files.begin(), part.Files.end());
    }
  }
  return files;
}

//------------------------------------------------------------------------------
bool EditTool::Begin()
{
  if (!this->Owner.GetSceneView())
  {
    this->Owner.ShowMessage(
      "direct control needs a scene: open a survey or a scene, and wait for it");
    return false;
  }
  std::vector<std::string> files;
  for (const std::string& file : this->GetDocuments())
  {
    vtkHeliosDialect::IsDocument(file) ? files.push_back(file) : void();
  }
  this->Choice = ReadCatalogue(this->Owner.GetOptions().Assets, files);
  this->Scene = SceneEdit();
  this->HasBegun = this->Owner.GetSurvey() ? this->BeginWithSurvey() : this->BeginWithScene();
  this->Edit.Seed = this->Owner.GetOptions().Seed;
  if (this->HasBegun && this->LoadScene())
  {
    this->FirstScene = this->Scene.GetText();
  }
  return this->HasBegun;
}

//------------------------------------------------------------------------------
bool EditTool::BeginWithSurvey()
{
  const std::string left = EditSurvey(this->Owner.GetSurvey()->GetData(), this->Edit);
  this->FollowPlatform();
  this->FindGround();
  if (!left.empty())
  {
    this->Owner.ShowMessage(left);
  }
  return true;
}

//------------------------------------------------------------------------------
/// Sets height and speed to those of the survey. A platform that plays a trajectory back becomes the
/// one that it is based on, to be steered by hand.
void EditTool::FollowPlatform()
{
  const std::vector<SimulatedLeg>& legs = this->Owner.GetLegs();
  if (!this->Edit.IsMoving() || legs.empty() || legs.front().Positions.empty())
  {
    return;
  }
  const SimulatedLeg& leg = legs.front();
  double length = 0.0;
  for (std::size_t i = 1; i < leg.Positions.size(); ++i)
  {
    length += (leg.Positions[i] - leg.Positions[i - 1]).Norm();
  }
  if (this->Edit.PlatformModel.Type == PlatformType::Interpolated)
  {
    this->Edit.Settings.Leg.Speed =
      RoundComputed(length / std::max(1e-3, leg.EndTime - leg.StartTime));
    const auto& all = this->Choice.Platforms;
    auto base = std::find_if(all.begin(), all.end(),
      [&](const auto& entry) { return entry.second.Id == this->Edit.PlatformModel.Id; });
    base = base != all.end()
      ? base
      : std::find_if(all.begin(), all.end(),
          [&leg](const auto& entry) { return FindPlatformKind(entry.second) == leg.Kind; });
    if (base != all.end())
    {
      this->Edit.Platform = base->first;
      this->Edit.PlatformModel = base->second;
    }
  }
  std::vector<double> heights;
  for (int i = 1; i < HeightSamples; ++i)
  {
    const double share = static_cast<double>(i) / HeightSamples;
    const Vec3 place = leg.GetPose(leg.StartTime + share * (leg.EndTime - leg.StartTime)).Position;
    const auto height = this->Owner.GetSceneView()->FindHeight(place);
    height ? heights.push_back(*height) : void();
  }
  if (!heights.empty()) // their median: some may be above roofs
  {
    std::sort(heights.begin(), heights.end());
    SetFlownHeight(this->Edit, heights[heights.size() / 2]);
  }
}

//------------------------------------------------------------------------------
/// Legs on the ground are placed as in the run.
void EditTool::FindGround()
{
  Simulation* run = this->Owner.GetSimulation();
  for (std::size_t i = 0; run && !this->Edit.IsMoving() && i < this->Edit.Legs.size(); ++i)
  {
    for (const SimulatedLeg& leg : run->GetLegs())
    {
      if (leg.Leg == static_cast<int>(i) && !leg.Positions.empty())
      {
        this->Edit.Legs[i].Ground = leg.Positions.front()[2];
      }
    }
  }
}

//------------------------------------------------------------------------------
/// The first tripod of the catalogue, and the first rotating instrument.
bool EditTool::BeginWithScene()
{
  const fs::path input = fs::absolute(this->Owner.GetOptions().Inputs.front());
  this->Edit = SurveyEdit();
  this->Edit.Name = fs::path(this->Owner.GetOptions().Save).stem().string();
  this->Edit.Scene = input.string();
  for (const auto& entry : this->Choice.Platforms)
  {
    if (this->Edit.Platform.empty() && entry.second.Type == PlatformType::Static)
    {
      ChoosePlatform(this->Edit, entry.first, entry.second);
    }
  }
  for (const auto& entry : this->Choice.Scanners)
  {
    if (this->Edit.Scanner.empty() && entry.second.HeadRotateSpeedMax > 0.0)
    {
      ChooseScanner(this->Edit, entry.first, entry.second);
    }
  }
  if (this->Edit.Platform.empty() || this->Edit.Scanner.empty())
  {
    this->Owner.ShowError(
      "direct control needs a catalogue of platforms and scanners: give its folder with --assets");
    return false;
  }
  if (!this->LoadScene())
  {
    return false;
  }
  this->Edit.Scene += vtkHeliosDialect::IsDocument(input.string()) ? "#" + this->Scene.GetId() : "";
  return true;
}

//------------------------------------------------------------------------------
void EditTool::ShowPanel()
{
  const bool hasSliders = this->Doing != Mode::Parts;
  this->Panel->SetRanges(hasSliders ? FindRanges(this->Edit) : std::vector<EditRange>());
  this->Panel->ShowValues(this->Edit);
  this->Panel->SetHeading(this->MakeHeading());
  this->Panel->SetVisible(this->IsOn);
  SceneView* view = this->Owner.GetSceneView();
  int part = -1;
  double b[6];
  if (view)
  {
    this->FindMeshPart(part, b);
    view->SetHighlightedPart(part);
  }
  this->Owner.Redraw();
}

//------------------------------------------------------------------------------
std::string EditTool::MakeHeading() const
{
  if (this->Doing == Mode::Parts)
  {
    const std::string file =
      this->Files.empty() ? "none found" : fs::path(this->Files[this->File]).filename().string();
    return "Scene parts (M: back)\npart: " + (this->Part.empty() ? "click on one" : this->Part) +
      "\nadd (a, next: g): " + file +
      "\nmove: arrows, Shift-click\nrotate: < >   scale: * /\nremove: Delete";
  }
  std::string text = "Direct control\nTab: " + this->Edit.PlatformModel.Name +
    "\ng: " + this->Edit.ScannerModel.Name + "\n";
  text += this->Edit.IsMoving() ? "waypoints: " : "positions: ";
  text += std::to_string(this->Edit.Legs.size());
  text += this->Edit.HasArea ? ", flight lines\n" : "\n";
  text += this->Doing == Mode::Area ? "click two corners"
    : this->Edit.IsMoving()         ? "click: waypoint   A: lines\nReturn: scan   s: save"
                                    : "click: place   Shift: add\nReturn: scan   s: save";
  return text;
}

//------------------------------------------------------------------------------
/// The platform where it was placed, until it scans there.
void EditTool::ShowGhost()
{
  this->Ghost.reset();
  this->HasChanges = true;
  if (const Status status = FlyArea(this->Edit); !status.IsOk())
  {
    this->Owner.ShowMessage(status.Message());
  }
  if (PlatformView* last = this->Owner.GetPlatformView())
  {
    last->SetVisible(!this->IsOn);
    last->SetFanVisible(!this->IsOn && this->Owner.GetOptions().Fan);
  }
  if (this->IsOn && !this->Edit.Legs.empty())
  {
    this->Models = this->Models ? this->Models : std::make_shared<ModelFiles>();
    this->Ghost = std::make_unique<PlatformView>(
      this->Owner.GetRenderer(), this->Owner.GetOrigin(), this->Models);
    this->Ghost->SetTrajectories(MakeTrajectories(this->Edit));
    this->PlaceGhost();
  }
}

//------------------------------------------------------------------------------
void EditTool::PlaceGhost()
{
  const std::size_t index = this->Edit.HasArea ? 0 : this->Edit.Legs.size() - 1;
  SimulatedLeg leg;
  leg.Type = this->Edit.PlatformModel.Type;
  leg.Kind = FindPlatformKind(this->Edit.PlatformModel);
  leg.Kind = leg.Kind == PlatformKind::Unknown
    ? GuessPlatformKind(this->Edit.Height, this->Edit.Settings.Leg.Speed)
    : leg.Kind;
  leg.Mount = this->Edit.PlatformModel.Mount;
  leg.Model = this->Edit.PlatformModel.Model;
  leg.ScannerModel = this->Edit.ScannerModel.Model;
  this->Ghost->Place(leg, FindPose(this->Edit, index), leg.StartTime);
}

//------------------------------------------------------------------------------
void EditTool::Place()
{
  if (!this->Panel)
  {
    return;
  }
  const Hud& hud = this->Owner.GetHud();
  this->Panel->Place(hud.GetRect(PanelId::Editor), hud.GetTheme(), hud.GetTextSize());
}

//------------------------------------------------------------------------------
bool EditTool::OnFrame()
{
  if (!this->IsOn)
  {
    return false;
  }
  SceneView* view = this->Owner.GetSceneView();
  if (view && !this->Part.empty() && view->GetHighlightedPart() < 0)
  {
    this->ShowPanel(); // a new scan has a new view
  }
  if (this->Ghost)
  {
    this->PlaceGhost(); // scaled to be visible
  }
  return false;
}

//------------------------------------------------------------------------------
void EditTool::Describe(Json::Value& state) const
{
  static const char* const modes[] = { "scanner", "area", "parts" };
  Json::Value& editor = state["editor"];
  editor["on"] = this->IsOn;
  if (!this->HasBegun)
  {
    return;
  }
  editor["mode"] = modes[static_cast<int>(this->Doing)];
  editor["platform"] = this->Edit.Platform;
  editor["scanner"] = this->Edit.Scanner;
  editor["legs"] = Json::Value(Json::arrayValue);
  for (const EditLeg& leg : this->Edit.Legs)
  {
    const LegData& data = leg.Settings.Leg;
    Json::Value one;
    for (int i = 0; i < 3; ++i)
    {
      one["position"].append(i == 2 && !this->Edit.IsMoving() ? leg.Ground : data.Position[i]);
    }
    one["ground"] = leg.Ground;
    one["onGround"] = data.OnGround;
    one["active"] = data.Active;
    editor["legs"].append(one);
  }
  const int* size = this->Owner.GetWindow()->GetSize();
  editor["sliders"] = this->Panel ? this->Panel->Describe(size) : Json::Value(Json::objectValue);
  editor["part"] = this->Part;
  for (int i = 0; i < this->Scene.GetNumberOfParts(); ++i)
  {
    editor["parts"].append(this->Scene.GetPartName(i));
  }
  editor["file"] = this->Files.empty() ? "" : this->Files[this->File];
  editor["undos"] = Json::UInt64(this->UndoStack.size());
  editor["saved"] = this->Saved;
  editor["scans"] = this->Scans;
}

} // namespace helios::viewer
