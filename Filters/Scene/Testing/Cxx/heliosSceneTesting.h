// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Measurements on scenes, shared by the tests.

#ifndef heliosSceneTesting_h
#define heliosSceneTesting_h

#include "heliosMaterialTable.h"
#include "heliosTriangleMesh.h"
#include "vtkHeliosArrayNames.h"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkIntArray.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <algorithm>
#include <limits>
#include <map>
#include <utility>

namespace helios
{

/// A triangle at x, with material id 0 of a table of the given materials.
inline vtkSmartPointer<vtkPolyData> MakeTriangle(
  double x, const MaterialTable& materials, bool narrow = true, int precision = VTK_DOUBLE)
{
  vtkNew<vtkPoints> points;
  points->SetDataType(precision);
  points->InsertNextPoint(x, 0, 0);
  points->InsertNextPoint(x + 1, 0, 0);
  points->InsertNextPoint(x, 1, 0);
  vtkNew<vtkCellArray> polys;
  narrow ? polys->Use32BitStorage() : polys->Use64BitStorage();
  polys->InsertNextCell({ 0, 1, 2 });
  vtkNew<vtkIntArray> ids;
  ids->SetName(vtkHeliosArrayNames::MaterialIds);
  ids->InsertNextValue(0);
  auto part = vtkSmartPointer<vtkPolyData>::New();
  part->SetPoints(points);
  part->SetPolys(polys);
  part->GetCellData()->AddArray(ids);
  SetMaterials(part, materials);
  return part;
}

inline Material MakeMaterial(const char* name, double reflectance)
{
  Material material;
  material.Name = name;
  material.Reflectance = reflectance;
  return material;
}

inline vtkIntArray* GetIds(vtkPolyData* scene, const char* name)
{
  return vtkIntArray::SafeDownCast(scene->GetCellData()->GetArray(name));
}

/// The number of directed edges not matched by exactly one opposite edge.
inline int CountOpenEdges(const TriangleMesh& mesh)
{
  std::map<std::pair<int, int>, int> edges;
  for (vtkIdType i = 0; i < mesh.GetNumberOfTriangles(); ++i)
  {
    const vtkTypeInt32* c = mesh.GetCorners() + 3 * i;
    for (int k = 0; k < 3; ++k)
    {
      ++edges[{ c[k], c[(k + 1) % 3] }];
    }
  }
  int open = 0;
  for (const auto& edge : edges)
  {
    const auto back = edges.find({ edge.first.second, edge.first.first });
    open += edge.second != 1 || back == edges.end();
  }
  return open;
}

/// The volume of a closed mesh, positive for outward normals.
inline double GetVolume(const TriangleMesh& mesh)
{
  double volume = 0.0;
  for (vtkIdType i = 0; i < mesh.GetNumberOfTriangles(); ++i)
  {
    const Vec3 a(mesh.GetCorner(i, 0));
    const Vec3 b(mesh.GetCorner(i, 1));
    const Vec3 c(mesh.GetCorner(i, 2));
    volume += a.Dot(b.Cross(c)) / 6.0;
  }
  return volume;
}

inline double GetArea(const TriangleMesh& mesh, vtkIdType triangle)
{
  const Vec3 a(mesh.GetCorner(triangle, 0));
  const Vec3 b(mesh.GetCorner(triangle, 1));
  const Vec3 c(mesh.GetCorner(triangle, 2));
  return 0.5 * (b - a).Cross(c - a).Norm();
}

inline double GetSmallestArea(const TriangleMesh& mesh)
{
  double smallest = std::numeric_limits<double>::infinity();
  for (vtkIdType i = 0; i < mesh.GetNumberOfTriangles(); ++i)
  {
    smallest = std::min(smallest, GetArea(mesh, i));
  }
  return smallest;
}

} // namespace helios

#endif
