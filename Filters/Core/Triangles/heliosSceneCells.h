// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// The cell arrays of a scene with instances.

#ifndef heliosSceneCells_h
#define heliosSceneCells_h

#include "heliosPose.h"
#include "heliosSceneGeometry.h"
#include "vtkHeliosFiltersCoreModule.h" // For export macro

#include <vtkSmartPointer.h>
#include <vtkType.h>

#include <vector>

class vtkDataArray;
class vtkPolyData;

namespace helios
{

/**
 * Values by cell id, as the mesh of vtkHeliosSceneFlatten has them: PartIds, MaterialIds, Normals.
 * For a few cells; the scanner has SceneSurfaces.
 */
class VTKHELIOSFILTERSCORE_EXPORT SceneCells
{
public:
  /// Keeps the arrays of a scene alive; its geometry must outlive this.
  SceneCells(vtkPolyData* scene, const SceneGeometry& geometry);

  /// Returns the part of a cell; -1: the scene has no parts.
  int GetPart(vtkIdType cell) const;

  /// Returns the material of a cell; -1: the scene has no material ids.
  int GetMaterial(vtkIdType cell) const;

  /// Gets the unit normal of the array Normals; false: it has none for the cell.
  bool GetNormal(vtkIdType cell, Vec3& normal) const;

private:
  /// Cell arrays of a mesh; null: none.
  struct Arrays
  {
    vtkSmartPointer<vtkDataArray> Parts;
    vtkSmartPointer<vtkDataArray> Materials;
    vtkSmartPointer<vtkDataArray> Normals;
  };

  const Arrays& GetArrays(const SceneGeometry::Cell& at) const;

  const SceneGeometry& Geometry;
  Arrays Mesh;
  std::vector<Arrays> Prototypes;
};

/// Returns the nearest float, for values that a copy of a prototype stores in floats.
VTKHELIOSFILTERSCORE_EXPORT double RoundToFloat(double x);

} // namespace helios

#endif
