// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosPlanScene.h"

#include "heliosPlanGround.h"
#include "heliosRayCasterBackends.h"
#include "heliosSceneBounds.h"
#include "heliosSceneCells.h"
#include "heliosSceneGeometry.h"
#include "heliosStatus.h"
#include "vtkHeliosRayCaster.h"
#include "vtkHeliosScene.h"

#include <vtkPolyData.h>

#include <string>

namespace helios
{

PlanScene::PlanScene() = default;
PlanScene::~PlanScene() = default;

Status PlanScene::Set(vtkPolyData* scene)
{
  this->Ground = nullptr;
  if (scene->GetNumberOfCells() == 0 && !vtkHeliosScene::HasInstances(scene))
  {
    return Status::Error("The scene on port 0 is empty; connect what is to be scanned");
  }
  const std::string problem = "No rays can be cast onto the scene on port 0";
  if (const Status status = this->FindBounds(scene); !status.IsOk())
  {
    return Status::Error(problem + ": " + status.Message());
  }
  this->Caster = MakeDefaultRayCaster();
  if (!this->Caster->Build(scene))
  {
    return Status::Error(problem);
  }
  this->Cells = std::make_unique<SceneCells>(scene, this->Caster->GetGeometry());
  return {};
}

Status PlanScene::FindBounds(vtkPolyData* scene)
{
  SceneGeometry geometry;
  const Status status = geometry.Set(scene);
  if (status.IsOk())
  {
    ComputeTightBounds(geometry, this->Bounds);
  }
  return status;
}

Status PlanScene::Set(PlanGround& ground)
{
  const Status status = this->Set(ground.Extract());
  this->Ground = &ground;
  return status;
}

vtkIdType PlanScene::GetCell(vtkIdType hit) const
{
  return this->Ground ? this->Ground->GetCell(this->Caster->GetGeometry(), hit) : hit;
}

int PlanScene::GetPart(vtkIdType hit) const
{
  return this->Cells->GetPart(hit);
}

Vec3 PlanScene::GetFaceNormal(vtkIdType hit) const
{
  return this->Caster->GetGeometry().GetNormal(hit);
}

Vec3 PlanScene::GetNormal(vtkIdType hit) const
{
  Vec3 normal;
  return this->Cells->GetNormal(hit, normal) ? normal : this->GetFaceNormal(hit);
}

double PlanScene::GetStep(double given) const
{
  const double* b = this->Bounds;
  const Vec3 diagonal(b[1] - b[0], b[3] - b[2], b[5] - b[4]);
  return given > 0.0 ? given : 0.05 * diagonal.Norm();
}

} // namespace helios
