// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosEditTool.h"

#include "heliosEditArea.h"
#include "heliosEditDocument.h"
#include "heliosErrorText.h"
#include "heliosHud.h"
#include "heliosMessages.h"
#include "heliosSceneView.h"
#include "heliosStatus.h"
#include "heliosViewer.h"
#include "vtkHeliosSurvey.h"

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

constexpr std::size_t MaximumUndos = 200;

} // namespace

//------------------------------------------------------------------------------
EditTool::EditTool(Viewer& viewer)
  : Owner(viewer)
{
  this->MakeActions();
}

//------------------------------------------------------------------------------
EditTool::~EditTool()
{
  this->Owner.GetHud().SetEditor(nullptr);
}

//------------------------------------------------------------------------------
std::vector<KeyHelp> EditTool::GetKeys() const
{
  return { { "d", "on, off; then click the scan position", "d" },
    { "Shift-click, a", "add a scan position or waypoint", "" },
    { "A", "flight lines: click two corners", "A" }, { "Tab", "next platform", "Tab" },
    { "g", "next instrument; next file of a part", "g" }, { "Delete", "remove the last", "Delete" },
    { "z", "undo", "z" }, { "Return", "scan", "Return" }, { "s", "save the survey", "s" },
    { "M", "scene parts: click selects, Shift-click moves it there", "M" },
    { "a", "add a part at the mouse position", "" }, { "Left", "move the part west", "Left" },
    { "Right", "move the part east", "Right" }, { "Up", "move the part north", "Up" },
    { "Down", "move the part south", "Down" }, { "<", "rotate the part left", "less" },
    { ">", "rotate the part right", "greater" }, { "*", "enlarge the part", "asterisk" },
    { "/", "reduce the part", "slash" } };
}

//------------------------------------------------------------------------------
void EditTool::MakeActions()
{
  const auto atMouse = [](EditTool& tool)
  {
    int at[2];
    tool.Owner.GetInteractor()->GetEventPosition(at[0], at[1]);
    tool.ClickAt(at[0], at[1], true);
  };
  this->PartActions["a"] = [](EditTool& tool)
  {
    int at[2];
    tool.Owner.GetInteractor()->GetEventPosition(at[0], at[1]);
    SceneView* scene = tool.Owner.GetSceneView();
    const auto pick = scene ? scene->Pick(at[0], at[1]) : std::nullopt;
    pick ? tool.AddPart(*pick) : tool.Owner.ShowMessage("point at the surface to place it on");
  };
  this->Actions["a"] = atMouse;
  this->Actions["A"] = [](EditTool& tool) { tool.SetMode(Mode::Area); };
  this->Actions["M"] = [](EditTool& tool)
  { tool.SetMode(tool.Doing == Mode::Parts ? Mode::Scanner : Mode::Parts); };
  this->Actions["Escape"] = [](EditTool& tool) { tool.SetMode(Mode::Scanner); };
  this->Actions["Tab"] = [](EditTool& tool) { tool.ChangePlatform(1); };
  this->Actions["ISO_Left_Tab"] = [](EditTool& tool) { tool.ChangePlatform(-1); };
  this->Actions["g"] = [](EditTool& tool) { tool.ChangeScanner(1); };
  this->Actions["G"] = [](EditTool& tool) { tool.ChangeScanner(-1); };
  this->Actions["Delete"] = [](EditTool& tool) { tool.Remove(); };
  this->Actions["BackSpace"] = this->Actions["Delete"];
  this->Actions["z"] = [](EditTool& tool) { tool.Undo(); };
  this->Actions["Return"] = [](EditTool& tool) { tool.Scan(); };
  this->Actions["KP_Enter"] = this->Actions["Return"];
  this->Actions["s"] = [](EditTool& tool)
  {
    const Status status = tool.Save();
    status.IsOk() ? void() : tool.Owner.ShowError(status.Message());
  };
  this->PartActions["Up"] = [](EditTool& tool) { tool.MovePart(0.0, 1.0); };
  this->PartActions["Down"] = [](EditTool& tool) { tool.MovePart(0.0, -1.0); };
  this->PartActions["Left"] = [](EditTool& tool) { tool.MovePart(-1.0, 0.0); };
  this->PartActions["Right"] = [](EditTool& tool) { tool.MovePart(1.0, 0.0); };
  this->PartActions["less"] = [](EditTool& tool) { tool.TurnPart(15.0); };
  this->PartActions["greater"] = [](EditTool& tool) { tool.TurnPart(-15.0); };
  this->PartActions["asterisk"] = [](EditTool& tool) { tool.ScalePart(1.1); };
  this->PartActions["KP_Multiply"] = this->PartActions["asterisk"];
  this->PartActions["slash"] = [](EditTool& tool) { tool.ScalePart(1.0 / 1.1); };
  this->PartActions["KP_Divide"] = this->PartActions["slash"];
  this->PartActions["g"] = [](EditTool& tool)
  {
    tool.File = tool.Files.empty() ? 0 : (tool.File + 1) % tool.Files.size();
    tool.ShowPanel();
  };
}

//------------------------------------------------------------------------------
bool EditTool::OnKey(const std::string& key, bool)
{
  if (key == "d")
  {
    return this->Toggle();
  }
  if (!this->IsOn)
  {
    return false;
  }
  const auto part = this->PartActions.find(key);
  const auto action = this->Actions.find(key);
  if (this->Doing == Mode::Parts && part != this->PartActions.end())
  {
    part->second(*this);
  }
  else if (action != this->Actions.end())
  {
    action->second(*this);
  }
  else
  {
    return false;
  }
  this->Owner.Redraw();
  return true;
}

//------------------------------------------------------------------------------
bool EditTool::Toggle()
{
  if (!this->IsOn && !this->HasBegun && !this->Begin())
  {
    return true;
  }
  this->IsOn = !this->IsOn;
  if (!this->Panel)
  {
    this->Panel = std::make_unique<EditPanel>(this->Owner.GetInteractor(),
      [this](const std::string& name, double value, bool isOver)
      { this->ChangeSetting(name, value, isOver); });
    this->Owner.GetHud().SetEditor(this->Panel.get());
    this->Owner.GetHud().SetOnEditorLine(
      [this](int line)
      {
        const bool isList = this->Doing != Mode::Parts && (line == 1 || line == 2);
        isList ? this->Owner.GetHud().OpenMenu(line == 1 ? "Platform" : "Instrument") : void();
        return isList;
      });
  }
  this->SetMode(Mode::Scanner);
  this->HasChanges ? this->ShowGhost() : void();
  this->Owner.UpdateMenus();
  this->Owner.ShowMessage(
    this->IsOn ? "direct control: click the scan position, Return scans" : "direct control is off");
  return true;
}

//------------------------------------------------------------------------------
bool EditTool::OnClick(int x, int y)
{
  if (!this->IsOn)
  {
    return false;
  }
  vtkRenderWindowInteractor* keys = this->Owner.GetInteractor();
  this->ClickAt(x, y, keys && (keys->GetShiftKey() != 0 || keys->GetControlKey() != 0));
  return true;
}

//------------------------------------------------------------------------------
void EditTool::ClickAt(int x, int y, bool isMore)
{
  SceneView* scene = this->Owner.GetSceneView();
  const auto pick = scene ? scene->Pick(x, y) : std::nullopt;
  if (!pick)
  {
    this->Owner.ShowMessage("there is no surface there: click on one of the scene");
    return;
  }
  switch (this->Doing)
  {
    case Mode::Scanner:
      this->SetScanPosition(*pick, isMore);
      break;
    case Mode::Area:
      this->SetCorner(*pick);
      break;
    case Mode::Parts:
      this->Select(*pick, isMore);
      break;
  }
}

//------------------------------------------------------------------------------
void EditTool::SetScanPosition(const ScenePick& pick, bool isMore)
{
  this->Remember();
  if (this->Edit.HasArea)
  {
    this->Edit.Legs.clear(); // strips cannot be extended by hand
  }
  const bool isNew = isMore || this->Edit.IsMoving() || this->Edit.Legs.empty();
  isNew ? AddLeg(this->Edit, pick.Position, pick.IsGround)
        : MoveLeg(this->Edit, this->Edit.Legs.size() - 1, pick.Position, pick.IsGround);
  this->ShowGhost();
  this->ShowPanel();
}

//------------------------------------------------------------------------------
void EditTool::SetCorner(const ScenePick& pick)
{
  if (!this->HasCorner)
  {
    this->HasCorner = true;
    this->Corner = pick.Position;
    this->Owner.ShowMessage("now click the opposite corner");
    return;
  }
  this->Remember();
  this->Edit.Corners[0] = this->Corner;
  this->Edit.Corners[1] = pick.Position;
  this->Edit.HasArea = true;
  const Status status = FlyArea(this->Edit);
  this->Edit.HasArea = status.IsOk();
  this->SetMode(Mode::Scanner);
  this->ShowGhost();
  this->Owner.ShowMessage(status.IsOk()
      ? "flight lines: " + std::to_string(this->Edit.Legs.size() / 2)
      : status.Message());
}

//------------------------------------------------------------------------------
void EditTool::SetMode(Mode mode)
{
  if (mode == Mode::Area && !this->Edit.IsMoving())
  {
    this->Owner.ShowMessage("flight lines need a moving platform: press Tab for one");
    return;
  }
  if (mode == Mode::Parts && !this->LoadScene())
  {
    return;
  }
  this->Doing = mode;
  this->HasCorner = false;
  this->Part.clear();
  this->ShowPanel();
  this->Owner.UpdateMenus();
  if (mode == Mode::Area)
  {
    this->Owner.ShowMessage("flight lines: click a corner of the rectangle, then the opposite one");
  }
}

//------------------------------------------------------------------------------
void EditTool::Remove()
{
  if (this->Doing == Mode::Parts)
  {
    this->Remember();
    this->ChangeParts(this->Scene.RemovePart(this->Scene.FindPart(this->Part)));
    return;
  }
  if (!this->Edit.Legs.empty())
  {
    this->Remember();
    this->Edit.HasArea ? this->Edit.Legs.clear()
                       : RemoveLeg(this->Edit, this->Edit.Legs.size() - 1);
    this->Edit.HasArea = false;
    this->ShowGhost();
    this->ShowPanel();
  }
}

//------------------------------------------------------------------------------
/// Called by the panel's sliders, which keep their state.
void EditTool::ChangeSetting(const std::string& name, double value, bool isOver)
{
  if (!this->IsSliding)
  {
    this->Remember();
  }
  this->IsSliding = !isOver;
  const std::string message = SetSetting(this->Edit, name, value);
  if (!message.empty() && isOver)
  {
    this->Owner.ShowMessage(message);
  }
  this->Panel->ShowValues(this->Edit);
  this->Panel->SetHeading(this->MakeHeading());
  this->ShowGhost();
  this->Owner.Redraw();
}

//------------------------------------------------------------------------------
void EditTool::Remember()
{
  this->UndoStack.push_back({ this->Edit, this->HasNewScene ? this->Scene.GetText() : "" });
  if (this->UndoStack.size() > MaximumUndos)
  {
    this->UndoStack.erase(this->UndoStack.begin());
  }
}

//------------------------------------------------------------------------------
void EditTool::Scan()
{
  vtkNew<vtkHeliosSurvey> survey;
  const ErrorText errors(survey);
  SurveyEdit edit = this->Edit;
  edit.SceneText = this->HasNewScene ? this->Scene.GetText() : "";
  const std::string file = fs::absolute(this->Owner.GetOptions().Save).string();
  if (!ReadEdit(edit, file, this->Owner.GetOptions().Assets, survey))
  {
    this->Owner.ShowError("not scanned: " + errors.Get("the survey is not valid"));
    return;
  }
  this->Ghost.reset();
  this->HasChanges = false;
  ++this->Scans;
  this->IsEditedSurvey = true;
  this->Owner.GetClock().SetPlaying(true);
  this->Owner.ShowSurvey(survey, true);
  this->IsEditedSurvey = false;
  this->Owner.ShowMessage("scanning; s saves the survey");
}

//------------------------------------------------------------------------------
Status EditTool::Save()
{
  if (!this->HasBegun && !this->Begin())
  {
    return Status::Error("there is nothing to save: open a survey or a scene, and wait for it");
  }
  const fs::path file = this->Owner.GetOptions().Save;
  vtkNew<vtkHeliosSurvey> owner;
  const ErrorText errors(owner);
  Messages log(owner);
  SurveyEdit edit = this->Edit;
  Status status;
  if (this->HasNewScene)
  {
    fs::path scene = fs::absolute(file);
    scene.replace_filename(file.stem().string() + "_scene.xml");
    status = this->Scene.Save(scene.string());
    edit.Scene = scene.string() + "#" + this->Scene.GetId();
  }
  status =
    status.IsOk() ? SaveSurvey(edit, file.string(), this->Owner.GetOptions().Assets, log) : status;
  if (status.IsOk())
  {
    this->Saved = file.string();
    this->Owner.ShowMessage("saved: vtkhelios run " + this->Saved);
  }
  return status;
}

//------------------------------------------------------------------------------
void EditTool::OnNewSurvey()
{
  if (this->IsEditedSurvey)
  {
    return;
  }
  this->IsOn = false;
  this->HasBegun = false;
  this->HasNewScene = false;
  this->Owner.UpdateMenus(); // they refer to the catalogue
  this->HasChanges = false;
  this->Ghost.reset();
  this->UndoStack.clear();
  this->Saved.clear();
  this->Part.clear();
  if (this->Panel)
  {
    this->Panel->SetVisible(false);
    this->Place();
  }
}

} // namespace helios::viewer
