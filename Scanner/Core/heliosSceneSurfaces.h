// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// What the triangles of a scene are made of, as plain arrays.

#ifndef heliosSceneSurfaces_h
#define heliosSceneSurfaces_h

#include "heliosPose.h"
#include "heliosRadiometry.h"

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

  const SurfaceReflection& GetReflection(int material) const
  {
    return this->Reflections[static_cast<std::size_t>(material)];
  }
  int GetClassification(int material) const
  {
    return this->Classifications[static_cast<std::size_t>(material)];
  }

  /// Sets the unit normal that the scene gives a cell; leaves it as it is where the scene gives none.
  void GetNormal(vtkIdType cell, Vec3& normal) const
  {
    if (!this->Normals)
    {
      return;
    }
    const float* n = this->Normals + 3 * cell;
    const Vec3 given(n[0], n[1], n[2]);
    const double length = given.Norm();
    if (length > 0.0)
    {
      normal = (1.0 / length) * given;
    }
  }

private:
  std::string SetMaterials(vtkPolyData* scene);
  std::string CheckMaterialIds() const;

  vtkSmartPointer<vtkIntArray> MaterialArray;
  vtkSmartPointer<vtkIntArray> PartArray;
  vtkSmartPointer<vtkFloatArray> NormalArray;
  const int* Materials = nullptr;
  const int* Parts = nullptr;
  const float* Normals = nullptr;
  std::vector<SurfaceReflection> Reflections; // of the materials
  std::vector<int> Classifications;
};

} // namespace helios

#endif
