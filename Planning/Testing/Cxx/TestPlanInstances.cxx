// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Plans of scenes with instances equal plans of copies, byte for byte.
#include "heliosFlatScene.h"
#include "heliosMaterialTable.h"
#include "heliosPlanningTest.h"
#include "heliosPose.h"
#include "heliosRandom.h"
#include "heliosTestRasters.h"
#include "vtkHeliosArrayNames.h"
#include "vtkHeliosScanPositionCandidates.h"
#include "vtkHeliosScanPositionPlanner.h"
#include "vtkHeliosScene.h"
#include "vtkHeliosViewsheds.h"
#include "vtkHeliosVisibilityTestPoints.h"

#include <vtkCellData.h>
#include <vtkDoubleArray.h>
#include <vtkFloatArray.h>
#include <vtkIdTypeArray.h>
#include <vtkIntArray.h>
#include <vtkPointData.h>

#include <cstring>

namespace names = vtkHeliosArrayNames;
using Candidates = vtkHeliosScanPositionCandidates;
using TestPoints = vtkHeliosVisibilityTestPoints;

namespace
{

constexpr int Grass = 0;
constexpr int Leaf = 1;
constexpr int Path = 2;

double Uniform(int index, double low, double high)
{
  const auto id = static_cast<std::uint64_t>(index);
  return low + (high - low) * helios::Uniform4(9, helios::RandomStream::Scene, id, 0)[0];
}

void AddMaterials(vtkPolyData* mesh, const std::vector<int>& ids)
{
  vtkNew<vtkIntArray> array;
  array->SetName(names::MaterialIds);
  for (const int id : ids)
  {
    array->InsertNextValue(id);
  }
  mesh->GetCellData()->AddArray(array);
}

/// Random leaves, with normals.
vtkSmartPointer<vtkPolyData> MakeTree(int count)
{
  std::vector<std::array<double, 3>> points;
  std::vector<std::array<int, 3>> corners;
  vtkNew<vtkFloatArray> normals;
  normals->SetName(names::Normals);
  normals->SetNumberOfComponents(3);
  for (int i = 0; i < count; ++i)
  {
    const int seed = 20 * i;
    const double centre[3] = { Uniform(seed, -1.5, 1.5), Uniform(seed + 1, -1.5, 1.5),
      Uniform(seed + 2, 1.0, 5.0) };
    for (int k = 3; k < 12; k += 3)
    {
      points.push_back(
        { centre[0] + Uniform(seed + k, -0.7, 0.7), centre[1] + Uniform(seed + k + 1, -0.7, 0.7),
          centre[2] + Uniform(seed + k + 2, -0.7, 0.7) });
    }
    corners.push_back({ 3 * i, 3 * i + 1, 3 * i + 2 });
    normals->InsertNextTuple3(Uniform(seed + 12, -1, 1), Uniform(seed + 13, -1, 1), 0.5);
  }
  auto tree = helios::MakeTriangles(points, corners);
  AddMaterials(tree, std::vector<int>(static_cast<std::size_t>(count), Leaf));
  tree->GetCellData()->AddArray(normals);
  return tree;
}

/// A ramp of a path between two walls.
vtkSmartPointer<vtkPolyData> MakeRamp()
{
  auto ramp = helios::MakeTriangles({ { -1, 0, 0 }, { 1, 0, 0 }, { 1, 6, 0.7 }, { -1, 6, 0.7 },
                                      { -1, 0, 1 }, { 1, 0, 1 }, { 1, 6, 1.7 }, { -1, 6, 1.7 } },
    { { 0, 3, 4 }, { 0, 1, 2 }, { 1, 2, 5 }, { 0, 2, 3 }, { 3, 4, 7 }, { 2, 5, 6 } });
  AddMaterials(ramp, { Leaf, Path, Leaf, Path, Leaf, Leaf });
  return ramp;
}

class Places
{
public:
  Places()
  {
    this->Points->SetDataTypeToDouble();
    this->Prototypes->SetName(names::PrototypeIds);
    this->Materials->SetName(names::MaterialIds);
    this->Orientations->SetName(names::Orientation);
    this->Orientations->SetNumberOfComponents(4);
    this->Scales->SetName(names::Scale);
  }

  void Add(int prototype, const helios::Vec3& at, const helios::Quaternion& q, double scale,
    int material = -1)
  {
    this->Points->InsertNextPoint(at.GetData());
    this->Prototypes->InsertNextValue(prototype);
    this->Materials->InsertNextValue(material);
    this->Orientations->InsertNextTuple4(q.GetW(), q.GetX(), q.GetY(), q.GetZ());
    this->Scales->InsertNextValue(scale);
  }

  vtkSmartPointer<vtkPolyData> Get() const
  {
    auto data = vtkSmartPointer<vtkPolyData>::New();
    data->SetPoints(this->Points);
    for (vtkDataArray* array :
      { static_cast<vtkDataArray*>(this->Prototypes), static_cast<vtkDataArray*>(this->Materials),
        static_cast<vtkDataArray*>(this->Orientations), static_cast<vtkDataArray*>(this->Scales) })
    {
      data->GetPointData()->AddArray(array);
    }
    return data;
  }

private:
  vtkNew<vtkPoints> Points;
  vtkNew<vtkIntArray> Prototypes;
  vtkNew<vtkIntArray> Materials;
  vtkNew<vtkDoubleArray> Orientations;
  vtkNew<vtkDoubleArray> Scales;
};

/// A lawn with trees that stick out over its border, two ramps, and a slab that an instance paves.
vtkSmartPointer<vtkHeliosScene> MakePark(bool hasLawn = true)
{
  auto scene = vtkSmartPointer<vtkHeliosScene>::New();
  if (hasLawn)
  {
    const auto lawn = helios::MakeFloor(15.0, 0.0);
    AddMaterials(lawn, { Grass, Leaf });
    scene->ShallowCopy(lawn);
  }
  helios::MaterialTable materials(3);
  materials[Grass].IsGround = true;
  materials[Path].IsGround = true;
  helios::SetMaterials(scene, materials);
  scene->AddPrototype(MakeTree(80));
  scene->AddPrototype(MakeRamp());
  const auto slab = helios::MakeFloor(1.5, 0.1);
  AddMaterials(slab, { Leaf, Leaf });
  scene->AddPrototype(slab);
  Places places;
  for (int i = 0; i < 14; ++i)
  {
    const int seed = 10000 + 9 * i;
    const helios::Vec3 axis(Uniform(seed, -0.3, 0.3), Uniform(seed + 1, -0.3, 0.3), 1.0);
    places.Add(0, { Uniform(seed + 2, -16, 16), Uniform(seed + 3, -16, 16), 0.0 },
      helios::AxisAngle(axis, Uniform(seed + 4, 0, 360)), Uniform(seed + 5, 0.6, 1.7));
  }
  places.Add(1, { 3, 2, 0.1 }, helios::AxisAngle({ 0, 0, 1 }, 30.0), 1.2);
  places.Add(1, { -8, -4, 0.2 }, helios::AxisAngle({ 0, 0, 1 }, 200.0), 0.9);
  places.Add(2, { 9, 9, 0 }, helios::Quaternion(1, 0, 0, 0), 1.0, Path);
  places.Add(2, { -9, 9, 0 }, helios::Quaternion(1, 0, 0, 0), 1.3);
  scene->SetInstances(places.Get());
  return scene;
}

vtkSmartPointer<vtkPolyData> MakeCopies(vtkHeliosScene* scene)
{
  auto flat = vtkSmartPointer<vtkPolyData>::New();
  REQUIRE(helios::FlattenScene(scene, flat).IsOk());
  return flat;
}

void CheckSame(vtkDataArray* a, vtkDataArray* b)
{
  REQUIRE(a->GetNumberOfValues() == b->GetNumberOfValues());
  REQUIRE(a->GetDataType() == b->GetDataType());
  const auto size = static_cast<std::size_t>(a->GetNumberOfValues() * a->GetDataTypeSize());
  CHECK(std::memcmp(a->GetVoidPointer(0), b->GetVoidPointer(0), size) == 0);
}

/// Points and all point arrays.
void CheckSame(vtkPolyData* a, vtkPolyData* b)
{
  REQUIRE(a->GetNumberOfPoints() > 0);
  CheckSame(a->GetPoints()->GetData(), b->GetPoints()->GetData());
  REQUIRE(a->GetPointData()->GetNumberOfArrays() == b->GetPointData()->GetNumberOfArrays());
  for (int i = 0; i < a->GetPointData()->GetNumberOfArrays(); ++i)
  {
    INFO(a->GetPointData()->GetArrayName(i));
    CheckSame(a->GetPointData()->GetArray(i), b->GetPointData()->GetArray(i));
  }
}

vtkSmartPointer<vtkPolyData> FindCandidates(vtkPolyData* scene, int surface)
{
  helios::FilterOverScene<Candidates> over(scene);
  over.Filter->SetSurface(surface);
  over.Update();
  CHECK(over.Log->Errors.empty());
  return over.Filter->GetOutput();
}

vtkSmartPointer<vtkPolyData> FindTestPoints(vtkPolyData* scene)
{
  helios::FilterOverScene<TestPoints> over(scene);
  over.Filter->SetStep(0.0); // by the diagonal
  over.Filter->GenerateAreasOn();
  over.Update();
  CHECK(over.Log->Errors.empty());
  return over.Filter->GetOutput();
}

vtkSmartPointer<vtkPolyData> MakePlan(vtkPolyData* scene)
{
  vtkNew<vtkHeliosViewsheds> viewsheds;
  viewsheds->SetInputDataObject(0, scene);
  viewsheds->SetInputDataObject(1, FindCandidates(scene, Candidates::AUTOMATIC));
  const auto points = FindTestPoints(scene);
  viewsheds->SetInputDataObject(2, points);
  vtkNew<vtkHeliosScanPositionPlanner> planner;
  planner->SetInputConnection(0, viewsheds->GetOutputPort());
  planner->SetInputDataObject(1, points);
  planner->Update();
  return vtkPolyData::SafeDownCast(planner->GetOutputDataObject(0));
}

} // namespace

TEST_CASE("Plans: candidates on instances are those on copies", "[PlanInstances]")
{
  const auto scene = MakePark();
  const auto copies = MakeCopies(scene);
  for (const int surface :
    { Candidates::HIGHEST, Candidates::GROUND, Candidates::OPEN_GROUND, Candidates::AUTOMATIC })
  {
    INFO(surface);
    CheckSame(FindCandidates(scene, surface), FindCandidates(copies, surface));
  }
}

TEST_CASE("Plans: candidates are on ramps and paved slabs that are instances", "[PlanInstances]")
{
  const auto scene = MakePark();
  const auto found = FindCandidates(scene, Candidates::GROUND);
  vtkDataArray* cells = found->GetPointData()->GetArray(names::CellIds);
  const vtkIdType ramp = 2 + 14 * 80;
  int onRamps = 0, onSlabs = 0;
  for (vtkIdType i = 0; i < found->GetNumberOfPoints(); ++i)
  {
    const auto cell = static_cast<vtkIdType>(cells->GetComponent(i, 0));
    const bool isRamp = cell >= ramp && cell < ramp + 12;
    onRamps += isRamp;
    onSlabs += cell >= ramp + 12;
    CHECK((cell == 0 || isRamp || (cell >= ramp + 12 && cell < ramp + 14))); // the paved one
    CHECK((!isRamp || (cell - ramp) % 6 == 1 || (cell - ramp) % 6 == 3));    // no walls
  }
  CHECK(onRamps > 5);
  CHECK(onSlabs > 5);
}

TEST_CASE("Plans: candidates on instances without a mesh", "[PlanInstances]")
{
  const auto scene = MakePark(false);
  const auto copies = MakeCopies(scene);
  CheckSame(FindCandidates(scene, Candidates::GROUND), FindCandidates(copies, Candidates::GROUND));
  CheckSame(MakePlan(scene), MakePlan(copies));
}

TEST_CASE("Plans: test points on instances are those on copies", "[PlanInstances]")
{
  const auto scene = MakePark();
  CheckSame(FindTestPoints(scene), FindTestPoints(MakeCopies(scene)));
}

TEST_CASE("Plans: cell ids of the mesh follow those of instances before", "[PlanInstances]")
{
  const auto scene = MakePark();
  vtkPolyData* instances = scene->GetInstances();
  vtkNew<vtkIdTypeArray> first;
  first->SetName(names::FirstCellIds);
  for (vtkIdType i = 0; i < 14; ++i)
  {
    first->InsertNextValue(80 * i + (i > 4 ? 1 : 0)); // a cell of the mesh after five trees
  }
  const vtkIdType others[] = { 14 * 80 + 2, 14 * 80 + 8, 14 * 80 + 14, 14 * 80 + 16 };
  for (const vtkIdType cell : others)
  {
    first->InsertNextValue(cell);
  }
  instances->GetPointData()->AddArray(first);
  const auto copies = MakeCopies(scene);
  for (const int surface : { Candidates::GROUND, Candidates::OPEN_GROUND })
  {
    CheckSame(FindCandidates(scene, surface), FindCandidates(copies, surface));
  }
}

TEST_CASE("Plans: a plan on a raster of heights is that on its mesh", "[PlanInstances]")
{
  const auto scene = MakePark(false);
  helios::HeightRaster raster(40, 50, { -10.0, 0.6, 0.1, 16.0, 0.05, -0.7 });
  raster.AddHills(1.5, 0.02);
  raster.AddHoles();
  scene->AddPrototype(raster.MakeImage<vtkFloatArray>());
  vtkPolyData* instances = scene->GetInstances();
  instances->GetPoints()->SetPoint(3, 0.5, -0.25, 0.125);
  const auto set = [&](const char* name, vtkIdType component, double value)
  { instances->GetPointData()->GetArray(name)->SetComponent(3, component, value); };
  set(names::PrototypeIds, 0, 3);
  set(names::Scale, 0, 1.25);
  const int material = GENERATE(-1, Leaf, Path);
  set(names::MaterialIds, 0, material);
  const auto copies = MakeCopies(scene);
  for (const int surface : { Candidates::HIGHEST, Candidates::GROUND, Candidates::OPEN_GROUND })
  {
    INFO(material << ", " << surface);
    CheckSame(FindCandidates(scene, surface), FindCandidates(copies, surface));
  }
  CheckSame(MakePlan(scene), MakePlan(copies));
}

TEST_CASE("Plans: a plan of instances is that of copies", "[PlanInstances]")
{
  const auto scene = MakePark();
  CheckSame(MakePlan(scene), MakePlan(MakeCopies(scene)));
}

TEST_CASE("Plans: invalid instances are errors", "[PlanInstances]")
{
  const auto scene = MakePark();
  vtkIntArray::SafeDownCast(scene->GetInstances()->GetPointData()->GetArray(names::PrototypeIds))
    ->SetValue(2, 7);
  const std::string text = "instance 2 of the scene has PrototypeIds 7, but there are 3";
  CHECK(helios::FilterOverScene<Candidates>(scene).Fails(
    "No rays can be cast onto the scene on port 0: " + text));
  CHECK(helios::FilterOverScene<TestPoints>(scene).Fails(text));
}
