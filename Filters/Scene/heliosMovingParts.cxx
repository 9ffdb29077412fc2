// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosMovingParts.h"

#include "heliosStatus.h"
#include "heliosTriangleMesh.h"
#include "vtkHeliosArrayNames.h"

#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkDoubleArray.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <algorithm>
#include <cmath>

namespace helios
{
namespace names = vtkHeliosArrayNames;

namespace
{

bool IsFinite(const Vec3& v)
{
  return std::isfinite(v[0]) && std::isfinite(v[1]) && std::isfinite(v[2]);
}

Status CheckMotion(int part, const Motion& motion)
{
  const std::string what = "a motion of part " + std::to_string(part);
  const bool needsAxis =
    motion.Kind != MotionKind::Identity && motion.Kind != MotionKind::Translation;
  if (!IsFinite(motion.Vector) || !IsFinite(motion.Center) || !IsFinite(motion.Shift) ||
    !std::isfinite(motion.Angle) || !std::isfinite(motion.Glide))
  {
    return Status::Error(what + " has numbers that are not finite; give finite ones");
  }
  if (needsAxis && !(motion.Vector.Norm() > 0.0))
  {
    return Status::Error(what + " has an axis or normal of length 0; give one that is not 0, 0, 0");
  }
  return {};
}

Status CheckMotions(const std::map<int, std::vector<MotionSequence>>& motions)
{
  for (const auto& part : motions)
  {
    for (const MotionSequence& sequence : part.second)
    {
      for (const Motion& motion : sequence.Motions)
      {
        const Status status = CheckMotion(part.first, motion);
        if (!status.IsOk())
        {
          return status;
        }
      }
    }
  }
  return {};
}

Vec3 FindCentroid(const TriangleMesh& mesh, const std::vector<vtkIdType>& cells)
{
  CentroidSum sum;
  for (const vtkIdType cell : cells)
  {
    sum.Add(mesh.GetCorner(cell, 0), mesh.GetCorner(cell, 1), mesh.GetCorner(cell, 2));
  }
  return sum.Get();
}

/// Assigns points to parts; returns an error if a moving part shares one.
Status ShareOutPoints(const TriangleMesh& mesh, vtkDataArray* partIds,
  const std::map<int, std::size_t>& places, std::vector<MovingPart>& parts)
{
  constexpr int Nobody = -1;
  std::vector<int> owners(static_cast<std::size_t>(mesh.GetNumberOfPoints()), Nobody);
  const vtkTypeInt32* corners = mesh.GetCorners();
  for (vtkIdType i = 0; i < 3 * mesh.GetNumberOfTriangles(); ++i)
  {
    const auto found = places.find(static_cast<int>(partIds->GetComponent(i / 3, 0)));
    const int owner = found != places.end() ? static_cast<int>(found->second) + 1 : 0;
    int& before = owners[static_cast<std::size_t>(corners[i])];
    if (before != Nobody && before != owner)
    {
      return Status::Error("point " + std::to_string(corners[i]) +
        " belongs to a part that moves, part " +
        std::to_string(parts[static_cast<std::size_t>(std::max(before, owner)) - 1].Id) +
        ", and to another one; compose the parts with vtkHeliosSceneComposer, which gives each its "
        "own points");
    }
    if (before == Nobody && owner > 0)
    {
      parts[static_cast<std::size_t>(owner) - 1].Points.push_back(corners[i]);
    }
    before = owner;
  }
  return {};
}

void TurnNormals(
  const std::vector<MovingPart>& parts, const std::vector<MotionMap>& maps, vtkPolyData* scene)
{
  vtkDataArray* before = scene->GetCellData()->GetNormals();
  const bool turns =
    std::any_of(maps.begin(), maps.end(), [](const MotionMap& map) { return map.Turns; });
  if (!before || !turns)
  {
    return;
  }
  auto normals = vtkSmartPointer<vtkDataArray>::Take(before->NewInstance());
  normals->DeepCopy(before);
  for (std::size_t i = 0; i < parts.size(); ++i)
  {
    for (const vtkIdType cell : parts[i].Cells)
    {
      const Vec3 normal(before->GetTuple3(cell));
      normals->SetTuple(cell, (maps[i].Turns ? maps[i].Linear * normal : normal).GetData());
    }
  }
  scene->GetCellData()->SetNormals(normals);
}

} // namespace

//------------------------------------------------------------------------------
void CentroidSum::Add(const double p[3], const double q[3], const double r[3])
{
  this->Base = this->Count++ == 0 ? Vec3(p) : this->Base;
  const Vec3 a = Vec3(p) - this->Base;
  const Vec3 b = Vec3(q) - this->Base;
  const Vec3 c = Vec3(r) - this->Base;
  const Vec3 middle = (1.0 / 3.0) * (a + b + c);
  const double area = (b - a).Cross(c - a).Norm();
  this->ByArea = this->ByArea + area * middle;
  this->Plain = this->Plain + middle;
  this->Areas += area;
}

void CentroidSum::Add(const CentroidSum& other, const Similarity& place)
{
  if (other.Count == 0)
  {
    return;
  }
  const auto count = static_cast<double>(other.Count);
  Vec3 mean, centroid;
  place.Apply((other.Base + (1.0 / count) * other.Plain).GetData(), mean.GetData());
  place.Apply(other.Get().GetData(), centroid.GetData());
  this->Base = this->Count == 0 ? mean : this->Base;
  const double areas = place.Scale * place.Scale * other.Areas;
  this->ByArea = this->ByArea + areas * (centroid - this->Base);
  this->Plain = this->Plain + count * (mean - this->Base);
  this->Areas += areas;
  this->Count += other.Count;
}

Vec3 CentroidSum::Get() const
{
  return this->Base +
    (this->Areas > 0.0 ? (1.0 / this->Areas) * this->ByArea
                       : (1.0 / static_cast<double>(this->Count)) * this->Plain);
}

//------------------------------------------------------------------------------
Status FindMovingParts(vtkPolyData* scene,
  const std::map<int, std::vector<MotionSequence>>& motions, std::vector<MovingPart>& parts)
{
  parts.clear();
  TriangleMesh mesh;
  Status status = CheckMotions(motions);
  status = status.IsOk() ? mesh.Set(scene) : status;
  vtkDataArray* partIds = scene->GetCellData()->GetArray(names::PartIds);
  if (status.IsOk() && (!partIds || partIds->GetNumberOfTuples() < mesh.GetNumberOfTriangles()))
  {
    status = Status::Error(std::string("the scene has no cell array ") + names::PartIds +
      " with the part of each triangle; compose it with vtkHeliosSceneComposer");
  }
  if (!status.IsOk())
  {
    return status;
  }
  std::map<int, std::vector<vtkIdType>> cells;
  for (vtkIdType i = 0; i < mesh.GetNumberOfTriangles(); ++i)
  {
    const auto part = static_cast<int>(partIds->GetComponent(i, 0));
    if (motions.count(part) > 0)
    {
      cells[part].push_back(i);
    }
  }
  std::map<int, std::size_t> places;
  for (const auto& part : motions)
  {
    if (cells[part.first].empty())
    {
      return Status::Error("part " + std::to_string(part.first) +
        " moves, but the scene has no triangle of it; parts are numbered from 0, like the "
        "composer's inputs");
    }
    places[part.first] = parts.size();
    const Vec3 centroid = FindCentroid(mesh, cells[part.first]);
    parts.push_back({ part.first, PartMotion(part.second, centroid), {}, cells[part.first] });
  }
  status = ShareOutPoints(mesh, partIds, places, parts);
  if (!status.IsOk())
  {
    parts.clear();
  }
  return status;
}

//------------------------------------------------------------------------------
void MoveParts(
  const std::vector<MovingPart>& parts, const std::vector<MotionMap>& maps, vtkPolyData* scene)
{
  const auto isAtRest = [](const MotionMap& map)
  { return !map.Turns && map.Shift == Vec3(0.0, 0.0, 0.0); };
  if (std::all_of(maps.begin(), maps.end(), isAtRest))
  {
    return;
  }
  vtkPoints* before = scene->GetPoints();
  auto points = vtkSmartPointer<vtkPoints>::New();
  points->SetDataTypeToDouble();
  points->DeepCopy(before); // converts to double
  double* to = vtkDoubleArray::FastDownCast(points->GetData())->GetPointer(0);
  for (std::size_t i = 0; i < parts.size(); ++i)
  {
    for (const vtkIdType point : parts[i].Points)
    {
      const Vec3 moved = maps[i] * Vec3(to + 3 * point);
      std::copy_n(moved.GetData(), 3, to + 3 * point);
    }
  }
  scene->SetPoints(points);
  TurnNormals(parts, maps, scene);
}

//------------------------------------------------------------------------------
vtkIdType CountSteps(double time, double step)
{
  const double steps = time / step;
  const double nearest = std::round(steps);
  const double count = std::abs(steps - nearest) <= 1e-12 * steps ? nearest : std::floor(steps);
  return static_cast<vtkIdType>(std::min(std::max(count, 0.0), 9e15));
}

} // namespace helios
