// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Collects the triangles in a cone.

#ifndef heliosConeCollector_h
#define heliosConeCollector_h

#include "heliosCone.h"
#include "heliosConeView.h"
#include "heliosPlacedTree.h"
#include "heliosTriangleTest.h"

#include <cstddef>

namespace helios
{

class SceneTree;

class ConeCollector
{
public:
  ConeCollector(const double origin[3], const double axis[3], double tanHalfAngle);

  /// Collects the triangles in the cone, see ConeProbe::Collect().
  bool Run(const SceneTree& scene, double nearest, std::size_t maximum, ConeView& view);

private:
  /// Triangles of one tree that are tested together.
  struct Block
  {
    static constexpr int Width = 4;
    int Size = 0;
    PlacedTree Placed;
    vtkIdType Cells[Width];
    double Corners[3][3]
                  [Width] = {}; ///< by corner and axis; before the test in the frame of the tree
    long long IsBeside[Width];  ///< or too near
    long long HasCornerInside[Width];
  };
  void Add(const PlacedTree& placed, vtkTypeInt32 triangle, double nearest, ConeView& view);
  void AddBlock(double nearest, ConeView& view);
  void Test(Block& block, double nearest) const;
  void DropHidden(ConeView& view) const;

  Cone Shape;
  TestRay Axis;
  bool IsValid;
  Block Waiting;
  double Farthest = NoHit; ///< depth beyond which a triangle hides all others
};

} // namespace helios

#endif
