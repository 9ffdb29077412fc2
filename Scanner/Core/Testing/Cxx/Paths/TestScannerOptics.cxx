// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Echoes by mirrors, panes and water against closed forms.
#include "heliosFresnel.h"
#include "heliosOpticsBench.h"

#include <vtkMath.h>

#include <catch2/catch.hpp>

#include <cmath>
#include <memory>
#include <vector>

using namespace helios::testing;
using helios::Material;
using helios::OpticsKind;
using helios::Vec3;
namespace names = vtkHeliosArrayNames;

TEST_CASE("ScannerOptics: a mirror shows what is before it as a ghost behind it")
{
  // A mirror at 45 degrees, 10 m away, and a wall 5 m beside it.
  const double angle = GENERATE(45.0, 30.0, 60.0);
  const double a = vtkMath::RadiansFromDegrees(angle); // from the mirror's normal
  const Vec3 normal(std::sin(a), -std::cos(a), 0.0);
  const Vec3 reflected(std::sin(2.0 * a), -std::cos(2.0 * a), 0.0);
  Material mirror = MakeMaterial(OpticsKind::Mirror);
  mirror.Optics.MirrorReflectance = 0.9;
  const Vec3 end = Vec3(0.0, 10.0, 0.0) + 5.0 * reflected;
  RayBench bench(MakeOpticalScene(
    { Across({ 0, 10, 0 }, normal, 1.0) }, mirror, { Across(end, reflected, 1.0) }));
  vtkPolyData* cloud = bench.Run();
  REQUIRE(cloud->GetNumberOfPoints() == 1);
  CHECK(Value(cloud, names::Range, 0) == Approx(15.0).margin(15.0 * Rounding));
  CHECK(cloud->GetPoint(0)[1] == Approx(15.0).margin(15.0 * Rounding));
  CHECK(Value(cloud, names::Amplitude, 0) == Approx(0.81 * bench.GetAmplitude(15.0)).epsilon(1e-9));
  CHECK((GetTruth(cloud, 0) - end).Norm() < 20.0 * Rounding);
  CHECK(Value(cloud, names::MaterialIds, 0) == 0);
  CHECK(Value(cloud, names::SpecularEvents, 0) == 1);
}

TEST_CASE("ScannerOptics: paths end at the limits of the scanner")
{
  // A zigzag of five mirrors, and a wall at its end.
  const double a = vtkMath::RadiansFromDegrees(45.0);
  Material mirror = MakeMaterial(OpticsKind::Mirror);
  mirror.Optics.MirrorReflectance = 0.9;
  const Vec3 at(0.0, 10.0, 0.0);
  const Vec3 turn(std::sin(a / 2), -std::cos(a / 2), 0.0);
  Vec3 direction = helios::GetMirrored({ 0, 1, 0 }, turn);
  std::vector<Rectangle> mirrors = { Across(at, turn, 0.5) };
  Vec3 place = at;
  for (int i = 0; i < 4; ++i)
  {
    place = place + 3.0 * direction;
    const Vec3 normal = i % 2 == 0 ? -1.0 * turn : turn;
    mirrors.push_back(Across(place, normal, 0.5));
    direction = helios::GetMirrored(direction, normal);
  }
  const auto scene =
    MakeOpticalScene(mirrors, mirror, { Across(place + 3.0 * direction, direction, 1.0) });
  const auto count = [&scene](int events, double share)
  {
    RayBench bench(scene);
    bench.Scanner->SetMaximumSpecularEvents(events);
    bench.Scanner->SetLeastSpecularShare(share);
    return bench.Run()->GetNumberOfPoints();
  };
  CHECK(count(5, 1e-4) == 1);
  CHECK(count(4, 1e-4) == 0);
  CHECK(count(5, 0.99 * std::pow(0.9, 10)) == 1);
  CHECK(count(5, 1.01 * std::pow(0.9, 10)) == 0);
}

TEST_CASE("ScannerOptics: scenes without optics have no column of events")
{
  RayBench bench(MakeScene({ Wall(10.0) }));
  CHECK_FALSE(bench.Run()->GetPointData()->HasArray(names::SpecularEvents));
}

TEST_CASE("ScannerOptics: a mirror across the beam sends it back to the receiver")
{
  RayBench bench(MakeOpticalScene({ Wall(20.0, 1.0) }, MakeMaterial(OpticsKind::Mirror), {}));
  vtkPolyData* cloud = bench.Run();
  REQUIRE(cloud->GetNumberOfPoints() == 1);
  CHECK(Value(cloud, names::Range, 0) == Approx(20.0).margin(20.0 * Rounding));
  // all of the light, whatever the distance
  const double expected = bench.Scanner->GetAveragePower() * bench.Scanner->GetOpticalEfficiency() *
    std::exp(-2.0 * 20.0 *
      helios::AtmosphericExtinction(
        bench.Scanner->GetAtmosphericVisibility(), bench.Scanner->GetWavelength()));
  CHECK(Value(cloud, names::Amplitude, 0) == Approx(expected).epsilon(1e-9));
}

TEST_CASE("ScannerOptics: two mirrors at 90 degrees send the beam back")
{
  const double c = std::sqrt(0.5);
  // The edge is 30 m away; the beam meets both beside it, and comes back 2 * 0.01 m aside.
  const Vec3 edge(0.01, 30.0, 0.0);
  RayBench bench(MakeOpticalScene({ { edge - Vec3(0, 0, 1), { -c, -c, 0 }, { 0, 0, 2 } },
                                    { edge - Vec3(0, 0, 1), { c, -c, 0 }, { 0, 0, 2 } } },
    MakeMaterial(OpticsKind::Mirror), {}));
  vtkPolyData* cloud = bench.Run();
  REQUIRE(cloud->GetNumberOfPoints() == 1);
  CHECK(Value(cloud, names::Range, 0) == Approx(30.0).margin(30.0 * Rounding));
}

TEST_CASE("ScannerOptics: a wall behind a pane is shifted, later and fainter")
{
  const double degrees = GENERATE(0.0, 20.0, 50.0, 75.0);
  const double a = vtkMath::RadiansFromDegrees(degrees);
  Material glass = MakeMaterial(OpticsKind::Pane);
  glass.Optics.Thickness = 0.01;
  RayBench bench(
    MakeOpticalScene({ Across({ 0, 10, 0 }, { std::sin(a), -std::cos(a), 0.0 }, 20.0) }, glass,
      { Wall(30.0, 10.0) }));
  vtkPolyData* cloud = bench.Run();
  const vtkIdType last = degrees == 0.0 ? 1 : 0; // after the glint of the pane
  REQUIRE(cloud->GetNumberOfPoints() == last + 1);
  const double n = glass.Optics.RefractiveIndex;
  const double within = std::asin(std::sin(a) / n);
  const double length = 0.01 / std::cos(within);
  const double advance = length * std::cos(a - within); // along the beam
  const double range = 30.0 - advance + n * length;
  CHECK(Value(cloud, names::Range, last) == Approx(range).margin(60.0 * Rounding / std::cos(a)));
  const double shift = length * std::sin(a - within);
  CHECK(std::abs(GetTruth(cloud, last)[0]) == Approx(shift).margin(60.0 * Rounding / std::cos(a)));
  const double through = helios::GetPaneShares(std::cos(a), n, 1.0).Transmitted;
  CHECK(Value(cloud, names::Amplitude, last) ==
    Approx(through * through * bench.GetAmplitude(30.0)).epsilon(2e-3)); // 4 mm of 30 m
}

TEST_CASE("ScannerOptics: the floor of a pool is displaced as Snell's law says")
{
  const double degrees = GENERATE(0.0, 10.0, 45.0, 80.0);
  const double a = vtkMath::RadiansFromDegrees(degrees);
  // The surface of the water is at 10 m along the beam, the floor 2 m below it.
  const double n = 1.33;
  Material water = MakeMaterial(OpticsKind::Volume);
  water.Optics.RefractiveIndex = n;
  const Vec3 normal(std::sin(a), -std::cos(a), 0.0);
  const Vec3 surface(0.0, 10.0, 0.0);
  RayBench bench(MakeOpticalScene(
    { Across(surface, normal, 50.0) }, water, { Across(surface - 2.0 * normal, normal, 50.0) }));
  vtkPolyData* cloud = bench.Run();
  const vtkIdType last = degrees == 0.0 ? 1 : 0; // after the glint of the water
  REQUIRE(cloud->GetNumberOfPoints() == last + 1);
  const double within = std::asin(std::sin(a) / n);
  const double length = 2.0 / std::cos(within);
  const double margin = 40.0 * Rounding / std::cos(a);
  CHECK(Value(cloud, names::Range, last) == Approx(10.0 + n * length).margin(margin));
  // aside of the beam by l sin(a - b)
  CHECK(std::abs(GetTruth(cloud, last)[0]) == Approx(length * std::sin(a - within)).margin(margin));
  if (degrees == 0.0)
  {
    const double face = 1.0 - std::pow((n - 1.0) / (n + 1.0), 2);
    const double extinct = bench.GetAmplitude(10.0) * 100.0; // extinction of 10 m of air only
    CHECK(Value(cloud, names::Amplitude, last) ==
      Approx(face * face * extinct / std::pow(n * 10.0 + 2.0, 2)).epsilon(1e-9));
  }
}

TEST_CASE("ScannerOptics: a closed body of glass is a pane without its inner reflections")
{
  Material glass = MakeMaterial(OpticsKind::Volume);
  glass.Optics.Attenuation = 5.0;
  RayBench bench(
    MakeOpticalScene({ Wall(10.0, 1.0), Wall(10.02, 1.0) }, glass, { Wall(30.0, 10.0) }));
  vtkPolyData* cloud = bench.Run();
  REQUIRE(cloud->GetNumberOfPoints() >= 1);
  const vtkIdType last = cloud->GetNumberOfPoints() - 1;
  CHECK(Value(cloud, names::Range, last) == Approx(30.0 + 0.5 * 0.02).margin(60.0 * Rounding));
  const double face = 0.96;
  CHECK(Value(cloud, names::Amplitude, last) ==
    Approx(std::pow(face * face * std::exp(-5.0 * 0.02), 2) * bench.GetAmplitude(30.0))
      .epsilon(2e-3));
}

TEST_CASE("ScannerOptics: a dusty pane has an echo of its own")
{
  Material glass = MakeMaterial(OpticsKind::Pane);
  glass.Reflectance = 0.1;
  RayBench bench(MakeOpticalScene({ Wall(10.0, 1.0) }, glass, { Wall(30.0, 10.0) }));
  vtkPolyData* cloud = bench.Run();
  REQUIRE(cloud->GetNumberOfPoints() == 2);
  CHECK(Value(cloud, names::Range, 0) == Approx(10.0).margin(1e-9));
  CHECK(Value(cloud, names::Range, 1) == Approx(30.002).margin(1e-6));
  CHECK(Value(cloud, names::MaterialIds, 1) == 0);
}

TEST_CASE("ScannerOptics: adaptive and fixed beams agree half on a pane, half beside it")
{
  Material glass = MakeMaterial(OpticsKind::Mirror);
  glass.Optics.MirrorReflectance = 0.5;
  const double c = std::sqrt(0.5);
  const auto scene = MakeOpticalScene({ { { 0.0, 10.0, -1.0 }, { c, c, 0.0 }, { 0, 0, 2 } } },
    glass, { Wall(30.0, 10.0), Across({ 8.0, 10.0, 0.0 }, { 1, 0, 0 }, 5.0) });
  const auto run = [&scene](bool isAdaptive)
  {
    auto bench = std::make_unique<Bench>(scene);
    bench->Scanner->SetDuration(1e-5);
    bench->Scanner->SetRangeAccuracy(0.0);
    bench->Scanner->GetBeamSampler()->SetBeamDivergence(1e-3);
    bench->Scanner->GetBeamSampler()->SetPatternToVogel();
    bench->Scanner->GetBeamSampler()->SetNumberOfSubRays(20000);
    if (isAdaptive)
    {
      bench->Scanner->SetSamplingToTolerance();
    }
    bench->Run();
    return bench;
  };
  const auto fixed = run(false);
  const auto adaptive = run(true);
  vtkPolyData* a = fixed->Scanner->GetOutput();
  vtkPolyData* b = adaptive->Scanner->GetOutput();
  REQUIRE(a->GetNumberOfPoints() == 2);
  REQUIRE(b->GetNumberOfPoints() == 2);
  for (vtkIdType i = 0; i < 2; ++i)
  {
    CHECK(Value(b, names::Range, i) == Approx(Value(a, names::Range, i)).margin(1e-3));
    CHECK(Value(b, names::Amplitude, i) == Approx(Value(a, names::Amplitude, i)).epsilon(0.02));
  }
}

TEST_CASE("ScannerOptics: an adaptive beam that a pane fills meets the wall behind it")
{
  Bench bench(
    MakeOpticalScene({ Wall(10.0, 5.0) }, MakeMaterial(OpticsKind::Pane), { Wall(30.0, 10.0) }));
  bench.Scanner->SetDuration(1e-5);
  bench.Scanner->SetRangeAccuracy(0.0);
  bench.Scanner->SetSamplingToTolerance();
  vtkPolyData* cloud = bench.Run();
  REQUIRE(cloud->GetNumberOfPoints() == 2); // the pane sends light to the receiver, too
  CHECK(Value(cloud, names::Range, 0) == Approx(10.0).margin(1e-3));
  CHECK(Value(cloud, names::Range, 1) == Approx(30.002).margin(1e-3));
}

TEST_CASE("ScannerOptics: beams behind a flat mirror or pane need no sub-rays")
{
  const auto kind = GENERATE(OpticsKind::Mirror, OpticsKind::Pane);
  const double degrees = GENERATE(20.0, 45.0, 70.0, 85.0);
  const double a = vtkMath::RadiansFromDegrees(degrees);
  const Vec3 normal(std::sin(a), -std::cos(a), 0.0);
  const Vec3 reflected(std::sin(2.0 * a), -std::cos(2.0 * a), 0.0);
  const Vec3 aside = Vec3(0.0, 0.0, 1.0).Cross(reflected);
  const Vec3 point(0.0, 10.0, 0.0);
  Material material = MakeMaterial(kind);
  material.Optics.MirrorReflectance = 0.8;
  material.Optics.Thickness = 0.02;
  // Half a wall 0.5 m before another, behind the pane and beside it; and one behind the plane,
  // which a mirror hides, and which is in no reflected beam.
  const Vec3 up(0.0, 0.0, 4.0);
  std::vector<Rectangle> walls = { { { 0.001, 30.0, -2.0 }, { 4.0, 0.0, 0.0 }, up },
    Wall(30.5, 4.0), { point + 12.0 * reflected - Vec3(0.0, 0.0, 2.0), 4.0 * aside, up },
    Across(point + 12.5 * reflected, reflected, 4.0) };
  if (kind == OpticsKind::Mirror)
  {
    walls.push_back(Across(point - 0.05 * normal, normal, 3.0));
  }
  const auto scene = MakeOpticalScene({ Across(point, normal, 3.0) }, material, walls);
  const auto run = [&scene](bool isAdaptive)
  {
    auto bench = std::make_unique<Bench>(scene);
    bench->Scanner->SetDuration(1e-5);
    bench->Scanner->SetRangeAccuracy(0.0);
    bench->Scanner->SetGenerateTruth(true);
    bench->Scanner->SetBinSize(0.01);
    bench->Scanner->GetBeamSampler()->SetBeamDivergence(1e-3);
    bench->Scanner->GetBeamSampler()->SetPatternToVogel();
    bench->Scanner->GetBeamSampler()->SetNumberOfSubRays(20000);
    bench->Scanner->SetSampling(isAdaptive ? vtkHeliosScanner::TOLERANCE : vtkHeliosScanner::FIXED);
    bench->Run();
    return bench;
  };
  const auto fixed = run(false);
  const auto adaptive = run(true);
  CHECK(adaptive->Scanner->GetCount("pulsesSampled") == 0);
  vtkPolyData* a0 = fixed->Scanner->GetOutput();
  vtkPolyData* b0 = adaptive->Scanner->GetOutput();
  REQUIRE(a0->GetNumberOfPoints() >= 1);
  REQUIRE(b0->GetNumberOfPoints() == a0->GetNumberOfPoints());
  for (vtkIdType i = 0; i < a0->GetNumberOfPoints(); ++i)
  {
    CHECK(Value(b0, names::Range, i) == Approx(Value(a0, names::Range, i)).margin(1e-3));
    CHECK(Value(b0, names::Amplitude, i) == Approx(Value(a0, names::Amplitude, i)).epsilon(0.01));
    CHECK(Value(b0, names::SpecularEvents, i) == 1);
    CHECK((GetTruth(b0, i) - GetTruth(a0, i)).Norm() < 0.05);
  }
}

TEST_CASE("ScannerOptics: a pane reflects what Fresnel's equations say, to rays and to beams")
{
  const bool isBeam = GENERATE(false, true);
  const double a = vtkMath::RadiansFromDegrees(60.0);
  const Vec3 normal(std::sin(a), -std::cos(a), 0.0);
  const Vec3 reflected(std::sin(2.0 * a), -std::cos(2.0 * a), 0.0);
  const Vec3 end = Vec3(0.0, 10.0, 0.0) + 5.0 * reflected;
  RayBench bench(MakeOpticalScene({ Across({ 0, 10, 0 }, normal, 1.0) },
    MakeMaterial(OpticsKind::Pane), { Across(end, reflected, 1.0) }));
  if (isBeam)
  {
    bench.Scanner->GetBeamSampler()->SetBeamDivergence(3e-4);
    bench.Scanner->SetSamplingToTolerance();
  }
  vtkPolyData* cloud = bench.Run();
  REQUIRE(cloud->GetNumberOfPoints() == 1);
  CHECK(bench.Scanner->GetCount("pulsesSampled") == 0);
  const double share = helios::GetPaneShares(std::cos(a), 1.5, 1.0).Reflected;
  CHECK(Value(cloud, names::Range, 0) == Approx(15.0).margin(1e-4));
  CHECK(Value(cloud, names::Amplitude, 0) ==
    Approx(share * share * bench.GetAmplitude(15.0)).epsilon(1e-3));
}

TEST_CASE("ScannerOptics: a beam through two panes is sampled")
{
  const double a = vtkMath::RadiansFromDegrees(30.0);
  const Vec3 normal(std::sin(a), -std::cos(a), 0.0);
  RayBench bench(
    MakeOpticalScene({ Across({ 0, 10, 0 }, normal, 1.0), Across({ 0, 12, 0 }, normal, 1.0) },
      MakeMaterial(OpticsKind::Pane), { Wall(30.0, 2.0) }));
  bench.Scanner->GetBeamSampler()->SetBeamDivergence(3e-4);
  bench.Scanner->SetSamplingToTolerance();
  vtkPolyData* cloud = bench.Run();
  CHECK(bench.Scanner->GetCount("pulsesSampled") == 1);
  REQUIRE(cloud->GetNumberOfPoints() >= 1);
  const double through = helios::GetPaneShares(std::cos(a), 1.5, 1.0).Transmitted;
  CHECK(Value(cloud, names::Amplitude, 0) ==
    Approx(std::pow(through, 4) * bench.GetAmplitude(30.0)).epsilon(2e-3));
}

TEST_CASE("ScannerOptics: invalid materials are errors")
{
  Material material = MakeMaterial(OpticsKind::Pane);
  std::string fault;
  SECTION("index")
  {
    material.Optics.RefractiveIndex = 0.5;
    fault = "has refractive index 0.500000; give it within [1, 4]";
  }
  SECTION("dispersion")
  {
    material.Optics.Dispersion = static_cast<helios::DispersionKind>(7);
    fault = "has dispersion 7; give 0 none, 1 water, 2 soda-lime glass, 3 BK7 or 4 fused silica";
  }
  SECTION("mirror")
  {
    material.Optics.MirrorReflectance = 1.5;
    fault = "has mirror reflectance 1.500000; give it within [0, 1]";
  }
  SECTION("thickness")
  {
    material.Optics.Thickness = -1.0;
    fault = "has thickness -1.000000 m and attenuation 0.000000 1/m; give the first within [0, 10]";
  }
  SECTION("leaf")
  {
    material.Optics.Kind = OpticsKind::Leaf;
    material.Optics.Transmittance = 0.6;
    fault =
      "is a leaf with reflectance 0.500000 and transmittance 0.600000; together they are at most 1";
  }
  SECTION("retroreflector")
  {
    material.Optics.Retroreflection = -2.0;
    fault = "has transmittance 0.000000 and retroreflection -2.000000 1/sr; give the first within "
            "[0, 1] and the second within [0, 1e9]";
  }
  SECTION("kind")
  {
    material.Optics.Kind = static_cast<OpticsKind>(9);
    fault = "has optics 9; give 0 opaque, 1 mirror, 2 pane, 3 volume, 4 water, 5 leaf or 6 "
            "retroreflector";
  }
  RayBench bench(MakeOpticalScene({ Wall(10.0) }, material, {}));
  bench.Run();
  CHECK(bench.Log->HasError("material 1 of the scene, default, " + fault));
}

TEST_CASE("ScannerOptics: leaves let a share of the light through, both ways")
{
  Material leaf = MakeMaterial(OpticsKind::Leaf);
  leaf.Reflectance = 0.4;
  leaf.Optics.Transmittance = 0.45;
  RayBench bench(
    MakeOpticalScene({ Wall(10.0, 1.0), Wall(15.0, 1.0) }, leaf, { Wall(30.0, 10.0) }));
  vtkPolyData* cloud = bench.Run();
  REQUIRE(cloud->GetNumberOfPoints() == 3);
  const double through = 0.45 * 0.45;
  CHECK(Value(cloud, names::Amplitude, 0) == Approx(0.8 * bench.GetAmplitude(10.0)).epsilon(1e-9));
  CHECK(Value(cloud, names::Amplitude, 1) ==
    Approx(0.8 * through * bench.GetAmplitude(15.0)).epsilon(1e-9));
  CHECK(Value(cloud, names::Amplitude, 2) ==
    Approx(through * through * bench.GetAmplitude(30.0)).epsilon(1e-9));
  CHECK(Value(cloud, names::Range, 2) == Approx(30.0).margin(1e-12));
  CHECK(Value(cloud, names::MaterialIds, 2) == 0);
}

TEST_CASE("ScannerOptics: retroreflectors return as their coefficient says, at any angle")
{
  const double degrees = GENERATE(0.0, 30.0);
  const double a = vtkMath::RadiansFromDegrees(degrees);
  RayBench bench(MakeOpticalScene({ Across({ 0, 40, 0 }, { std::sin(a), -std::cos(a), 0.0 }, 1.0) },
    MakeMaterial(OpticsKind::Retroreflector), { Wall(60.0) }));
  vtkPolyData* cloud = bench.Run();
  REQUIRE(cloud->GetNumberOfPoints() == 1);
  // P0 R_A / cos of the light goes back per solid angle; the receiver covers pi D^2 / 4 R^2
  const double factor = vtkMath::Pi() * 250.0 / std::cos(a);
  CHECK(Value(cloud, names::Amplitude, 0) ==
    Approx(factor / 0.5 * bench.GetAmplitude(40.0)).epsilon(1e-9));
  bench.Scanner->SetSaturationPower(1e-6);
  CHECK(Value(bench.Run(), names::Amplitude, 0) == Approx(1e-6).epsilon(0.01));
}
