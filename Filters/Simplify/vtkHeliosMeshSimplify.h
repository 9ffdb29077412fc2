// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHeliosMeshSimplify
 * @brief   fewer triangles within a guaranteed distance
 *
 * Input 0: a vtkPolyData of triangles. Output 0: fewer of them, so that no point of the input's
 * surface is further than MaximumDistance from the output's, nor the other way round (Hausdorff's
 * distance of the surfaces). For scenes denser than the scan needs.
 *
 * What stays:
 * - points are points of the input, bit by bit; cell data are those of the triangle that remains,
 *   point and field data follow. Cell data Normals are dropped where triangles were taken out: they
 *   would be another surface's;
 * - the borders of the surface, of parts (PartIds) and of materials (MaterialIds): all their points
 *   and edges, so that patches of different materials stay watertight to each other, each within
 *   the distance by itself;
 * - triangles at edges that more than two triangles share, and what OpenMesh takes for no manifold:
 *   untouched and counted. Triangles without area and duplicates are dropped and counted, as by
 *   vtkHeliosMeshRepair, and points of one part at equal coordinates become one. A soup of single
 *   leaves comes out as it went in, fast.
 *
 * Triangles are taken out by OpenMesh's quadrics (M. Garland, P. Heckbert 1997), as long as the
 * points taken out, and the middles of the edges, stay within 3/4 of the distance and no triangle
 * turns by 75 degrees or more at a time. That says nothing of the places in between. The guarantee
 * comes after it: the distance of every changed triangle from the other surface, cut into pieces
 * over each of which one triangle bounds it (the distance from a triangle is convex), with CGAL's
 * tree of boxes to find the triangles. Where it fails, the points about take less, the decimation
 * is repeated as far as that allows, and so on; a patch that fails 24 times stays untouched.
 * VerifiedDistance is the largest of those bounds: the true distance is not above it, and may be a
 * third below. It is true up to rounding: 1.4e-14 of the size of a patch (a nanometre for 70 km),
 * and a smaller MaximumDistance counts as that. The tests hold it against CGAL's
 * bounded_error_symmetric_Hausdorff_distance, which says the same in several times the time, and
 * not where the limit is exceeded.
 *
 * Patches are worked at in parallel, the largest first; each patch in local coordinates. The result
 * does not depend on the number of threads.
 *
 * @warning
 * This class uses CGAL's AABB tree, which is under the GPL: a program that links this module is,
 * too. It is an optional module (VTKHELIOS_ENABLE_CGAL).
 *
 * Errors: cells that are not triangles, corners that are no points or not finite, an array shorter
 * than the cells or points, a MaximumDistance that is not finite.
 *
 * @sa
 * vtkHeliosMeshRepair
 */

#ifndef vtkHeliosMeshSimplify_h
#define vtkHeliosMeshSimplify_h

#include "vtkHeliosFiltersSimplifyModule.h" // For export macro
#include "vtkPolyDataAlgorithm.h"

class VTKHELIOSFILTERSSIMPLIFY_EXPORT vtkHeliosMeshSimplify : public vtkPolyDataAlgorithm
{
public:
  static vtkHeliosMeshSimplify* New();
  vtkTypeMacro(vtkHeliosMeshSimplify, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Set/Get how far apart the surfaces before and after may be anywhere [m]. Valid range: [0, 1e6];
   * 0: only what is flat is made of fewer triangles. Default: 0.01.
   */
  vtkSetClampMacro(MaximumDistance, double, 0.0, 1e6);
  vtkGetMacro(MaximumDistance, double);
  ///@}

  /**
   * A bound of the distance of the last input and output [m], proven: see above.
   */
  vtkGetMacro(VerifiedDistance, double);

  ///@{
  /**
   * Of the last run: triangles without area and duplicates that were dropped; triangles that fit no
   * manifold, which passed untouched; patches that have points inside, and those of them that
   * stayed as they were.
   */
  vtkGetMacro(NumberOfDroppedTriangles, vtkIdType);
  vtkGetMacro(NumberOfRejectedTriangles, vtkIdType);
  vtkGetMacro(NumberOfPatches, vtkIdType);
  vtkGetMacro(NumberOfUntouchedPatches, vtkIdType);
  ///@}

protected:
  vtkHeliosMeshSimplify() = default;
  ~vtkHeliosMeshSimplify() override = default;

  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkHeliosMeshSimplify(const vtkHeliosMeshSimplify&) = delete;
  void operator=(const vtkHeliosMeshSimplify&) = delete;

  class Run;
  bool Check(vtkPolyData* input);
  void Follow(vtkObject* repair, unsigned long event, void*);
  int Abort();

  double MaximumDistance = 0.01;
  double VerifiedDistance = 0.0;
  vtkIdType NumberOfDroppedTriangles = 0;
  vtkIdType NumberOfRejectedTriangles = 0;
  vtkIdType NumberOfPatches = 0;
  vtkIdType NumberOfUntouchedPatches = 0;
};

#endif
