// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Builds the nodes and leaves of a BeamTree in parts, which take little memory while they are built.
// For sources only, as heliosBoxSplit.h.

#ifndef heliosBeamBuilder_h
#define heliosBeamBuilder_h

#include "heliosBeamPacking.h"
#include "heliosBeamStorage.h"
#include "heliosBoxSplit.h"
#include "heliosCoarseBox.h"
#include "heliosStopCheck.h"

#include <vtkType.h>

#include <cstring>
#include <vector>

namespace helios
{

class BeamPart;
class TriangleMesh;

/**
 * Triangles are divided by coarse boxes of 16 bytes each until parts are small enough; a part is
 * built in floats by one thread, and appended, the last one first; then its coarse boxes are freed.
 * The tree does not depend on the number of threads.
 */
class BeamBuilder
{
public:
  /// The mesh and the frame must outlive this; a leaf gets up to leafSize triangles.
  BeamBuilder(const TriangleMesh& mesh, const TreeFrame& frame, vtkIdType count, int leafSize);
  ~BeamBuilder();

  /// Sets a triangle, of the number given at first.
  void SetTriangle(vtkIdType i, vtkTypeInt32 triangle);

  /// Builds the tree over the triangles, which are gone then.
  void Build(BeamStorage& tree, StopCheck& check);

private:
  /// Coarse boxes from the first to the last.
  struct Part
  {
    vtkTypeInt32 First;
    vtkTypeInt32 Last;
    int Depth;
    vtkTypeUInt32 Root;
    PlainBox Bounds;
  };

  void Divide(vtkTypeInt32 size, StopCheck& check);
  void BuildParts(BeamStorage& tree, StopCheck& check);
  void Append(const BeamPart& from, Part& part, BeamStorage& tree) const;
  void SetTopBoxes();
  void MakeTop(BeamStorage& tree) const;

  const TriangleMesh& Mesh;
  const TreeFrame& Frame;
  const int LeafSize;
  TreeArray<CoarseBox> Boxes;
  std::vector<Part> Parts;    ///< in any order
  std::vector<SplitNode> Top; ///< the binary tree above the parts; a leaf is the number of a part
};

} // namespace helios

#endif
