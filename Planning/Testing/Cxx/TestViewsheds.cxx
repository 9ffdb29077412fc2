// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHeliosViewsheds.h"

#include "heliosErrorObserver.h"
#include "heliosPlanningTest.h"
#include "heliosPyramidScene.h"
#include "heliosVisibility.h"
#include "vtkHeliosArrayNames.h"
#include "vtkHeliosBvhRayCaster.h"
#include "vtkHeliosScanPositionCandidates.h"
#include "vtkHeliosVisibilityTestPoints.h"

#include <catch2/catch.hpp>
#include <vtkDoubleArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkSMPTools.h>

#include <cmath>

namespace names = vtkHeliosArrayNames;
using helios::MakeFloor;
using helios::MakePoints;

namespace
{

/// The pyramid scene seen from a grid of 1 m.
struct PyramidViews
{
  vtkSmartPointer<vtkPolyData> Scene = helios::MakePyramidScene();
  vtkNew<vtkHeliosScanPositionCandidates> Candidates;
  vtkNew<vtkHeliosVisibilityTestPoints> TestPoints;
  vtkNew<vtkHeliosViewsheds> Viewsheds;

  PyramidViews()
  {
    this->Candidates->SetInputData(this->Scene);
    this->Candidates->SetStep(1.0);
    this->Candidates->SetMaximumSlope(30.0);
    this->TestPoints->SetInputData(this->Scene);
    this->TestPoints->SetStep(1.0);
    this->TestPoints->HorizontalOff();
    this->Viewsheds->SetInputData(0, this->Scene);
    this->Viewsheds->SetInputConnection(1, this->Candidates->GetOutputPort());
    this->Viewsheds->SetInputConnection(2, this->TestPoints->GetOutputPort());
  }

  vtkPolyData* Update()
  {
    this->Viewsheds->Update();
    return this->Viewsheds->GetOutput();
  }

  vtkIdType CountOnes()
  {
    vtkDataArray* sizes = this->Update()->GetPointData()->GetArray(names::ViewshedSize);
    vtkIdType sum = 0;
    for (vtkIdType i = 0; i < sizes->GetNumberOfTuples(); ++i)
    {
      sum += static_cast<vtkIdType>(sizes->GetTuple1(i));
    }
    return sum;
  }

  /// ViewshedSize and MeanIncidenceAngle of the candidate at a position.
  std::pair<double, double> GetView(double x, double y, double z)
  {
    vtkPolyData* views = this->Update();
    for (vtkIdType i = 0; i < views->GetNumberOfPoints(); ++i)
    {
      double p[3];
      views->GetPoint(i, p);
      if (std::hypot(p[0] - x, p[1] - y, p[2] - z) < 1e-9)
      {
        return { views->GetPointData()->GetArray(names::ViewshedSize)->GetTuple1(i),
          views->GetPointData()->GetArray(names::MeanIncidenceAngle)->GetTuple1(i) };
      }
    }
    return { -1.0, -1.0 };
  }
};

void AddNormal(vtkPolyData* points, double x, double y, double z)
{
  vtkNew<vtkDoubleArray> normals;
  normals->SetName(names::Normal);
  normals->SetNumberOfComponents(3);
  for (vtkIdType i = 0; i < points->GetNumberOfPoints(); ++i)
  {
    normals->InsertNextTuple3(x, y, z);
  }
  points->GetPointData()->AddArray(normals);
}

/// One instrument over a floor, and test points on it at these x.
struct FloorViews
{
  vtkNew<vtkHeliosViewsheds> Viewsheds;
  vtkSmartPointer<helios::ErrorObserver> Log =
    vtkSmartPointer<helios::ErrorObserver>::Take(helios::ErrorObserver::New());

  FloorViews()
  {
    this->Viewsheds->SetInputData(0, MakeFloor(100.0, 0.0));
    this->Viewsheds->SetInputData(1, MakePoints({ { 0.0, 0.0, 2.0 } }));
    auto testPoints =
      MakePoints({ { 0.0, 0.0, 0.0 }, { 2.0, 0.0, 0.0 }, { 20.0, 0.0, 0.0 }, { 90.0, 0.0, 0.0 } });
    AddNormal(testPoints, 0.0, 0.0, 1.0);
    this->Viewsheds->SetInputData(2, testPoints);
    this->Log->Watch(this->Viewsheds);
  }

  /// Which of the four are seen, from left to right.
  std::string See()
  {
    this->Viewsheds->Update();
    helios::Visibility matrix;
    REQUIRE(matrix.Set(this->Viewsheds->GetOutput(), 4).IsOk());
    std::string seen;
    for (vtkIdType v = 0; v < 4; ++v)
    {
      seen += matrix.IsVisible(0, v) ? '1' : '0';
    }
    return seen;
  }
};

} // namespace

TEST_CASE("Viewsheds: the pyramid agrees with the closed form", "[Viewsheds]")
{
  PyramidViews views;
  CHECK(views.Update()->GetNumberOfPoints() == 425);
  CHECK(views.TestPoints->GetOutput()->GetNumberOfPoints() == 441);
  for (const bool bothSides : { false, true })
  {
    views.Viewsheds->SetBothSides(bothSides);
    for (const double tolerance : { 0.04, 0.05, 0.06 })
    {
      views.Viewsheds->SetHitTolerance(tolerance);
      CAPTURE(bothSides, tolerance);
      CHECK(views.CountOnes() == 135873);
    }
  }
  const double truth[][5] = { // x y z, test points seen, mean incidence
    { -2, 10, 1.5, 347, 78.8327 }, { 0, 0, 3.9375, 401, 63.6560 }, { 10, -2, 1.5, 347, 78.4633 },
    { -10, -10, 1.5, 329, 80.5455 }, { 10, 10, 1.5, 329, 80.5228 }
  };
  for (const auto& t : truth)
  {
    const auto [size, angle] = views.GetView(t[0], t[1], t[2]);
    CHECK(size == t[3]);
    CHECK(angle == Approx(t[4]).margin(0.5)); // normals on the pyramid's edges are ambiguous
  }
}

TEST_CASE("Viewsheds: pieces equal the whole, with every ray caster", "[Viewsheds]")
{
  PyramidViews views;
  const auto getBytes = [&views](int piece, int pieces)
  {
    views.Viewsheds->Modified();
    views.Viewsheds->UpdatePiece(piece, pieces, 0);
    auto* rows = views.Viewsheds->GetOutput()->GetPointData()->GetArray(names::Visibility);
    auto* angles =
      views.Viewsheds->GetOutput()->GetPointData()->GetArray(names::MeanIncidenceAngle);
    std::string bytes(static_cast<const char*>(rows->GetVoidPointer(0)),
      static_cast<std::size_t>(8 * rows->GetNumberOfValues()));
    bytes += std::string(static_cast<const char*>(angles->GetVoidPointer(0)),
      static_cast<std::size_t>(8 * angles->GetNumberOfValues()));
    return std::make_pair(bytes, views.Viewsheds->GetOutput()->GetNumberOfPoints());
  };
  const auto whole = getBytes(0, 1);
  CHECK(whole.second == 425);
  vtkSMPTools::Initialize(1);
  CHECK(getBytes(0, 1) == whole);
  vtkSMPTools::Initialize(0);
  vtkNew<vtkHeliosBvhRayCaster> bvh;
  views.Viewsheds->SetRayCaster(bvh);
  CHECK(getBytes(0, 1) == whole);
  std::string rows, angles;
  for (int piece = 0; piece < 3; ++piece)
  {
    const auto [bytes, count] = getBytes(piece, 3);
    const std::size_t size = static_cast<std::size_t>(count) * 7 * 8;
    rows += bytes.substr(0, size);
    angles += bytes.substr(size);
  }
  CHECK(rows + angles == whole.first);
}

TEST_CASE("Viewsheds: limits of the instrument", "[Viewsheds]")
{
  FloorViews views; // at 0, 2, 20 and 90 m, incidence 0, 45, 84.3 and 88.7 degrees
  CHECK(views.See() == "1111");
  vtkPolyData* output = views.Viewsheds->GetOutput();
  const double mean =
    (0.0 + 45.0 + std::atan(10.0) * 180.0 / M_PI + std::atan(45.0) * 180.0 / M_PI) / 4.0;
  CHECK(output->GetPointData()->GetArray(names::MeanIncidenceAngle)->GetTuple1(0) ==
    Approx(mean).epsilon(1e-12));
  CHECK(views.Viewsheds->GetNumberOfRays() == 4);
  SECTION("range")
  {
    views.Viewsheds->SetMinimumRange(2.5);
    views.Viewsheds->SetMaximumRange(20.5);
    CHECK(views.See() == "0110");
    CHECK(views.Viewsheds->GetNumberOfRays() == 2);
  }
  SECTION("incidence, on the limit")
  {
    views.Viewsheds->SetMaximumIncidenceAngle(45.0);
    CHECK(views.See() == "1100");
  }
  SECTION("field of view, on the limit")
  {
    views.Viewsheds->SetMinimumElevation(-45.0);
    CHECK(views.See() == "0111");
    views.Viewsheds->SetMaximumElevation(-2.0);
    CHECK(views.See() == "0110");
  }
  SECTION("density")
  {
    // cos i / (R step)^2 at 2 m: 0.7071 / (8 step^2)
    views.Viewsheds->SetAngularStep(0.1);
    const double step = 0.1 * M_PI / 180.0;
    views.Viewsheds->SetMinimumPointDensity(0.99999 * std::sqrt(0.5) / (8.0 * step * step));
    CHECK(views.See() == "1100");
    views.Viewsheds->SetMinimumPointDensity(1.00001 * std::sqrt(0.5) / (8.0 * step * step));
    CHECK(views.See() == "1000");
  }
  SECTION("no test point is visible")
  {
    views.Viewsheds->SetMaximumRange(1.0);
    CHECK(views.See() == "0000");
    output = views.Viewsheds->GetOutput();
    CHECK(std::isnan(output->GetPointData()->GetArray(names::MeanIncidenceAngle)->GetTuple1(0)));
    CHECK(output->GetPointData()->GetArray(names::ViewshedSize)->GetTuple1(0) == 0);
  }
}

TEST_CASE("Viewsheds: surfaces just before and behind a test point", "[Viewsheds]")
{
  FloorViews views;
  // 30 mm and 70 mm under the floor, 30 mm and 70 mm above it, straight below the instrument.
  const auto testPoints =
    MakePoints({ { 0, 0, -0.03 }, { 0, 0, -0.07 }, { 0, 0, 0.03 }, { 0, 0, 0.07 } });
  views.Viewsheds->SetInputData(2, testPoints);
  CHECK(views.See() == "1011");
  views.Viewsheds->BothSidesOn();
  CHECK(views.See() == "1010");
  views.Viewsheds->SetHitTolerance(0.08);
  CHECK(views.See() == "1111");
}

TEST_CASE(
  "Viewsheds: a line of sight without a hit sees the point, but not from both sides", "[Viewsheds]")
{
  FloorViews views;
  views.Viewsheds->SetInputData(
    2, MakePoints({ { 0, 0, 3 }, { 200, 0, 0 }, { 0, 0, 2 }, { 1, 0, -1 } }));
  CHECK(views.See() == "1100"); // the third is at the instrument position
  views.Viewsheds->BothSidesOn();
  CHECK(views.See() == "0000");
}

TEST_CASE("Viewsheds: bad input is an error", "[Viewsheds]")
{
  FloorViews views;
  const auto fails = [&views](const std::string& text)
  {
    views.Viewsheds->Update();
    return views.Log->HasError(text);
  };
  SECTION("scene")
  {
    views.Viewsheds->SetInputData(0, vtkNew<vtkPolyData>());
    CHECK(fails("The scene on port 0 is empty; connect what hides test points."));
  }
  SECTION("candidates")
  {
    views.Viewsheds->SetInputData(1, vtkNew<vtkPolyData>());
    CHECK(fails("There are no candidates on port 1; connect a vtkHeliosScanPositionCandidates, or "
                "points of your own."));
    views.Viewsheds->SetInputData(1, MakePoints({ { 0, 0, 1 }, { 0, NAN, 1 } }));
    CHECK(fails("Candidate 1 is not finite; correct or remove it."));
  }
  SECTION("test points")
  {
    views.Viewsheds->SetInputData(2, vtkNew<vtkPolyData>());
    CHECK(fails("There are no test points on port 2; connect a vtkHeliosVisibilityTestPoints, or "
                "points of your own."));
    views.Viewsheds->SetInputData(2, MakePoints({ { 0, INFINITY, 1 } }));
    CHECK(fails("Test point 0 is not finite; correct or remove it."));
  }
  SECTION("normals")
  {
    views.Viewsheds->SetInputData(2, MakePoints({ { 0, 0, 1 } }));
    views.Viewsheds->SetMaximumIncidenceAngle(80.0);
    CHECK(fails(
      "A maximum incidence angle and a minimum point density need normals, and the test "
      "points have no point array Normal of 3 components; add it, or do not set these limits."));
  }
  SECTION("angular step")
  {
    views.Viewsheds->SetMinimumPointDensity(1.0);
    CHECK(
      fails("A minimum point density needs the angle between neighbouring pulses, and AngularStep "
            "is 0, unknown or irregular; set it, or give no minimum density."));
  }
  SECTION("ray caster")
  {
    views.Viewsheds->SetRayCaster(nullptr);
    CHECK(fails("RayCaster is not set; set one, e.g. a vtkHeliosBvhRayCaster."));
  }
  SECTION("memory")
  {
    views.Viewsheds->SetMemoryLimit(1.0);
    auto many = MakePoints({});
    for (int i = 0; i < 3000; ++i)
    {
      many->GetPoints()->InsertNextPoint(i, 0.0, 0.0);
    }
    views.Viewsheds->SetInputData(1, many);
    views.Viewsheds->SetInputData(2, many);
    CHECK(
      fails("3000 candidates' views need 1.076 MiB, more than the memory limit (1 MiB); make the "
            "grids coarser, ask for the matrix in pieces, or allow more."));
    views.Viewsheds->UpdatePiece(1, 2, 0); // half the size is allowed
    CHECK(views.Viewsheds->GetOutput()->GetNumberOfPoints() == 1500);
  }
  SECTION("abort")
  {
    helios::AbortAtProgress(views.Viewsheds);
    CHECK(fails("Aborted; update again for all viewsheds."));
  }
}
