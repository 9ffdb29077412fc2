// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosErrorObserver.h"
#include "heliosMaterialTable.h"
#include "heliosPose.h"
#include "vtkHeliosArrayNames.h"
#include "vtkHeliosMeshRepair.h"
#include "vtkHeliosMeshSimplify.h"
#include "vtkHeliosSyntheticScene.h"

#include <vtkCallbackCommand.h>
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkDoubleArray.h>
#include <vtkExecutive.h>
#include <vtkGenericCell.h>
#include <vtkIntArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkSMPTools.h>
#include <vtkStaticCellLocator.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <CGAL/Polygon_mesh_processing/distance.h> // after the kernel

#include <catch2/catch.hpp>

#include <array>
#include <cmath>
#include <functional>
#include <initializer_list>
#include <limits>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace names = vtkHeliosArrayNames;
using helios::Vec3;

namespace
{

/// A grid of squares of a side, with heights by a function; material and part by position.
vtkSmartPointer<vtkPolyData> MakeGrid(int cells, double side,
  const std::function<double(double, double)>& height, const Vec3& offset = Vec3(0, 0, 0))
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkDoubleArray> pointIds;
  pointIds->SetName("id");
  for (int j = 0; j <= cells; ++j)
  {
    for (int i = 0; i <= cells; ++i)
    {
      const double x = side * i;
      const double y = side * j;
      points->InsertNextPoint((Vec3(x, y, height(x, y)) + offset).GetData());
      pointIds->InsertNextValue(j * (cells + 1) + i);
    }
  }
  vtkNew<vtkCellArray> polys;
  vtkNew<vtkIntArray> materials;
  vtkNew<vtkIntArray> parts;
  vtkNew<vtkDoubleArray> cellIds;
  materials->SetName(names::MaterialIds);
  parts->SetName(names::PartIds);
  cellIds->SetName("id");
  for (int j = 0; j < cells; ++j)
  {
    for (int i = 0; i < cells; ++i)
    {
      const vtkIdType a = j * (cells + 1) + i;
      polys->InsertNextCell({ a, a + 1, a + cells + 2 });
      polys->InsertNextCell({ a, a + cells + 2, a + cells + 1 });
      for (int k = 0; k < 2; ++k)
      {
        cellIds->InsertNextValue(cellIds->GetNumberOfValues());
        materials->InsertNextValue(std::hypot(i - cells / 2, j - cells / 2) < cells / 4.0);
        parts->InsertNextValue(i > 2 * cells / 3);
      }
    }
  }
  auto scene = vtkSmartPointer<vtkPolyData>::New();
  scene->SetPoints(points);
  scene->SetPolys(polys);
  scene->GetPointData()->AddArray(pointIds);
  scene->GetCellData()->AddArray(materials);
  scene->GetCellData()->AddArray(parts);
  scene->GetCellData()->AddArray(cellIds);
  return scene;
}

vtkSmartPointer<vtkPolyData> OfOneKind(vtkSmartPointer<vtkPolyData> scene)
{
  scene->GetCellData()->RemoveArray(names::MaterialIds);
  scene->GetCellData()->RemoveArray(names::PartIds);
  return scene;
}

double Flat(double, double)
{
  return 0.0;
}

double Hills(double x, double y)
{
  return 0.6 * std::sin(0.9 * x) * std::cos(0.7 * y) + 0.02 * std::sin(3.1 * x + 2.3 * y);
}

vtkSmartPointer<vtkPolyData> Simplify(vtkPolyData* scene, double distance)
{
  vtkNew<vtkHeliosMeshSimplify> simplify;
  simplify->SetInputData(scene);
  simplify->SetMaximumDistance(distance);
  simplify->Update();
  return simplify->GetOutput();
}

/// The largest distance of samples of one surface from the other one, by VTK's locator.
double SampleDistance(vtkPolyData* from, vtkPolyData* to, int steps)
{
  vtkNew<vtkStaticCellLocator> locator;
  locator->SetDataSet(to);
  locator->BuildLocator();
  vtkNew<vtkGenericCell> cell;
  double largest = 0.0;
  vtkNew<vtkIdList> corners;
  for (vtkIdType i = 0; i < from->GetNumberOfCells(); ++i)
  {
    from->GetCellPoints(i, corners);
    const Vec3 a(from->GetPoint(corners->GetId(0)));
    const Vec3 b(from->GetPoint(corners->GetId(1)));
    const Vec3 c(from->GetPoint(corners->GetId(2)));
    for (int u = 0; u <= steps; ++u)
    {
      for (int v = 0; u + v <= steps; ++v)
      {
        const Vec3 p = a + (b - a) * (1.0 * u / steps) + (c - a) * (1.0 * v / steps);
        double nearest[3];
        vtkIdType id;
        int sub;
        double squared;
        locator->FindClosestPoint(p.GetData(), nearest, cell, id, sub, squared);
        largest = std::max(largest, squared);
      }
    }
  }
  return std::sqrt(largest);
}

using CgalMesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;

CgalMesh ToCgal(vtkPolyData* scene)
{
  CgalMesh mesh;
  for (vtkIdType i = 0; i < scene->GetNumberOfPoints(); ++i)
  {
    const double* p = scene->GetPoint(i);
    mesh.add_vertex({ p[0], p[1], p[2] });
  }
  vtkNew<vtkIdList> corners;
  const auto vertex = [&corners](vtkIdType k)
  { return CgalMesh::Vertex_index(static_cast<unsigned>(corners->GetId(k))); };
  for (vtkIdType i = 0; i < scene->GetNumberOfCells(); ++i)
  {
    scene->GetCellPoints(i, corners);
    mesh.add_face(vertex(0), vertex(1), vertex(2));
  }
  return mesh;
}

using Edge = std::pair<std::array<double, 3>, std::array<double, 3>>;

/// The edges, by coordinates, where triangles of one material and part end.
std::set<Edge> GetBorders(vtkPolyData* scene)
{
  std::map<std::pair<std::pair<int, int>, Edge>, int> uses;
  vtkDataArray* materials = scene->GetCellData()->GetArray(names::MaterialIds);
  vtkDataArray* parts = scene->GetCellData()->GetArray(names::PartIds);
  vtkNew<vtkIdList> corners;
  for (vtkIdType i = 0; i < scene->GetNumberOfCells(); ++i)
  {
    const std::pair<int, int> kind(materials ? static_cast<int>(materials->GetComponent(i, 0)) : 0,
      parts ? static_cast<int>(parts->GetComponent(i, 0)) : 0);
    scene->GetCellPoints(i, corners);
    for (int k = 0; k < 3; ++k)
    {
      std::array<double, 3> a, b;
      scene->GetPoint(corners->GetId(k), a.data());
      scene->GetPoint(corners->GetId((k + 1) % 3), b.data());
      ++uses[{ kind, { std::min(a, b), std::max(a, b) } }];
    }
  }
  std::set<Edge> borders;
  for (const auto& use : uses)
  {
    if (use.second == 1)
    {
      borders.insert(use.first.second);
    }
  }
  return borders;
}

/// Every coordinate is one of the input's, bit by bit, and arrays match their points and cells.
void CheckFollows(vtkPolyData* input, vtkPolyData* output)
{
  vtkDataArray* pointIds = output->GetPointData()->GetArray("id");
  vtkDataArray* cellIds = output->GetCellData()->GetArray("id");
  REQUIRE(pointIds->GetNumberOfTuples() == output->GetNumberOfPoints());
  REQUIRE(cellIds->GetNumberOfTuples() == output->GetNumberOfCells());
  bool isSame = true;
  for (vtkIdType i = 0; i < output->GetNumberOfPoints(); ++i)
  {
    const auto id = static_cast<vtkIdType>(pointIds->GetComponent(i, 0));
    isSame = isSame && Vec3(output->GetPoint(i)) == Vec3(input->GetPoint(id));
  }
  for (const char* name : { names::MaterialIds, names::PartIds })
  {
    vtkDataArray* before = input->GetCellData()->GetArray(name);
    vtkDataArray* after = output->GetCellData()->GetArray(name);
    for (vtkIdType i = 0; before && i < output->GetNumberOfCells(); ++i)
    {
      const auto id = static_cast<vtkIdType>(cellIds->GetComponent(i, 0));
      isSame = isSame && before->GetComponent(id, 0) == after->GetComponent(i, 0);
    }
  }
  CHECK(isSame);
}

bool IsSame(vtkPolyData* a, vtkPolyData* b, const Vec3& shift = Vec3(0, 0, 0))
{
  bool isSame = a->GetNumberOfCells() == b->GetNumberOfCells() &&
    a->GetNumberOfPoints() == b->GetNumberOfPoints();
  for (vtkIdType i = 0; isSame && i < a->GetNumberOfPoints(); ++i)
  {
    isSame = Vec3(a->GetPoint(i)) + shift == Vec3(b->GetPoint(i));
  }
  vtkNew<vtkIdList> mine, other;
  for (vtkIdType i = 0; isSame && i < a->GetNumberOfCells(); ++i)
  {
    a->GetCellPoints(i, mine);
    b->GetCellPoints(i, other);
    for (int k = 0; k < 3; ++k)
    {
      isSame = isSame && mine->GetId(k) == other->GetId(k);
    }
  }
  return isSame;
}

} // namespace

TEST_CASE("MeshSimplify: a flat grid is reduced to its border", "[MeshSimplify]")
{
  const auto scene = OfOneKind(MakeGrid(40, 0.25, Flat));
  vtkNew<vtkHeliosMeshSimplify> simplify;
  simplify->SetInputData(scene);
  simplify->SetMaximumDistance(0.0);
  simplify->Update();
  vtkPolyData* output = simplify->GetOutput();
  // A polygon of 160 corners takes 158 triangles; a few interior points may remain.
  CHECK(output->GetNumberOfCells() >= 158);
  CHECK(output->GetNumberOfCells() <= 200);
  CHECK(simplify->GetVerifiedDistance() < 1e-12);
  CHECK(simplify->GetNumberOfPatches() == 1);
  CHECK(simplify->GetNumberOfUntouchedPatches() == 0);
  CHECK(GetBorders(output) == GetBorders(scene));
  CheckFollows(scene, output);
}

TEST_CASE("MeshSimplify: the distance is within the limit in both directions", "[MeshSimplify]")
{
  const auto scene = OfOneKind(MakeGrid(60, 0.0625, Hills));
  vtkIdType last = scene->GetNumberOfCells();
  for (const double distance : { 0.001, 0.01, 0.1 })
  {
    vtkNew<vtkHeliosMeshSimplify> simplify;
    simplify->SetInputData(scene);
    simplify->SetMaximumDistance(distance);
    simplify->Update();
    vtkPolyData* output = simplify->GetOutput();
    const double there = SampleDistance(scene, output, 4);
    const double back = SampleDistance(output, scene, 12);
    INFO("distance " << distance << ", there " << there << ", back " << back);
    CHECK(simplify->GetVerifiedDistance() <= distance);
    CHECK(there <= simplify->GetVerifiedDistance() + 1e-12);
    CHECK(back <= simplify->GetVerifiedDistance() + 1e-12);
    CHECK(std::max(there, back) > 0.3 * simplify->GetVerifiedDistance()); // the bound is tight
    CHECK(output->GetNumberOfCells() < last);
    CHECK(GetBorders(output) == GetBorders(scene));
    CheckFollows(scene, output);
    last = output->GetNumberOfCells();
  }
  CHECK(last < scene->GetNumberOfCells() / 8);
}

TEST_CASE("MeshSimplify: CGAL confirms the bound of the distance", "[MeshSimplify]")
{
  const auto scene = OfOneKind(MakeGrid(24, 0.125, Hills));
  for (const double distance : { 0.005, 0.05 })
  {
    vtkNew<vtkHeliosMeshSimplify> simplify;
    simplify->SetInputData(scene);
    simplify->SetMaximumDistance(distance);
    simplify->Update();
    const double error = 0.1 * distance;
    const double bound = CGAL::Polygon_mesh_processing::bounded_error_symmetric_Hausdorff_distance<
      CGAL::Sequential_tag>(ToCgal(scene), ToCgal(simplify->GetOutput()), error);
    INFO("distance " << distance << ", CGAL " << bound);
    CHECK(bound - error <= simplify->GetVerifiedDistance());
    CHECK(bound - error <= distance);
    CHECK(simplify->GetVerifiedDistance() <= 2.0 * bound);
    CHECK(simplify->GetOutput()->GetNumberOfCells() < scene->GetNumberOfCells());
  }
}

TEST_CASE("MeshSimplify: a sphere is reduced as far as its chords allow", "[MeshSimplify]")
{
  // A chord of length e is e^2 / (8 rho) below a sphere: this determines the triangle size.
  vtkNew<vtkHeliosSyntheticScene> sphere;
  sphere->SetKindToSphere();
  sphere->SetSize(10.0);
  sphere->SetResolution(24);
  sphere->Update();
  const double distance = 0.05;
  const auto output = Simplify(sphere->GetOutput(), distance);
  CHECK(GetBorders(output).empty());
  const double area = 4.0 * 3.14159265358979 * 25.0 / output->GetNumberOfCells();
  const double edge = std::sqrt(area * 4.0 / std::sqrt(3.0));
  const double chord = std::sqrt(8.0 * 5.0 * distance);
  INFO("edge " << edge << ", chord " << chord);
  CHECK(edge > 0.5 * chord);
  CHECK(edge < 2.0 * chord);
  for (vtkIdType i = 0; i < output->GetNumberOfPoints(); ++i)
  {
    CHECK(Vec3(output->GetPoint(i)).Norm() == Approx(5.0).epsilon(1e-14));
  }
}

TEST_CASE(
  "MeshSimplify: a scene at UTM coordinates gives the same result, translated", "[MeshSimplify]")
{
  // Coordinates of 2^-10 m, so that translation is exact.
  const auto rounded = [](double x, double y) { return std::round(1024.0 * Hills(x, y)) / 1024.0; };
  const Vec3 shift(500000.0, 5500000.0, 300.0);
  const auto local = MakeGrid(40, 0.125, rounded);
  const auto moved = MakeGrid(40, 0.125, rounded, shift);
  const auto here = Simplify(local, 0.02);
  CHECK(here->GetNumberOfCells() < local->GetNumberOfCells());
  CHECK(IsSame(here, Simplify(moved, 0.02), shift));
}

TEST_CASE("MeshSimplify: borders of materials and parts are kept", "[MeshSimplify]")
{
  const auto scene = MakeGrid(48, 0.125, Hills);
  vtkNew<vtkHeliosMeshSimplify> simplify;
  simplify->SetInputData(scene);
  simplify->SetMaximumDistance(0.1);
  simplify->Update();
  vtkPolyData* output = simplify->GetOutput();
  CHECK(output->GetNumberOfCells() < scene->GetNumberOfCells() / 3);
  CHECK(GetBorders(output) == GetBorders(scene));
  CHECK(simplify->GetNumberOfPatches() >= 3);
  CheckFollows(scene, output);
}

TEST_CASE("MeshSimplify: independent of the number of threads", "[MeshSimplify]")
{
  const auto scene = MakeGrid(40, 0.125, Hills);
  const auto many = Simplify(scene, 0.05);
  vtkSmartPointer<vtkPolyData> one;
  vtkSMPTools::LocalScope(
    vtkSMPTools::Config(1, "Sequential", false), [&]() { one = Simplify(scene, 0.05); });
  CHECK(IsSame(many, one));
}

TEST_CASE("MeshSimplify: a fan about one edge is kept and counted", "[MeshSimplify]")
{
  // Three flat sheets that share one edge of 8 m, each of 8 x 8 squares.
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> polys;
  for (int sheet = 0; sheet < 3; ++sheet)
  {
    const vtkIdType first = points->GetNumberOfPoints();
    const Vec3 out[] = { { 1, 0, 0 }, { -1, 0, 0 }, { 0, 0, 1 } };
    for (int j = 0; j <= 8; ++j)
    {
      for (int i = 0; i <= 8; ++i)
      {
        points->InsertNextPoint((out[sheet] * i + Vec3(0, 1, 0) * j).GetData());
      }
    }
    for (int j = 0; j < 8; ++j)
    {
      for (int i = 0; i < 8; ++i)
      {
        const vtkIdType a = first + 9 * j + i;
        polys->InsertNextCell({ a, a + 1, a + 10 });
        polys->InsertNextCell({ a, a + 10, a + 9 });
      }
    }
  }
  vtkNew<vtkPolyData> scene;
  scene->SetPoints(points);
  scene->SetPolys(polys);
  vtkNew<vtkHeliosMeshSimplify> simplify;
  simplify->SetInputData(scene);
  simplify->Update();
  vtkPolyData* output = simplify->GetOutput();
  CHECK(simplify->GetNumberOfRejectedTriangles() == 3 * 8); // one per square at the edge
  CHECK(output->GetNumberOfCells() < scene->GetNumberOfCells());
  vtkNew<vtkHeliosMeshRepair> repair;
  repair->SetInputData(output);
  repair->Update();
  CHECK(repair->GetNumberOfNonManifoldEdges() == 8);
  CHECK(GetBorders(output) == GetBorders(scene));
  CHECK(SampleDistance(scene, output, 3) < 1e-12);
}

TEST_CASE(
  "MeshSimplify: faces refused by OpenMesh are kept, and nothing is printed", "[MeshSimplify]")
{
  // Two closed tetrahedra that share an edge, which four triangles share.
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (const Vec3& p :
    { Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(0, 0, 1), Vec3(0, -1, 0), Vec3(0, 0, -1) })
  {
    points->InsertNextPoint(p.GetData());
  }
  vtkNew<vtkCellArray> polys;
  const auto add = [&polys](vtkIdType a, vtkIdType b, vtkIdType c, vtkIdType d)
  {
    polys->InsertNextCell({ a, c, b });
    polys->InsertNextCell({ a, b, d });
    polys->InsertNextCell({ b, c, d });
    polys->InsertNextCell({ c, a, d });
  };
  add(0, 1, 2, 3);
  add(0, 1, 4, 5);
  vtkNew<vtkPolyData> scene;
  scene->SetPoints(points);
  scene->SetPolys(polys);
  vtkNew<vtkHeliosMeshSimplify> simplify;
  simplify->SetInputData(scene);
  simplify->SetMaximumDistance(100.0);
  simplify->Update();
  CHECK(simplify->GetOutput()->GetNumberOfCells() == 8);
  CHECK(simplify->GetNumberOfRejectedTriangles() == 4);
}

TEST_CASE("MeshSimplify: separate leaves are not changed", "[MeshSimplify]")
{
  vtkNew<vtkHeliosSyntheticScene> tree;
  tree->SetKindToTree();
  tree->SetSpeciesToShrub();
  tree->Update();
  vtkNew<vtkHeliosMeshSimplify> simplify;
  simplify->SetInputConnection(tree->GetOutputPort());
  simplify->SetMaximumDistance(0.001);
  simplify->Update();
  vtkPolyData* output = simplify->GetOutput();
  CHECK(output->GetNumberOfCells() > 1000);
  CHECK(simplify->GetVerifiedDistance() <= 0.001);
  CHECK(GetBorders(output) == GetBorders(tree->GetOutput()));
  CHECK(helios::GetMaterials(output) == helios::GetMaterials(tree->GetOutput()));
}

TEST_CASE("MeshSimplify: drops and counts triangles without area and duplicates", "[MeshSimplify]")
{
  const auto scene = OfOneKind(MakeGrid(10, 1.0, Flat));
  vtkNew<vtkCellArray> polys;
  polys->DeepCopy(scene->GetPolys());
  polys->InsertNextCell({ 0, 1, 2 });
  polys->InsertNextCell({ 1, 12, 0 });
  scene->SetPolys(polys);
  scene->GetCellData()->Initialize();
  vtkNew<vtkHeliosMeshSimplify> simplify;
  simplify->SetInputData(scene);
  simplify->Update();
  CHECK(simplify->GetNumberOfDroppedTriangles() == 2);
  CHECK(simplify->GetOutput()->GetNumberOfCells() < 60);
}

TEST_CASE("MeshSimplify: cell normals stay with their triangles", "[MeshSimplify]")
{
  const auto scene = OfOneKind(MakeGrid(10, 1.0, Hills));
  vtkNew<vtkDoubleArray> normals;
  normals->SetName(names::Normals);
  normals->SetNumberOfComponents(3);
  normals->SetNumberOfTuples(scene->GetNumberOfCells());
  normals->Fill(0.0);
  scene->GetCellData()->AddArray(normals);
  CHECK(Simplify(scene, 1.0)->GetCellData()->GetArray(names::Normals) == nullptr);
  CHECK(Simplify(scene, 1e-6)->GetCellData()->GetArray(names::Normals) != nullptr);
}

TEST_CASE("MeshSimplify: passes an empty scene, and bad input is an error", "[MeshSimplify]")
{
  auto log = vtkSmartPointer<helios::ErrorObserver>::Take(helios::ErrorObserver::New());
  vtkNew<vtkHeliosMeshSimplify> simplify;
  log->Watch(simplify);
  vtkNew<vtkPolyData> empty;
  simplify->SetInputData(empty);
  simplify->Update();
  CHECK(simplify->GetOutput()->GetNumberOfCells() == 0);
  CHECK(log->Errors.empty());

  simplify->SetInputData(MakeGrid(2, 1.0, Flat));
  simplify->SetMaximumDistance(std::numeric_limits<double>::quiet_NaN());
  simplify->Update();
  CHECK(log->HasError("MaximumDistance is nan; set a finite length of at least 0 m"));
  simplify->SetMaximumDistance(-1.0);
  CHECK(simplify->GetMaximumDistance() == 0.0);

  log->Clear();
  simplify->SetInputData(MakeGrid(2, 1.0, [](double x, double) { return 1.0 / (x - 1.0); }));
  simplify->Update();
  CHECK(log->HasError("has a corner that is not finite"));

  log->Clear();
  const auto lines = MakeGrid(2, 1.0, Flat);
  lines->GetPolys()->InsertNextCell({ 0, 1, 4, 3 });
  simplify->SetInputData(lines);
  simplify->Update();
  CHECK(log->HasError("cells that are not triangles; pass it through vtkTriangleFilter first"));

  log->Clear();
  const auto shortArray = MakeGrid(2, 1.0, Flat);
  shortArray->GetCellData()->GetArray(names::MaterialIds)->Resize(3);
  simplify->SetInputData(shortArray);
  simplify->Update();
  CHECK(log->HasError("The cell array MaterialIds has 3 values for 8 cells"));
}

TEST_CASE("MeshSimplify: reports progress and can be aborted", "[MeshSimplify]")
{
  vtkNew<vtkHeliosMeshSimplify> simplify;
  simplify->SetInputData(MakeGrid(20, 0.125, Hills));
  vtkNew<vtkCallbackCommand> stop;
  stop->SetCallback(
    [](vtkObject* caller, unsigned long, void*, void*)
    {
      auto* algorithm = static_cast<vtkAlgorithm*>(caller);
      algorithm->SetAbortExecute(algorithm->GetProgress() > 0.15);
    });
  simplify->AddObserver(vtkCommand::ProgressEvent, stop);
  const auto log = vtkSmartPointer<helios::ErrorObserver>::Take(helios::ErrorObserver::New());
  log->Watch(simplify);
  log->Watch(simplify->GetExecutive());
  simplify->Update();
  CHECK(simplify->GetOutput()->GetNumberOfCells() == 0);
  CHECK(log->HasError("The work was aborted at 20 %; update again to complete it"));
}

TEST_CASE("MeshSimplify: can be aborted during the repair", "[MeshSimplify]")
{
  vtkNew<vtkHeliosMeshSimplify> simplify;
  simplify->SetInputData(MakeGrid(20, 0.125, Hills));
  vtkNew<vtkCallbackCommand> stop;
  stop->SetCallback(
    [](vtkObject* caller, unsigned long, void*, void*)
    {
      auto* algorithm = static_cast<vtkAlgorithm*>(caller);
      algorithm->SetAbortExecute(algorithm->GetProgress() > 0.0);
    });
  simplify->AddObserver(vtkCommand::ProgressEvent, stop);
  const auto log = vtkSmartPointer<helios::ErrorObserver>::Take(helios::ErrorObserver::New());
  log->Watch(simplify);
  log->Watch(simplify->GetExecutive());
  simplify->Update();
  CHECK(simplify->GetOutput()->GetNumberOfCells() == 0);
  CHECK(log->HasError("The work was aborted at 2.5 %; update again to complete it"));
}

namespace
{

/// Counts the progress events of the work itself, and aborts at one of them.
struct CountedEvents
{
  int Count = 0;
  int Last = VTK_INT_MAX;

  static void OnProgress(vtkObject* caller, unsigned long, void* self, void*)
  {
    auto* algorithm = static_cast<vtkAlgorithm*>(caller);
    auto* events = static_cast<CountedEvents*>(self);
    // VTK 9.3 adds a progress of 1, also of aborted filters.
    events->Count += algorithm->GetProgress() >= 0.2 && algorithm->GetProgress() < 1.0;
    algorithm->SetAbortExecute(events->Count >= events->Last);
  }
};

} // namespace

TEST_CASE("MeshSimplify: can be aborted at any time within one large patch", "[MeshSimplify]")
{
  const auto scene = OfOneKind(MakeGrid(160, 0.125, Hills)); // 51,200 triangles
  const auto run = [&scene](int last, helios::ErrorObserver* log)
  {
    CountedEvents events;
    events.Last = last;
    vtkNew<vtkHeliosMeshSimplify> simplify;
    simplify->SetInputData(scene);
    simplify->SetMaximumDistance(1e-9); // nothing can be removed: only checks
    vtkNew<vtkCallbackCommand> stop;
    stop->SetClientData(&events);
    stop->SetCallback(CountedEvents::OnProgress);
    simplify->AddObserver(vtkCommand::ProgressEvent, stop);
    log->Watch(simplify);
    log->Watch(simplify->GetExecutive());
    simplify->Update();
    CHECK((simplify->GetOutput()->GetNumberOfCells() == 0) == (last < VTK_INT_MAX));
    return events.Count;
  };
  const auto none = vtkSmartPointer<helios::ErrorObserver>::Take(helios::ErrorObserver::New());
  const int all = run(VTK_INT_MAX, none);
  REQUIRE(all > 20);
  for (int last = 1; last < all; last += 3)
  {
    CAPTURE(last, all);
    const auto log = vtkSmartPointer<helios::ErrorObserver>::Take(helios::ErrorObserver::New());
    CHECK(run(last, log) == last);
    CHECK(log->HasError("The work was aborted at 20 %; update again to complete it"));
  }
}
