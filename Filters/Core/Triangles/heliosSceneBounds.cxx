// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosSceneBounds.h"

#include "heliosSceneGeometry.h"
#include "vtkHeliosScene.h"

#include <vtkPolyData.h>
#include <vtkType.h>

#include <algorithm>
#include <array>
#include <limits>
#include <numeric>
#include <vector>

namespace helios
{

namespace
{

using Box = std::array<double, 6>;

Box MakeEmptyBox()
{
  constexpr double infinity = std::numeric_limits<double>::infinity();
  return { infinity, -infinity, infinity, -infinity, infinity, -infinity };
}

/// Returns the coordinate of a box on a side, negated if needed: larger is further out.
double GetReach(const Box& box, int side)
{
  return side % 2 == 0 ? -box[side] : box[side];
}

void AddBox(const Box& added, Box& box)
{
  for (int axis = 0; axis < 3; ++axis)
  {
    box[2 * axis] = std::min(box[2 * axis], added[2 * axis]);
    box[2 * axis + 1] = std::max(box[2 * axis + 1], added[2 * axis + 1]);
  }
}

/// Adds the corners of an instance. Without rotation, the box of the prototype is exact.
void AddCorners(const SceneGeometry& geometry, const SceneInstance& instance, Box& box)
{
  if (!instance.Place.HasRotation)
  {
    Box outer;
    geometry.GetBounds(instance, outer.data());
    AddBox(outer, box);
    return;
  }
  const vtkIdType count = geometry.GetPrototype(instance).GetNumberOfTriangles();
  for (vtkIdType triangle = 0; triangle < count; ++triangle)
  {
    double corners[3][3];
    geometry.GetCorners(instance.FirstCell + triangle, corners);
    for (const double* p : corners)
    {
      AddBox({ p[0], p[0], p[1], p[1], p[2], p[2] }, box);
    }
  }
}

/**
 * Computes the corners of an instance only if its outer box reaches beyond those computed. Rounding
 * is monotonic, so no corner is outside of the outer box, not even by rounding.
 */
class TightBox
{
public:
  explicit TightBox(const SceneGeometry& geometry)
    : Geometry(geometry)
    , Tight(MakeEmptyBox())
    , IsDone(geometry.GetInstances().size())
  {
    if (geometry.GetMesh().GetNumberOfTriangles() > 0)
    {
      geometry.GetMesh().GetBounds(this->Tight.data());
    }
    for (const SceneInstance& instance : geometry.GetInstances())
    {
      this->Outer.push_back({});
      geometry.GetBounds(instance, this->Outer.back().data());
    }
  }

  const Box& Compute()
  {
    for (int side = 0; side < 6; ++side)
    {
      this->Extend(side);
    }
    return this->Tight;
  }

private:
  void Extend(int side)
  {
    std::vector<std::size_t> order(this->Outer.size());
    std::iota(order.begin(), order.end(), std::size_t(0));
    std::sort(order.begin(), order.end(),
      [&](std::size_t a, std::size_t b)
      { return GetReach(this->Outer[a], side) > GetReach(this->Outer[b], side); });
    for (const std::size_t i : order)
    {
      if (GetReach(this->Outer[i], side) <= GetReach(this->Tight, side))
      {
        return;
      }
      if (!this->IsDone[i])
      {
        AddCorners(this->Geometry, this->Geometry.GetInstances()[i], this->Tight);
        this->IsDone[i] = true;
      }
    }
  }

  const SceneGeometry& Geometry;
  Box Tight;
  std::vector<Box> Outer; ///< outer boxes of the instances
  std::vector<bool> IsDone;
};

} // namespace

//------------------------------------------------------------------------------
void ComputeTightBounds(const SceneGeometry& geometry, double bounds[6])
{
  const Box box = TightBox(geometry).Compute();
  std::copy(box.begin(), box.end(), bounds);
}

//------------------------------------------------------------------------------
void ComputeTightBounds(
  const SceneGeometry& geometry, const SceneInstance& instance, double bounds[6])
{
  Box box = MakeEmptyBox();
  AddCorners(geometry, instance, box);
  std::copy(box.begin(), box.end(), bounds);
}

//------------------------------------------------------------------------------
Status GetSceneBounds(vtkPolyData* scene, double bounds[6])
{
  if (!vtkHeliosScene::HasInstances(scene))
  {
    scene->GetBounds(bounds);
    return {};
  }
  SceneGeometry geometry;
  const Status status = geometry.Set(scene);
  if (status.IsOk())
  {
    ComputeTightBounds(geometry, bounds);
  }
  return status;
}

} // namespace helios
