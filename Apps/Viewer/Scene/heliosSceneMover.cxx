// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosSceneMover.h"

#include "heliosSceneView.h"
#include "heliosSimulation.h"

#include <vtkCallbackCommand.h>
#include <vtkCommand.h>
#include <vtkPolyData.h>

#include <algorithm>
#include <cmath>

namespace helios::viewer
{

namespace
{

/// Returns the last pulse of a channel of a leg emitted by a time [s]; otherwise the first.
vtkIdType FindPulse(const SimulatedLeg& leg, double time)
{
  const double elapsed = std::clamp(time, leg.StartTime, leg.EndTime) - leg.StartTime;
  return static_cast<vtkIdType>(std::floor(elapsed * leg.Clock.Rate + 1e-6));
}

} // namespace

//------------------------------------------------------------------------------
SceneMover::SceneMover(const SceneData& scene, SceneView& view)
  : View(view)
  , Log(Owner)
{
  vtkNew<vtkCallbackCommand> nobody;
  nobody->SetCallback([](vtkObject*, unsigned long, void*, void*) {});
  this->Owner->AddObserver(vtkCommand::ErrorEvent, nobody);
  this->Owner->AddObserver(vtkCommand::WarningEvent, nobody);
  vtkNew<vtkPolyData> mesh; // the run uses the view's mesh
  mesh->ShallowCopy(view.GetScene());
  const std::vector<int> parts = MovingScene(scene, mesh, this->Log).GetParts();
  if (!parts.empty())
  {
    view.SetMovingParts(parts);
    this->Parts = std::make_unique<MovingScene>(scene, view.GetMovingMesh(), this->Log);
  }
}

//------------------------------------------------------------------------------
bool SceneMover::MoveTo(const std::vector<SimulatedLeg>& legs, double time)
{
  const bool isMoving =
    this->Parts && this->View.GetMovingMesh(); // the scene may have been changed
  const SimulatedLeg* leg = isMoving ? FindLeg(legs, time) : nullptr;
  const vtkIdType pulse = leg ? FindPulse(*leg, time) : 0;
  if (!leg || (leg == this->Leg && pulse >= this->First && pulse < this->Next))
  {
    return false;
  }
  this->Leg = leg;
  this->First = pulse;
  this->Next = this->Parts->MoveTo(leg->Clock, pulse);
  vtkSmartPointer<vtkDataObject> moved = this->Parts->Move(this->View.GetMovingMesh());
  this->View.Move(vtkPolyData::SafeDownCast(moved));
  return true;
}

} // namespace helios::viewer
