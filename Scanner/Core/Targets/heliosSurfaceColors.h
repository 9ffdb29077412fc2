// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// The colours of the surfaces of a scene.

#ifndef heliosSurfaceColors_h
#define heliosSurfaceColors_h

#include "heliosMaterialTable.h"
#include "heliosPose.h"
#include "heliosSceneGeometry.h"
#include "heliosTexture.h"
#include "vtkHeliosScannerCoreModule.h" // For export macro

#include <vtkSmartPointer.h>
#include <vtkType.h>

#include <array>
#include <memory>
#include <string>
#include <vector>

class vtkDataArray;
class vtkDataObject;
class vtkImageData;
class vtkPolyData;

namespace helios
{

/**
 * Finds the colour of a place on a surface: the cell array RGB of its triangle, else the point
 * array between its corners, else the base colour of its material times its texture; black if it
 * has none.
 */
class VTKHELIOSSCANNERCORE_EXPORT SurfaceColors
{
public:
  /**
   * Reads the colours of a scene and its voxel grids, whose textures the store has; keeps the arrays
   * alive, and the geometry must outlive this (null: no triangles).
   */
  void Set(vtkPolyData* scene, const std::vector<vtkImageData*>& grids,
    const SceneGeometry* geometry, const TextureStore& store);

  /// Replaces the geometry by one in which instances move.
  void SetGeometry(const SceneGeometry& geometry)
  {
    this->Geometry = this->Geometry ? &geometry : nullptr;
  }

  /// Returns whether anything is coloured.
  bool IsEmpty() const { return !this->HasColors; }

  /// Returns the colour of a cell at a point; its material is a row of the materials of the scene
  /// and then of the grids.
  std::array<float, 3> Find(vtkIdType cell, int material, const Vec3& point) const;

private:
  /// The cell arrays of a mesh; null: none.
  struct Arrays
  {
    vtkSmartPointer<vtkDataArray> Colors;
    vtkSmartPointer<vtkDataArray> CornerColors; ///< red green blue of each of the three corners
    vtkSmartPointer<vtkDataArray> Coordinates;
  };
  struct Row
  {
    MaterialColor Color;
    std::shared_ptr<const Texture> Image; ///< null: none
  };

  Arrays FindArrays(vtkPolyData* mesh);
  void AddMaterials(vtkDataObject* data, const TextureStore& store);
  Rgb FindOnTriangle(
    vtkIdType cell, const Vec3& point, const Texture* image, const Rgb& base) const;
  Vec3 FindWeights(vtkIdType cell, const Vec3& point) const;

  const SceneGeometry* Geometry = nullptr;
  Arrays Mesh;
  std::vector<Arrays> Prototypes;
  std::vector<Row> Rows; // rows of the materials
  bool HasColors = false;
};

} // namespace helios

#endif
