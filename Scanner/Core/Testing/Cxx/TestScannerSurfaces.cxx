// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Surface data of the scene: materials and normals.
#include "heliosMaterialTable.h"
#include "heliosRadiometry.h"
#include "heliosScannerBench.h"

#include <vtkCellData.h>
#include <vtkFloatArray.h>
#include <vtkIntArray.h>

#include <catch2/catch.hpp>

#include <cmath>

namespace names = vtkHeliosArrayNames;
using namespace helios::testing;

TEST_CASE("Scanner: materials give reflectance and class", "[Scanner]")
{
  const auto scene = MakeScene({ Wall(100) });
  helios::MaterialTable materials(1);
  materials[0].Reflectance = 0.25;
  materials[0].Classification = 6;
  helios::SetMaterials(scene, materials);
  Bench bench(scene);
  vtkPolyData* echoes = bench.Run();
  CHECK(Value(echoes, names::ClassificationIds, 0) == 6);
  const helios::LidarEquation equation{ 0.15, 0.99, helios::AtmosphericExtinction(23, 1064) };
  CHECK(Value(echoes, names::Amplitude, 0) == Approx(4 * equation(100, 0.25, 1)).epsilon(1e-6));
}

TEST_CASE("Scanner: incidence uses the normals of the scene if present", "[Scanner]")
{
  const auto scene = MakeScene({ Wall(100) });
  Bench plain(scene);
  const double perpendicular = Value(plain.Run(), names::Amplitude, 0);

  const auto tilted = MakeScene({ Wall(100) });
  vtkNew<vtkFloatArray> normals;
  normals->SetName(names::Normals);
  normals->SetNumberOfComponents(3);
  const double angle = std::acos(0.5); // 60 degrees
  normals->InsertNextTuple3(std::sin(angle), std::cos(angle), 0);
  normals->InsertNextTuple3(2 * std::sin(angle), 2 * std::cos(angle), 0); // any length is valid
  tilted->GetCellData()->AddArray(normals);
  Bench bench(tilted);
  vtkPolyData* echoes = bench.Run();
  REQUIRE(echoes->GetNumberOfPoints() == 1000);
  CHECK(Value(echoes, names::IncidenceAngle, 0) == Approx(60).margin(0.02));
  CHECK(Value(echoes, names::Amplitude, 0) == Approx(0.5 * perpendicular).epsilon(1e-4));
  CHECK(Value(echoes, names::Range, 0) ==
    Approx(Value(plain.Run(), names::Range, 0)).epsilon(0).margin(5e-7)); // error of float samples

  normals->SetTuple3(0, 0, 0, 0); // no normal: the triangle's counts
  normals->SetTuple3(1, 0, 0, 0);
  normals->Modified();
  tilted->Modified();
  CHECK(Value(bench.Run(), names::Amplitude, 0) == Approx(perpendicular).epsilon(1e-12));
}

TEST_CASE("Scanner: a beam on a wall of two materials returns the energy of both", "[Scanner]")
{
  const double tolerance = GENERATE(0.01, 0.0003);
  const auto scene = MakeScene({ { { -50, 100, -50 }, { 50, 0, 0 }, { 0, 0, 100 } },
    { { 0, 100, -50 }, { 50, 0, 0 }, { 0, 0, 100 } } });
  helios::MaterialTable materials(2);
  materials[0].Reflectance = 0.2;
  materials[1].Reflectance = 0.8;
  helios::SetMaterials(scene, materials);
  vtkNew<vtkIntArray> ids;
  ids->SetName(names::MaterialIds);
  for (const int id : { 0, 0, 1, 1 })
  {
    ids->InsertNextValue(id);
  }
  scene->GetCellData()->AddArray(ids);
  Bench bench(scene);
  bench.Scanner->GetBeamSampler()->SetBeamDivergence(1e-3);
  bench.Scanner->SetSamplingToTolerance();
  bench.Scanner->SetRangeTolerance(tolerance);
  bench.Scanner->SetEnergyTolerance(10 * tolerance);
  vtkPolyData* echoes = bench.Run();
  const helios::LidarEquation equation{ 0.15, 0.99, helios::AtmosphericExtinction(23, 1064) };
  REQUIRE(echoes->GetNumberOfPoints() > 0);
  CHECK(Value(echoes, names::Amplitude, 0) == Approx(4 * equation(100, 0.5, 1)).epsilon(1e-3));
}
