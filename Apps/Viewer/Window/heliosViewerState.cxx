// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosViewerState.h"

#include "heliosCameraRig.h"
#include "heliosCloud.h"
#include "heliosCloudView.h"
#include "heliosColorNames.h"
#include "heliosHud.h"
#include "heliosPartFile.h"
#include "heliosPlatformView.h"
#include "heliosPlayClock.h"
#include "heliosRecorder.h"
#include "heliosSceneView.h"
#include "heliosSimulation.h"
#include "heliosViewerTool.h"

#include <vtkCamera.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>

#include <json/json.h>

#include <cmath>
#include <sstream>

namespace helios::viewer
{

namespace
{

Json::Value ToJson(const Vec3& v)
{
  Json::Value value(Json::arrayValue);
  for (int i = 0; i < 3; ++i)
  {
    value.append(v[i]);
  }
  return value;
}

const char* GetPhaseName(const Simulation* run)
{
  static const char* const names[] = { "loading", "running", "finished", "failed" };
  return run ? names[static_cast<int>(run->GetPhase())] : "none";
}

} // namespace

//------------------------------------------------------------------------------
Json::Value ViewerState::DescribeCamera() const
{
  vtkCamera* camera = this->Renderer->GetActiveCamera();
  const Vec3 origin = this->Origin;
  Json::Value value;
  value["mode"] = GetCameraModeName(this->Camera.GetMode());
  value["position"] = ToJson(Vec3(camera->GetPosition()) + origin);
  value["focalPoint"] = ToJson(Vec3(camera->GetFocalPoint()) + origin);
  value["viewUp"] = ToJson(Vec3(camera->GetViewUp()));
  value["parallel"] = camera->GetParallelProjection() != 0;
  value["scale"] = camera->GetParallelScale();
  value["viewAngle"] = camera->GetViewAngle();
  return value;
}

//------------------------------------------------------------------------------
Json::Value ViewerState::DescribeTime() const
{
  const PlayClock& clock = this->Clock;
  Json::Value value;
  value["time"] = clock.GetTime();
  value["start"] = clock.GetStart();
  value["end"] = clock.GetEnd();
  value["speed"] = std::isinf(clock.GetSpeed()) ? Json::Value("max") : clock.GetSpeed();
  value["playing"] = clock.IsPlaying();
  const Simulation* run = this->Running;
  value["phase"] = GetPhaseName(run);
  value["computed"] = run ? run->GetCollectedTime() : clock.GetEnd();
  value["pulses"] = Json::Int64(run ? run->GetCollectedPulses() : 0);
  value["computingSeconds"] = run ? run->GetComputingSeconds() : 0.0;
  value["pulsesPerSecond"] = this->PulsesPerSecond;
  Json::Value bar(Json::arrayValue); // fraction of window width, height from below
  const int* size = this->Window->GetSize();
  const Rect track = this->Words.GetTimeTrack();
  bar.append(static_cast<double>(track.X) / size[0]);
  bar.append(static_cast<double>(track.Right()) / size[0]);
  bar.append((track.Y + 0.5 * track.Height) / size[1]);
  value["bar"] = bar;
  return value;
}

//------------------------------------------------------------------------------
Json::Value ViewerState::DescribeCloud() const
{
  const CloudView& view = this->PointsView;
  Json::Value value;
  value["points"] = Json::Int64(this->Points.GetNumberOfPoints());
  value["drawn"] = Json::Int64(view.GetNumberOfDrawnPoints());
  value["bytes"] = Json::UInt64(this->Points.GetMemorySize() + view.GetMemorySize());
  value["colorBy"] = GetColorByName(view.GetColorBy());
  value["low"] = view.GetLow();
  value["high"] = view.GetHigh();
  value["pointSize"] = view.GetPointSize();
  value["eyeDome"] = view.GetEyeDomeLighting();
  value["clipping"] = view.GetClipping();
  return value;
}

//------------------------------------------------------------------------------
/// Returns the panels' rectangles: x and y of the lower left corner, width, height [pixels].
Json::Value ViewerState::DescribePanels() const
{
  Json::Value panels(Json::objectValue);
  for (std::size_t i = 0; i < NumberOfPanels; ++i)
  {
    const auto id = static_cast<PanelId>(i);
    const Rect& rect = this->Words.GetRect(id);
    for (const int value : { rect.X, rect.Y, rect.Width, rect.Height })
    {
      rect.IsEmpty() ? void() : void(panels[GetPanelName(id)].append(value));
    }
  }
  return panels;
}

//------------------------------------------------------------------------------
/// Describes the texts of the legend and of the panels, and the menus with their items.
void ViewerState::DescribeTexts(Json::Value& state) const
{
  const Legend& legend = this->Words.GetLegend();
  state["legend"]["title"] = legend.Title;
  state["legend"]["marks"] = Json::Value(Json::arrayValue);
  for (const Legend::Mark& mark : legend.Marks)
  {
    state["legend"]["marks"].append(mark.Text);
  }
  state["theme"] = this->Words.GetTheme().Name;
  state["scaleBar"] = this->Words.GetScaleBar().GetLabel();
  state["cursor"] = this->Words.GetCursor();
  state["textSize"] = this->Words.GetTextSize();
  state["openMenu"] = this->Words.GetMenuBar().GetOpen();
  this->DescribeDialog(state);
  state["menus"] = Json::Value(Json::arrayValue);
  for (const Menu& menu : this->Words.GetMenus())
  {
    Json::Value one;
    one["title"] = menu.Title;
    one["x"] = this->Words.GetMenuBar().GetTitlePosition(
      static_cast<int>(state["menus"].size()), this->Words.GetTextSize());
    for (const MenuItem& item : menu.Items)
    {
      one["items"].append(item.Text);
      item.IsOn&& item.IsOn() ? void(one["ticks"].append(item.Text)) : void();
    }
    state["menus"].append(one);
  }
}

//------------------------------------------------------------------------------
/// Describes the buttons with their centres [pixels], and the dialog of files.
void ViewerState::DescribeDialog(Json::Value& state) const
{
  const ToolBar& tools = this->Words.GetToolBar();
  const Rect& bar = this->Words.GetRect(PanelId::ToolBar);
  for (int i = 0; !bar.IsEmpty() && i < static_cast<int>(tools.GetButtons().size()); ++i)
  {
    const ToolButton& button = tools.GetButtons()[static_cast<std::size_t>(i)];
    const Rect place = tools.GetPlace(bar, i, this->Words.GetTextSize());
    Json::Value& one = state["buttons"][button.Text];
    one["on"] = button.IsOn && button.IsOn();
    one["x"] = place.X + place.Width / 2;
    one["y"] = place.Y + place.Height / 2;
  }
  state["tip"] = this->Words.GetTip();
  const FileDialog& dialog = this->Words.GetDialog();
  Json::Value& value = state["dialog"];
  value["open"] = dialog.IsOpen();
  value["folder"] = dialog.GetList().GetFolder();
  value["text"] = dialog.GetText();
  value["hint"] = dialog.GetHint();
  const FileEntry* selected = dialog.GetList().GetEntry();
  value["selected"] = selected ? selected->Name : "";
  const auto& entries = dialog.GetList().GetEntries();
  for (std::size_t i = 0; dialog.IsOpen() && i < entries.size(); ++i)
  {
    const Rect row = dialog.GetRow(
      this->Words.GetRect(PanelId::Dialog), static_cast<int>(i), this->Words.GetTextSize());
    Json::Value one;
    one["name"] = entries[i].Name;
    one["kind"] = entries[i].Kind;
    one["y"] = row.Y + row.Height / 2;
    one["x"] = row.X + row.Width / 2;
    value["entries"].append(one);
  }
}

//------------------------------------------------------------------------------
Json::Value ViewerState::Describe() const
{
  Json::Value state;
  const int* size = this->Window->GetSize();
  state["window"].append(size[0]);
  state["window"].append(size[1]);
  state["frames"] = Json::Int64(this->NumberOfFrames);
  state["framesPerSecond"] = this->FramesPerSecond;
  state["camera"] = this->DescribeCamera();
  state["time"] = this->DescribeTime();
  state["cloud"] = this->DescribeCloud();
  state["scene"] = this->Mesh && this->Mesh->IsVisible();
  state["voxels"] = Json::Int64(this->Mesh ? this->Mesh->GetNumberOfBoxes() : 0);
  state["beams"] = Json::Int64(
    this->Platform && this->Platform->IsFanVisible() ? this->Platform->GetNumberOfBeams() : 0);
  state["help"] = this->Words.IsHelpVisible();
  state["words"] = this->Words.GetText();
  state["panels"] = this->DescribePanels();
  this->DescribeTexts(state);
  state["message"] = this->Message;
  state["recording"] = this->Video.IsOpen();
  for (const auto& tool : this->Tools)
  {
    tool->Describe(state);
  }
  return state;
}

//------------------------------------------------------------------------------
void ViewerState::Write(const std::string& fileName) const
{
  if (fileName.empty())
  {
    return;
  }
  std::ostringstream text;
  text << this->Describe();
  static_cast<void>(WriteUnsynced(fileName, text.str())); // tests wait for the file
}

} // namespace helios::viewer
