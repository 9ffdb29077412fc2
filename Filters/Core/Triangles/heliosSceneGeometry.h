// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// The triangles of a scene: of its mesh, and of prototypes at instances.

#ifndef heliosSceneGeometry_h
#define heliosSceneGeometry_h

#include "heliosPose.h"
#include "heliosPrototype.h"
#include "heliosSimilarity.h"
#include "heliosStatus.h"
#include "heliosTriangleMesh.h"
#include "vtkHeliosFiltersCoreModule.h" // For export macro

#include <vtkPolyData.h>
#include <vtkSmartPointer.h>
#include <vtkType.h>

#include <vector>

class vtkHeliosScene;

namespace helios
{

/// A prototype at a place.
struct SceneInstance
{
  Similarity Place;
  int PrototypeId = 0;
  int Part = 0;
  int Material = -1;         ///< material of all triangles; -1: materials of the prototype
  vtkIdType FirstCell = 0;   ///< the cell id of its first triangle
  vtkIdType CellsBefore = 0; ///< triangles of the mesh with lower cell ids

  /// Computes the corners of a triangle of the prototype in the scene.
  void GetCorners(const Prototype& prototype, vtkIdType triangle, double corners[3][3]) const
  {
    prototype.GetCorners(triangle, corners);
    for (int corner = 0; corner < 3; ++corner)
    {
      this->Place.Apply(corners[corner], corners[corner]);
    }
  }
};

/**
 * Cell ids count all triangles, 64-bit; the ids of an instance are consecutive. Corners of
 * instances equal the corners of a copy of the prototype moved by vtkHeliosSceneTransform.
 */
class VTKHELIOSFILTERSCORE_EXPORT SceneGeometry
{
public:
  /**
   * Sets a scene, which may be a vtkHeliosScene, and keeps references. Errors: see TriangleMesh and
   * HeightField; and instances whose values are invalid.
   */
  Status Set(vtkPolyData* scene);

  vtkPolyData* GetScene() const { return this->Scene; }

  /// Returns the triangles that are no instance's; may be empty.
  const TriangleMesh& GetMesh() const { return this->Mesh; }
  const std::vector<Prototype>& GetPrototypes() const { return this->Prototypes; }
  const std::vector<SceneInstance>& GetInstances() const { return this->Instances; }
  const Prototype& GetPrototype(const SceneInstance& instance) const
  {
    return this->Prototypes[static_cast<std::size_t>(instance.PrototypeId)];
  }

  vtkIdType GetNumberOfTriangles() const { return this->NumberOfTriangles; }

  /// Where the triangle of a cell is stored.
  struct Cell
  {
    const SceneInstance* Instance; ///< null: in the mesh
    vtkIdType Triangle;
  };
  Cell Find(vtkIdType cell) const
  {
    return this->Instances.empty() ? Cell{ nullptr, cell } : this->FindInstance(cell);
  }

  /// Returns the cell id of a triangle of the mesh.
  vtkIdType GetCell(vtkIdType triangle) const
  {
    return this->Instances.empty() ? triangle : this->CountCells(triangle);
  }

  void GetCorners(vtkIdType cell, double corners[3][3]) const;

  /// Returns the unit normal of a cell, see TriangleMesh::GetNormal().
  Vec3 GetNormal(vtkIdType cell) const;

  /// Computes a box that contains all corners, to rounding: x0 x1 y0 y1 z0 z1. Tight for the mesh.
  void GetBounds(double bounds[6]) const;

  /// Computes the box of an instance.
  void GetBounds(const SceneInstance& instance, double bounds[6]) const;

  /// Bytes held by this object in addition to the scene.
  std::size_t GetMemorySize() const;

private:
  Status AddPrototypes(vtkHeliosScene* scene);
  Status AddInstances(vtkPolyData* instances);
  Status SetCells(vtkPolyData* instances);
  Cell FindInstance(vtkIdType cell) const;
  vtkIdType CountCells(vtkIdType triangle) const;

  vtkSmartPointer<vtkPolyData> Scene;
  TriangleMesh Mesh;
  std::vector<Prototype> Prototypes;
  std::vector<SceneInstance> Instances;
  vtkIdType NumberOfTriangles = 0;
};

} // namespace helios

#endif
