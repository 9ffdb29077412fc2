// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Actions of the keys.
#include "heliosViewer.h"

#include "heliosCloudView.h"
#include "heliosColorNames.h"
#include "heliosHud.h"
#include "heliosPlatformView.h"
#include "heliosSceneView.h"
#include "heliosSimulation.h"
#include "heliosTheme.h"
#include "heliosViewerKeys.h"
#include "heliosViewerTool.h"

#include <algorithm>
#include <memory>

namespace helios::viewer
{

namespace
{

constexpr double StepSeconds = 0.1; // if the scan has no lines

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
  viewer.ShowMessage("colours: " + all[static_cast<std::size_t>(next)].first);
}

/// Clips to half of the cloud's box in each direction, about its centre.
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

void ChangePointSize(Viewer& viewer, double step)
{
  CloudView& view = viewer.GetCloudView();
  view.SetPointSize(std::clamp(view.GetPointSize() + step, 1.0, 20.0));
}

void AddTime(Viewer& viewer, ViewerKeys& keys)
{
  PlayClock& clock = viewer.GetClock();
  keys.Add({ "Time", { "space" }, "space", "play, pause",
    [&clock]
    {
      const bool isAtEnd = !clock.IsPlaying() && clock.GetTime() >= clock.GetEnd();
      clock.SetPlaying(!clock.IsPlaying());
      isAtEnd ? clock.Seek(clock.GetStart()) : void();
    } });
  keys.Add({ "", { "period" }, ".", "forward by one scan line", [&viewer] { Step(viewer, 1); } });
  keys.Add({ "", { "comma" }, ",", "back by one scan line", [&viewer] { Step(viewer, -1); } });
  keys.Add({ "", { "plus", "equal", "KP_Add" }, "+", "faster, up to the maximum",
    [&clock] { clock.ChangeSpeed(1); } });
  keys.Add({ "", { "minus", "KP_Subtract" }, "-", "slower", [&clock] { clock.ChangeSpeed(-1); } });
  keys.Add({ "", { "1" }, "1", "real time", [&clock] { clock.SetSpeed(1.0); } });
  keys.Add({ "", { "Home" }, "Home", "to the start", [&clock] { clock.Seek(clock.GetStart()); } });
  keys.Add({ "", { "End" }, "End", "to the end", [&clock] { clock.Seek(clock.GetEnd()); } });
}

void AddCameras(Viewer& viewer, ViewerKeys& keys)
{
  const auto add = [&keys, &viewer](
                     const char* heading, const char* key, const char* what, CameraMode mode)
  {
    keys.Add({ heading, { key }, key, what, [&viewer, mode] { viewer.SetCameraMode(mode); },
      [&viewer, mode] { return viewer.GetCamera().GetMode() == mode; } });
  };
  add("Camera", "c", "free: drag turns, wheel zooms, middle button moves", CameraMode::Free);
  add("", "y", "fly: left button forward, right button back", CameraMode::Fly);
  add("", "f", "follow the platform", CameraMode::Follow);
  add("", "v", "scanner view", CameraMode::Scanner);
  add("", "t", "from above, north up", CameraMode::Top);
  add("", "x", "from the side, looking north", CameraMode::Side);
  add("", "o", "orbit", CameraMode::Orbit);
  keys.Add({ "", { "r" }, "r", "show all", [&viewer] { viewer.ResetCamera(); } });
}

void AddColors(Viewer& viewer, ViewerKeys& keys)
{
  keys.Add({ "Colours", { "k" }, "k", "next colours", [&viewer] { ChangeColors(viewer, 1); } });
  keys.Add({ "", { "K" }, "K", "previous colours", [&viewer] { ChangeColors(viewer, -1); } });
  for (const auto& coloring : GetColorings())
  {
    keys.Add({ "", {}, "", GetColorTitle(coloring.second),
      [&viewer, by = coloring.second] { viewer.GetCloudView().SetColorBy(by); },
      [&viewer, by = coloring.second] { return viewer.GetCloudView().GetColorBy() == by; } });
  }
}

void AddLook(Viewer& viewer, ViewerKeys& keys)
{
  keys.Add({ "Display", { "bracketright" }, "]", "larger points",
    [&viewer] { ChangePointSize(viewer, 1.0); } });
  keys.Add(
    { "", { "bracketleft" }, "[", "smaller points", [&viewer] { ChangePointSize(viewer, -1.0); } });
  keys.Add({ "", { "e" }, "e", "eye-dome lighting (EDL)",
    [&viewer]
    { viewer.GetCloudView().SetEyeDomeLighting(!viewer.GetCloudView().GetEyeDomeLighting()); },
    [&viewer] { return viewer.GetCloudView().GetEyeDomeLighting(); } });
  keys.Add(
    { "", { "b" }, "b", "clipping box: the middle half", [&viewer] { ToggleClipping(viewer); },
      [&viewer] { return viewer.GetCloudView().GetClipping(); } });
  keys.Add({ "", { "m" }, "m", "the scene's mesh",
    [&viewer]
    {
      SceneView* scene = viewer.GetSceneView();
      scene ? scene->SetVisible(!scene->IsVisible()) : void();
    },
    [&viewer] { return viewer.GetSceneView() && viewer.GetSceneView()->IsVisible(); } });
  keys.Add({ "", { "l" }, "l", "the beams",
    [&viewer]
    {
      PlatformView* platform = viewer.GetPlatformView();
      platform ? platform->SetFanVisible(!platform->IsFanVisible()) : void();
    },
    [&viewer] { return viewer.GetPlatformView() && viewer.GetPlatformView()->IsFanVisible(); } });
  keys.Add({ "", { "w" }, "w", "menus, text and time bar",
    [&viewer]
    {
      const bool isVisible = !viewer.GetHud().IsVisible();
      viewer.GetHud().SetVisible(isVisible);
      viewer.Redraw();
    } });
  keys.Add({ "", { "L" }, "L", "light, dark colours",
    [&viewer]
    {
      const bool isDark = viewer.GetHud().GetTheme().Name == "dark";
      viewer.SetTheme(isDark ? "light" : "dark");
    } });
}

void AddFiles(Viewer& viewer, ViewerKeys& keys)
{
  keys.Add({ "File", { "Control-o", "O" }, "Ctrl-O", "open ...",
    [&viewer] { viewer.OpenInputDialog(); } });
  keys.Add({ "", { "Control-s" }, "Ctrl-S", "save the survey as ...",
    [&viewer] { viewer.OpenSurveyDialog(); } });
  keys.Add({ "", { "p" }, "p", "save a picture, vtkhelios.png",
    [&viewer] { viewer.SaveStill("vtkhelios.png"); } });
  keys.Add({ "", { "P" }, "P", "save a picture as ...", [&viewer] { viewer.OpenStillDialog(); } });
  keys.Add({ "", { "R" }, "R", "start, stop recording vtkhelios.ogv",
    [&viewer] { viewer.ToggleRecording(); } });
  keys.Add({ "", { "h", "question", "F1" }, "h", "this help",
    [&viewer]
    {
      viewer.GetHud().SetHelpVisible(!viewer.GetHud().IsHelpVisible());
      viewer.Redraw();
    } });
  keys.Add({ "", { "q" }, "q", "quit", [&viewer] { viewer.Close(); } });
}

/// Returns the buttons of the main actions, which do what keys do.
std::vector<ToolButton> MakeButtons(Viewer& viewer, ViewerKeys& keys)
{
  const auto press = [&keys](const char* key) { return [&keys, key] { keys.Press(key, false); }; };
  const auto isMode = [&viewer](CameraMode mode)
  { return [&viewer, mode] { return viewer.GetCamera().GetMode() == mode; }; };
  const auto isIn = [&viewer](const char* tool)
  { return [&viewer, tool] { return viewer.IsToolOn(tool); }; };
  return { { "Open", "open a survey, scene, run, plan or cloud (Ctrl-O)",
             [&viewer] { viewer.OpenInputDialog(); }, nullptr },
    { "Save as", "save the survey (Ctrl-S)", [&viewer] { viewer.OpenSurveyDialog(); }, nullptr },
    { "Show all", "show all data (r)", press("r"), nullptr },
    { "Top", "from above, north up (t); drag to leave it", press("t"), isMode(CameraMode::Top) },
    { "Follow", "follow the platform (f)", press("f"), isMode(CameraMode::Follow) },
    { "Free", "free camera: drag turns, wheel zooms (c)", press("c"), isMode(CameraMode::Free) },
    { "Colours", "list of colours (next: k)", [&viewer] { viewer.GetHud().OpenMenu("Colours"); },
      nullptr },
    { "Mesh", "show or hide the scene's mesh (m)", press("m"),
      [&viewer] { return viewer.GetSceneView() && viewer.GetSceneView()->IsVisible(); } },
    { "EDL", "eye-dome lighting: shading by depth (e)", press("e"),
      [&viewer] { return viewer.GetCloudView().GetEyeDomeLighting(); } },
    { "Measure", "measure distances between two clicks (D)", press("D"), isIn("Measure") },
    { "Section", "show a vertical section between two clicks (S)", press("S"), isIn("Section") },
    { "Scan", "direct control: place and run a scanner (d)", press("d"), isIn("Direct control") },
    { "Help", "all keys (h)", press("h"), [&viewer] { return viewer.GetHud().IsHelpVisible(); } } };
}

} // namespace

//------------------------------------------------------------------------------
void Viewer::SetUpKeys()
{
  this->Keys = std::make_unique<ViewerKeys>(this->Tools);
  AddFiles(*this, *this->Keys);
  AddTime(*this, *this->Keys);
  AddCameras(*this, *this->Keys);
  AddColors(*this, *this->Keys);
  AddLook(*this, *this->Keys);
  this->Words->GetToolBar().SetButtons(MakeButtons(*this, *this->Keys));
  this->UpdateMenus();
}

//------------------------------------------------------------------------------
void Viewer::UpdateMenus()
{
  this->Words->SetMenus(this->Keys->GetMenus());
}

//------------------------------------------------------------------------------
bool Viewer::IsToolOn(const std::string& name) const
{
  return std::any_of(this->Tools.begin(), this->Tools.end(),
    [&name](const auto& tool) { return tool->GetName() == name && tool->IsActive(); });
}

} // namespace helios::viewer
