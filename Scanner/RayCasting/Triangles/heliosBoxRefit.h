// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Fits the boxes of a tree to points that have moved.

#ifndef heliosBoxRefit_h
#define heliosBoxRefit_h

#include "heliosBeamStorage.h"
#include "heliosMeshFrames.h"
#include "vtkHeliosScannerRayCastingModule.h" // For export macro

#include <vtkType.h>

#include <vector>

namespace helios
{

class TriangleMesh;

/// The order in which the nodes of a tree are fitted, and the corners of the triangles in it.
struct VTKHELIOSSCANNERRAYCASTING_EXPORT RefitOrder
{
  std::vector<vtkTypeUInt32> Nodes;  ///< children before their parents
  std::vector<unsigned char> Counts; ///< triangles of each leaf below these nodes
  std::vector<vtkTypeInt32> Corners; ///< the points of these triangles, three each

  /// Sets the order for a tree over a mesh.
  void Set(const BeamStorage& tree, const TriangleMesh& mesh);
};

/// Fits a tree to a part of the way between two frames. One per thread: it keeps its memory.
class VTKHELIOSSCANNERRAYCASTING_EXPORT BoxRefit
{
public:
  /// Fits the boxes of the nodes to where points are at the fractions from low to high.
  void Run(const RefitOrder& order, const MeshShape& shape, vtkIdType numberOfPoints, double low,
    double high, const TreeFrame& frame, BeamStorage& tree);

private:
  /// A box of floats in the frame of the tree; the fourth lanes are to be ignored.
  struct alignas(32) Box
  {
    float Low[4];
    float High[4];
  };

  static void FitPoints(const MeshShape& shape, vtkIdType count, double low, double high,
    const TreeFrame& frame, Box* boxes);
  static void FitNodes(const RefitOrder& order, const Box* points, Box* nodes, BeamStorage& tree);

  std::vector<Box> Points;
  std::vector<Box> Nodes;
};

} // namespace helios

#endif
