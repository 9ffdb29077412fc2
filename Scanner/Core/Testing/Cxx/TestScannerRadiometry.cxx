// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Amplitudes of whole scans against the lidar equation.
#include "heliosRadiometry.h"
#include "heliosScannerBench.h"
#include "vtkHeliosEchoDetector.h"

#include <vtkFieldData.h>
#include <vtkStringArray.h>
#include <vtkTable.h>

#include <catch2/catch.hpp>

#include <cmath>

namespace names = vtkHeliosArrayNames;
using helios::Vec3;
using namespace helios::testing;

namespace
{

constexpr double Degree = 0.017453292519943295;

/// A plane at a range on the y axis with an incidence, as large as the range.
vtkSmartPointer<vtkPolyData> MakeTilted(double range, double degrees)
{
  const Vec3 slope(0, std::sin(degrees * Degree), std::cos(degrees * Degree));
  const double half = 0.5 * range;
  return MakeScene({ { Vec3(-half, range, 0) - half * slope, { range, 0, 0 }, range * slope } });
}

void SetMaterial(vtkPolyData* scene, double reflectance, double specularity, double exponent)
{
  const auto add = [scene](const char* name, double value)
  {
    vtkNew<vtkDoubleArray> column;
    column->SetName(name);
    column->InsertNextValue(value);
    scene->GetFieldData()->AddArray(column);
  };
  vtkNew<vtkStringArray> name;
  name->SetName(names::MaterialName);
  name->InsertNextValue("surface");
  scene->GetFieldData()->AddArray(name);
  add(names::MaterialReflectance, reflectance);
  add(names::MaterialSpecularity, specularity);
  add(names::MaterialSpecularExponent, exponent);
}

/// One pulse of 1 W, D = 0.15 m, eta = 0.9, in vacuum.
struct OnePulse : Bench
{
  explicit OnePulse(vtkPolyData* scene)
    : Bench(scene)
  {
    this->Scanner->SetDuration(1e-5);
    this->Scanner->SetAveragePower(1.0);
    this->Scanner->SetOpticalEfficiency(0.9);
    this->Scanner->SetAtmosphericExtinction(0.0);
    this->Scanner->GetEchoDetector()->SetDetectionThreshold(0.0);
  }

  double GetAmplitude()
  {
    vtkPolyData* echoes = this->Run();
    REQUIRE(echoes->GetNumberOfPoints() == 1);
    return Value(echoes, names::Amplitude, 0);
  }
};

} // namespace

TEST_CASE("Scanner: received power of a single ray to 1e-12", "[ScannerRadiometry]")
{
  struct Row
  {
    double Range;
    double At[4]; // 0, 45, 60, 80 degrees
  };
  const double angles[4] = { 0, 45, 60, 80 };
  for (const Row& row :
    { Row{ 10, { 2.527601030733e-05, 1.787283828965e-05, 1.263800515366e-05, 4.389133128558e-06 } },
      Row{
        100, { 2.494996110359e-07, 1.764228668669e-07, 1.247498055180e-07, 4.332515278500e-08 } },
      Row{
        1000, { 2.191206784973e-09, 1.549417176636e-09, 1.095603392486e-09, 3.804990651019e-10 } },
      Row{ 10000,
        { 5.981612499755e-12, 4.229638761007e-12, 2.990806249877e-12, 1.038696110092e-12 } } })
  {
    for (int i = 0; i < 4; ++i)
    {
      OnePulse bench(MakeTilted(row.Range, angles[i]));
      bench.Scanner->SetAtmosphericExtinction(-1);
      bench.Scanner->SetAtmosphericVisibility(23);
      bench.Scanner->GetBeamSampler()->SetBeamDivergence(0);
      CHECK(bench.GetAmplitude() == Approx(row.At[i]).epsilon(2e-12));
    }
  }
}

TEST_CASE("Scanner: extinction given directly", "[ScannerRadiometry]")
{
  OnePulse bench(MakeTilted(1000, 0));
  bench.Scanner->GetBeamSampler()->SetBeamDivergence(0);
  const double clear = bench.GetAmplitude();
  bench.Scanner->SetAtmosphericExtinction(7.213040822e-5);
  CHECK(bench.GetAmplitude() / clear == Approx(0.865661940).epsilon(1e-8));
}

TEST_CASE(
  "Scanner: a Phong surface has its lobe towards the scanner, and none at grazing incidence",
  "[ScannerRadiometry]")
{
  struct Row
  {
    double Angle, Lobe;
  };
  const double n = 10;
  for (const Row& row : { Row{ 0, 1 }, Row{ 10, 5.368564e-1 }, Row{ 20, 6.958885e-2 },
         Row{ 30, 9.765625e-4 }, Row{ 50, 0 }, Row{ 80, 0 } })
  {
    const auto scene = MakeTilted(100, row.Angle);
    SetMaterial(scene, 0.8, 0.25, n);
    OnePulse bench(scene);
    bench.Scanner->GetBeamSampler()->SetBeamDivergence(0);
    const helios::LidarEquation equation{ 0.15, 0.9, 0.0 };
    const double f = 0.8 * (0.75 + 0.25 * (n + 2) / 2 * row.Lobe);
    CHECK(
      bench.GetAmplitude() == Approx(equation(100, f, std::cos(row.Angle * Degree))).epsilon(1e-6));
  }
}

TEST_CASE("Radiometry: a lobe returns no more than it receives", "[ScannerRadiometry]")
{
  // At normal incidence the hemisphere receives rho: 2 pi int cos^n sin = 2 pi / (n + 2), by its
  // formula.
  for (const double n : { 0.0, 1.0, 10.0, 100.0 })
  {
    const double lobe = helios::GetBackscatter({ 1.0, 1.0, n }, 1.0) / std::acos(-1.0);
    double hemisphere = 0;
    const int steps = 20000;
    for (int i = 0; i < steps; ++i)
    {
      const double theta = (i + 0.5) * std::acos(-1.0) / 2 / steps;
      hemisphere += lobe * std::pow(std::cos(theta), n) * std::cos(theta) * std::sin(theta);
    }
    hemisphere *= 2 * std::acos(-1.0) * std::acos(-1.0) / 2 / steps;
    CHECK(hemisphere == Approx(1).epsilon(1e-6));
  }
}

TEST_CASE("Scanner: amplitudes of plane, wire and disc fall with range to the power 2, 3 and 4",
  "[ScannerRadiometry]")
{
  // A disc as a 48-gon of the same area, a wire across the beam, a wall; w = 0.5 mrad.
  const auto makeDisc = [](double y)
  {
    vtkNew<vtkPoints> points;
    points->SetDataTypeToDouble();
    vtkNew<vtkCellArray> polys;
    const int sides = 48;
    const double step = 2 * std::acos(-1.0) / sides;
    const double radius = 0.01 * std::sqrt(step / std::sin(step));
    points->InsertNextPoint(0, y, 0);
    for (int i = 0; i < sides; ++i)
    {
      points->InsertNextPoint(radius * std::cos(i * step), y, radius * std::sin(i * step));
      polys->InsertNextCell({ 0, 1 + i, 1 + (i + 1) % sides });
    }
    auto scene = vtkSmartPointer<vtkPolyData>::New();
    scene->SetPoints(points);
    scene->SetPolys(polys);
    return scene;
  };
  const auto makeWire = [](double y) {
    return MakeScene({ { { -50, y, -0.0025 }, { 100, 0, 0 }, { 0, 0, 0.005 } } });
  };
  const auto makeWall = [](double y) { return MakeScene({ Wall(y) }); };

  // Circles about the axis are aligned with the cells of adaptive sampling: the disc takes the
  // spiral.
  const auto exponent = [](const auto& make, double range, bool isFixed)
  {
    double amplitudes[2];
    for (const int i : { 0, 1 })
    {
      OnePulse bench(make((i + 1) * range));
      vtkHeliosBeamSampler* sampler = bench.Scanner->GetBeamSampler();
      sampler->SetBeamDivergence(1e-3);
      sampler->SetTruncation(3);
      sampler->SetPatternToVogel();
      sampler->SetNumberOfSubRays(10000);
      bench.Scanner->SetSampling(isFixed ? 0 : 1);
      bench.Scanner->SetEnergyTolerance(1e-4);
      bench.Scanner->SetRangeTolerance(1e-4);
      amplitudes[i] = bench.GetAmplitude();
    }
    return std::log2(amplitudes[1] / amplitudes[0]);
  };
  CHECK(exponent(makeWall, 500, false) == Approx(-2).margin(1e-4));
  CHECK(exponent(makeWire, 20, false) ==
    Approx(std::log2(
             std::erf(std::sqrt(2.0) * 0.0025 / 0.02) / std::erf(std::sqrt(2.0) * 0.0025 / 0.01)) -
      2)
      .margin(0.02));
  CHECK(exponent(makeDisc, 20, true) ==
    Approx(std::log2(std::expm1(-2 * std::pow(0.01 / 0.02, 2)) /
             std::expm1(-2 * std::pow(0.01 / 0.01, 2))) -
      2)
      .margin(0.02));
}

TEST_CASE("Scanner: a thin wire and a small disc in the far field", "[ScannerRadiometry]")
{
  // f = erf(sqrt2 d / (2 w R)) and 1 - exp(-2 a^2 / (w R)^2) decrease as R^-1 and R^-2.
  const double w = 0.5e-3;
  const auto wire = [w](double r) { return std::erf(std::sqrt(2.0) * 0.0025 / (w * r)); };
  const auto disc = [w](double r) { return -std::expm1(-2 * std::pow(0.01 / (w * r), 2)); };
  CHECK(wire(10) == Approx(0.6826894921371).epsilon(1e-12));
  CHECK(disc(1000) == Approx(7.996800853163e-4).epsilon(1e-12));
  // The scanner at 200 m, where the wire is 1/40 of the footprint, with 40,000 sub-rays.
  for (const double range : { 100.0, 200.0 })
  {
    OnePulse bench(MakeScene({ { { -50, range, -0.0025 }, { 100, 0, 0 }, { 0, 0, 0.005 } } }));
    vtkHeliosBeamSampler* sampler = bench.Scanner->GetBeamSampler();
    sampler->SetBeamDivergence(2 * w);
    sampler->SetTruncation(3);
    sampler->SetPatternToVogel();
    sampler->SetNumberOfSubRays(40000);
    const double full = 0.25 * std::pow(0.15 / range, 2) * 0.9 * 0.5;
    CHECK(bench.GetAmplitude() / full == Approx(wire(range)).epsilon(0.02));
  }
}

TEST_CASE("Scanner: sunlight adds an offset to the waveform", "[ScannerRadiometry]")
{
  OnePulse bench(MakeTilted(100, 0));
  bench.Scanner->GenerateWaveformsOn();
  bench.Scanner->SetSolarIrradiance(0.6);
  bench.Scanner->SetFilterBandwidth(2);
  bench.Scanner->SetFieldOfView(1e-3);
  bench.Run();
  auto* table = vtkTable::SafeDownCast(bench.Scanner->GetOutputDataObject(1));
  const double first = table->GetFieldData()->GetArray(names::Samples)->GetComponent(0, 0);
  const double pi = std::acos(-1.0);
  const double sun = 0.6 * 2 * 0.5 / pi * (pi / 4 * 1e-6) * (pi / 4 * 0.15 * 0.15) * 0.9;
  const helios::LidarEquation equation{ 0.15, 0.9, 0.0 };
  CHECK(first == Approx(sun + equation(100, 0.5, 1) * std::exp(-12.5)).epsilon(1e-5));
}

TEST_CASE("Scanner: two surfaces are two echoes above the separation limit", "[ScannerRadiometry]")
{
  // Half of the beam each: 0.509241 m at 4 ns; at 1 % less it is one echo, with either sampling.
  for (const bool isFixed : { true, false })
  {
    for (const double factor : { 0.99, 1.01 })
    {
      const double behind = 50 + factor * 0.509241;
      // The nearer half returns more, by (R2 / R1)^2; its reflectance is reduced to match.
      OnePulse bench(MakeScene({ { { -50, 50, 0 }, { 100, 0, 0 }, { 0, 0, 50 } }, Wall(behind) }));
      bench.Scanner->SetSampling(isFixed ? 0 : 1);
      bench.Scanner->SetBinSize(0.05);
      bench.Scanner->SetRangeTolerance(1e-4);
      bench.Scanner->GetBeamSampler()->SetPatternToVogel();
      bench.Scanner->GetBeamSampler()->SetNumberOfSubRays(4000);
      // Unequal by 2 %, the limit changes: see the condition |ln a| <= 2 d sqrt(d^2 - 1) + ...
      const double a = std::pow(50 / behind, 2);
      double d = 1.0;
      for (double step = 0.1; step > 1e-9; step *= 0.5)
      {
        const auto misses = [a](double x)
        {
          const double root = std::sqrt(x * x - 1);
          return std::abs(std::log(a)) > 2 * x * root + 2 * std::log(x - root);
        };
        d += misses(d) ? step : -step * (d - step >= 1);
      }
      const double limit = d * 0.509241;
      const bool isTwo = factor * 0.509241 > limit;
      CAPTURE(isFixed, factor, limit);
      CHECK(bench.Run()->GetNumberOfPoints() == (isTwo ? 2 : 1));
    }
  }
}
