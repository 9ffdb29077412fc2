// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// A tree of the boxes of instances.

#ifndef heliosBoxTree_h
#define heliosBoxTree_h

#include "heliosBeamTree.h"
#include "heliosTriangleMesh.h"

#include <vtkType.h>

#include <array>
#include <cstddef>
#include <vector>

namespace helios
{

class StopCheck;

/// A tree of the boxes of instances.
struct VTKHELIOSSCANNERRAYCASTING_EXPORT BoxTree
{
  TriangleMesh Mesh; ///< a triangle for each, with the bounds of its box; empty if built fast
  BeamTree Tree;
  std::vector<int> Instances; ///< their numbers; empty: those of the triangles

  int GetInstance(vtkTypeInt32 triangle) const
  {
    return this->Instances.empty() ? triangle : this->Instances[static_cast<std::size_t>(triangle)];
  }
  void Build(const std::vector<std::array<double, 6>>& boxes, StopCheck& check);

  /// Builds fast, for boxes of a short time.
  void Build(std::vector<std::array<double, 6>> boxes);
  std::size_t GetMemorySize() const;
};

} // namespace helios

#endif
