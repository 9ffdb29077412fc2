// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// The triangles and triangle sides of a mesh, sorted so that equal ones are neighbours.

#ifndef heliosMeshRecords_h
#define heliosMeshRecords_h

#include "vtkHeliosFiltersSceneModule.h"

#include <vtkType.h>

#include <cstddef>
#include <vector>

namespace helios
{

/// Triangles as three corners each, and the group (part) of each: different groups are never equal.
struct Triangles
{
  const vtkTypeInt32* Corners;
  const int* Groups;
  vtkIdType Count;
  vtkIdType NumberOfPoints;
};

/// Side k of a triangle goes from its corner k to the next one; Use is 3 times the triangle plus k.
struct SideRecord
{
  vtkTypeInt32 Low;
  vtkTypeInt32 High;
  int Group;
  vtkIdType Use;

  bool IsSameEdge(const SideRecord& other) const
  {
    return this->Low == other.Low && this->High == other.High && this->Group == other.Group;
  }
};

/// A triangle by its corners in ascending order.
struct FaceRecord
{
  vtkTypeInt32 Low;
  vtkTypeInt32 Middle;
  vtkTypeInt32 High;
  int Group;
  vtkIdType Cell;

  bool IsSameFace(const FaceRecord& other) const
  {
    return this->Low == other.Low && this->Middle == other.Middle && this->High == other.High &&
      this->Group == other.Group;
  }
};

/**
 * Returns the sides of all triangles with three different corners, edge by edge, in ascending order
 * of their triangles within an edge. Sorted by the lower end first, which takes one pass, then
 * among the few that share it. A half-edge structure could not hold edges of three triangles.
 */
VTKHELIOSFILTERSSCENE_EXPORT std::vector<SideRecord> SortSides(const Triangles& triangles);

/// Returns the triangles with three different corners, equal ones adjacent, the lowest first.
VTKHELIOSFILTERSSCENE_EXPORT std::vector<FaceRecord> SortFaces(const Triangles& triangles);

/// Returns whether a side goes from its lower to its higher end.
inline bool IsAscending(const SideRecord& side, const vtkTypeInt32* corners)
{
  return corners[side.Use] == side.Low;
}

/// Calls visit(first, last) for the records of each edge, in the order of SortSides.
template <typename VisitT>
void ForEachEdge(const std::vector<SideRecord>& sides, VisitT visit)
{
  for (std::size_t first = 0, last = 0; first < sides.size(); first = last)
  {
    while (last < sides.size() && sides[last].IsSameEdge(sides[first]))
    {
      ++last;
    }
    visit(sides.data() + first, sides.data() + last);
  }
}

} // namespace helios

#endif
