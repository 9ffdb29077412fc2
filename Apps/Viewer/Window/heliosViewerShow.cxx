// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Shows and replaces the viewer's surveys, scenes and clouds.
#include "heliosStatus.h"
#include "heliosViewer.h"

#include "heliosCloudView.h"
#include "heliosHud.h"
#include "heliosPlatformView.h"
#include "heliosSceneBounds.h"
#include "heliosSceneMover.h"
#include "heliosSceneView.h"
#include "heliosSimulation.h"
#include "heliosTimeBar.h"
#include "heliosViewerTool.h"
#include "vtkHeliosRunOptions.h"
#include "vtkHeliosSurvey.h"
#include "vtkHeliosSurveySource.h"

#include <vtkBoundingBox.h>
#include <vtkPolyData.h>

#include <algorithm>
#include <cmath>
#include <iostream>

namespace helios::viewer
{

namespace
{

/// The centre of a box, in whole metres.
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
void Viewer::ShowScene(vtkPolyData* scene, const std::vector<vtkSmartPointer<vtkImageData>>& grids)
{
  double bounds[6];
  vtkBoundingBox box;
  if (GetSceneBounds(scene, bounds).IsOk()) // else ShowMesh() has the error
  {
    box.SetBounds(bounds);
  }
  for (vtkImageData* grid : grids)
  {
    box.AddBounds(grid->GetBounds());
  }
  box.GetBounds(bounds);
  this->Running.reset();
  this->Legs.clear();
  this->Begin(bounds, false);
  this->ShowMesh(scene);
  this->Mesh->SetGrids(grids);
  this->PointsView->SetEyeDomeLighting(false); // meant for points: leaves would be mostly edges
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
  const bool hasPoints = this->Points->GetBounds(bounds);
  this->ShowBox(bounds, hasPoints);
  this->PointsView->Update();
  this->ShowTrajectories();
  this->SetCameraMode(this->Camera.GetMode());
  this->Camera.Reset();
  if (this->Points->GetTimeRange(times))
  {
    this->SetSpan(times[0], times[1]);
    this->Clock.Seek(this->Options.StartTime >= 0.0 ? this->Options.StartTime : times[1]);
  }
  this->Redraw();
}

//------------------------------------------------------------------------------
void Viewer::ShowMesh(vtkPolyData* scene)
{
  this->Mesh = std::make_unique<SceneView>(this->Renderer);
  this->Mesh->SetOrigin(this->Origin);
  const Status status = this->Mesh->SetScene(scene);
  if (!status.IsOk())
  {
    this->ShowError(status.Message());
  }
}

//------------------------------------------------------------------------------
/// Clears the view; the origin is at the centre of a box [m].
void Viewer::Begin(const double bounds[6], bool keepCamera)
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
  this->ShowBox(bounds, hasData);
  if (!keepCamera || before != this->Origin)
  {
    this->SetCameraMode(this->Camera.GetMode());
    this->Camera.Reset();
  }
}

//------------------------------------------------------------------------------
/// Frames a box [m], if any, and all trajectories.
void Viewer::ShowBox(const double bounds[6], bool hasData)
{
  vtkBoundingBox box;
  hasData ? box.SetBounds(bounds) : void();
  for (const SimulatedLeg& leg : this->Legs)
  {
    for (const Pose& pose : { leg.Poses.front(), leg.Poses.back() })
    {
      box.AddPoint(pose.Position[0], pose.Position[1], pose.Position[2]);
    }
  }
  double whole[6];
  box.GetBounds(whole);
  double local[6] = { -1.0, 1.0, -1.0, 1.0, -1.0, 1.0 };
  for (int i = 0; box.IsValid() && i < 6; ++i)
  {
    local[i] = whole[i] - this->Origin[i / 2];
  }
  this->Camera.SetBounds(local);
}

//------------------------------------------------------------------------------
/// After the thread has loaded the survey, or failed to.
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
  this->Begin(bounds, this->KeepsCamera);
  this->ShowMesh(this->Running->GetScene());
  this->Mesh->SetGrids(this->Running->GetGrids());
  if (this->Mesh->GetScene())
  {
    this->Mover = std::make_unique<SceneMover>(this->Survey->GetData().Scene, *this->Mesh);
  }
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
    this->Bar->SetVisible(this->Words->IsVisible());
  }
  this->Redraw();
}

} // namespace helios::viewer
