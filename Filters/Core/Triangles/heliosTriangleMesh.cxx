// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosTriangleMesh.h"

#include "heliosFloatCoordinates.h"
#include "heliosStatus.h"
#include "heliosThreadLoop.h"
#include "vtkHeliosScene.h"

#include <vtkCellArray.h>
#include <vtkDataArray.h>
#include <vtkDoubleArray.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkTypeInt32Array.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>

namespace helios
{

namespace
{

/// The points that corners refer to.
struct PointCheck
{
  const double* Points;
  vtkIdType Count;

  bool Exists(vtkTypeInt32 id) const { return id >= 0 && id < this->Count; }
  bool IsFinite(vtkTypeInt32 id) const
  {
    const double* p = this->Points + 3 * static_cast<vtkIdType>(id);
    return std::isfinite(p[0]) && std::isfinite(p[1]) && std::isfinite(p[2]);
  }

  /// Returns the first corner whose point does not exist or is not finite, or -1; on all threads.
  vtkIdType FindBad(const vtkTypeInt32* corners, vtkIdType count) const
  {
    constexpr vtkIdType chunk = 1 << 18;
    std::atomic<vtkIdType> first(count);
    LoopOnThreads(0, (count + chunk - 1) / chunk,
      [&](vtkIdType begin, vtkIdType end)
      {
        vtkIdType i = begin * chunk;
        const vtkIdType last = std::min(count, end * chunk);
        while (i < last && this->Exists(corners[i]) && this->IsFinite(corners[i]))
        {
          ++i;
        }
        for (vtkIdType known = first; i < last && i < known;)
        {
          first.compare_exchange_weak(known, i);
        }
      });
    return first < count ? first.load() : -1;
  }
};

} // namespace

Status CheckNoInstances(vtkPolyData* scene)
{
  return vtkHeliosScene::HasInstances(scene)
    ? Status::Error("the scene has instances, which are not supported here; pass it through "
                    "vtkHeliosSceneFlatten first")
    : Status();
}

Status TriangleMesh::Set(vtkPolyData* scene)
{
  *this = TriangleMesh();
  if (Status status = CheckNoInstances(scene); !status.IsOk())
  {
    return status;
  }
  if (!scene || scene->GetNumberOfCells() == 0)
  {
    return Status::Error("the scene is empty: it has no triangles");
  }
  vtkCellArray* polys = scene->GetPolys();
  if (scene->GetNumberOfCells() != polys->GetNumberOfCells() || polys->IsHomogeneous() != 3)
  {
    return Status::Error(
      "the scene has cells that are not triangles; pass it through vtkTriangleFilter first");
  }
  const vtkIdType pointCount = scene->GetNumberOfPoints();
  if (pointCount > std::numeric_limits<vtkTypeInt32>::max())
  {
    return Status::Error("the scene has " + std::to_string(pointCount) +
      " points, more than 2^31; split it into several scenes");
  }

  vtkDataArray* points = scene->GetPoints()->GetData();
  if (Status status = CheckFloatCoordinates(points, "the scene"); !status.IsOk())
  {
    return status;
  }
  if (auto* doubles = vtkDoubleArray::FastDownCast(points))
  {
    this->Points = doubles->GetPointer(0);
  }
  else
  {
    this->OwnPoints.resize(3 * static_cast<std::size_t>(pointCount));
    for (vtkIdType i = 0; i < pointCount; ++i)
    {
      points->GetTuple(i, &this->OwnPoints[3 * static_cast<std::size_t>(i)]);
    }
    this->Points = this->OwnPoints.data();
  }

  this->NumberOfTriangles = polys->GetNumberOfCells();
  if (polys->IsStorage64Bit())
  {
    const vtkTypeInt64* corners = polys->GetConnectivityArray64()->GetPointer(0);
    this->OwnCorners.assign(corners, corners + 3 * this->NumberOfTriangles);
    this->Corners = this->OwnCorners.data();
  }
  else
  {
    this->Corners = polys->GetConnectivityArray32()->GetPointer(0);
  }

  this->NumberOfPoints = pointCount;
  const PointCheck check{ this->Points, pointCount };
  if (const vtkIdType bad = check.FindBad(this->Corners, 3 * this->NumberOfTriangles); bad >= 0)
  {
    const std::string cell = "cell " + std::to_string(bad / 3) + " of the scene ";
    const vtkTypeInt32 point = this->Corners[bad];
    return check.Exists(point) ? Status::Error(cell + "has a corner that is not finite (point " +
                                   std::to_string(point) + "); repair or remove it")
                               : Status::Error(cell + "refers to point " + std::to_string(point) +
                                   ", but it has " + std::to_string(pointCount));
  }
  this->Scene = scene;
  return {};
}

Vec3 GetTriangleNormal(const double p[3], const double q[3], const double r[3])
{
  const Vec3 a(p);
  const Vec3 b(q);
  const Vec3 c(r);
  Vec3 normal = (b - a).Cross(c - a);
  normal.Normalize();
  return normal;
}

Vec3 GetTriangleWeights(const double corners[3][3], const Vec3& point)
{
  const Vec3 a(corners[0]);
  const Vec3 u = Vec3(corners[1]) - a;
  const Vec3 v = Vec3(corners[2]) - a;
  const Vec3 p = point - a;
  const double uu = u.Dot(u);
  const double uv = u.Dot(v);
  const double vv = v.Dot(v);
  const double area = uu * vv - uv * uv;
  const double s = area > 0.0 ? (vv * p.Dot(u) - uv * p.Dot(v)) / area : 0.0;
  const double t = area > 0.0 ? (uu * p.Dot(v) - uv * p.Dot(u)) / area : 0.0;
  const Vec3 weights(std::max(0.0, 1.0 - s - t), std::max(0.0, s), std::max(0.0, t));
  return (1.0 / (weights[0] + weights[1] + weights[2])) * weights;
}

Vec3 TriangleMesh::GetNormal(vtkIdType triangle) const
{
  return GetTriangleNormal(
    this->GetCorner(triangle, 0), this->GetCorner(triangle, 1), this->GetCorner(triangle, 2));
}

void TriangleMesh::GetBounds(double bounds[6]) const
{
  for (int axis = 0; axis < 3; ++axis)
  {
    bounds[2 * axis] = std::numeric_limits<double>::infinity();
    bounds[2 * axis + 1] = -std::numeric_limits<double>::infinity();
  }
  for (vtkIdType i = 0; i < 3 * this->NumberOfTriangles; ++i)
  {
    const double* p = this->Points + 3 * static_cast<vtkIdType>(this->Corners[i]);
    for (int axis = 0; axis < 3; ++axis)
    {
      bounds[2 * axis] = std::min(bounds[2 * axis], p[axis]);
      bounds[2 * axis + 1] = std::max(bounds[2 * axis + 1], p[axis]);
    }
  }
}

std::size_t TriangleMesh::GetMemorySize() const
{
  return this->OwnPoints.capacity() * sizeof(double) +
    this->OwnCorners.capacity() * sizeof(vtkTypeInt32);
}

} // namespace helios
