// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// The points and cells of parts that move, and where they go.

#ifndef heliosMovingParts_h
#define heliosMovingParts_h

#include "heliosPartMotion.h"

#include <map>
#include <string>
#include <vector>

class vtkPolyData;

namespace helios
{

/// A part, the points and triangles it has, and how it moves about its centroid.
struct MovingPart
{
  int Id;
  PartMotion Motion;
  std::vector<vtkIdType> Points;
  std::vector<vtkIdType> Cells;
};

/// Finds the parts of a scene that have motions; says in words what is wrong, or returns an empty text.
std::string FindMovingParts(vtkPolyData* scene,
  const std::map<int, std::vector<MotionSequence>>& motions, std::vector<MovingPart>& parts);

/// Moves the points of parts, and turns the active normals of their cells; one map a part.
void MoveParts(
  const std::vector<MovingPart>& parts, const std::vector<MotionMap>& maps, vtkPolyData* scene);

/// The whole steps of a time; one lost to rounding counts.
vtkIdType CountSteps(double time, double step);

} // namespace helios

#endif
