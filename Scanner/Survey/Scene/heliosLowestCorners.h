// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// The lowest corners of meshes that stand at many places.

#ifndef heliosLowestCorners_h
#define heliosLowestCorners_h

#include "heliosPose.h"
#include "vtkHeliosScannerSurveyModule.h" // For export macro

#include <map>
#include <vector>

class vtkPolyData;

namespace helios
{

/// Finds the first lowest corner of a mesh along a direction; false if it has no triangles.
VTKHELIOSSCANNERSURVEY_EXPORT bool FindLowestCorner(
  vtkPolyData* mesh, const Vec3& up, Vec3& lowest);

/// Finds the lowest corners of meshes for many directions. A mesh is searched once for directions
/// that differ only by rounding, such as the directions of parts that are rotated about the
/// vertical.
class VTKHELIOSSCANNERSURVEY_EXPORT LowestCorners
{
public:
  void Clear() { this->Known.clear(); }

  /// Finds the lowest corner for a unit vector, like FindLowestCorner().
  bool Find(vtkPolyData* mesh, const Vec3& up, Vec3& lowest);

private:
  /// The corners that may be the lowest along directions near a direction, in their order.
  struct Candidates
  {
    Vec3 Up{ 0.0, 0.0, 0.0 };
    std::vector<Vec3> Corners;
  };

  static Candidates FindCandidates(vtkPolyData* mesh, const Vec3& up);

  std::map<vtkPolyData*, Candidates> Known;
};

} // namespace helios

#endif
