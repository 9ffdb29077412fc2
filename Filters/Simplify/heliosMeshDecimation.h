// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// OpenMesh's decimation by collapsing half-edges, held within tolerances at points and edges.

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
  std::vector<vtkTypeInt32> PointIds; ///< of the scene
  std::vector<bool> IsLocked;         ///< points that must stay
  std::vector<vtkTypeInt32> Corners;  ///< three a triangle
  std::vector<vtkIdType> Cells;       ///< of the scene, one a triangle
};

/// What a decimation leaves: some of a patch's triangles, with other corners of the patch.
struct DecimatedPatch
{
  std::vector<vtkTypeInt32> Corners;
  std::vector<vtkIdType> Triangles; ///< of the patch, ascending
  std::vector<vtkIdType>
    PlaceOfPoint;         ///< where a point taken out is counted to in Triangles; or -1
  vtkIdType Rejected = 0; ///< triangles that fit no half-edges, kept as they are
};

/**
 * Takes points out, the least quadric error first (M. Garland, P. Heckbert 1997, OpenMesh's
 * ModQuadric), as long as every point taken out, and the middle of every edge, is within its tolerance of the triangle it is
 * counted to and no triangle turns its face. Run again, it repeats what it did as far as the
 * tolerances still allow it, which takes a fraction of the time. Throws Stopped where it
 * is told to stop.
 */
class MeshDecimation
{
public:
  explicit MeshDecimation(const Patch& patch);

  DecimatedPatch Run(const std::vector<double>& tolerances, StopCheck& check);

private:
  const Patch& Source;
  std::vector<std::pair<int, int>> History; ///< points taken out, and those they went to
};

} // namespace helios

#endif
