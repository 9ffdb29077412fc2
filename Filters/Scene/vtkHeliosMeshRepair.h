// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHeliosMeshRepair
 * @brief   removes invalid and duplicate triangles and unused points, and counts bad edges
 *
 * Input 0: a vtkPolyData of triangles. Output 0: the same without
 * - triangles with a corner that is not finite,
 * - degenerate triangles: a repeated corner, or zero area, decided exactly for the given
 *   coordinates,
 * - duplicate triangles: the same three positions, in any order. One of opposite winding is also a
 *   duplicate: triangles are two-sided, and of two at the same position a ray hits the one with the
 *   lowest cell id. That one stays, with its material;
 * - points that no triangle uses.
 *
 * With MergePoints, points at the same position become one, the one with the lowest id, and its
 * point data. Different parts (PartIds) are never merged, nor duplicates of each other. Nothing
 * else changes: order, winding and coordinates stay, cell and point data follow, field data pass.
 * Points become double. If there is nothing to repair the input passes by reference.
 *
 * Edges are counted on the result, with points at equal coordinates of one part as one:
 * - boundary edges have one triangle,
 * - non-manifold edges have more than two,
 * - inconsistent edges have two in the same direction: one of them has the wrong winding.
 *
 * With GenerateEdgeDefects the result has cell data EdgeDefects (unsigned char): the sum of 1, 2
 * and 4 for triangles at a boundary, a non-manifold and an inconsistent edge.
 *
 * Points are found by hash, triangles and edges by sorting them into the buckets of their lowest
 * corner: this works for any soup of triangles, such as vegetation, which half-edge structures
 * reject.
 *
 * Errors: cells that are not triangles, corners with invalid ids, more than 2^31 points, an array
 * shorter than the cells or points, a MergeTolerance that is not finite.
 *
 * @sa
 * vtkHeliosMeshSimplify vtkHeliosSceneComposer
 */

#ifndef vtkHeliosMeshRepair_h
#define vtkHeliosMeshRepair_h

#include "vtkHeliosFiltersSceneModule.h" // For export macro
#include "vtkPolyDataAlgorithm.h"

class VTKHELIOSFILTERSSCENE_EXPORT vtkHeliosMeshRepair : public vtkPolyDataAlgorithm
{
public:
  static vtkHeliosMeshRepair* New();
  vtkTypeMacro(vtkHeliosMeshRepair, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// The bits of EdgeDefects.
  enum EdgeDefectType
  {
    BOUNDARY = 1,
    NON_MANIFOLD = 2,
    INCONSISTENT = 4
  };

  ///@{
  /**
   * Set/Get whether points of one part at the same position are merged. Default: off.
   */
  vtkSetMacro(MergePoints, bool);
  vtkGetMacro(MergePoints, bool);
  vtkBooleanMacro(MergePoints, bool);
  ///@}

  ///@{
  /**
   * Set/Get the maximum distance of merged points [m], with MergePoints. Each point in turn goes to
   * the lowest remaining one within that distance; triangles move with it. Valid range: [0, 1e3];
   * 0: equal coordinates only. Default: 0.
   */
  vtkSetClampMacro(MergeTolerance, double, 0.0, 1e3);
  vtkGetMacro(MergeTolerance, double);
  ///@}

  ///@{
  /**
   * Set/Get whether the output has the cell data EdgeDefects. Default: off.
   */
  vtkSetMacro(GenerateEdgeDefects, bool);
  vtkGetMacro(GenerateEdgeDefects, bool);
  vtkBooleanMacro(GenerateEdgeDefects, bool);
  ///@}

  ///@{
  /**
   * Removed in the last run: triangles by reason (the first that applies, in this order), unused
   * points, merged points.
   */
  vtkGetMacro(NumberOfNonFiniteTriangles, vtkIdType);
  vtkGetMacro(NumberOfDegenerateTriangles, vtkIdType);
  vtkGetMacro(NumberOfDuplicateTriangles, vtkIdType);
  vtkGetMacro(NumberOfUnusedPoints, vtkIdType);
  vtkGetMacro(NumberOfMergedPoints, vtkIdType);
  ///@}

  ///@{
  /**
   * The edges of the last result, see above.
   */
  vtkGetMacro(NumberOfBoundaryEdges, vtkIdType);
  vtkGetMacro(NumberOfNonManifoldEdges, vtkIdType);
  vtkGetMacro(NumberOfInconsistentEdges, vtkIdType);
  ///@}

protected:
  vtkHeliosMeshRepair() = default;
  ~vtkHeliosMeshRepair() override = default;

  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkHeliosMeshRepair(const vtkHeliosMeshRepair&) = delete;
  void operator=(const vtkHeliosMeshRepair&) = delete;

  struct Mesh;
  bool Read(vtkPolyData* input, Mesh& mesh);
  void DropNonFinite(Mesh& mesh);
  void FindPlaces(Mesh& mesh);
  void DropDegenerate(Mesh& mesh);
  void DropDuplicates(Mesh& mesh);
  void CheckEdges(Mesh& mesh);
  void Write(const Mesh& mesh, vtkPolyData* input, vtkPolyData* output);
  void ResetCounters();

  bool MergePoints = false;
  double MergeTolerance = 0.0;
  bool GenerateEdgeDefects = false;
  vtkIdType NumberOfNonFiniteTriangles = 0;
  vtkIdType NumberOfDegenerateTriangles = 0;
  vtkIdType NumberOfDuplicateTriangles = 0;
  vtkIdType NumberOfUnusedPoints = 0;
  vtkIdType NumberOfMergedPoints = 0;
  vtkIdType NumberOfBoundaryEdges = 0;
  vtkIdType NumberOfNonManifoldEdges = 0;
  vtkIdType NumberOfInconsistentEdges = 0;
};

#endif
