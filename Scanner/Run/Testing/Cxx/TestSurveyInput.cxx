// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Scenes from a pipeline in place of the survey's.
#include "vtkHeliosRunOptions.h"
#include "vtkHeliosSurveySource.h"

#include "heliosSurveyPlaying.h"
#include "vtkHeliosArrayNames.h"

#include <vtkAppendFilter.h>
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkDoubleArray.h>
#include <vtkImageData.h>
#include <vtkMultiBlockDataSet.h>
#include <vtkPlaneSource.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkSphereSource.h>
#include <vtkTriangleFilter.h>
#include <vtkUnstructuredGrid.h>

#include <catch2/catch.hpp>

#include <cmath>
#include <vector>

namespace fs = std::filesystem;
namespace names = vtkHeliosArrayNames;
using helios::ErrorObserver;
using namespace helios::test;

namespace
{

/// A survey whose own scene is a floor at z = 0, run with other scenes, without noise.
struct Bench
{
  Files Folder;
  Reading Survey{ Folder, Flight, ThreeLegs };
  vtkNew<vtkHeliosSurveySource> Source;
  vtkSmartPointer<ErrorObserver> Log = Observe(Source);

  Bench()
  {
    REQUIRE(this->Survey.Good);
    this->Source->SetSurvey(this->Survey.Reader->GetSurvey());
    this->Source->GetOptions()->NoiseOff();
    this->Source->SetPulseWindow(0, 2000);
  }

  /// The height of all echoes; NaN if they are not level, or not 2000.
  double FindHeight()
  {
    this->Source->Update();
    vtkPolyData* echoes = this->Source->GetOutput();
    double bounds[6];
    echoes->GetBounds(bounds);
    const bool isLevel = echoes->GetNumberOfPoints() == 2000 && bounds[5] - bounds[4] < 1e-4;
    return isLevel ? 0.5 * (bounds[4] + bounds[5]) : std::nan("");
  }
};

/// A rectangle of 100 m by 100 m as one polygon with four corners.
vtkSmartPointer<vtkPlaneSource> MakePlane(double z)
{
  auto plane = vtkSmartPointer<vtkPlaneSource>::New();
  plane->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
  plane->SetOrigin(-50.0, -50.0, z);
  plane->SetPoint1(50.0, -50.0, z);
  plane->SetPoint2(-50.0, 50.0, z);
  return plane;
}

} // namespace

TEST_CASE("SurveyInput: the echoes lie on the input scene", "[SurveyInput]")
{
  Bench bench;
  CHECK(bench.FindHeight() == Approx(0.0).margin(1e-4)); // its own scene
  const auto plane = MakePlane(1.0);
  bench.Source->SetInputConnection(0, plane->GetOutputPort());
  CHECK(bench.FindHeight() == Approx(1.0));
  CHECK(bench.Source->GetScene()->GetNumberOfPolys() == 2);

  plane->SetOrigin(-50.0, -50.0, 2.5);
  plane->SetPoint1(50.0, -50.0, 2.5);
  plane->SetPoint2(-50.0, 50.0, 2.5);
  CHECK(bench.FindHeight() == Approx(2.5)); // follows the pipeline
  CHECK(bench.Source->Load());
  vtkPolyData* scene = bench.Source->GetScene();
  CHECK(bench.FindHeight() == Approx(2.5));
  CHECK(bench.Source->GetScene() == scene); // and only its changes

  bench.Source->SetInputConnection(0, nullptr);
  CHECK(bench.FindHeight() == Approx(0.0).margin(1e-4));
  CHECK(bench.Log->Errors.empty());
}

TEST_CASE("SurveyInput: a moved point of a mesh moves its echoes", "[SurveyInput]")
{
  Bench bench;
  vtkNew<vtkTriangleFilter> triangles;
  triangles->SetInputConnection(MakePlane(1.0)->GetOutputPort());
  triangles->Update();
  vtkPolyData* mesh = triangles->GetOutput();
  bench.Source->SetInputData(0, mesh);
  CHECK(bench.FindHeight() == Approx(1.0));
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
  {
    const double* p = mesh->GetPoint(i);
    mesh->GetPoints()->SetPoint(i, p[0], p[1], 3.0);
  }
  mesh->GetPoints()->Modified();
  CHECK(bench.FindHeight() == Approx(3.0));
}

TEST_CASE("SurveyInput: any data set with a surface is scanned", "[SurveyInput]")
{
  Bench bench;
  const auto plane = MakePlane(1.5);
  SECTION("an unstructured grid")
  {
    vtkNew<vtkAppendFilter> grid;
    grid->SetInputConnection(plane->GetOutputPort());
    grid->Update();
    REQUIRE(grid->GetOutput()->IsA("vtkUnstructuredGrid"));
    bench.Source->SetInputConnection(0, grid->GetOutputPort());
    CHECK(bench.FindHeight() == Approx(1.5));
  }
  SECTION("an image: its faces")
  {
    vtkNew<vtkImageData> box;
    box->SetDimensions(2, 2, 2);
    box->SetSpacing(100.0, 100.0, 1.0);
    box->SetOrigin(-50.0, -50.0, 0.5);
    bench.Source->SetInputData(0, box);
    CHECK(bench.FindHeight() == Approx(1.5));
    CHECK(bench.Source->GetScene()->GetNumberOfPolys() == 12);
  }
  SECTION("a composite data set")
  {
    const auto lower = MakePlane(0.5);
    plane->Update();
    lower->Update();
    vtkNew<vtkMultiBlockDataSet> blocks;
    blocks->SetBlock(0, lower->GetOutput());
    blocks->SetBlock(1, plane->GetOutput());
    bench.Source->SetInputDataObject(0, blocks);
    CHECK(bench.FindHeight() == Approx(1.5));
    CHECK(bench.Source->GetScene()->GetNumberOfPolys() == 4);
  }
  CHECK(bench.Log->Errors.empty());
}

TEST_CASE("SurveyInput: a piece of the pulses has the whole scene", "[SurveyInput]")
{
  Bench bench;
  vtkNew<vtkSphereSource> sphere; // makes pieces of itself
  sphere->SetRadius(100.0);
  sphere->SetCenter(0.0, 0.0, -100.0);
  sphere->SetThetaResolution(60);
  sphere->SetPhiResolution(60);
  bench.Source->SetInputConnection(0, sphere->GetOutputPort());
  vtkIdType count = 0;
  for (int piece = 0; piece < 3; ++piece)
  {
    bench.Source->UpdatePiece(piece, 3, 0);
    count += bench.Source->GetOutput()->GetNumberOfPoints();
  }
  CHECK(count == 2000);
}

TEST_CASE("SurveyInput: grids of turbid voxels are scanned with a scene, or alone", "[SurveyInput]")
{
  Bench bench;
  vtkNew<vtkImageData> leaves;
  leaves->SetDimensions(2, 2, 2);
  leaves->SetSpacing(100.0, 100.0, 0.5);
  leaves->SetOrigin(-50.0, -50.0, 1.0);
  vtkNew<vtkDoubleArray> density;
  density->SetName(names::PAD);
  density->InsertNextValue(200.0); // opaque [m^2/m^3]
  leaves->GetCellData()->AddArray(density);
  bench.Source->AddInputDataObject(1, leaves);
  const auto isInside = [&bench]
  {
    bench.Source->Update();
    double bounds[6];
    bench.Source->GetOutput()->GetBounds(bounds);
    return bench.Source->GetOutput()->GetNumberOfPoints() > 1900 && bounds[4] > 1.0 &&
      bounds[5] < 1.5;
  };
  CHECK(isInside());
  CHECK(bench.Source->GetGrid(0) != nullptr);
  bench.Source->SetInputConnection(0, MakePlane(-5.0)->GetOutputPort());
  CHECK(isInside());
  INFO(bench.Log->Errors);
  CHECK(bench.Log->Errors.empty());
}

TEST_CASE("SurveyInput: a scene without a surface is an error", "[SurveyInput]")
{
  Bench bench;
  vtkNew<vtkPolyData> nothing;
  bench.Source->SetInputData(0, nothing);
  CHECK_FALSE(bench.Source->Load());
  CHECK(bench.Log->HasError("the input scene, a vtkPolyData, has no polygons"));
  const auto plane = MakePlane(1.0);
  bench.Source->SetInputConnection(0, plane->GetOutputPort());
  CHECK(bench.FindHeight() == Approx(1.0));
}

TEST_CASE("SurveyInput: beams hit a mesh in place of the scene", "[SurveyInput]")
{
  Bench bench;
  CHECK(bench.Source->GetSceneSize() == 0.0);
  CHECK(bench.FindHeight() == Approx(0.0).margin(1e-4));
  const double start =
    bench.Source->GetOutput()->GetPointData()->GetArray(names::Range)->GetTuple1(0);
  const double size = bench.Source->GetSceneSize();
  CHECK(size > 500.0);
  vtkPolyData* scene = bench.Source->GetScene();
  const auto plane = MakePlane(1.0);
  plane->SetResolution(30, 30);
  bench.Source->SetInputConnection(3, plane->GetOutputPort());
  CHECK(bench.FindHeight() == Approx(1.0));
  CHECK(bench.Source->GetScene() == scene); // planned on it: the tripod stands as before
  const double now =
    bench.Source->GetOutput()->GetPointData()->GetArray(names::Range)->GetTuple1(0);
  CHECK(now < start - 0.5);
  CHECK(bench.Source->GetSceneSize() > 8.0 * size);
  plane->SetOrigin(-50.0, -50.0, 0.25);
  plane->SetPoint1(50.0, -50.0, 0.25);
  plane->SetPoint2(-50.0, 50.0, 0.25);
  CHECK(bench.FindHeight() == Approx(0.25)); // follows the pipeline

  vtkNew<vtkHeliosSurveyPlayer> player;
  player->SetSource(bench.Source);
  player->SetOutputDirectory((bench.Folder / "out").c_str());
  const auto log = Observe(player);
  REQUIRE(player->Run());
  CHECK(std::abs(ReadPoints(bench.Folder / "out/test/leg000_points.xyz").front().Z - 0.25) < 1e-3);
  bench.Source->SetInputConnection(3, nullptr);
  player->ResumeOn();
  CHECK_FALSE(player->Run());
  CHECK(player->GetMessage().find("the input mesh has changed") != std::string::npos);
  CHECK(bench.FindHeight() == Approx(0.0).margin(1e-4));

  vtkNew<vtkPolyData> nothing;
  bench.Source->SetInputData(3, nothing);
  bench.Source->Update();
  CHECK(
    bench.Log->HasError("the input mesh has no polygons; give one that stands in for the scene"));
}

TEST_CASE("SurveyInput: a player writes the echoes of its source", "[SurveyInput]")
{
  Bench bench;
  bench.Source->SetInputConnection(0, MakePlane(1.0)->GetOutputPort());
  CHECK(bench.FindHeight() == Approx(1.0));
  vtkPolyData* scene = bench.Source->GetScene();
  vtkNew<vtkHeliosSurveyPlayer> player;
  player->SetSource(bench.Source);
  player->SetOutputDirectory((bench.Folder / "out").c_str());
  CHECK(player->GetSurvey() == bench.Survey.Reader->GetSurvey());
  CHECK(player->GetOptions() == bench.Source->GetOptions());
  REQUIRE(player->Run());
  CHECK(bench.Source->GetScene() == scene); // not loaded again
  bool isOn = true;
  const auto points = ReadPoints(bench.Folder / "out/test/leg000_points.xyz");
  for (const Point& point : points)
  {
    isOn = isOn && std::abs(point.Z - 1.0) < 1e-3;
  }
  CHECK(isOn);
  CHECK(static_cast<vtkIdType>(points.size()) <= player->GetCount("points"));
  CHECK(points.size() > 10000);

  player->ResumeOn();
  CHECK(player->Run());
  CHECK(player->GetWasFinished());
  bench.Source->SetInputConnection(0, MakePlane(2.0)->GetOutputPort());
  const auto log = Observe(player);
  CHECK_FALSE(player->Run()); // the files belong to another scene
  CHECK(
    log->HasError("cannot be resumed, since the scene has changed: its input, or a file of PROJ"));
  log->Clear();
  bench.Source->SetInputConnection(0, MakePlane(1.0)->GetOutputPort());
  CHECK(player->Run());
  vtkNew<vtkImageData> voxels;
  voxels->SetDimensions(2, 2, 2);
  bench.Source->AddInputDataObject(1, voxels);
  CHECK_FALSE(player->Run());
  CHECK(
    log->HasError("cannot be resumed, since the scene has changed: its input, or a file of PROJ"));
}

TEST_CASE("SurveyInput: polygons that cross are a warning with the input", "[SurveyInput]")
{
  Bench bench;
  const auto plane = MakePlane(1.0);
  plane->Update();
  vtkNew<vtkPolyData> crossed;
  crossed->ShallowCopy(plane->GetOutput());
  vtkNew<vtkCellArray> polys;
  polys->InsertNextCell({ 0, 1, 3, 2 });
  polys->InsertNextCell({ 0, 1, 2, 3 }); // a bow tie
  crossed->SetPolys(polys);
  bench.Source->SetInputData(0, crossed);
  CHECK(bench.FindHeight() == Approx(1.0));
  INFO(bench.Log->Warnings);
  CHECK(bench.Log->HasWarning("the input scene: The sides of polygon 1 cross, so its triangles"));
}
