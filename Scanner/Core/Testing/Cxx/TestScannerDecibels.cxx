// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Amplitudes and reflectances in decibels.
#include "heliosRadiometry.h"
#include "heliosScannerBench.h"
#include "vtkHeliosEchoDetector.h"

#include <vtkFieldData.h>
#include <vtkStringArray.h>

#include <catch2/catch.hpp>

#include <cmath>

namespace names = vtkHeliosArrayNames;
using helios::Vec3;
using namespace helios::testing;

namespace
{

/// A plane on the y axis at a range, inclined by an angle [deg], of a reflectance.
vtkSmartPointer<vtkPolyData> MakePlane(double range, double degrees, double reflectance)
{
  const double angle = degrees * 0.017453292519943295;
  const Vec3 slope(0, range * std::sin(angle), range * std::cos(angle));
  const auto scene =
    MakeScene({ { Vec3(-0.5 * range, range, 0) - 0.5 * slope, { range, 0, 0 }, slope } });
  vtkNew<vtkDoubleArray> column;
  column->SetName(names::MaterialReflectance);
  column->InsertNextValue(reflectance);
  scene->GetFieldData()->AddArray(column);
  vtkNew<vtkStringArray> name;
  name->SetName(names::MaterialName);
  name->InsertNextValue("surface");
  scene->GetFieldData()->AddArray(name);
  return scene;
}

} // namespace

TEST_CASE("Decibels: a Lambertian plane, at any range and visibility", "[ScannerDecibels]")
{
  for (const double range : { 5.0, 80.0, 1500.0 })
  {
    for (const double degrees : { 0.0, 60.0 })
    {
      for (const double reflectance : { 1.0, 0.2 })
      {
        CAPTURE(range, degrees, reflectance);
        Bench bench(MakePlane(range, degrees, reflectance));
        bench.Scanner->GetBeamSampler()->SetBeamDivergence(0.0);
        bench.Scanner->SetDuration(1e-4);
        bench.Scanner->SetAtmosphericVisibility(2.0);
        bench.Scanner->GetEchoDetector()->SetDetectionThreshold(1e-15);
        CHECK_FALSE(bench.Run()->GetPointData()->HasArray(names::Reflectance));
        bench.Scanner->GenerateDecibelsOn();
        vtkPolyData* echoes = bench.Run();
        REQUIRE(echoes->GetNumberOfPoints() == 10);
        const double cosine = degrees > 0.0 ? 0.5 : 1.0;
        CHECK(Value(echoes, names::Reflectance, 9) ==
          Approx(10.0 * std::log10(reflectance * cosine)).margin(1e-5)); // samples are floats
        CHECK(Value(echoes, names::RelativeAmplitude, 9) ==
          Approx(10.0 * std::log10(Value(echoes, names::Amplitude, 9) / 1e-15)).epsilon(1e-13));
      }
    }
  }
}

TEST_CASE("Decibels: a strip that covers half of the beam is 3 dB darker", "[ScannerDecibels]")
{
  Bench bench(MakeScene({ { Vec3(0, 100, -50), { 50, 0, 0 }, { 0, 0, 100 } } })); // x > 0
  bench.Scanner->SetSamplingToTolerance();
  bench.Scanner->SetDuration(1e-4);
  bench.Scanner->GenerateDecibelsOn();
  vtkPolyData* echoes = bench.Run();
  REQUIRE(echoes->GetNumberOfPoints() == 10);
  const double half = 10.0 * std::log10(0.5);
  CHECK(Value(echoes, names::Reflectance, 0) == Approx(2.0 * half).margin(0.01)); // rho 0.5
}

TEST_CASE("Decibels: pieces have the values of the whole", "[ScannerDecibels]")
{
  Bench bench(MakePlane(80.0, 30.0, 0.3));
  bench.Scanner->GenerateDecibelsOn();
  vtkPolyData* whole = bench.Run();
  const double last = Value(whole, names::Reflectance, 999);
  bench.Scanner->UpdatePiece(3, 4, 0);
  vtkPolyData* piece = bench.Scanner->GetOutput();
  REQUIRE(piece->GetNumberOfPoints() == 250);
  CHECK(Value(piece, names::Reflectance, 249) == last);
}

TEST_CASE("Decibels: without a threshold or power they are an error", "[ScannerDecibels]")
{
  for (const bool hasPower : { true, false })
  {
    Bench bench(MakeScene({ Wall(10) }));
    bench.Scanner->GenerateDecibelsOn();
    bench.Scanner->SetAveragePower(hasPower ? 4.0 : 0.0);
    bench.Scanner->GetEchoDetector()->SetDetectionThreshold(hasPower ? 0.0 : 1e-12);
    bench.Scanner->Update();
    CHECK(bench.Log->HasError(hasPower
        ? "GenerateDecibels is on, with a DetectionThreshold of 0 W and an AveragePower of 4 W; "
          "decibels need both positive"
        : "GenerateDecibels is on, with a DetectionThreshold of 1e-12 W and an AveragePower of 0 "
          "W"));
  }
}
