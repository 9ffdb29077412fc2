// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// The materials of the triangles and the turbid voxels of a scene, as plain arrays.

#ifndef heliosSceneSurfaces_h
#define heliosSceneSurfaces_h

#include "heliosMaterialTable.h"
#include "heliosPose.h"
#include "heliosRadiometry.h"
#include "heliosSceneGeometry.h"
#include "heliosStatus.h"
#include "vtkHeliosScannerCoreModule.h" // For export macro

#include <vtkFloatArray.h>
#include <vtkIntArray.h>
#include <vtkSmartPointer.h>
#include <vtkStringArray.h>

#include <string>
#include <vector>

class vtkDataObject;
class vtkDataSet;
class vtkImageData;
class vtkPolyData;

namespace helios
{

class SceneSurfaces
{
public:
  /**
   * Reads a scene and keeps its arrays alive. Its geometry must outlive it if it has instances; null:
   * it has none.
   */
  VTKHELIOSSCANNERCORE_EXPORT Status Set(
    vtkPolyData* scene, const SceneGeometry* geometry = nullptr);

  /**
   * Appends a grid of turbid voxels; its cell ids, materials and part follow all previous ones.
   * Gets the id of its first cell.
   */
  VTKHELIOSSCANNERCORE_EXPORT Status AddGrid(vtkImageData* grid, vtkIdType& firstCell);

  /// Replaces the geometry by one in which instances move.
  void SetGeometry(const SceneGeometry& geometry)
  {
    this->Geometry = this->Geometry ? &geometry : nullptr;
  }

  /// Sets the wavelength [nm] of the light, on which the attenuation of water depends.
  void SetWavelength(double wavelength);

  /// Returns whether an id belongs to a voxel.
  bool IsTurbid(vtkIdType cell) const { return cell >= this->NumberOfTriangles; }

  int GetMaterialId(vtkIdType cell) const
  {
    return this->IsTurbid(cell) ? this->FindGrid(cell).GetMaterialId(cell)
      : this->Geometry          ? this->FindMaterialId(cell)
                                : this->Mesh.GetMaterialId(cell);
  }
  int GetPartId(vtkIdType cell) const
  {
    return this->IsTurbid(cell) ? this->FindGrid(cell).Part
      : this->Geometry          ? this->FindPartId(cell)
                                : this->Mesh.GetPartId(cell);
  }

  /// Returns whether triangles of one plane have the same response and part.
  bool AreAlike(vtkIdType a, vtkIdType b) const
  {
    return !this->HasNormals &&
      (this->Geometry && !this->IsTurbid(a) && !this->IsTurbid(b)
          ? this->AreAlikeInInstances(a, b)
          : this->GetMaterialId(a) == this->GetMaterialId(b) &&
            this->GetPartId(a) == this->GetPartId(b));
  }

  /// Passes the names of all parts, the coordinate system and the materials of grids to the echoes,
  /// if set.
  void PassFields(vtkPolyData* scene, vtkPolyData* echoes) const;

  const SurfaceReflection& GetReflection(int material) const
  {
    return this->Reflections[static_cast<std::size_t>(material)];
  }
  int GetClassification(int material) const
  {
    return this->Classifications[static_cast<std::size_t>(material)];
  }

  /// Returns whether any surface reflects like a mirror or transmits light.
  bool HasOptics() const { return !this->Optics.empty(); }

  /// Returns the optics of a cell; null if it is opaque.
  const MaterialOptics* GetOptics(vtkIdType cell) const
  {
    if (this->Optics.empty() || cell < 0 || this->IsTurbid(cell))
    {
      return nullptr;
    }
    const auto& optics = this->Optics[static_cast<std::size_t>(this->GetMaterialId(cell))];
    return optics.Kind == OpticsKind::Opaque ? nullptr : &optics;
  }

  /// Returns the share of the light that leaves of a material transmit; 0 of other materials.
  double GetLeafTransmittance(int material) const
  {
    const auto* optics =
      this->Optics.empty() ? nullptr : &this->Optics[static_cast<std::size_t>(material)];
    return optics && optics->Kind == OpticsKind::Leaf ? optics->Transmittance : 0.0;
  }

  /// Sets the unit normal of a cell from the scene; unchanged if the scene has none.
  void GetNormal(vtkIdType cell, Vec3& normal) const
  {
    if (!this->HasNormals || this->IsTurbid(cell))
    {
      return;
    }
    const Vec3 given = this->Geometry ? this->FindNormal(cell) : this->Mesh.GetNormal(cell);
    const double length = given.Norm();
    if (length > 0.0)
    {
      normal = (1.0 / length) * given;
    }
  }

private:
  /// The cell arrays of a mesh.
  struct CellArrays
  {
    vtkSmartPointer<vtkIntArray> MaterialArray;
    vtkSmartPointer<vtkIntArray> PartArray;
    vtkSmartPointer<vtkFloatArray> NormalArray;
    const int* Materials = nullptr;
    const int* Parts = nullptr;
    const float* Normals = nullptr;

    Status Set(vtkPolyData* mesh, const std::string& what);
    int GetMaterialId(vtkIdType cell) const { return this->Materials ? this->Materials[cell] : 0; }
    int GetPartId(vtkIdType cell) const { return this->Parts ? this->Parts[cell] : 0; }
    Vec3 GetNormal(vtkIdType cell) const
    {
      const float* n = this->Normals ? this->Normals + 3 * cell : nullptr;
      return n ? Vec3(n[0], n[1], n[2]) : Vec3(0.0, 0.0, 0.0);
    }
  };

  /// Turbid voxels and their materials.
  struct Grid
  {
    vtkIdType FirstCell;
    vtkSmartPointer<vtkIntArray> Materials; // null: all the first
    int FirstMaterial;
    int Part;
    std::string Name;

    int GetMaterialId(vtkIdType cell) const
    {
      return this->FirstMaterial +
        (this->Materials ? this->Materials->GetValue(cell - this->FirstCell) : 0);
    }
  };

  const Grid& FindGrid(vtkIdType cell) const;
  vtkSmartPointer<vtkStringArray> MakePartNames() const;
  int CountParts() const;
  Status AddMaterials(vtkDataObject* data, const std::string& what);
  void AddOptics(const MaterialTable& materials);
  Status CheckMaterialIds(vtkIntArray* ids, int count, const std::string& what) const;
  Status AddInstances(vtkPolyData* scene);
  int FindMaterialId(vtkIdType cell) const;
  int GetMaterialIdAt(const SceneGeometry::Cell& at) const;
  bool AreAlikeInInstances(vtkIdType a, vtkIdType b) const;
  int FindPartId(vtkIdType cell) const;
  Vec3 FindNormal(vtkIdType cell) const;

  CellArrays Mesh;
  std::vector<CellArrays> Prototypes;
  const SceneGeometry* Geometry = nullptr; // null: no instances
  bool HasNormals = false;
  vtkIdType NumberOfTriangles = VTK_ID_MAX;
  vtkSmartPointer<vtkStringArray> PartNames; // names of the scene; null: none
  std::vector<Grid> Grids;
  MaterialTable GridMaterials;
  vtkIdType NumberOfCells = 0;                // number of triangles and voxels
  std::vector<SurfaceReflection> Reflections; // one per material
  std::vector<int> Classifications;
  std::vector<MaterialOptics> Optics; // one per material; empty: all are opaque
};

} // namespace helios

#endif
