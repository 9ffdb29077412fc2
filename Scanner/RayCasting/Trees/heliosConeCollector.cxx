// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma GCC diagnostic ignored "-Wpsabi" // vectors are passed to inlined functions only
#include "heliosConeCollector.h"

#include "heliosConeWalk.h"
#include "heliosSceneTree.h"

#include <algorithm>
#include <cmath>

namespace helios
{

namespace
{

/// Triangles in order, delayed by some steps, in which their corners are fetched from memory.
class FetchQueue
{
public:
  template <typename UseT>
  void Add(const PlacedTree& placed, vtkTypeInt32 triangle, UseT use)
  {
    if (this->Size == 0 || !placed.IsSame(this->Placed))
    {
      this->Finish(use);
      this->Placed = placed;
    }
    placed.GetTree().PrefetchNumbers(triangle);
    this->Triangles[this->Size++ % Capacity] = triangle;
    this->Advance(this->Size, use);
  }

  /// Uses those that are left.
  template <typename UseT>
  void Finish(UseT use)
  {
    for (std::size_t i = 1; i <= 2 * Step && this->Used < this->Size; ++i)
    {
      this->Advance(this->Size + i, use);
    }
    this->Size = 0;
    this->Used = 0;
  }

private:
  static constexpr std::size_t Step = 16;
  static constexpr std::size_t Capacity = 64; ///< more than two steps, and a power of two

  template <typename UseT>
  void Advance(std::size_t now, UseT use)
  {
    if (now > Step && now - Step <= this->Size)
    {
      this->Placed.GetTree().PrefetchPoints(this->Triangles[(now - Step - 1) % Capacity]);
    }
    if (now > 2 * Step)
    {
      use(this->Placed, this->Triangles[this->Used++ % Capacity]);
    }
  }

  PlacedTree Placed; ///< the tree of all
  std::size_t Size = 0;
  std::size_t Used = 0;
  vtkTypeInt32 Triangles[Capacity];
};

HELIOS_INLINE void Turn(const Rotation& rotation, const Doubles from[3], Doubles to[3])
{
  for (int axis = 0; axis < 3; ++axis)
  {
    const auto& row = rotation.M[axis];
    to[axis] = row[0] * from[0] + row[1] * from[1] + row[2] * from[2];
  }
}

/// Moves points in lanes to the scene, as Similarity::Apply() does.
HELIOS_INLINE void Apply(const Similarity& place, Doubles p[3])
{
  if (place.HasPivot)
  {
    Doubles q[3];
    for (int axis = 0; axis < 3; ++axis)
    {
      q[axis] = p[axis] - place.Pivot[axis];
    }
    Turn(place.Turn, q, p);
    for (int axis = 0; axis < 3; ++axis)
    {
      p[axis] = place.Pivot[axis] + p[axis];
    }
  }
  else if (place.HasRotation)
  {
    const Doubles q[3] = { p[0], p[1], p[2] };
    Turn(place.Turn, q, p);
  }
  for (int axis = 0; axis < 3; ++axis)
  {
    p[axis] = p[axis] * place.Scale + place.Translation[axis];
  }
}

} // namespace

ConeCollector::ConeCollector(const double origin[3], const double axis[3], double tanHalfAngle)
  : Shape(origin, axis, tanHalfAngle)
{
  this->IsValid = SetAxis(origin, axis, this->Axis) && tanHalfAngle >= 0.0;
}

//------------------------------------------------------------------------------
bool ConeCollector::Run(const SceneTree& scene, double nearest, std::size_t maximum, ConeView& view)
{
  constexpr std::size_t transient =
    4; // times as many before those that a triangle hides are dropped
  view.Triangles.clear();
  this->Shape.CopyFrame(view.Frame);
  FetchQueue queue;
  const auto use = [&](const PlacedTree& placed, vtkTypeInt32 triangle)
  { this->Add(placed, triangle, nearest, view); };
  const bool isWhole = this->IsValid &&
    WalkCone(this->Shape, this->Axis.Axes, scene, this->Farthest,
      [&](const PlacedTree& placed, vtkTypeInt32 triangle)
      {
        queue.Add(placed, triangle, use);
        return view.Triangles.size() <= transient * maximum;
      });
  queue.Finish(use);
  this->AddBlock(nearest, view);
  view.Farthest = this->Farthest;
  view.Finish();
  this->DropHidden(view);
  return isWhole && view.Triangles.size() <= maximum;
}

//------------------------------------------------------------------------------
/// Adds a triangle that may touch the cone to those that are tested next.
void ConeCollector::Add(
  const PlacedTree& placed, vtkTypeInt32 triangle, double nearest, ConeView& view)
{
  Block& block = this->Waiting;
  if (block.Size > 0 && !placed.IsSame(block.Placed))
  {
    this->AddBlock(nearest, view);
  }
  if (block.Size == 0)
  {
    block.Placed = placed;
  }
  double buffer[3][3];
  const double* points[3];
  placed.GetTree().GetPoints(triangle, buffer, points);
  for (int corner = 0; corner < 3; ++corner)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      block.Corners[corner][axis][block.Size] = points[corner][axis];
    }
  }
  block.Cells[block.Size++] = placed.GetCell(triangle);
  if (block.Size == Block::Width)
  {
    this->AddBlock(nearest, view);
  }
}

//------------------------------------------------------------------------------
/// Moves the corners of a block from the frame of its tree to that of the cone, and tests them.
HELIOS_CLONES
void ConeCollector::Test(Block& block, double nearest) const
{
  const double* origin = this->Shape.GetOrigin();
  const double tangent = this->Shape.GetTangent();
  constexpr double inside = 1 - 1e-6; // beyond doubt
  Masks isBeyond[4] = { Masks() - 1, Masks() - 1, Masks() - 1, Masks() - 1 };
  Masks isBehind = Masks() - 1;
  Masks isBefore = Masks() - 1;
  Masks hasCorner = Masks();
  for (auto& corner : block.Corners)
  {
    Doubles p[3];
    for (int axis = 0; axis < 3; ++axis)
    {
      p[axis] = Load<Doubles>(corner[axis]);
    }
    if (block.Placed.IsMoved())
    {
      Apply(block.Placed.GetPlace(), p);
    }
    for (int axis = 0; axis < 3; ++axis)
    {
      p[axis] = p[axis] - origin[axis];
    }
    Doubles q[3];
    for (int axis = 0; axis < 3; ++axis)
    {
      const double* row = this->Shape.GetAxis(axis);
      q[axis] = row[0] * p[0] + row[1] * p[1] + row[2] * p[2];
      Store(corner[axis], q[axis]);
    }
    const Doubles reach = tangent * q[2];
    for (int axis = 0; axis < 2; ++axis)
    {
      isBeyond[2 * axis] &= q[axis] > reach;
      isBeyond[2 * axis + 1] &= -q[axis] > reach;
    }
    const Doubles radius = reach * inside;
    isBehind &= q[2] <= nearest;
    isBefore &= q[2] > 0.0;
    hasCorner |= q[0] * q[0] + q[1] * q[1] < radius * radius;
  }
  Store(block.IsBeside, isBeyond[0] | isBeyond[1] | isBeyond[2] | isBeyond[3] | isBehind);
  Store(block.HasCornerInside, hasCorner & isBefore);
}

//------------------------------------------------------------------------------
/// Adds those of a block that may touch the cone to a view; one that covers it hides what is farther.
void ConeCollector::AddBlock(double nearest, ConeView& view)
{
  Block& block = this->Waiting;
  this->Test(block, nearest);
  for (int i = 0; i < block.Size; ++i)
  {
    // A triangle with a corner inside touches the cone, and cannot cover it.
    if (block.IsBeside[i] != 0)
    {
      continue;
    }
    ConeCandidate c;
    for (int corner = 0; corner < 3; ++corner)
    {
      for (int axis = 0; axis < 3; ++axis)
      {
        c.Corners[corner][axis] = block.Corners[corner][axis][i];
      }
    }
    const bool hasCornerInside = block.HasCornerInside[i] != 0;
    if (!hasCornerInside && !this->Shape.Touches(c))
    {
      continue;
    }
    view.Triangles.emplace_back();
    view.Triangles.back().Cell = block.Cells[i];
    std::copy_n(&c.Corners[0][0], 9, &view.Triangles.back().Corners[0][0]);
    if (!hasCornerInside && c.Covers && c.IsBefore)
    {
      this->Shape.SetPlane(c);
      this->Farthest =
        c.Surface.Nearest > nearest ? std::min(this->Farthest, c.Surface.Farthest) : this->Farthest;
    }
  }
  block.Size = 0;
}

//------------------------------------------------------------------------------
/// Drops triangles all of which in the cone is hidden: whether the tree returned them depends on its
/// boxes.
void ConeCollector::DropHidden(ConeView& view) const
{
  if (!(this->Farthest < HUGE_VAL) || view.Triangles.size() == 1)
  {
    return;
  }
  const auto isHidden = [this](const ConeTriangle& t)
  {
    if (std::max({ t.Corners[0][2], t.Corners[1][2], t.Corners[2][2] }) <= this->Farthest)
    {
      return false;
    }
    ConeCandidate c;
    std::copy_n(&t.Corners[0][0], 9, &c.Corners[0][0]);
    if (!this->Shape.Touches(c))
    {
      return true;
    }
    this->Shape.SetPlane(c);
    return this->Shape.GetNearestDepth(c) > this->Farthest;
  };
  view.Triangles.erase(
    std::remove_if(view.Triangles.begin(), view.Triangles.end(), isHidden), view.Triangles.end());
}

} // namespace helios
