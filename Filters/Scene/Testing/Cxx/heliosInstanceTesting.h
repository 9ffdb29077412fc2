// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Meshes and instances for tests of scenes, and the comparison of meshes.

#ifndef heliosInstanceTesting_h
#define heliosInstanceTesting_h

#include "heliosMaterialTable.h"
#include "vtkHeliosArrayNames.h"

#include <catch2/catch.hpp>

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkIntArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkStringArray.h>

#include <algorithm>
#include <string>
#include <vector>

namespace helios::test
{

/// A strip of triangles of a material.
inline vtkSmartPointer<vtkPolyData> MakeMesh(int count, const char* material)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> polys;
  for (int i = 0; i < count + 2; ++i)
  {
    points->InsertNextPoint(0.1 * i, i % 2, 0.3 * i);
  }
  for (vtkIdType i = 0; i < count; ++i)
  {
    polys->InsertNextCell({ i, i + 1, i + 2 });
  }
  auto mesh = vtkSmartPointer<vtkPolyData>::New();
  mesh->SetPoints(points);
  mesh->SetPolys(polys);
  MaterialTable table(1);
  table[0].Name = material;
  SetMaterials(mesh, table);
  return mesh;
}

struct Place
{
  int Prototype;
  double Position[3];
  double Rotation[4];
  double Scale;
  int Part;
};

inline vtkSmartPointer<vtkPolyData> MakeInstances(const std::vector<Place>& places)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkIntArray> prototypes, parts;
  prototypes->SetName(vtkHeliosArrayNames::PrototypeIds);
  parts->SetName(vtkHeliosArrayNames::PartIds);
  vtkNew<vtkDoubleArray> orientations, scales;
  orientations->SetName(vtkHeliosArrayNames::Orientation);
  orientations->SetNumberOfComponents(4);
  scales->SetName(vtkHeliosArrayNames::Scale);
  vtkNew<vtkStringArray> partNames;
  partNames->SetName(vtkHeliosArrayNames::PartName);
  for (const Place& place : places)
  {
    points->InsertNextPoint(place.Position);
    prototypes->InsertNextValue(place.Prototype);
    parts->InsertNextValue(place.Part);
    orientations->InsertNextTuple(place.Rotation);
    scales->InsertNextValue(place.Scale);
    partNames->InsertNextValue("tree " + std::to_string(place.Part));
  }
  auto instances = vtkSmartPointer<vtkPolyData>::New();
  instances->SetPoints(points);
  for (vtkAbstractArray* array : { static_cast<vtkAbstractArray*>(prototypes),
         static_cast<vtkAbstractArray*>(parts), static_cast<vtkAbstractArray*>(orientations),
         static_cast<vtkAbstractArray*>(scales), static_cast<vtkAbstractArray*>(partNames) })
  {
    instances->GetPointData()->AddArray(array);
  }
  return instances;
}

inline std::string Bytes(vtkDataArray* array)
{
  return { static_cast<const char*>(array->GetVoidPointer(0)),
    static_cast<std::size_t>(array->GetNumberOfValues() * array->GetDataTypeSize()) };
}

/// Checks that two meshes have the same triangles, to the last bit, parts and materials.
inline void CheckSame(vtkPolyData* flat, vtkPolyData* truth)
{
  REQUIRE(flat->GetNumberOfPolys() == truth->GetNumberOfPolys());
  for (vtkIdType i = 0; i < truth->GetNumberOfPolys(); ++i)
  {
    for (vtkIdType corner = 0; corner < 3; ++corner)
    {
      vtkIdType size;
      const vtkIdType *a, *b;
      double p[3], q[3];
      flat->GetPolys()->GetCellAtId(i, size, a);
      flat->GetPoint(a[corner], p);
      truth->GetPolys()->GetCellAtId(i, size, b);
      truth->GetPoint(b[corner], q);
      REQUIRE(std::equal(p, p + 3, q)); // to the last bit
    }
  }
  for (const char* name : { vtkHeliosArrayNames::MaterialIds, vtkHeliosArrayNames::PartIds })
  {
    INFO(name);
    CHECK(
      Bytes(flat->GetCellData()->GetArray(name)) == Bytes(truth->GetCellData()->GetArray(name)));
  }
  CHECK(GetMaterials(flat) == GetMaterials(truth));
  auto* own = vtkStringArray::SafeDownCast(
    flat->GetFieldData()->GetAbstractArray(vtkHeliosArrayNames::PartName));
  auto* all = vtkStringArray::SafeDownCast(
    truth->GetFieldData()->GetAbstractArray(vtkHeliosArrayNames::PartName));
  REQUIRE(own->GetNumberOfValues() == all->GetNumberOfValues());
  for (vtkIdType i = 0; i < all->GetNumberOfValues(); ++i)
  {
    CHECK(own->GetValue(i) == all->GetValue(i));
  }
}

} // namespace helios::test

#endif
