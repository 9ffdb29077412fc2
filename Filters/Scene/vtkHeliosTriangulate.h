// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHeliosTriangulate
 * @brief   makes triangles of the polygons of a mesh
 *
 * Input 0: a mesh (vtkPolyData). Output 0: its points, and the triangles of its polygons and strips
 * in their order, with the cell data of each and the field data; vertices and lines are left out. A
 * mesh that has only triangles passes by reference.
 *
 * Polygons are triangulated like polygons of files: as a fan about the first corner if that covers
 * them once (convex polygons), else by a constrained Delaunay triangulation. They may be concave,
 * not quite plane, touch themselves in vertices, and have holes that a side leads to and back:
 * vtkTriangleFilter drops those. Their area is kept to rounding, also far from the origin.
 *
 * Warning: polygons whose sides cross. Error: more than 2^31 - 1 points.
 *
 * @sa
 * vtkHeliosMeshRepair vtkHeliosSceneComposer
 */

#ifndef vtkHeliosTriangulate_h
#define vtkHeliosTriangulate_h

#include "vtkHeliosFiltersSceneModule.h" // For export macro
#include "vtkPolyDataAlgorithm.h"

class VTKHELIOSFILTERSSCENE_EXPORT vtkHeliosTriangulate : public vtkPolyDataAlgorithm
{
public:
  static vtkHeliosTriangulate* New();
  vtkTypeMacro(vtkHeliosTriangulate, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * Returns whether a mesh has triangles only, or nothing.
   */
  static bool HasOnlyTriangles(vtkPolyData* mesh);

  ///@{
  /**
   * Get the number of polygons of the last update whose sides cross.
   */
  vtkGetMacro(NumberOfCrossedPolygons, vtkIdType);
  ///@}

protected:
  vtkHeliosTriangulate() = default;
  ~vtkHeliosTriangulate() override = default;

  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkHeliosTriangulate(const vtkHeliosTriangulate&) = delete;
  void operator=(const vtkHeliosTriangulate&) = delete;

  vtkIdType NumberOfCrossedPolygons = 0;
};

#endif
