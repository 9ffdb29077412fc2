// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Shows and replaces the viewer's surveys, scenes and clouds.
#include "heliosStatus.h"
#include "heliosViewer.h"

#include "heliosCloudView.h"
#include "heliosGroundHeight.h"
#include "heliosHud.h"
#include "heliosPlatformView.h"
#include "heliosSceneBounds.h"
#include "heliosSceneMover.h"
#include "heliosSceneView.h"
#include "heliosSimulation.h"
#include "heliosTimeBar.h"
#include "heliosViewerTool.h"
#include "vtkHeliosRunOptions.h"
#include "vtkHeliosScene.h"
#include "vtkHeliosSurvey.h"
#include "vtkHeliosSurveySource.h"

#include <vtkBoundingBox.h>
#include <vtkPolyData.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <vector>

namespace helios::viewer
{

namespace
{

constexpr std::size_t FramedPoints = 20000; // points that the first view is fitted to
constexpr double FarTrajectory = 2.0;       // times the data's diagonal: not framed

/// Returns those that are in a box [m]: not of parts that move there later.
std::vector<Vec3> SampleInside(vtkPolyData* scene, const double bounds[6])
{
  const vtkBoundingBox box(bounds);
  std::vector<Vec3> points = SampleMesh(scene);
  points.erase(std::remove_if(points.begin(), points.end(),
                 [&box](const Vec3& p) { return !box.ContainsPoint(p[0], p[1], p[2]); }),
    points.end());
  return points;
}

/// Leaves out points far from the middle 99 % along an axis.
void DropOutliers(std::vector<Vec3>& points)
{
  constexpr double share = 0.005, margin = 0.2;
  for (int axis = 0; axis < 3 && points.size() > 100; ++axis)
  {
    std::vector<double> values;
    for (const Vec3& point : points)
    {
      values.push_back(point[axis]);
    }
    std::sort(values.begin(), values.end());
    const auto rank = static_cast<std::size_t>(share * static_cast<double>(values.size()));
    const double low = values[rank], high = values[values.size() - 1 - rank];
    const double room = margin * (high - low);
    points.erase(std::remove_if(points.begin(), points.end(),
                   [=](const Vec3& p) { return p[axis] < low - room || p[axis] > high + room; }),
      points.end());
  }
}

/// Returns every nth point of a cloud [m], without outliers.
std::vector<Vec3> SamplePoints(const Cloud& cloud)
{
  std::vector<Vec3> points;
  const vtkIdType count = cloud.GetNumberOfPoints();
  const vtkIdType step = 1 + count / static_cast<vtkIdType>(FramedPoints);
  for (vtkIdType i = 0; i < count; i += step)
  {
    points.push_back(cloud.GetEcho(i).Position);
  }
  DropOutliers(points);
  return points;
}

/// Adds the bounds of turbid voxels.
void AddGrids(const std::vector<vtkSmartPointer<vtkImageData>>& grids, double bounds[6])
{
  vtkBoundingBox box(bounds);
  for (vtkImageData* grid : grids)
  {
    box.AddBounds(grid->GetBounds());
  }
  box.GetBounds(bounds);
}

/// Returns the centre of a box, in whole metres.
Vec3 FindOrigin(const double bounds[6])
{
  return { std::round(0.5 * (bounds[0] + bounds[1])), std::round(0.5 * (bounds[2] + bounds[3])),
    std::round(0.5 * (bounds[4] + bounds[5])) };
}

} // namespace

//------------------------------------------------------------------------------
void Viewer::ShowSurvey(vtkHeliosSurvey* survey, bool keepCamera)
{
  for (auto& tool : this->Tools)
  {
    tool->OnNewSurvey();
  }
  if (!this->Running)
  {
    this->PointsView->SetEyeDomeLighting(this->Options.EyeDome);
  }
  this->Survey = survey;
  this->KeepsCamera = keepCamera;
  this->Running = std::make_unique<Simulation>(survey);
  this->Running->GetSource()->GetOptions()->SetSeed(this->Options.Seed);
  this->Running->GetSource()->GetOptions()->SetNoise(this->Options.Noise);
  this->Running->Start();
  this->IsLoading = true;
  this->HasFailed = false;
  this->ExitCode = 0;
  this->Clock.SetSpan(0.0, 0.0);
  this->Redraw();
}

//------------------------------------------------------------------------------
void Viewer::ShowScene(
  vtkPolyData* scene, const std::vector<vtkSmartPointer<vtkImageData>>& grids, vtkPolyData* above)
{
  double bounds[6];
  vtkBoundingBox box;
  if (GetSceneBounds(scene, bounds).IsOk()) // else ShowMesh() has the error
  {
    box.SetBounds(bounds);
  }
  above ? box.AddBounds(above->GetBounds()) : void();
  box.GetBounds(bounds);
  AddGrids(grids, bounds);
  this->Running.reset();
  this->Legs.clear();
  this->Begin(bounds, scene, false);
  this->ShowMesh(scene);
  this->Mesh->SetGrids(grids);
  this->PointsView->SetEyeDomeLighting(false); // meant for points: leaves would be mostly edges
  this->SetSpan(0.0, 0.0);
  this->Redraw();
}

//------------------------------------------------------------------------------
void Viewer::ShowCloud(const std::vector<SimulatedLeg>& legs)
{
  double bounds[6];
  double times[2];
  this->Running.reset();
  this->Legs = legs;
  this->Origin = this->Points->GetOrigin();
  this->Camera.SetOrigin(this->Origin);
  FindPlatforms(this->Legs, SamplePoints(*this->Points));
  const bool hasPoints = this->Points->GetBounds(bounds);
  this->ShowBox(bounds, hasPoints, nullptr);
  this->PointsView->Update();
  this->ShowTrajectories();
  this->SetCameraMode(this->Camera.GetMode());
  this->ResetCamera();
  if (this->Points->GetTimeRange(times))
  {
    this->SetSpan(times[0], times[1]);
    this->Clock.Seek(this->Options.StartTime >= 0.0 ? this->Options.StartTime : times[1]);
  }
  else
  {
    this->SetSpan(0.0, 0.0);
  }
  this->Redraw();
}

//------------------------------------------------------------------------------
/// Shows all data in the middle of the part of the window between the panels.
void Viewer::ResetCamera()
{
  this->PlacePanels();
  const int* size = this->Window->GetSize();
  const Rect& view = this->Words->GetLayout().GetView();
  this->Camera.SetMargins(static_cast<double>(view.Y) / std::max(1, size[1]),
    static_cast<double>(size[1] - view.Top()) / std::max(1, size[1]));
  this->Camera.Reset();
  this->Redraw();
}

//------------------------------------------------------------------------------
void Viewer::ShowMesh(vtkPolyData* scene)
{
  this->Mesh = std::make_unique<SceneView>(this->Renderer);
  this->Mesh->SetOrigin(this->Origin);
  this->CoverMesh();
  const Status status = this->Mesh->SetScene(scene);
  if (!status.IsOk())
  {
    this->ShowError(status.Message());
  }
}

//------------------------------------------------------------------------------
/// Covers the mesh below the echoes of a survey; a scene alone has its own colours.
void Viewer::CoverMesh()
{
  if (this->Mesh)
  {
    this->Mesh->SetVeil(this->Running ? this->Words->GetTheme().Scene : Veil());
  }
}

//------------------------------------------------------------------------------
/// Clears the view; the origin is at the centre of a box [m].
void Viewer::Begin(const double bounds[6], vtkPolyData* scene, bool keepCamera)
{
  const bool hasData = std::isfinite(bounds[0]) && bounds[0] <= bounds[1];
  const Vec3 before = this->Origin;
  if (!keepCamera)
  {
    this->Origin = hasData ? FindOrigin(bounds) : Vec3(0.0, 0.0, 0.0);
  }
  this->Mover.reset();
  this->Mesh.reset();
  this->Platform.reset();
  this->Points->Clear();
  this->Points->SetOrigin(this->Origin);
  this->PointsView->Update();
  this->Camera.SetOrigin(this->Origin);
  this->ShowBox(bounds, hasData, scene);
  if (!keepCamera || before != this->Origin)
  {
    this->SetCameraMode(this->Camera.GetMode());
    this->ResetCamera();
  }
}

//------------------------------------------------------------------------------
/// Frames a box [m], if any, with the scene or the cloud in it, and trajectories that are near.
void Viewer::ShowBox(const double bounds[6], bool hasData, vtkPolyData* scene)
{
  vtkBoundingBox box;
  hasData ? box.SetBounds(bounds) : void();
  vtkBoundingBox all = box;
  const bool hasInstances = scene && vtkHeliosScene::HasInstances(scene); // not sampled
  std::vector<Vec3> points = hasInstances ? std::vector<Vec3>()
    : scene                               ? SampleInside(scene, bounds)
                                          : SamplePoints(*this->Points);
  const std::size_t count = points.size();
  for (const SimulatedLeg& leg : this->Legs)
  {
    for (Vec3 position : { leg.Positions.front(), leg.Positions.back() })
    {
      all.AddPoint(position.GetData());
      points.push_back(position);
    }
  }
  if (box.IsValid() && all.GetDiagonalLength() > FarTrajectory * box.GetDiagonalLength())
  {
    all = box; // the data would be small
    points.resize(count);
  }
  double whole[6];
  all.GetBounds(whole);
  double local[6] = { -1.0, 1.0, -1.0, 1.0, -1.0, 1.0 };
  for (int i = 0; all.IsValid() && i < 6; ++i)
  {
    local[i] = whole[i] - this->Origin[i / 2];
  }
  for (Vec3& point : points)
  {
    point = point - this->Origin;
  }
  this->Camera.SetBounds(local);
  this->Camera.SetPoints(count > 0 ? points : std::vector<Vec3>());
}

//------------------------------------------------------------------------------
/// Finishes loading after the thread has loaded the survey, or failed to.
void Viewer::FinishLoading()
{
  const Simulation::Phase phase = this->Running->GetPhase();
  if (phase == Simulation::Phase::Failed && !this->HasFailed)
  {
    this->ShowError(this->Running->GetMessage());
    this->HasFailed = true;
    this->ExitCode = 1;
    this->IsLoading = false;
  }
  if (!this->IsLoading || phase == Simulation::Phase::Loading)
  {
    return;
  }
  this->IsLoading = false;
  double bounds[6];
  this->Running->GetBounds(bounds);
  this->Legs = this->Running->GetLegs();
  auto mover = std::make_unique<SceneMover>(
    this->Survey->GetData(), this->Running->GetScene(), this->Running->GetFrames());
  if (!this->Legs.empty() && mover->GetBounds(this->Legs.front(), bounds))
  {
    AddGrids(this->Running->GetGrids(), bounds);
  }
  std::vector<Vec3> ground = SampleInside(this->Running->GetScene(), bounds);
  ground.empty() ? void(ground.emplace_back(bounds[0], bounds[2], bounds[4])) : void();
  FindPlatforms(this->Legs, ground);
  this->Begin(bounds, this->Running->GetScene(), this->KeepsCamera);
  this->ShowMesh(this->Running->GetScene());
  this->Mesh->SetGrids(this->Running->GetGrids());
  this->Mesh->GetScene() ? mover->SetView(*this->Mesh) : void();
  this->Mover = std::move(mover);
  this->ShowTrajectories();
  this->SetSpan(this->Running->GetStartTime(), this->Running->GetEndTime());
}

//------------------------------------------------------------------------------
void Viewer::ShowTrajectories()
{
  this->Platform = std::make_unique<PlatformView>(this->Renderer, this->Origin);
  this->Platform->SetTrajectories(this->Legs);
  this->Platform->SetFanVisible(this->Options.Fan);
  const Status status = this->Platform->ReadModels(this->Legs);
  if (!status.IsOk())
  {
    std::cerr << "warning: " << status.Message() << "\n";
    this->ShowMessage(status.Message());
  }
}

//------------------------------------------------------------------------------
/// Sets the ends of the time bar [s].
void Viewer::SetSpan(double start, double end)
{
  this->Clock.SetSpan(start, end);
  this->Clock.Seek(std::max(this->Options.StartTime, start));
  if (this->Bar)
  {
    this->Bar->SetSpan(start, end);
  }
  this->Redraw();
}

} // namespace helios::viewer
