// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosViewerKeys.h"

#include "heliosCloudView.h"
#include "heliosColorNames.h"
#include "heliosHud.h"
#include "heliosPlatformView.h"
#include "heliosSceneView.h"
#include "heliosSimulation.h"
#include "heliosTimeBar.h"
#include "heliosViewer.h"
#include "heliosViewerTool.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace helios::viewer
{

namespace
{

constexpr double StepSeconds = 0.1; // if the scan has no lines
constexpr std::size_t KeyWidth = 16;

/// Moves forward or back by the time of a scan line.
void Step(Viewer& viewer, int lines)
{
  PlayClock& clock = viewer.GetClock();
  clock.SetPlaying(false);
  const SimulatedLeg* leg = FindLeg(viewer.GetLegs(), clock.GetTime());
  const double seconds = leg && leg->LineFrequency > 0.0 ? 1.0 / leg->LineFrequency : StepSeconds;
  clock.Seek(clock.GetTime() + lines * seconds);
}

void ChangeColors(Viewer& viewer, int step)
{
  const auto& all = GetColorings();
  const auto now = std::find_if(all.begin(), all.end(),
    [&viewer](const auto& coloring)
    { return coloring.second == viewer.GetCloudView().GetColorBy(); });
  const auto count = static_cast<int>(all.size());
  const int next = (static_cast<int>(now - all.begin()) + step + count) % count;
  viewer.GetCloudView().SetColorBy(all[static_cast<std::size_t>(next)].second);
  viewer.Tell("colours: " + all[static_cast<std::size_t>(next)].first);
}

/// Half of the cloud's box in each direction, about its centre.
void ToggleClipping(Viewer& viewer)
{
  CloudView& view = viewer.GetCloudView();
  double b[6];
  if (view.GetClipping() || !viewer.GetCloud().GetBounds(b))
  {
    view.SetClipping(false);
    return;
  }
  for (int i = 0; i < 6; i += 2)
  {
    const double quarter = 0.25 * (b[i + 1] - b[i]);
    b[i] += i < 4 ? quarter : 0.0;
    b[i + 1] -= i < 4 ? quarter : 0.0;
  }
  view.SetClipBox(b);
  view.SetClipping(true);
}

/// The lines as a column of equal lengths: they are centred as one block.
std::string JoinColumns(const std::vector<std::string>& lines)
{
  std::size_t width = 0;
  for (const std::string& line : lines)
  {
    width = std::max(width, line.size() + 1);
  }
  std::string text;
  for (const std::string& line : lines)
  {
    text += line + std::string(width - line.size(), ' ') + "\n";
  }
  return text;
}

void ChangePointSize(Viewer& viewer, double step)
{
  CloudView& view = viewer.GetCloudView();
  view.SetPointSize(std::clamp(view.GetPointSize() + step, 1.0, 20.0));
}

} // namespace

//------------------------------------------------------------------------------
ViewerKeys::ViewerKeys(Viewer& viewer, const std::vector<std::unique_ptr<ViewerTool>>& tools)
  : Owner(viewer)
  , Tools(tools)
{
  this->AddTime();
  this->AddCameras();
  this->AddLook();
  this->AddFiles();
}

//------------------------------------------------------------------------------
void ViewerKeys::AddTime()
{
  Viewer& viewer = this->Owner;
  PlayClock& clock = viewer.GetClock();
  this->Actions.push_back({ "Time", { "space" }, "space", "play, pause",
    [&clock]
    {
      const bool isAtEnd = !clock.IsPlaying() && clock.GetTime() >= clock.GetEnd();
      clock.SetPlaying(!clock.IsPlaying());
      isAtEnd ? clock.Seek(clock.GetStart()) : void();
    } });
  this->Actions.push_back(
    { "", { "period" }, ".", "forward by one scan line", [&viewer] { Step(viewer, 1); } });
  this->Actions.push_back(
    { "", { "comma" }, ",", "back by one scan line", [&viewer] { Step(viewer, -1); } });
  this->Actions.push_back({ "", { "plus", "equal", "KP_Add" }, "+", "faster, up to the maximum",
    [&clock] { clock.ChangeSpeed(1); } });
  this->Actions.push_back(
    { "", { "minus", "KP_Subtract" }, "-", "slower", [&clock] { clock.ChangeSpeed(-1); } });
  this->Actions.push_back({ "", { "1" }, "1", "real time", [&clock] { clock.SetSpeed(1.0); } });
  this->Actions.push_back(
    { "", { "Home" }, "Home", "to the start", [&clock] { clock.Seek(clock.GetStart()); } });
  this->Actions.push_back(
    { "", { "End" }, "End", "to the end", [&clock] { clock.Seek(clock.GetEnd()); } });
}

//------------------------------------------------------------------------------
void ViewerKeys::AddCameras()
{
  Viewer& viewer = this->Owner;
  const auto add = [this, &viewer](
                     const char* heading, const char* key, const char* what, CameraMode mode)
  {
    this->Actions.push_back(
      { heading, { key }, key, what, [&viewer, mode] { viewer.SetCameraMode(mode); } });
  };
  add("Camera", "c", "free: drag turns, wheel zooms, middle button moves", CameraMode::Free);
  add("", "y", "fly: left button forward, right button back", CameraMode::Fly);
  add("", "f", "follow the platform", CameraMode::Follow);
  add("", "v", "scanner view", CameraMode::Scanner);
  add("", "t", "from above, north up", CameraMode::Top);
  add("", "x", "from the side, looking north", CameraMode::Side);
  add("", "o", "orbit", CameraMode::Orbit);
  this->Actions.push_back({ "", { "r" }, "r", "show all",
    [&viewer]
    {
      viewer.GetCamera().Reset();
      viewer.Redraw();
    } });
}

//------------------------------------------------------------------------------
void ViewerKeys::AddLook()
{
  Viewer& viewer = this->Owner;
  this->Actions.push_back(
    { "Display", { "k" }, "k", "next colours", [&viewer] { ChangeColors(viewer, 1); } });
  this->Actions.push_back(
    { "", { "K" }, "K", "previous colours", [&viewer] { ChangeColors(viewer, -1); } });
  this->Actions.push_back(
    { "", { "bracketright" }, "]", "larger points", [&viewer] { ChangePointSize(viewer, 1.0); } });
  this->Actions.push_back(
    { "", { "bracketleft" }, "[", "smaller points", [&viewer] { ChangePointSize(viewer, -1.0); } });
  this->Actions.push_back({ "", { "e" }, "e", "eye-dome lighting (EDL)",
    [&viewer]
    { viewer.GetCloudView().SetEyeDomeLighting(!viewer.GetCloudView().GetEyeDomeLighting()); } });
  this->Actions.push_back(
    { "", { "b" }, "b", "clipping box: the middle half", [&viewer] { ToggleClipping(viewer); } });
  this->Actions.push_back({ "", { "m" }, "m", "the scene's mesh",
    [&viewer]
    {
      SceneView* scene = viewer.GetSceneView();
      scene ? scene->SetVisible(!scene->IsVisible()) : void();
    } });
  this->Actions.push_back({ "", { "l" }, "l", "the beams",
    [&viewer]
    {
      PlatformView* platform = viewer.GetPlatformView();
      platform ? platform->SetFanVisible(!platform->IsFanVisible()) : void();
    } });
  this->Actions.push_back({ "", { "w" }, "w", "text and time bar",
    [&viewer]
    {
      const bool isVisible = !viewer.GetHud().IsVisible();
      viewer.GetHud().SetVisible(isVisible);
      viewer.GetCloudView().SetScalarBarVisible(isVisible);
      viewer.GetTimeBar() ? viewer.GetTimeBar()->SetVisible(isVisible) : void();
    } });
}

//------------------------------------------------------------------------------
void ViewerKeys::AddFiles()
{
  Viewer& viewer = this->Owner;
  this->Actions.push_back({ "Files", { "p" }, "p", "save a picture, vtkhelios.png",
    [&viewer] { viewer.SaveStill("vtkhelios.png"); } });
  this->Actions.push_back({ "", { "R" }, "R", "start, stop recording vtkhelios.ogv",
    [&viewer] { viewer.ToggleRecording(); } });
  this->Actions.push_back({ "", { "h", "question", "F1" }, "h", "this help",
    [&viewer]
    {
      viewer.GetHud().SetHelpVisible(!viewer.GetHud().IsHelpVisible());
      viewer.Redraw();
    } });
  this->Actions.push_back({ "", { "q" }, "q", "quit", [&viewer] { viewer.Close(); } });
}

//------------------------------------------------------------------------------
bool ViewerKeys::Press(const std::string& key, bool control)
{
  for (const auto& tool : this->Tools)
  {
    if (tool->OnKey(key, control))
    {
      return true;
    }
  }
  for (const Action& action : this->Actions)
  {
    if (!control && std::find(action.Keys.begin(), action.Keys.end(), key) != action.Keys.end())
    {
      action.Do();
      return true;
    }
  }
  return false;
}

//------------------------------------------------------------------------------
std::string ViewerKeys::GetHelp() const
{
  std::vector<std::string> lines;
  const auto add = [&lines](const std::string& key, const std::string& what)
  {
    const std::size_t gap = key.size() < KeyWidth ? KeyWidth - key.size() : 1;
    lines.push_back("   " + key + std::string(gap, ' ') + what);
  };
  for (const Action& action : this->Actions)
  {
    if (!action.Heading.empty())
    {
      lines.push_back(" " + action.Heading);
    }
    add(action.Shown, action.What);
  }
  for (const auto& tool : this->Tools)
  {
    lines.push_back(" " + tool->GetName());
    for (const KeyHelp& key : tool->GetKeys())
    {
      add(key.first, key.second);
    }
  }
  return JoinColumns(lines);
}

} // namespace helios::viewer
