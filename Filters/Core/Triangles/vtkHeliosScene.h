// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHeliosScene
 * @brief   a scene of a mesh, of instances of other meshes, and of rasters of heights
 *
 * The mesh is this vtkPolyData itself, with the cell arrays and material columns of any scene; it
 * may be empty. Instances are meshes at several places that are stored once. They are what
 * vtkGlyph3DMapper draws: prototypes are its sources, instances its input, with
 * - points: the translation [m], double;
 * - point data PrototypeIds (int): the number of the prototype;
 * - point data Orientation (4 doubles, optional): quaternion w, x, y, z of any length but 0;
 *   default: no rotation;
 * - point data Scale (double, optional): greater than 0, default 1;
 * - point data PartIds (int, optional), default 0;
 * - point data MaterialIds (int, optional): the material of all triangles of the instance; -1, the
 *   default: the materials of the prototype;
 * - point data FirstCellIds (int64, optional): the cell id of its first triangle, ascending; cells
 *   of the mesh have the ids between. Default: all instances follow the mesh.
 *
 * A point p of a prototype is at R p s + t. MaterialIds of prototypes are rows of the material
 * columns in the field data of this scene.
 *
 * A prototype may also be a raster of heights, as from vtkHeliosGeoTiffHeightReader: a vtkImageData
 * with the point data Heights and the field data GeoTransform. Its triangles equal the output of
 * vtkHeliosGeoTiffSceneReader and are computed on demand; their material is the material of the
 * instance, by default the first.
 *
 * Ray casters, the scanner and their users take such a scene as a mesh; the ray caster "beam"
 * without copies of the triangles. vtkHeliosSceneFlatten makes a mesh for all other filters.
 *
 * @sa
 * vtkHeliosSceneComposer vtkHeliosSceneFlatten
 */

#ifndef vtkHeliosScene_h
#define vtkHeliosScene_h

#include "vtkHeliosFiltersCoreModule.h" // For export macro
#include "vtkPolyData.h"

#include "vtkSmartPointer.h" // For the instances
#include <vector>            // For the prototypes

class VTKHELIOSFILTERSCORE_EXPORT vtkHeliosScene : public vtkPolyData
{
public:
  static vtkHeliosScene* New();
  vtkTypeMacro(vtkHeliosScene, vtkPolyData);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Set/Get the instances, with the arrays above. Null: none. Default: null.
   */
  void SetInstances(vtkPolyData* instances);
  vtkPolyData* GetInstances() const { return this->Instances; }
  vtkIdType GetNumberOfInstances() const;
  ///@}

  ///@{
  /**
   * Adds a mesh (vtkPolyData) or raster (vtkImageData) of the instances, numbered from 0; returns
   * one (null: no such number).
   */
  void AddPrototype(vtkDataSet* prototype);
  vtkDataSet* GetPrototype(int prototype) const;
  int GetNumberOfPrototypes() const { return static_cast<int>(this->Prototypes.size()); }
  ///@}

  /**
   * Returns the number of triangles of the mesh and of all instances; an invalid raster has none.
   */
  vtkIdType GetNumberOfTriangles() const;

  /// Returns whether a scene is a vtkHeliosScene with instances.
  static bool HasInstances(vtkPolyData* scene);

  ///@{
  /**
   * Computes the bounds of the mesh and of the instances.
   */
  void ComputeBounds() override;
  void Initialize() override;
  void ShallowCopy(vtkDataObject* from) override;
  void DeepCopy(vtkDataObject* from) override;
  vtkMTimeType GetMTime() override;
  unsigned long GetActualMemorySize() override;
  ///@}

protected:
  vtkHeliosScene() = default;
  ~vtkHeliosScene() override = default;

private:
  vtkHeliosScene(const vtkHeliosScene&) = delete;
  void operator=(const vtkHeliosScene&) = delete;

  vtkSmartPointer<vtkPolyData> Instances;
  std::vector<vtkSmartPointer<vtkDataSet>> Prototypes;
};

#endif
