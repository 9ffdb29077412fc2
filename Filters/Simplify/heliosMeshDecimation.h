// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// OpenMesh's decimation by half-edge collapse, within tolerances at points and edges.

#ifndef heliosMeshDecimation_h
#define heliosMeshDecimation_h

#include "heliosPose.h"
#include "heliosStopCheck.h"

#include <vtkType.h>

#include <utility>
#include <vector>

namespace helios
{

/// Triangles of one material and part in a local frame.
struct Patch
{
  std::vector<Vec3> Points;
  std::vector<vtkTypeInt32> PointIds; ///< points of the scene
  std::vector<bool> IsLocked;         ///< points that must stay
  std::vector<vtkTypeInt32> Corners;  ///< three per triangle
  std::vector<vtkIdType> Cells;       ///< cells of the scene, one per triangle
};

/// The result of a decimation: some of a patch's triangles, with other corners of the patch.
struct DecimatedPatch
{
  std::vector<vtkTypeInt32> Corners;
  std::vector<vtkIdType> Triangles; ///< triangles of the patch, ascending
  std::vector<vtkIdType>
    PlaceOfPoint;         ///< index in Triangles that a removed point is assigned to; or -1
  vtkIdType Rejected = 0; ///< triangles that fit no half-edges, kept unchanged
};

/**
 * Removes points, the smallest quadric error first (M. Garland, P. Heckbert 1997, OpenMesh's
 * ModQuadric), as long as every removed point, and the midpoint of every edge, is within its
 * tolerance of the triangle it is assigned to and no triangle flips. A second run repeats the
 * previous collapses as far as the tolerances still allow them, which takes a fraction of the time.
 * Throws Stopped if the stop check returns true.
 */
class MeshDecimation
{
public:
  explicit MeshDecimation(const Patch& patch);

  DecimatedPatch Run(const std::vector<double>& tolerances, StopCheck& check);

private:
  const Patch& Source;
  std::vector<std::pair<int, int>> History; ///< removed points, and those they were collapsed to
};

} // namespace helios

#endif
