// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHeliosVisibilityTestPoints.h"

#include "heliosPlanningTest.h"
#include "heliosPyramidScene.h"
#include "heliosSceneCrs.h"
#include "vtkHeliosArrayNames.h"

#include <catch2/catch.hpp>
#include <vtkCellData.h>
#include <vtkDoubleArray.h>
#include <vtkPointData.h>
#include <vtkSMPTools.h>

#include <cmath>

namespace names = vtkHeliosArrayNames;
using helios::MakeFloor;

namespace
{

struct TestPoints : helios::FilterOverScene<vtkHeliosVisibilityTestPoints>
{
  using FilterOverScene::FilterOverScene;

  double GetArea()
  {
    vtkDataArray* areas = this->Update()->GetPointData()->GetArray(names::Area);
    double sum = 0.0;
    for (vtkIdType i = 0; i < areas->GetNumberOfTuples(); ++i)
    {
      sum += areas->GetTuple1(i);
    }
    return sum;
  }
};

/// The twelve triangles of a box about the origin.
vtkSmartPointer<vtkPolyData> MakeBox(double x, double y, double z)
{
  std::vector<std::array<double, 3>> corners;
  for (int i = 0; i < 8; ++i)
  {
    corners.push_back({ i & 1 ? x : -x, i & 2 ? y : -y, i & 4 ? z : -z });
  }
  return helios::MakeTriangles(corners,
    { { 0, 1, 3 }, { 0, 3, 2 }, { 4, 5, 7 }, { 4, 7, 6 }, { 0, 1, 5 }, { 0, 5, 4 }, { 2, 3, 7 },
      { 2, 7, 6 }, { 0, 2, 6 }, { 0, 6, 4 }, { 1, 3, 7 }, { 1, 7, 5 } });
}

/// A sphere of radius 1 with this many meridians and parallels.
vtkSmartPointer<vtkPolyData> MakeSphere(int count)
{
  std::vector<std::array<double, 3>> corners;
  std::vector<std::array<int, 3>> triangles;
  for (int j = 0; j <= count; ++j)
  {
    const double polar = M_PI * j / count;
    for (int i = 0; i < count; ++i)
    {
      const double around = 2.0 * M_PI * i / count;
      corners.push_back({ std::sin(polar) * std::cos(around), std::sin(polar) * std::sin(around),
        std::cos(polar) });
      const int here = j * count + i;
      const int next = j * count + (i + 1) % count;
      if (j < count)
      {
        triangles.push_back({ here, here + count, next + count });
        triangles.push_back({ here, next + count, next });
      }
    }
  }
  return helios::MakeTriangles(corners, triangles);
}

} // namespace

TEST_CASE("VisibilityTestPoints: lines through a box hit all its sides", "[VisibilityTestPoints]")
{
  TestPoints points(MakeBox(5.0, 3.0, 2.0));
  points.Filter->GenerateAreasOn();
  vtkPolyData* output = points.Update();
  CHECK(output->GetNumberOfPoints() == 2 * (10 * 6 + 6 * 4 + 10 * 4));
  // Vertical lines first, down, in rows of x.
  CHECK(output->GetPoint(0)[0] == -4.5);
  CHECK(output->GetPoint(0)[1] == -2.5);
  CHECK(output->GetPoint(0)[2] == 2.0);
  CHECK(output->GetPoint(1)[2] == Approx(-2.0));
  CHECK(output->GetPoint(2)[0] == -3.5);
  for (vtkIdType i = 0; i < output->GetNumberOfPoints(); ++i)
  {
    double p[3], n[3];
    output->GetPoint(i, p);
    output->GetPointData()->GetArray(names::Normal)->GetTuple(i, n);
    const int axis = std::abs(n[0]) == 1.0 ? 0 : std::abs(n[1]) == 1.0 ? 1 : 2;
    const double half[3] = { 5.0, 3.0, 2.0 };
    REQUIRE(std::abs(n[axis]) == 1.0);
    CHECK(std::abs(p[axis]) == Approx(half[axis]).epsilon(1e-14));
  }
  CHECK(points.GetArea() == Approx(2.0 * 4.0 * (15.0 + 6.0 + 10.0)).epsilon(1e-12));
  SECTION("vertical only")
  {
    points.Filter->HorizontalOff();
    CHECK(points.Update()->GetNumberOfPoints() == 120);
    CHECK(points.GetArea() == Approx(120.0));
  }
  SECTION("horizontal only")
  {
    points.Filter->VerticalOff();
    CHECK(points.Update()->GetNumberOfPoints() == 128);
  }
  SECTION("own steps")
  {
    points.Filter->SetXStep(2.0);
    points.Filter->SetYStep(3.0);
    points.Filter->SetZStep(0.5);
    CHECK(points.Update()->GetNumberOfPoints() == 2 * (5 * 2 + 2 * 8 + 5 * 8));
    CHECK(points.GetArea() == Approx(248.0).epsilon(1e-12));
  }
  SECTION("a region")
  {
    points.Filter->SetRegion(-2.0, 2.0, -2.0, 2.0, -1.0, 9.0); // only the upper side
    CHECK(points.Update()->GetNumberOfPoints() == 16);
  }
  SECTION("without areas")
  {
    points.Filter->GenerateAreasOff();
    CHECK(points.Update()->GetPointData()->GetArray(names::Area) == nullptr);
  }
}

TEST_CASE("VisibilityTestPoints: areas add up to that of the surface", "[VisibilityTestPoints]")
{
  TestPoints points(MakeSphere(300));
  points.Filter->SetStep(0.02);
  points.Filter->GenerateAreasOn();
  CHECK(points.GetArea() == Approx(4.0 * M_PI).epsilon(2e-3));
  points.Filter->HorizontalOff(); // 1 / cos grows without bounds at the rim
  CHECK(points.GetArea() == Approx(4.0 * M_PI).epsilon(5e-2));
}

TEST_CASE("VisibilityTestPoints: points at crossings of lines are merged", "[VisibilityTestPoints]")
{
  // The planes x = z and y = 0.5: lines of two or three families intersect there at half metres.
  TestPoints points(helios::MakeTriangles(
    { { 0, 0, 0 }, { 4, 0, 4 }, { 4, 4, 4 }, { 0, 4, 0 } }, { { 0, 1, 2 }, { 0, 2, 3 } }));
  points.Filter->GenerateAreasOn();
  CHECK(points.Update()->GetNumberOfPoints() == 16); // 16 from above coincide with 16 from the side
  CHECK(points.GetArea() == Approx(16.0 * std::sqrt(2.0)).epsilon(1e-12));
  points.Filter->SetMergeTolerance(0.0);
  CHECK(points.Update()->GetNumberOfPoints() <= 32);
  CHECK(points.GetArea() == Approx(16.0 * std::sqrt(2.0)).epsilon(1e-12));
}

TEST_CASE("VisibilityTestPoints: close surfaces give separate points", "[VisibilityTestPoints]")
{
  auto scene = MakeBox(5.0, 5.0, 0.001);
  TestPoints points(scene);
  points.Filter->HorizontalOff();
  CHECK(points.Update()->GetNumberOfPoints() == 200);
  points.Filter->SetMergeTolerance(0.1); // limited to a thousandth of the step
  CHECK(points.Update()->GetNumberOfPoints() == 200);
  auto thin = MakeBox(5.0, 5.0, 0.0004);
  points.Filter->SetInputData(thin);
  CHECK(points.Update()->GetNumberOfPoints() == 100);
}

TEST_CASE("VisibilityTestPoints: the pyramid with horizontal lines", "[VisibilityTestPoints]")
{
  TestPoints points(helios::MakePyramidScene());
  points.Filter->HorizontalOff();
  CHECK(points.Update()->GetNumberOfPoints() == 441);
  points.Filter->HorizontalOn();
  points.Filter->VerticalOff();
  points.Filter->SetStep(0.5);
  points.Filter->SetRegion(-10.25, 10.25, -10.25, 10.25, 0.25, 2.25); // heights 0.5 to 2
  CHECK(points.Update()->GetNumberOfPoints() == 128);
}

TEST_CASE(
  "VisibilityTestPoints: cell normals have precedence over winding", "[VisibilityTestPoints]")
{
  auto scene = MakeFloor(5.0, 0.0);
  vtkNew<vtkDoubleArray> normals;
  normals->SetName(names::Normals);
  normals->SetNumberOfComponents(3);
  normals->InsertNextTuple3(0.0, 0.6, 0.8);
  normals->InsertNextTuple3(0.0, 0.0, 0.0); // none
  scene->GetCellData()->AddArray(normals);
  helios::SetCRS(scene, "EPSG:32632");
  TestPoints points(scene);
  vtkPolyData* output = points.Update();
  CHECK(helios::GetCRS(output) == "EPSG:32632");
  vtkDataArray* cells = output->GetPointData()->GetArray(names::CellIds);
  for (vtkIdType i = 0; i < output->GetNumberOfPoints(); ++i)
  {
    CHECK(output->GetPointData()->GetArray(names::Normal)->GetComponent(i, 2) ==
      (cells->GetTuple1(i) == 0.0 ? 0.8 : 1.0));
  }
}

TEST_CASE("VisibilityTestPoints: independent of the number of threads", "[VisibilityTestPoints]")
{
  TestPoints points(helios::MakePyramidScene());
  points.Filter->SetStep(0.05);
  vtkNew<vtkPolyData> first;
  first->DeepCopy(points.Update());
  vtkSMPTools::Initialize(1);
  points.Filter->Modified();
  vtkPolyData* second = points.Update();
  vtkSMPTools::Initialize(0);
  REQUIRE(first->GetNumberOfPoints() == second->GetNumberOfPoints());
  CHECK(first->GetNumberOfPoints() > 160000);
  bool isSame = true;
  for (vtkIdType i = 0; i < first->GetNumberOfPoints(); ++i)
  {
    double p[3];
    first->GetPoint(i, p);
    isSame = isSame && std::equal(p, p + 3, second->GetPoint(i));
  }
  CHECK(isSame);
}

TEST_CASE("VisibilityTestPoints: lines pass at large coordinates", "[VisibilityTestPoints]")
{
  auto scene = MakeBox(5.0, 5.0, 2.0);
  for (vtkIdType i = 0; i < 8; ++i)
  {
    double* p = scene->GetPoint(i);
    scene->GetPoints()->SetPoint(i, p[0] + 1e9, p[1] - 1e9, p[2] + 1e12);
  }
  TestPoints points(scene);
  points.Filter->HorizontalOff();
  CHECK(points.Update()->GetNumberOfPoints() == 200);
}

TEST_CASE("VisibilityTestPoints: bad input is an error", "[VisibilityTestPoints]")
{
  CHECK(TestPoints(vtkNew<vtkPolyData>())
          .Fails("The scene on port 0 is empty; connect what is to be scanned."));
  TestPoints points(MakeFloor(5.0, 0.0));
  SECTION("no lines")
  {
    points.Filter->VerticalOff();
    points.Filter->HorizontalOff();
    CHECK(points.Fails("Vertical and horizontal lines are both off; switch one on."));
  }
  SECTION("lines without a hit")
  {
    points.Filter->VerticalOff();
    points.Filter->SetRegion(-5.0, 5.0, -5.0, 5.0, 1.0, 3.0);
    CHECK(
      points.Fails("No test point: none of 0 vertical and 40 horizontal lines meets a surface in "
                   "the region; move it onto the scene, or make the grid finer."));
  }
  SECTION("a region upside down")
  {
    points.Filter->SetRegion(-5.0, 5.0, 5.0, -5.0, 1.0, 3.0);
    CHECK(points.Fails(
      "The region of test points is y 5 to -5; the first must not be above the second."));
  }
  SECTION("a grid too fine")
  {
    points.Filter->SetStep(1e-4);
    CHECK(points.Fails(" MiB, more than the memory limit (2048 MiB); make the grid of test points "
                       "coarser."));
  }
  SECTION("abort")
  {
    helios::AbortAtProgress(points.Filter);
    CHECK(points.Fails("Aborted; update again for all test points."));
  }
}
