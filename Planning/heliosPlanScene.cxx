// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosPlanScene.h"

#include "heliosRayCasterBackends.h"
#include "heliosSceneGeometry.h"
#include "heliosStatus.h"
#include "heliosTriangleMesh.h"
#include "vtkHeliosArrayNames.h"
#include "vtkHeliosRayCaster.h"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkNew.h>
#include <vtkPolyData.h>

#include <cmath>

namespace names = vtkHeliosArrayNames;

namespace helios
{

PlanScene::PlanScene() = default;
PlanScene::~PlanScene() = default;

Status PlanScene::Set(vtkPolyData* scene)
{
  this->Part = scene;
  this->Cells.clear();
  if (scene->GetNumberOfCells() == 0)
  {
    return Status::Error("The scene on port 0 is empty; connect what is to be scanned");
  }
  TriangleMesh mesh;
  const Status status = mesh.Set(scene);
  if (!status.IsOk())
  {
    return Status::Error("No rays can be cast onto the scene on port 0: " + status.Message());
  }
  this->Normals = scene->GetCellData()->GetArray(names::Normals);
  if (this->Normals && this->Normals->GetNumberOfComponents() != 3)
  {
    this->Normals = nullptr;
  }
  mesh.GetBounds(this->Bounds);
  this->Caster = MakeDefaultRayCaster();
  return this->Caster->Build(scene) ? Status()
                                    : Status::Error("No rays can be cast onto the scene on port 0");
}

Status PlanScene::Set(vtkPolyData* scene, const std::vector<bool>& isTaken)
{
  vtkNew<vtkPolyData> part;
  vtkNew<vtkCellArray> polys;
  polys->Use32BitStorage();
  std::vector<vtkIdType> cells;
  for (vtkIdType cell = 0; cell < scene->GetPolys()->GetNumberOfCells(); ++cell)
  {
    vtkIdType size;
    const vtkIdType* corners;
    scene->GetPolys()->GetCellAtId(cell, size, corners);
    if (isTaken[static_cast<std::size_t>(cell)])
    {
      polys->InsertNextCell(size, corners);
      cells.push_back(cell);
    }
  }
  part->SetPoints(scene->GetPoints());
  part->SetPolys(polys);
  const Status status = this->Set(part);
  this->Cells = cells;
  return status;
}

Vec3 PlanScene::GetFaceNormal(vtkIdType hit) const
{
  return this->Caster->GetGeometry().GetNormal(hit);
}

Vec3 PlanScene::GetNormal(vtkIdType hit) const
{
  if (this->Normals)
  {
    Vec3 normal;
    this->Normals->GetTuple(hit, normal.GetData());
    if (normal.Norm() > 0.0 && std::isfinite(normal.Norm()))
    {
      return normal.Normalized();
    }
  }
  return this->GetFaceNormal(hit);
}

double PlanScene::GetStep(double given) const
{
  const double* b = this->Bounds;
  const Vec3 diagonal(b[1] - b[0], b[3] - b[2], b[5] - b[4]);
  return given > 0.0 ? given : 0.05 * diagonal.Norm();
}

} // namespace helios
