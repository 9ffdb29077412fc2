// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// A beam on a plane, against the table of closed forms (untruncated beam, FWHM 4 ns).
#include "heliosConstants.h"
#include "heliosExtremeTruth.h"
#include "heliosPlaneEcho.h"

#include "heliosScannerBench.h"
#include "vtkHeliosEchoDetector.h"

#include <vtkFieldData.h>

#include <catch2/catch.hpp>

#include <cmath>

namespace names = vtkHeliosArrayNames;
using helios::Vec3;
using namespace helios::testing;

namespace
{

constexpr double Degree = 0.017453292519943295;
const double Sigma = 4.0 / helios::FwhmPerSigma;

struct Row
{
  double Range, Angle, Width; // w [mrad]
  double MeanShift, WidthNs, Ratio;
};

/// A plane at a range on the y axis, with an incidence.
vtkSmartPointer<vtkPolyData> MakeTilted(double range, double degrees, double half)
{
  const Vec3 slope(0, std::sin(degrees * Degree), std::cos(degrees * Degree));
  return MakeScene(
    { { Vec3(-half, range, 0) - half * slope, { 2 * half, 0, 0 }, 2 * half * slope } });
}

} // namespace

TEST_CASE("PlaneEcho: moments of the beam", "[PlaneEcho]")
{
  for (const auto& [k, moment] : { std::pair{ 1.0, 0.3434823572503343 },
         std::pair{ 1.5, 0.4747239664194075 }, std::pair{ 12.0, 0.5 } })
  {
    const helios::BeamMoments beam(2.0, k); // w = 1
    CHECK(2 * beam.Variance == Approx(moment).epsilon(1e-14));
  }
  CHECK(helios::BeamMoments(2.0, 12.0).Excess == Approx(0).margin(1e-12));
  CHECK(helios::BeamMoments(2.0, 0.1).Excess == Approx(-1).epsilon(1e-2)); // a uniform disc
}

TEST_CASE("PlaneEcho: width, amplitude and mean range of tabulated cases", "[PlaneEcho]")
{
  for (const Row& row : { Row{ 100, 0, 0.5, 6.249999481e-6, 1.698643601, 1 },
         Row{ 100, 45, 0.5, -6.249998306e-6, 1.706811745, 0.995214385 },
         Row{ 100, 60, 0.5, -3.124997982e-5, 1.723031873, 0.985845722 },
         Row{ 100, 75, 0.5, -1.678520880e-4, 1.809093830, 0.938947208 },
         Row{ 1000, 60, 0.15, -2.812499840e-5, 0, 0 },
         Row{ 1000, 75, 0.5, -1.678520880e-3, 6.452009791, 0.263273562 } })
  {
    const helios::PlaneModel model{ helios::BeamMoments(2e-3 * row.Width, 12.0), Sigma };
    const double tangent = std::tan(row.Angle * Degree);
    const helios::PlaneEcho echo = model.GetEcho(row.Range, row.Range, tangent, 1.0);
    CHECK(echo.Range - row.Range == Approx(row.MeanShift).epsilon(2e-5).margin(1e-10));
    if (row.WidthNs > 0)
    {
      CHECK(echo.Sigma == Approx(row.WidthNs).epsilon(1e-8));
      CHECK(echo.Power == Approx(row.Ratio).epsilon(2e-5)); // 1 + 3 s^2 (tan^2 - 1)
    }
  }
}

TEST_CASE("PlaneEcho: beam correction on a slope of 85 degrees", "[PlaneEcho]")
{
  // 1 + 3 s^2 (tan^2 - 1) - 1 = 2.4308e-3 for w = 5 mrad; at this short range the widening
  // is negligible.
  const helios::PlaneModel model{ helios::BeamMoments(1e-2, 12.0), Sigma };
  const helios::PlaneEcho echo = model.GetEcho(1e-3, 1e-3, std::tan(85 * Degree), 1.0);
  CHECK(echo.Power - 1 == Approx(2.4308e-3).epsilon(1e-4));
}

TEST_CASE("PlaneEcho: adaptive sampling agrees with ten thousand sub-rays", "[PlaneEcho]")
{
  struct Case
  {
    double Range, Angle;
  };
  for (const Case& c : { Case{ 10, 0 }, Case{ 100, 45 }, Case{ 100, 60 }, Case{ 1000, 30 },
         Case{ 100, 75 }, Case{ 1000, 60 }, Case{ 1000, 75 }, Case{ 100, 85 } })
  {
    INFO("range " << c.Range << " m, " << c.Angle << " deg");
    Bench bench(MakeTilted(c.Range, c.Angle, 5 * c.Range));
    bench.Scanner->SetDuration(1e-5);
    vtkHeliosBeamSampler* sampler = bench.Scanner->GetBeamSampler();
    sampler->SetBeamDivergence(1e-3);
    // Rings have converged by far; with finer bins the width is limited by the rounding of the
    // samples.
    sampler->SetPatternToGaussLegendre();
    sampler->SetNumberOfRings(50);
    vtkPolyData* echoes = bench.Run();
    REQUIRE(echoes->GetNumberOfPoints() == 1);
    const double range = Value(echoes, names::Range, 0);
    const double amplitude = Value(echoes, names::Amplitude, 0);
    const double width = Value(echoes, names::EchoWidth, 0);
    for (const double tolerance : { 1.0, 0.1 })
    {
      bench.Scanner->SetSamplingToTolerance();
      bench.Scanner->SetRangeTolerance(1e-3 * tolerance);
      bench.Scanner->SetEnergyTolerance(1e-2 * tolerance);
      echoes = bench.Run();
      REQUIRE(echoes->GetNumberOfPoints() == 1);
      CHECK(std::abs(Value(echoes, names::Range, 0) - range) < 1e-3 * tolerance);
      CHECK(std::abs(Value(echoes, names::Amplitude, 0) / amplitude - 1) < 1e-2 * tolerance);
      CHECK(std::abs(Value(echoes, names::EchoWidth, 0) / width - 1) < 2e-2 * tolerance);
    }
  }
}

TEST_CASE("PlaneEcho: the curvature of equal ranges lowers the echo of a wide beam", "[PlaneEcho]")
{
  // A plane across the beam: ranges R / cos g spread over 15 mm.
  constexpr double w = 0.025;
  const TrueReturn truth = GetFirstEcho(w,
    [](const Vec3& d) {
      return TrueReturn{ 100 / d[1], d[1] };
    });
  helios::PlaneModel model{ helios::BeamMoments(2 * w, 1.5), 4.0 / helios::FwhmPerSigma };
  const helios::PlaneEcho echo = model.GetEcho(100, 100, 0, GetFull(100));
  CHECK(echo.Power / GetFull(100) == Approx(truth.Power / GetFull(100)).epsilon(2e-4));
  CHECK(std::abs(echo.Range - truth.Range) < model.GetShift(100, 0) + 1e-4);
  CHECK(model.GetShift(100, 0) < 1e-4);
  // 4 times as wide, the ranges spread over as much as a pulse: the closed form is not exact.
  model.Beam = helios::BeamMoments(8 * w, 1.5);
  CHECK(model.GetShift(100, 0) > 0.1);
}
