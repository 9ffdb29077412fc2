// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Echoes of instances equal echoes of copies, byte for byte.
#include "heliosFlatScene.h"
#include "heliosMaterialTable.h"
#include "heliosRandom.h"
#include "heliosScannerBench.h"
#include "vtkHeliosArrayNames.h"
#include "vtkHeliosRayCaster.h"
#include "vtkHeliosRayCasterFactory.h"
#include "vtkHeliosRotatingMirror.h"
#include "vtkHeliosScene.h"

#include <catch2/catch.hpp>

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkDoubleArray.h>
#include <vtkFloatArray.h>
#include <vtkIntArray.h>
#include <vtkPointData.h>

#include <algorithm>
#include <cmath>
#include <set>

using helios::Vec3;
using namespace helios::testing;
namespace names = vtkHeliosArrayNames;

namespace
{

double Uniform(int index, double low, double high)
{
  return low +
    (high - low) *
    helios::Uniform4(5, helios::RandomStream::Scene, static_cast<std::uint64_t>(index), 0)[0];
}

/// Random triangles within a box, with two materials in turn, and normals if wished.
vtkSmartPointer<vtkPolyData> MakeTree(int count, double size, bool hasNormals)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> polys;
  vtkNew<vtkIntArray> materials;
  materials->SetName(names::MaterialIds);
  vtkNew<vtkFloatArray> normals;
  normals->SetName(names::Normals);
  normals->SetNumberOfComponents(3);
  for (int i = 0; i < count; ++i)
  {
    const Vec3 centre(Uniform(9 * i, -2, 2), Uniform(9 * i + 1, -2, 2), Uniform(9 * i + 2, 1, 6));
    const vtkIdType first = points->GetNumberOfPoints();
    for (int corner = 0; corner < 3; ++corner)
    {
      const int seed = 100000 + 9 * (3 * i + corner);
      points->InsertNextPoint(centre[0] + Uniform(seed, -size, size),
        centre[1] + Uniform(seed + 1, -size, size), centre[2] + Uniform(seed + 2, -size, size));
    }
    polys->InsertNextCell({ first, first + 1, first + 2 });
    materials->InsertNextValue(1 + i % 2);
    normals->InsertNextTuple3(0.6, 0.0, 0.8);
  }
  auto mesh = vtkSmartPointer<vtkPolyData>::New();
  mesh->SetPoints(points);
  mesh->SetPolys(polys);
  mesh->GetCellData()->AddArray(materials);
  if (hasNormals)
  {
    mesh->GetCellData()->AddArray(normals);
  }
  return mesh;
}

vtkSmartPointer<vtkPolyData> MakeGround()
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (const double y : { -60.0, 60.0 })
  {
    points->InsertNextPoint(-60, y, 0);
    points->InsertNextPoint(60, y, 0.5);
  }
  vtkNew<vtkCellArray> polys;
  polys->InsertNextCell({ 0, 1, 3 });
  polys->InsertNextCell({ 0, 3, 2 });
  vtkNew<vtkIntArray> zeros;
  zeros->SetName(names::MaterialIds);
  zeros->InsertNextValue(0);
  zeros->InsertNextValue(0);
  auto mesh = vtkSmartPointer<vtkPolyData>::New();
  mesh->SetPoints(points);
  mesh->SetPolys(polys);
  mesh->GetCellData()->AddArray(zeros);
  return mesh;
}

/// Sixty trees on a ground, some of another material.
vtkSmartPointer<vtkHeliosScene> MakeStand(bool hasNormals)
{
  auto scene = vtkSmartPointer<vtkHeliosScene>::New();
  scene->ShallowCopy(MakeGround());
  helios::MaterialTable materials(4);
  for (int i = 0; i < 4; ++i)
  {
    materials[static_cast<std::size_t>(i)].Name = "m" + std::to_string(i);
    materials[static_cast<std::size_t>(i)].Reflectance = 0.2 + 0.15 * i;
    materials[static_cast<std::size_t>(i)].Classification = 10 + i;
  }
  helios::SetMaterials(scene, materials);
  scene->AddPrototype(MakeTree(400, 0.15, hasNormals));
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkIntArray> prototypes, parts, overrides;
  prototypes->SetName(names::PrototypeIds);
  parts->SetName(names::PartIds);
  overrides->SetName(names::MaterialIds);
  vtkNew<vtkDoubleArray> orientations, scales;
  orientations->SetName(names::Orientation);
  orientations->SetNumberOfComponents(4);
  scales->SetName(names::Scale);
  for (int i = 0; i < 60; ++i)
  {
    points->InsertNextPoint(Uniform(500000 + 7 * i, -30, 30), Uniform(500001 + 7 * i, -30, 30), 0);
    prototypes->InsertNextValue(0);
    parts->InsertNextValue(1 + i);
    overrides->InsertNextValue(i % 4 == 0 ? 3 : -1);
    const helios::Quaternion q = helios::AxisAngle({ 0.1, 0.2, 1 }, 23.0 * i);
    orientations->InsertNextTuple4(q.GetW(), q.GetX(), q.GetY(), q.GetZ());
    scales->InsertNextValue(0.5 + 0.02 * i);
  }
  vtkNew<vtkPolyData> instances;
  instances->SetPoints(points);
  for (vtkDataArray* array : { static_cast<vtkDataArray*>(prototypes),
         static_cast<vtkDataArray*>(parts), static_cast<vtkDataArray*>(overrides),
         static_cast<vtkDataArray*>(orientations), static_cast<vtkDataArray*>(scales) })
  {
    instances->GetPointData()->AddArray(array);
  }
  scene->SetInstances(instances);
  return scene;
}

/// A sweep up and down, all around.
vtkSmartPointer<vtkPolyData> Scan(vtkPolyData* scene, const char* caster, bool isFixed)
{
  Bench bench(scene, { 0.1, 0.2, 4.0 });
  vtkNew<vtkHeliosRotatingMirror> mirror;
  mirror->SetMirrorAngle(60);
  mirror->SetPulseFrequency(20000);
  bench.Scanner->SetBeamDeflector(mirror);
  bench.Scanner->SetHeadRotateSpeed(2000);
  bench.Scanner->SetDuration(0.18);
  bench.Scanner->GetBeamSampler()->SetBeamDivergence(5e-3);
  bench.Scanner->SetGenerateTruth(true);
  const auto kind =
    vtkSmartPointer<vtkHeliosRayCaster>::Take(vtkHeliosRayCasterFactory::Create(caster));
  bench.Scanner->SetRayCaster(kind);
  if (!isFixed)
  {
    bench.Scanner->SetSamplingToTolerance();
  }
  auto echoes = vtkSmartPointer<vtkPolyData>::New();
  echoes->ShallowCopy(bench.Run());
  CHECK(bench.Log->Errors.empty());
  CHECK(echoes->GetNumberOfPoints() > 1000);
  return echoes;
}

/// Checks that two clouds have the same bytes.
void CheckEqual(vtkPolyData* a, vtkPolyData* b)
{
  REQUIRE(a->GetNumberOfPoints() == b->GetNumberOfPoints());
  REQUIRE(a->GetPointData()->GetNumberOfArrays() == b->GetPointData()->GetNumberOfArrays());
  for (int i = 0; i < a->GetPointData()->GetNumberOfArrays(); ++i)
  {
    vtkDataArray* p = a->GetPointData()->GetArray(i);
    vtkDataArray* q = b->GetPointData()->GetArray(i);
    INFO(p->GetName());
    vtkIdType different = 0;
    for (vtkIdType k = 0; k < p->GetNumberOfValues(); ++k)
    {
      different += p->GetVariantValue(k) != q->GetVariantValue(k);
    }
    CHECK(different == 0);
  }
  CHECK((Bytes(a) == Bytes(b)));
}

/// Checks that two clouds differ in few echoes, by the errors of sampling by tolerance: cones are
/// classified in the order of the trees.
void CheckSimilar(vtkPolyData* a, vtkPolyData* b)
{
  REQUIRE(a->GetNumberOfPoints() == b->GetNumberOfPoints());
  vtkIdType different = 0;
  for (vtkIdType i = 0; i < a->GetNumberOfPoints(); ++i)
  {
    const double off = Value(a, names::Range, i) - Value(b, names::Range, i);
    different += off != 0.0;
    CHECK(std::abs(off) < 1e-4); // the tolerance is 1 mm
    CHECK(Value(a, names::PartIds, i) == Value(b, names::PartIds, i));
    CHECK(Value(a, names::CellIds, i) == Value(b, names::CellIds, i));
  }
  CHECK(different * 100 < a->GetNumberOfPoints());
}

} // namespace

TEST_CASE("ScannerInstances: echoes are those of copies", "[ScannerInstances]")
{
  for (const bool hasNormals : { false, true })
  {
    const auto scene = MakeStand(hasNormals);
    vtkNew<vtkPolyData> flat;
    REQUIRE(helios::FlattenScene(scene, flat).IsOk());
    for (const bool isFixed : { true, false })
    {
      INFO("normals " << hasNormals << ", fixed " << isFixed);
      const auto truth = Scan(flat, "beam", isFixed);
      const auto echoes = Scan(scene, "beam", isFixed);
      CheckEqual(Scan(scene, "bvh", isFixed), truth); // copies them
      isFixed ? CheckEqual(echoes, truth) : CheckSimilar(echoes, truth);
      std::set<double> parts, classes;
      for (vtkIdType i = 0; i < echoes->GetNumberOfPoints(); ++i)
      {
        parts.insert(Value(echoes, names::PartIds, i));
        classes.insert(Value(echoes, names::ClassificationIds, i));
      }
      CHECK(parts.size() > 40);
      CHECK(classes == std::set<double>{ 10, 11, 12, 13 });
    }
  }
}

TEST_CASE("ScannerInstances: invalid materials have messages", "[ScannerInstances]")
{
  const auto fails = [](vtkHeliosScene* scene, const std::string& text)
  {
    Bench bench(scene);
    bench.Run();
    CHECK(bench.Log->HasError(text));
  };
  const auto scene = MakeStand(false);
  scene->GetInstances()->GetPointData()->GetArray(names::MaterialIds)->SetComponent(3, 0, 4);
  fails(scene,
    "point array MaterialIds of the instances has 4, but the field data of the scene has 4 "
    "materials");
  const auto other = MakeStand(false);
  other->GetPrototype(0)->GetCellData()->GetArray(names::MaterialIds)->SetComponent(3, 0, 7);
  fails(other, "cell array MaterialIds of prototype 0 ranges from 1 to 7");
}
