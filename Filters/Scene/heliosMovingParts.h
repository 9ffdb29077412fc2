// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// The points and cells of moving parts, and their motion.

#ifndef heliosMovingParts_h
#define heliosMovingParts_h

#include "heliosPartMotion.h"
#include "heliosSimilarity.h"
#include "heliosStatus.h"

#include <map>
#include <string>
#include <vector>

class vtkPolyData;

namespace helios
{

/// The area centroid of triangles; the mean of their corners if the area is zero.
class VTKHELIOSFILTERSSCENE_EXPORT CentroidSum
{
public:
  void Add(const double p[3], const double q[3], const double r[3]);

  /// Adds the triangles of another one, moved to a place.
  void Add(const CentroidSum& other, const Similarity& place);

  Vec3 Get() const;

private:
  Vec3 Base{ 0.0, 0.0, 0.0 }; // keeps precision far from 0
  Vec3 ByArea{ 0.0, 0.0, 0.0 };
  Vec3 Plain{ 0.0, 0.0, 0.0 };
  double Areas = 0.0;
  vtkIdType Count = 0;
};

/// A part, its points and triangles, and its motion about its centroid.
struct MovingPart
{
  int Id;
  PartMotion Motion;
  std::vector<vtkIdType> Points;
  std::vector<vtkIdType> Cells;
};

/// Finds the parts of a scene that have motions.
VTKHELIOSFILTERSSCENE_EXPORT Status FindMovingParts(vtkPolyData* scene,
  const std::map<int, std::vector<MotionSequence>>& motions, std::vector<MovingPart>& parts);

/// Moves the points of parts, and rotates the active normals of their cells; one map per part.
VTKHELIOSFILTERSSCENE_EXPORT void MoveParts(
  const std::vector<MovingPart>& parts, const std::vector<MotionMap>& maps, vtkPolyData* scene);

/// Returns the number of whole steps in a time; a step lost to rounding counts.
vtkIdType CountSteps(double time, double step);

} // namespace helios

#endif
