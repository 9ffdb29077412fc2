// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHeliosMeshRepair
 * @brief   takes out the triangles and points that no scene needs, and counts bad edges
 *
 * Input 0: a vtkPolyData of triangles. Output 0: the same without
 * - triangles with a corner that is not finite,
 * - degenerate triangles: a corner twice, or no area, decided exactly for the coordinates as they
 *   are,
 * - duplicate triangles: the same three places, in whatever order. One of opposite winding is a
 *   duplicate, too: a triangle is seen from both sides, and of two at the same place a ray finds
 *   the one with the lowest cell id. That one stays, and its material;
 * - points that no triangle uses.
 *
 * With MergePoints, points at the same place become one, the one with the lowest id, and its point
 * data. What lies in different parts (PartIds) is never merged, nor a duplicate. Nothing else
 * changes: order, winding and coordinates stay, cell and point data follow, field data pass. Points
 * become double. Where there is nothing to repair the input passes by reference.
 *
 * Edges are counted on the result, points at equal coordinates of one part taken as one:
 * - boundary edges have one triangle,
 * - non-manifold edges have more than two,
 * - inconsistent edges have two that run along it the same way: one of them is wound the wrong way.
 *
 * With GenerateEdgeDefects the result has cell data EdgeDefects (unsigned char): the sum of 1, 2
 * and 4 for triangles at a boundary, a non-manifold and an inconsistent edge.
 *
 * Points are found by hash, triangles and edges by sorting them into the buckets of their lowest
 * corner: that takes any soup of triangles, as vegetation is, which structures of half-edges
 * refuse.
 *
 * Errors: cells that are not triangles, corners that are no points, more than 2^31 points, an
 * array shorter than the cells or points, a MergeTolerance that is not finite.
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
   * Set/Get whether points of one part at the same place become one. Default: off.
   */
  vtkSetMacro(MergePoints, bool);
  vtkGetMacro(MergePoints, bool);
  vtkBooleanMacro(MergePoints, bool);
  ///@}

  ///@{
  /**
   * Set/Get how far apart two points may be to be at the same place [m], with MergePoints. Each
   * point in turn goes to the lowest one that stays within that distance; triangles move with it.
   * Valid range: [0, 1e3]; 0: equal coordinates only. Default: 0.
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
   * What the last run took out: triangles by reason (the first that holds, in this order), points
   * that no triangle uses, points that became one with another.
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
