// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosPlacedParts.h"

#include "heliosMovingParts.h"
#include "vtkHeliosArrayNames.h"
#include "vtkHeliosScene.h"

#include <vtkCellData.h>
#include <vtkDoubleArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>

#include <algorithm>
#include <iterator>
#include <vector>

namespace helios
{
namespace names = vtkHeliosArrayNames;

namespace
{

/// Places parts that have triangles in the mesh.
Status PlaceTriangles(const std::map<int, MotionMap>& maps, vtkPolyData* scene)
{
  std::map<int, std::vector<MotionSequence>> placed;
  vtkDataArray* ids = scene->GetCellData()->GetArray(names::PartIds);
  for (vtkIdType cell = 0; ids && cell < ids->GetNumberOfTuples(); ++cell)
  {
    const auto id = static_cast<int>(ids->GetComponent(cell, 0));
    maps.count(id) > 0 ? void(placed[id]) : void();
  }
  if (placed.empty())
  {
    return {};
  }
  vtkNew<vtkPolyData> mesh; // without instances
  mesh->ShallowCopy(scene);
  std::vector<MovingPart> parts;
  const Status status = FindMovingParts(mesh, placed, parts);
  if (status.IsOk())
  {
    std::vector<MotionMap> of;
    of.reserve(parts.size());
    std::transform(parts.begin(), parts.end(), std::back_inserter(of),
      [&maps](const MovingPart& part) { return maps.at(part.Id); });
    MoveParts(parts, of, mesh);
    scene->SetPoints(mesh->GetPoints());
    scene->GetCellData()->ShallowCopy(mesh->GetCellData());
  }
  return status;
}

/// Turns a quaternion (w, x, y, z) by a rotation.
void Turn(const Rotation& turn, double quaternion[4])
{
  double m[3][3];
  std::copy_n(&turn.M[0][0], 9, &m[0][0]);
  Quaternion q;
  q.FromMatrix3x3(m);
  const Quaternion turned =
    q * Quaternion(quaternion[0], quaternion[1], quaternion[2], quaternion[3]);
  std::copy_n(turned.GetData(), 4, quaternion);
}

/// Returns instances with those of parts placed.
vtkSmartPointer<vtkPolyData> PlaceInstances(
  const std::map<int, MotionMap>& maps, vtkPolyData* instances)
{
  auto placed = vtkSmartPointer<vtkPolyData>::New();
  placed->DeepCopy(instances);
  vtkDataArray* ids = placed->GetPointData()->GetArray(names::PartIds);
  vtkSmartPointer<vtkDataArray> turns = placed->GetPointData()->GetArray(names::Orientation);
  if (!turns)
  {
    turns = vtkSmartPointer<vtkDoubleArray>::New();
    turns->SetName(names::Orientation);
    turns->SetNumberOfComponents(4);
    for (vtkIdType i = 0; i < placed->GetNumberOfPoints(); ++i)
    {
      turns->InsertNextTuple4(1.0, 0.0, 0.0, 0.0);
    }
    placed->GetPointData()->AddArray(turns);
  }
  for (vtkIdType i = 0; i < placed->GetNumberOfPoints(); ++i)
  {
    const auto found = maps.find(ids ? static_cast<int>(ids->GetComponent(i, 0)) : 0);
    if (found == maps.end())
    {
      continue;
    }
    const Vec3 at = found->second * Vec3(placed->GetPoint(i));
    placed->GetPoints()->SetPoint(i, at.GetData());
    if (found->second.Turns)
    {
      double turn[4];
      turns->GetTuple(i, turn);
      Turn(found->second.Linear, turn);
      turns->SetTuple(i, turn);
    }
  }
  return placed;
}

} // namespace

//------------------------------------------------------------------------------
Status PlaceParts(const std::map<int, MotionMap>& maps, vtkPolyData* scene)
{
  const Status status = PlaceTriangles(maps, scene);
  auto* whole = vtkHeliosScene::SafeDownCast(scene);
  if (status.IsOk() && whole && whole->GetInstances())
  {
    whole->SetInstances(PlaceInstances(maps, whole->GetInstances()));
  }
  return status;
}

} // namespace helios
