// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosScannerBench.h"

#include <vtkCellData.h>
#include <vtkFloatArray.h>
#include <vtkIntArray.h>

#include <catch2/catch.hpp>

#include <limits>

namespace names = vtkHeliosArrayNames;
using namespace helios::testing;

TEST_CASE("Scanner: what is wrong is said", "[Scanner]")
{
  const auto scene = MakeScene({ Wall(100) });
  Bench bench(scene);
  const auto expect = [&bench](const char* message)
  {
    bench.Scanner->Update();
    CHECK(bench.Log->HasError(message));
    bench.Log->Clear();
  };
  SECTION("no deflector")
  {
    bench.Scanner->SetBeamDeflector(nullptr);
    expect("BeamDeflector is not set");
    CHECK(bench.Scanner->GetNumberOfPulses() == -1);
  }
  SECTION("no ray caster")
  {
    bench.Scanner->SetRayCaster(nullptr);
    expect("RayCaster, BeamSampler or EchoDetector was set to nothing");
  }
  SECTION("ranges the wrong way round")
  {
    bench.Scanner->SetRangeMin(10);
    bench.Scanner->SetRangeMax(5);
    expect("is not beyond RangeMin");
  }
  SECTION("a head axis without direction")
  {
    bench.Scanner->SetHeadRotateAxis(0, 0, 0);
    expect("HeadRotateAxis has no direction");
  }
  SECTION("a scan that never ends")
  {
    bench.Scanner->SetDuration(-1);
    expect("the scan never ends");
  }
  SECTION("a head that turns away")
  {
    bench.Scanner->SetDuration(-1);
    bench.Scanner->SetHeadRotateStop(90);
    bench.Scanner->SetHeadRotateSpeed(-10);
    expect("the head never arrives");
  }
  SECTION("an empty scene")
  {
    vtkNew<vtkPolyData> empty;
    bench.Scanner->SetInputData(0, empty);
    expect("the scene is empty");
  }
  SECTION("material ids without materials")
  {
    vtkNew<vtkIntArray> ids;
    ids->SetName(names::MaterialIds);
    ids->SetNumberOfValues(2);
    ids->FillValue(3);
    scene->GetCellData()->AddArray(ids);
    expect("has 1 materials");
  }
  SECTION("fewer normals than triangles")
  {
    vtkNew<vtkFloatArray> normals;
    normals->SetName(names::Normals);
    normals->SetNumberOfComponents(3);
    normals->InsertNextTuple3(0, 0, 1);
    scene->GetCellData()->AddArray(normals);
    expect(
      "cell array Normals of the scene has 1 tuples of 3 for 2 triangles; it needs one of 3 each");
  }
  SECTION("a trajectory without points")
  {
    vtkNew<vtkPolyData> empty;
    bench.Scanner->SetInputData(1, empty);
    expect("the trajectory has no points");
  }
  SECTION("a trajectory that goes back in time")
  {
    vtkNew<vtkPolyData> path;
    path->DeepCopy(MakeWaypoints({ { 0, 0, 0 }, { 1, 0, 0 } }));
    vtkNew<vtkDoubleArray> times;
    times->SetName(names::GpsTime);
    times->InsertNextValue(5);
    times->InsertNextValue(4);
    path->GetPointData()->AddArray(times);
    bench.Scanner->SetInputData(1, path);
    expect("go back at sample 1");
  }
}
