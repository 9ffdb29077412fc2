// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// What the triangles of a scene are made of, as plain arrays.

#ifndef heliosSceneSurfaces_h
#define heliosSceneSurfaces_h

#include "heliosPose.h"

#include <vtkFloatArray.h>
#include <vtkIntArray.h>
#include <vtkSmartPointer.h>

#include <string>
#include <vector>

class vtkPolyData;

namespace helios
{

class SceneSurfaces
{
public:
  /// Looks at a scene and keeps its arrays alive. Says in words what is wrong, or returns an empty text.
  std::string Set(vtkPolyData* scene);

  int GetMaterialId(vtkIdType cell) const { return this->Materials ? this->Materials[cell] : 0; }
  int GetPartId(vtkIdType cell) const { return this->Parts ? this->Parts[cell] : 0; }

  /// [0..1] of a material.
  double GetReflectance(int material) const
  {
    return this->Reflectances[static_cast<std::size_t>(material)];
  }
  int GetClassification(int material) const
  {
    return this->Classifications[static_cast<std::size_t>(material)];
  }

  /// The unit normal that the scene gives a cell; false where it gives none.
  bool GetNormal(vtkIdType cell, Vec3& normal) const
  {
    if (!this->Normals)
    {
      return false;
    }
    const float* n = this->Normals + 3 * cell;
    normal = Vec3(n[0], n[1], n[2]);
    const double length = normal.Norm();
    normal = length > 0.0 ? (1.0 / length) * normal : normal;
    return length > 0.0;
  }

private:
  void SetMaterials(vtkPolyData* scene);
  std::string CheckMaterialIds() const;

  vtkSmartPointer<vtkIntArray> MaterialArray;
  vtkSmartPointer<vtkIntArray> PartArray;
  vtkSmartPointer<vtkFloatArray> NormalArray;
  const int* Materials = nullptr;
  const int* Parts = nullptr;
  const float* Normals = nullptr;
  std::vector<double> Reflectances; // of the materials
  std::vector<int> Classifications;
};

} // namespace helios

#endif
