// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Editing the parts of the scene.
#include "heliosEditTool.h"

#include "heliosErrorText.h"
#include "heliosMessages.h"
#include "heliosSceneView.h"
#include "heliosStatus.h"
#include "heliosViewer.h"
#include "vtkHeliosDialect.h"
#include "vtkHeliosSurvey.h"

#include <vtkBoundingBox.h>
#include <vtkDataArray.h>
#include <vtkNew.h>
#include <vtkObject.h>
#include <vtkPolyData.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <set>

namespace fs = std::filesystem;

namespace helios::viewer
{

namespace
{

/// Returns whether a file may be added as a part: a model, neither terrain nor a city.
bool CanAdd(const fs::path& path)
{
  const std::string loader = vtkHeliosDialect::FindLoader(path.string());
  return loader == "objloader" || loader == "plyloader" || loader == "stlloader" ||
    loader == "gltfloader";
}

constexpr double StepShare = 0.01; // arrow key step, of the scene's size

/// Returns 1, 2 or 5 times a power of ten, at most a number.
double MakeRound(double value)
{
  const double ten = std::pow(10.0, std::floor(std::log10(std::max(value, 1e-3))));
  return ten * (value >= 5.0 * ten ? 5.0 : value >= 2.0 * ten ? 2.0 : 1.0);
}

Vec3 GetFoot(const double b[6])
{
  return { 0.5 * (b[0] + b[1]), 0.5 * (b[2] + b[3]), b[4] };
}

} // namespace

//------------------------------------------------------------------------------
bool EditTool::LoadScene()
{
  if (this->Scene.IsLoaded())
  {
    return true;
  }
  vtkNew<vtkHeliosSurvey> owner;
  const ErrorText errors(owner);
  Messages log(owner);
  if (!this->Scene.Load(this->Edit.Scene, this->Owner.GetOptions().Assets, log))
  {
    this->Owner.ShowError("the scene cannot be changed: " + log.GetLastError());
    return false;
  }
  this->FindFiles();
  return true;
}

//------------------------------------------------------------------------------
/// Models in the asset folders and in the folders of the scene's own files.
void EditTool::FindFiles()
{
  std::set<std::string> folders(
    this->Owner.GetOptions().Assets.begin(), this->Owner.GetOptions().Assets.end());
  for (const std::string& input : this->GetDocuments())
  {
    folders.insert(fs::absolute(input).parent_path().string());
  }
  std::set<std::string> found;
  for (const std::string& folder : folders)
  {
    std::error_code ignored;
    for (fs::directory_iterator entry(folder, ignored), end; entry != end; entry.increment(ignored))
    {
      if (CanAdd(entry->path()))
      {
        found.insert(fs::weakly_canonical(entry->path(), ignored).string());
      }
    }
  }
  this->Files.assign(found.begin(), found.end());
  this->File = 0;
}

//------------------------------------------------------------------------------
/// Finds the selected part in the shown mesh, and its box [m].
bool EditTool::FindMeshPart(int& part, double bounds[6]) const
{
  SceneView* view = this->Owner.GetSceneView();
  part = -1;
  return view && !this->Part.empty() && view->FindPart(this->Part, part, bounds);
}

//------------------------------------------------------------------------------
void EditTool::Select(const ScenePick& pick, bool isMore)
{
  int part = -1;
  double b[6];
  if (isMore && this->FindMeshPart(part, b))
  {
    this->Remember();
    const int chosen = this->Scene.FindPart(this->Part);
    this->ChangeParts(this->Scene.MovePart(chosen, pick.Position - GetFoot(b)));
    return;
  }
  this->Part = pick.Part < 0 ? this->Scene.GetPartName(0) : pick.PartName;
  this->ShowPanel();
}

//------------------------------------------------------------------------------
void EditTool::MovePart(double x, double y)
{
  double b[6];
  SceneView* view = this->Owner.GetSceneView();
  if (view && view->GetBounds(b))
  {
    const double step = MakeRound(StepShare * std::hypot(b[1] - b[0], b[3] - b[2]));
    this->Remember();
    this->ChangeParts(
      this->Scene.MovePart(this->Scene.FindPart(this->Part), { x * step, y * step, 0.0 }));
  }
}

//------------------------------------------------------------------------------
void EditTool::TurnPart(double angle)
{
  int part = -1;
  double b[6];
  const bool isThere = this->FindMeshPart(part, b);
  this->Remember();
  this->ChangeParts(
    isThere && this->Scene.TurnPart(this->Scene.FindPart(this->Part), angle, GetFoot(b)));
}

//------------------------------------------------------------------------------
void EditTool::ScalePart(double factor)
{
  int part = -1;
  double b[6];
  const bool isThere = this->FindMeshPart(part, b);
  this->Remember();
  this->ChangeParts(
    isThere && this->Scene.ScalePart(this->Scene.FindPart(this->Part), factor, GetFoot(b)));
}

//------------------------------------------------------------------------------
void EditTool::AddPart(const ScenePick& pick)
{
  if (this->Files.empty())
  {
    this->Owner.ShowMessage(
      "no OBJ, PLY, STL or glTF file was found next to the scene or in --assets");
    return;
  }
  vtkNew<vtkHeliosSurvey> owner;
  const ErrorText errors(owner);
  Messages log(owner);
  this->Remember();
  const int part = this->Scene.AddPart(this->Files[this->File], pick.Position, log);
  if (part < 0)
  {
    this->UndoStack.pop_back();
    this->Owner.ShowError(log.GetLastError());
    return;
  }
  this->Part = this->Scene.GetPartName(part);
  this->ChangeParts(true);
}

//------------------------------------------------------------------------------
/// Shows a change with an undo entry, or drops the entry if nothing changed.
void EditTool::ChangeParts(bool isGood)
{
  if (!isGood)
  {
    this->UndoStack.pop_back();
    this->Owner.ShowMessage(this->Part.empty()
        ? "select a part first: click on it"
        : this->Part + ": this change is not possible; a scene keeps at least one part");
    return;
  }
  this->HasNewScene = true;
  this->ShowScene();
}

//------------------------------------------------------------------------------
/// Shows the current scene mesh; echoes of the last scan are kept.
void EditTool::ShowScene()
{
  vtkNew<vtkHeliosSurvey> owner;
  const ErrorText errors(owner);
  Messages log(owner);
  const auto mesh = this->Scene.Build(log);
  SceneView* view = this->Owner.GetSceneView();
  if (!mesh)
  {
    this->Owner.ShowError("the scene cannot be shown: " + log.GetLastError());
    this->Undo();
    return;
  }
  if (const Status status = view ? view->SetScene(mesh) : Status(); !status.IsOk())
  {
    this->Owner.ShowError(status.Message());
  }
  if (this->Scene.FindPart(this->Part) < 0)
  {
    this->Part.clear();
  }
  this->ShowPanel();
}

//------------------------------------------------------------------------------
void EditTool::Undo()
{
  if (this->UndoStack.empty())
  {
    this->Owner.ShowMessage("nothing is left to undo");
    return;
  }
  const Before before = this->UndoStack.back();
  this->UndoStack.pop_back();
  this->Edit = before.Edit;
  const bool hadScene = this->HasNewScene;
  const std::string now = hadScene ? this->Scene.GetText() : "";
  this->HasNewScene = !before.Scene.empty();
  if (now != before.Scene)
  {
    this->HasNewScene ? this->Scene.SetText(before.Scene) : this->Scene.SetText(this->FirstScene);
    this->ShowScene();
  }
  this->ShowGhost();
  this->ShowPanel();
}

} // namespace helios::viewer
