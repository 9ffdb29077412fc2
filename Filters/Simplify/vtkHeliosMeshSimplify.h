// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHeliosMeshSimplify
 * @brief   fewer triangles within a guaranteed distance
 *
 * Input 0: a vtkPolyData of triangles. Output 0: fewer of them, such that no point of the input
 * surface is further than MaximumDistance from the output surface, and vice versa (Hausdorff
 * distance of the surfaces). For scenes denser than the scan needs.
 *
 * Invariants:
 * - points are points of the input, bit by bit; cell data come from the remaining triangle, point
 *   and field data follow. Cell data Normals are dropped if triangles were removed: they would
 *   belong to another surface;
 * - the borders of the surface, of parts (PartIds) and of materials (MaterialIds): all their points
 *   and edges, so that patches of different materials stay watertight to each other, each within
 *   the distance by itself;
 * - triangles at edges that more than two triangles share, and those OpenMesh rejects as
 *   non-manifold: unchanged and counted. Triangles of zero area and duplicates are dropped and
 *   counted, see vtkHeliosMeshRepair, and points of one part at equal coordinates are merged. A
 *   soup of single leaves passes unchanged and fast.
 *
 * Triangles are removed by OpenMesh's quadrics (M. Garland, P. Heckbert 1997), as long as the
 * removed points, and the midpoints of the edges, stay within 3/4 of the distance and no triangle
 * rotates by 75 degrees or more at a time. That does not bound the distance in between. The
 * guarantee comes from a second step: the distance of every changed triangle from the other
 * surface, split into pieces over each of which one triangle bounds it (the distance from a
 * triangle is convex), with CGAL's AABB tree to find the triangles. If it fails, the tolerances of
 * nearby points are reduced, the decimation is repeated as far as that allows, and so on; a patch
 * that fails 24 times stays unchanged. VerifiedDistance is the largest of those bounds: the true
 * distance is not above it, and may be a third below. It holds up to rounding: 1.4e-14 of the size
 * of a patch (a nanometre for 70 km), and a smaller MaximumDistance counts as that. The tests
 * compare it with CGAL's bounded_error_symmetric_Hausdorff_distance, which gives the same, takes
 * several times as long, and does not locate where the limit is exceeded.
 *
 * Patches are processed in parallel, the largest first; each patch in local coordinates. The result
 * does not depend on the number of threads.
 *
 * @warning
 * This class uses CGAL's AABB tree, which is under the GPL; so is any program that links this
 * module. It is an optional module (VTKHELIOS_ENABLE_CGAL).
 *
 * Errors: cells that are not triangles, corners with invalid ids or not finite, an array shorter
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
   * Set/Get the maximum distance between the surfaces before and after [m]. Valid range: [0, 1e6];
   * 0: only flat regions get fewer triangles. Default: 0.01.
   */
  vtkSetClampMacro(MaximumDistance, double, 0.0, 1e6);
  vtkGetMacro(MaximumDistance, double);
  ///@}

  /**
   * A proven bound on the distance between the last input and output [m], see above.
   */
  vtkGetMacro(VerifiedDistance, double);

  ///@{
  /**
   * Get, from the last run, dropped triangles of zero area and duplicates; non-manifold triangles,
   * which passed unchanged; patches with interior points, and how many of these stayed unchanged.
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
