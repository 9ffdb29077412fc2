// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosMovingScene.h"

#include "heliosMessages.h"
#include "vtkHeliosArrayNames.h"
#include "vtkHeliosSceneMotion.h"

#include <vtkCellData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace helios
{

namespace
{

/// Returns the parts that have triangles.
std::set<int> FindParts(vtkPolyData* mesh)
{
  std::set<int> parts;
  vtkDataArray* ids = mesh->GetCellData()->GetArray(vtkHeliosArrayNames::PartIds);
  for (vtkIdType i = 0; ids && i < ids->GetNumberOfTuples(); ++i)
  {
    parts.insert(static_cast<int>(ids->GetComponent(i, 0)));
  }
  return parts;
}

} // namespace

//------------------------------------------------------------------------------
MovingScene::MovingScene(const SceneData& scene, vtkPolyData* mesh, Messages& log)
{
  int id = 0; // id in the composer: turbid parts are not in the mesh
  for (const PartData& part : scene.Parts)
  {
    if (!part.IsTurbid() && part.Motion.IsMoving() && FindParts(mesh).count(id) > 0)
    {
      this->Parts.push_back({ id, part.Motion, PartMotion(part.Motion.Sequences) });
      this->Filter->SetMotion(id, part.Motion.Sequences);
    }
    id += part.IsTurbid() ? 0 : 1;
  }
  if (this->IsMoving())
  {
    log.Listen(this->Filter);
    vtkNew<vtkPolyData> own; // without instances, which do not move
    own->ShallowCopy(mesh);
    this->Mesh = mesh;
    this->Filter->SetInputData(own);
  }
}

//------------------------------------------------------------------------------
MovingScene::~MovingScene() = default;

//------------------------------------------------------------------------------
std::vector<int> MovingScene::GetParts() const
{
  std::vector<int> parts;
  for (const Part& part : this->Parts)
  {
    parts.push_back(part.Id);
  }
  return parts;
}

//------------------------------------------------------------------------------
vtkIdType MovingScene::MoveTo(const PulseClock& clock, vtkIdType pulse)
{
  vtkIdType next = VTK_ID_MAX;
  for (const Part& part : this->Parts)
  {
    const vtkIdType step = FindSeenStep(part.Data, clock, pulse);
    const vtkIdType move = part.Motion.FindNextMove(step);
    this->Filter->SetStep(part.Id, part.Motion.FindLastMove(step));
    if (move != VTK_ID_MAX)
    {
      const vtkIdType every = part.Data.Every;
      next = std::min(next, FindPulseOfStep(part.Data, clock, (move + every - 1) / every * every));
    }
  }
  this->Filter->Update();
  return std::max(next, pulse + 1);
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkDataObject> MovingScene::Move(vtkDataObject* scene) const
{
  vtkPolyData* moved = this->Filter->GetOutput();
  const auto mesh = vtkSmartPointer<vtkPolyData>::Take(
    vtkPolyData::SafeDownCast(scene->NewInstance())); // may have instances
  mesh->ShallowCopy(scene);
  mesh->SetPoints(moved->GetPoints());
  if (vtkDataArray* normals = moved->GetCellData()->GetNormals())
  {
    mesh->GetCellData()->SetNormals(normals);
  }
  return mesh;
}

//------------------------------------------------------------------------------
vtkMTimeType MovingScene::GetMoveTime() const
{
  vtkPoints* points = this->Filter->GetOutput()->GetPoints();
  return points ? points->GetMTime() : 0;
}

} // namespace helios
