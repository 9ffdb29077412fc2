// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosErrorObserver.h"
#include "heliosSceneTesting.h"
#include "vtkHeliosMeshRepair.h"
#include "vtkHeliosSyntheticScene.h"

#include <vtkCallbackCommand.h>
#include <vtkDoubleArray.h>
#include <vtkExecutive.h>
#include <vtkFieldData.h>
#include <vtkPointData.h>
#include <vtkStringArray.h>
#include <vtkUnsignedCharArray.h>

#include <catch2/catch.hpp>

#include <array>
#include <initializer_list>
#include <limits>
#include <random>
#include <string>
#include <vector>

namespace names = vtkHeliosArrayNames;

namespace
{

using Corner = std::array<double, 3>;

/// A handmade scene: cell i has material id i and the double 10 i, point i the double 100 i.
class Hand
{
public:
  Hand()
  {
    this->Points->SetDataTypeToDouble();
    this->MaterialIds->SetName(names::MaterialIds);
    this->PartIds->SetName(names::PartIds);
    this->CellValues->SetName("ten");
    this->PointValues->SetName("hundred");
  }

  vtkIdType AddPoint(const Corner& p)
  {
    this->PointValues->InsertNextValue(100.0 * this->Points->GetNumberOfPoints());
    return this->Points->InsertNextPoint(p.data());
  }
  void AddCell(std::initializer_list<vtkIdType> corners, int part = 0)
  {
    this->CellValues->InsertNextValue(10.0 * this->Polys->GetNumberOfCells());
    this->MaterialIds->InsertNextValue(static_cast<int>(this->Polys->GetNumberOfCells()));
    this->PartIds->InsertNextValue(part);
    this->Polys->InsertNextCell(corners);
  }
  void AddSoup(const Corner& a, const Corner& b, const Corner& c, int part = 0)
  {
    const vtkIdType first = this->AddPoint(a);
    this->AddPoint(b);
    this->AddPoint(c);
    this->AddCell({ first, first + 1, first + 2 }, part);
  }
  vtkSmartPointer<vtkPolyData> Finish()
  {
    auto scene = vtkSmartPointer<vtkPolyData>::New();
    scene->SetPoints(this->Points);
    scene->SetPolys(this->Polys);
    scene->GetCellData()->AddArray(this->MaterialIds);
    scene->GetCellData()->AddArray(this->PartIds);
    scene->GetCellData()->AddArray(this->CellValues);
    scene->GetPointData()->AddArray(this->PointValues);
    vtkNew<vtkStringArray> crs;
    crs->SetName(names::CRS);
    crs->InsertNextValue("EPSG:32632");
    scene->GetFieldData()->AddArray(crs);
    return scene;
  }

private:
  vtkNew<vtkPoints> Points;
  vtkNew<vtkCellArray> Polys;
  vtkNew<vtkIntArray> MaterialIds;
  vtkNew<vtkIntArray> PartIds;
  vtkNew<vtkDoubleArray> CellValues;
  vtkNew<vtkDoubleArray> PointValues;
};

std::vector<int> GetMaterialIds(vtkPolyData* scene)
{
  vtkIntArray* ids = helios::GetIds(scene, names::MaterialIds);
  return { ids->GetPointer(0), ids->GetPointer(0) + ids->GetNumberOfValues() };
}

/// Every array has the right value per cell or point, and every coordinate is one of the input's.
void CheckFollows(vtkPolyData* input, vtkPolyData* output)
{
  CHECK(output->GetPoints()->GetDataType() == VTK_DOUBLE);
  CHECK(output->GetCellData()->GetNumberOfTuples() == output->GetNumberOfCells());
  CHECK(output->GetPointData()->GetNumberOfTuples() == output->GetNumberOfPoints());
  vtkDataArray* ten = output->GetCellData()->GetArray("ten");
  const std::vector<int> ids = GetMaterialIds(output);
  for (std::size_t i = 0; i < ids.size(); ++i)
  {
    CHECK(ten->GetComponent(static_cast<vtkIdType>(i), 0) == 10.0 * ids[i]);
  }
  for (vtkIdType i = 0; i < output->GetNumberOfPoints(); ++i)
  {
    const double hundred = output->GetPointData()->GetArray("hundred")->GetComponent(i, 0);
    const helios::Vec3 p(output->GetPoint(i));
    CHECK(p == helios::Vec3(input->GetPoint(static_cast<vtkIdType>(hundred / 100.0))));
  }
  CHECK(output->GetFieldData()->GetAbstractArray(names::CRS) != nullptr);
}

const Corner A = { 0, 0, 0 };
const Corner B = { 1, 0, 0 };
const Corner C = { 0, 1, 0 };
const Corner D = { 1, 1, 0 };

} // namespace

TEST_CASE("MeshRepair: of duplicate triangles the first is kept", "[MeshRepair]")
{
  Hand hand;
  hand.AddSoup(C, B, D);
  hand.AddSoup(A, B, C);
  hand.AddSoup(A, B, C);
  hand.AddSoup(C, A, B); // rotated
  hand.AddSoup(A, C, B); // seen from behind
  hand.AddSoup(A, B, D);
  const auto scene = hand.Finish();
  vtkNew<vtkHeliosMeshRepair> repair;
  repair->SetInputData(scene);
  repair->Update();
  CHECK(GetMaterialIds(repair->GetOutput()) == std::vector<int>{ 0, 1, 5 });
  CHECK(repair->GetNumberOfDuplicateTriangles() == 3);
  CHECK(repair->GetNumberOfDegenerateTriangles() == 0);
  CHECK(repair->GetNumberOfUnusedPoints() == 9);
  CHECK(repair->GetNumberOfMergedPoints() == 0);
  CHECK(repair->GetOutput()->GetNumberOfPoints() == 9);
  CheckFollows(scene, repair->GetOutput());
  CHECK(scene->GetNumberOfCells() == 6);
}

TEST_CASE("MeshRepair: touching parts are not joined", "[MeshRepair]")
{
  Hand hand;
  hand.AddSoup(A, B, C, 0);
  hand.AddSoup(A, B, C, 7);
  hand.AddSoup(B, D, C, 7);
  const auto scene = hand.Finish();
  vtkNew<vtkHeliosMeshRepair> repair;
  repair->SetInputData(scene);
  repair->MergePointsOn();
  repair->Update();
  CHECK(repair->GetOutput()->GetNumberOfCells() == 3);
  CHECK(repair->GetOutput()->GetNumberOfPoints() == 7);
  CHECK(repair->GetNumberOfMergedPoints() == 2);
  CHECK(repair->GetNumberOfBoundaryEdges() == 3 + 4);
  CHECK(repair->GetNumberOfNonManifoldEdges() == 0);
  CheckFollows(scene, repair->GetOutput());
}

TEST_CASE("MeshRepair: drops triangles without area, exactly", "[MeshRepair]")
{
  const double x = 500000.1;
  const double y = 5500000.3;
  Hand hand;
  const vtkIdType a = hand.AddPoint({ x, y, 0 });
  const vtkIdType b = hand.AddPoint({ x + 1, y, 0 });
  const vtkIdType c = hand.AddPoint({ x, y + 1, 0 });
  hand.AddPoint({ 9, 9, 9 });
  hand.AddCell({ a, b, a });
  hand.AddCell({ a, b, c });
  hand.AddSoup({ 0, 0, 0 }, { 1, 2, 4 }, { 3, 6, 12 });
  hand.AddSoup({ 0, 0, 0 }, { 1, 2, 4 }, { 3, 6, std::nextafter(12.0, 13.0) });
  hand.AddSoup(A, B, B);
  const auto scene = hand.Finish();
  vtkNew<vtkHeliosMeshRepair> repair;
  repair->SetInputData(scene);
  repair->Update();
  CHECK(GetMaterialIds(repair->GetOutput()) == std::vector<int>{ 1, 3 });
  CHECK(repair->GetNumberOfDegenerateTriangles() == 3);
  CHECK(repair->GetNumberOfUnusedPoints() == 1 + 3 + 3);
  CheckFollows(scene, repair->GetOutput());
}

TEST_CASE("MeshRepair: drops triangles with points that are not finite", "[MeshRepair]")
{
  Hand hand;
  hand.AddSoup(A, B, { 0, std::numeric_limits<double>::quiet_NaN(), 0 });
  hand.AddSoup({ std::numeric_limits<double>::infinity(), 0, 0 }, B, C);
  hand.AddSoup(A, B, C);
  const auto scene = hand.Finish();
  vtkNew<vtkHeliosMeshRepair> repair;
  repair->SetInputData(scene);
  for (const bool merge : { false, true })
  {
    repair->SetMergePoints(merge);
    repair->Update();
    CHECK(GetMaterialIds(repair->GetOutput()) == std::vector<int>{ 2 });
    CHECK(repair->GetNumberOfNonFiniteTriangles() == 2);
    CheckFollows(scene, repair->GetOutput());
  }
}

TEST_CASE("MeshRepair: merges points at equal coordinates", "[MeshRepair]")
{
  Hand hand;
  hand.AddSoup(A, B, C);
  hand.AddSoup(B, D, C);
  hand.AddSoup({ -0.0, 0, 0 }, C, { -1, 0.5, 0 });
  hand.AddSoup({ 1e-200, 0, 0 }, { 0, -1, 0 }, { 1, -1, 0 });
  const auto scene = hand.Finish();
  vtkNew<vtkHeliosMeshRepair> repair;
  repair->SetInputData(scene);
  repair->Update();
  CHECK(repair->GetOutput()->GetPoints()->GetData() == scene->GetPoints()->GetData());
  CHECK(repair->GetOutput()->GetPolys() == scene->GetPolys());
  repair->MergePointsOn();
  repair->Update();
  CHECK(repair->GetOutput()->GetNumberOfCells() == 4);
  CHECK(repair->GetNumberOfMergedPoints() == 4);
  CHECK(repair->GetNumberOfUnusedPoints() == 0);
  CHECK(repair->GetOutput()->GetNumberOfPoints() == 12 - 4);
  CheckFollows(scene, repair->GetOutput());
}

TEST_CASE("MeshRepair: merges points within a tolerance", "[MeshRepair]")
{
  // Pairs 0.9 mm and 1.1 mm apart, 1 m from each other, anywhere on the search grid.
  std::mt19937 random(3);
  std::uniform_real_distribution<double> anywhere(0.0, 0.002);
  Hand hand;
  int near = 0;
  for (int i = 0; i < 300; ++i)
  {
    const double x = 500000.0 + 3 * i + anywhere(random);
    const double y = 5500000.0 + anywhere(random);
    const double apart = i % 2 == 0 ? 0.0009 : 0.0011;
    const double side = i % 4 < 2 ? apart : -apart;
    near += i % 2 == 0;
    hand.AddSoup({ x, y, 0 }, { x + 1, y, 0 }, { x, y + 1, 0 });
    hand.AddSoup(
      { x + side / 3, y + side * 2 / 3, side * 2 / 3 }, { x + 1, y, 2 }, { x, y + 1, 2 });
  }
  const auto scene = hand.Finish();
  vtkNew<vtkHeliosMeshRepair> repair;
  repair->SetInputData(scene);
  repair->MergePointsOn();
  repair->SetMergeTolerance(0.001);
  repair->Update();
  CHECK(repair->GetNumberOfMergedPoints() == near);
  CHECK(repair->GetNumberOfBoundaryEdges() == 6 * 300);
  CheckFollows(scene, repair->GetOutput());
  // A triangle smaller than the tolerance is degenerate.
  repair->SetMergeTolerance(10.0);
  repair->Update();
  CHECK(repair->GetNumberOfDegenerateTriangles() > 0);
  CHECK(repair->GetOutput()->GetNumberOfPoints() < 300);
}

TEST_CASE("MeshRepair: a closed surface has no reported edges", "[MeshRepair]")
{
  vtkNew<vtkHeliosSyntheticScene> sphere;
  sphere->SetKindToSphere();
  vtkNew<vtkHeliosMeshRepair> repair;
  repair->SetInputConnection(sphere->GetOutputPort());
  repair->GenerateEdgeDefectsOn();
  repair->Update();
  CHECK(repair->GetNumberOfBoundaryEdges() == 0);
  CHECK(repair->GetNumberOfNonManifoldEdges() == 0);
  CHECK(repair->GetNumberOfInconsistentEdges() == 0);
  auto* defects = vtkUnsignedCharArray::SafeDownCast(
    repair->GetOutput()->GetCellData()->GetArray(names::EdgeDefects));
  REQUIRE(defects);
  CHECK(defects->GetNumberOfValues() == repair->GetOutput()->GetNumberOfCells());
  CHECK(defects->GetRange()[1] == 0);
}

TEST_CASE("MeshRepair: counts boundary, non-manifold and inconsistent edges", "[MeshRepair]")
{
  Hand hand;
  hand.AddSoup(A, B, C); // with the next two: a fan about A B, and an edge B C
  hand.AddSoup(B, A, { 0, 0, 1 });
  hand.AddSoup(A, B, { 0, 0, -1 });
  hand.AddSoup(B, C, D); // goes along B C in the direction of the first
  hand.AddSoup({ 5, 0, 0 }, { 6, 0, 0 }, { 5, 1, 0 });
  vtkNew<vtkHeliosMeshRepair> repair;
  repair->SetInputData(hand.Finish());
  repair->GenerateEdgeDefectsOn();
  repair->Update();
  CHECK(repair->GetNumberOfNonManifoldEdges() == 1);
  CHECK(repair->GetNumberOfInconsistentEdges() == 1);
  CHECK(repair->GetNumberOfBoundaryEdges() == 1 + 2 + 2 + 2 + 3);
  vtkDataArray* defects = repair->GetOutput()->GetCellData()->GetArray(names::EdgeDefects);
  const int expected[] = { 1 + 2 + 4, 1 + 2, 1 + 2, 1 + 4, 1 };
  for (vtkIdType i = 0; i < 5; ++i)
  {
    CHECK(defects->GetComponent(i, 0) == expected[i]);
  }
}

TEST_CASE("MeshRepair: agrees with brute force on random triangles", "[MeshRepair]")
{
  std::mt19937 random(11);
  Hand hand;
  std::vector<std::array<Corner, 3>> soup;
  for (int i = 0; i < 600; ++i)
  {
    std::array<Corner, 3> triangle;
    for (Corner& corner : triangle)
    {
      corner = { random() % 3 * 0.5, random() % 3 * 0.25, 5.5e6 + random() % 2 };
    }
    hand.AddSoup(triangle[0], triangle[1], triangle[2]);
    soup.push_back(triangle);
  }
  std::vector<int> expected;
  std::map<std::array<Corner, 3>, int> known;
  for (int i = 0; i < 600; ++i)
  {
    const helios::Vec3 a(soup[i][0].data()), b(soup[i][1].data()), c(soup[i][2].data());
    const bool hasArea = (b - a).Cross(c - a).Norm() > 0.0; // exact: halves and quarters
    std::sort(soup[i].begin(), soup[i].end());
    if (hasArea && ++known[soup[i]] == 1)
    {
      expected.push_back(i);
    }
  }
  const auto scene = hand.Finish();
  vtkNew<vtkHeliosMeshRepair> repair;
  repair->SetInputData(scene);
  for (const bool merge : { false, true })
  {
    repair->SetMergePoints(merge);
    repair->Update();
    CHECK(GetMaterialIds(repair->GetOutput()) == expected);
    CheckFollows(scene, repair->GetOutput());
  }
  CHECK(repair->GetOutput()->GetNumberOfPoints() == 18);
}

TEST_CASE("MeshRepair: converts points to double and passes an empty scene", "[MeshRepair]")
{
  vtkNew<vtkHeliosMeshRepair> repair;
  repair->SetInputData(helios::MakeTriangle(3.0, { helios::Material() }, false, VTK_FLOAT));
  repair->Update();
  CHECK(repair->GetOutput()->GetPoints()->GetDataType() == VTK_DOUBLE);
  CHECK(repair->GetOutput()->GetPoint(1)[0] == 4.0);
  vtkNew<vtkPolyData> empty;
  repair->SetInputData(empty);
  repair->Update();
  CHECK(repair->GetOutput()->GetNumberOfCells() == 0);
  CHECK(repair->GetOutput()->GetNumberOfPoints() == 0);
  CHECK(repair->GetNumberOfBoundaryEdges() == 0);
}

TEST_CASE("MeshRepair: bad input is an error", "[MeshRepair]")
{
  auto log = vtkSmartPointer<helios::ErrorObserver>::Take(helios::ErrorObserver::New());
  vtkNew<vtkHeliosMeshRepair> repair;
  log->Watch(repair);

  Hand quad;
  for (const Corner& p : { A, B, D, C })
  {
    quad.AddPoint(p);
  }
  quad.AddCell({ 0, 1, 2, 3 });
  repair->SetInputData(quad.Finish());
  repair->Update();
  CHECK(log->HasError("cells that are not triangles; pass it through vtkTriangleFilter first"));

  log->Clear();
  Hand wild;
  wild.AddPoint(A);
  wild.AddCell({ 0, 0, 5 });
  repair->SetInputData(wild.Finish());
  repair->Update();
  CHECK(log->HasError("Triangle 0 has a corner that is not one of the scene's 1 points; corners "
                      "are point ids from 0"));

  log->Clear();
  Hand shortHand;
  shortHand.AddSoup(A, B, C);
  shortHand.AddSoup(B, D, C);
  const auto scene = shortHand.Finish();
  scene->GetCellData()->GetArray(names::PartIds)->Resize(1);
  repair->SetInputData(scene);
  repair->Update();
  CHECK(log->HasError("The cell array PartIds has 1 values for 2 cells; give each cell a value"));
  scene->GetCellData()->RemoveArray(names::PartIds);
  scene->GetPointData()->GetArray("hundred")->Resize(5);
  log->Clear();
  repair->Modified();
  repair->Update();
  CHECK(
    log->HasError("The point array hundred has 5 values for 6 points; give each point a value"));

  log->Clear();
  repair->SetInputData(helios::MakeTriangle(0.0, { helios::Material() }));
  repair->SetMergeTolerance(std::numeric_limits<double>::quiet_NaN());
  repair->Update();
  CHECK(log->HasError("MergeTolerance is nan; set a finite length of at least 0 m"));
}

TEST_CASE("MeshRepair: can be aborted", "[MeshRepair]")
{
  vtkNew<vtkHeliosMeshRepair> repair;
  repair->SetInputData(helios::MakeTriangle(0.0, { helios::Material() }));
  vtkNew<vtkCallbackCommand> stop;
  stop->SetCallback([](vtkObject* caller, unsigned long, void*, void*)
    { static_cast<vtkAlgorithm*>(caller)->AbortExecuteOn(); });
  repair->AddObserver(vtkCommand::ProgressEvent, stop);
  const auto log = vtkSmartPointer<helios::ErrorObserver>::Take(helios::ErrorObserver::New());
  log->Watch(repair);
  log->Watch(repair->GetExecutive());
  repair->Update();
  CHECK(repair->GetOutput()->GetNumberOfCells() == 0);
  CHECK(log->HasError("The work was aborted at 25 %; update again to complete it"));
}
