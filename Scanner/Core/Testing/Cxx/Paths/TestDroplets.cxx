// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Single drops: a Poisson process with the mean of homogeneous air.
#include "heliosDroplets.h"
#include "heliosScannerBench.h"
#include "heliosWeather.h"
#include "vtkHeliosEchoDetector.h"

#include <vtkMath.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <vector>

using namespace helios::testing;
using helios::AirSettings;
using helios::BeamWidth;
using helios::Droplets;
using helios::Hidden;
using helios::SubReturn;
namespace names = vtkHeliosArrayNames;

namespace
{

constexpr double Stop = 40.0; // [m]
constexpr double Diameter = 1e-3;

AirSettings MakeAir()
{
  AirSettings air;
  air.Extinction = 0.01;
  air.Backscatter = air.Extinction / 18.8;
  air.Gain = 2.0;
  air.Start = 2.0;
  air.Stop = Stop;
  air.Step = 0.25;
  return air;
}

/// Simpson's rule.
template <typename FunctionT>
double Integrate(double from, double to, FunctionT f)
{
  constexpr int steps = 2000;
  const double step = (to - from) / steps;
  double sum = 0.0;
  for (int i = 0; i <= steps; ++i)
  {
    sum += (i == 0 || i == steps ? 1.0 : i % 2 == 1 ? 4.0 : 2.0) * f(from + step * i);
  }
  return sum * step / 3.0;
}

} // namespace

TEST_CASE("Droplets: their number is Poisson's, and their mean power that of the air", "[Droplets]")
{
  const double apex = GENERATE(0.0, 25.0); // without and with a waist
  const AirSettings air = MakeAir();
  const BeamWidth beam{ 0.5e-3, apex, 2.0 };
  const Droplets drops(air, Stop, beam, Diameter);
  CHECK(drops.GetDensity() == Approx(0.01 / (0.5 * vtkMath::Pi() * 1e-6)).epsilon(1e-12));
  CHECK(drops.GetVolume(Stop) ==
    Approx(
      Integrate(0.0, Stop, [&](double r) { return vtkMath::Pi() * 1e-6 * (r * r + apex * apex); }))
      .epsilon(1e-9));
  constexpr int pulses = 20000;
  double count = 0.0, squares = 0.0, near = 0.0, far = 0.0;
  bool isInside = true;
  std::vector<Hidden> none;
  for (int i = 0; i < pulses; ++i)
  {
    std::vector<SubReturn> returns;
    drops.Append(7, i, none, returns);
    const auto number = static_cast<double>(returns.size());
    count += number / pulses;
    squares += number * number / pulses;
    for (const SubReturn& r : returns)
    {
      isInside = isInside && r.Range >= air.Start && r.Range <= Stop;
      (r.Range < 15.0 ? near : far) += r.Power / pulses;
    }
  }
  const double expected = drops.GetDensity() * (drops.GetVolume(Stop) - drops.GetVolume(air.Start));
  CHECK(count == Approx(expected).epsilon(4.0 / std::sqrt(pulses * expected)));
  CHECK((squares - count * count) / count == Approx(1.0).epsilon(0.05));
  const auto density = [&](double r)
  {
    return air.Gain * vtkMath::Pi() * air.Backscatter * std::exp(-2.0 * air.Extinction * r) /
      (r * r);
  };
  // The nearest drops may be larger than the beam without a waist, and return no more than all.
  CHECK(far == Approx(Integrate(15.0, Stop, density)).epsilon(0.03));
  CHECK((apex == 0.0 || near == Approx(Integrate(air.Start, 15.0, density)).epsilon(0.05)));
}

TEST_CASE("Droplets: weak ones are a column, and the mean stays that of the air", "[Droplets]")
{
  const AirSettings air = MakeAir();
  const BeamWidth beam{ 0.5e-3, 25.0, 2.0 };
  const double least = GENERATE(1e-9, 1e-7, 1e-6);
  const Droplets all(air, Stop, beam, Diameter);
  const Droplets strong(air, Stop, beam, Diameter, least);
  const auto density = [&](double r)
  {
    return air.Gain * vtkMath::Pi() * air.Backscatter * std::exp(-2.0 * air.Extinction * r) /
      (r * r);
  };
  double count = 0.0, countOfAll = 0.0, power = 0.0;
  constexpr int pulses = 20000;
  bool areStrong = true;
  for (int i = 0; i < pulses; ++i)
  {
    std::vector<Hidden> none;
    std::vector<SubReturn> returns, whole;
    strong.Append(7, i, none, returns);
    all.Append(7, i, none, whole);
    count += static_cast<double>(returns.size());
    countOfAll += static_cast<double>(whole.size());
    for (const SubReturn& r : returns)
    {
      areStrong = areStrong && r.Power >= least;
      power += r.Power / pulses;
    }
  }
  CHECK(areStrong);
  CHECK(count < countOfAll);
  const double mean = Integrate(air.Start, Stop, density);
  const double rest = Integrate(
    air.Start, Stop, [&](double r) { return density(r) * strong.GetHomogeneousShare(r); });
  CHECK(rest > 0.0);
  CHECK(rest < mean);
  CHECK(power + rest == Approx(mean).epsilon(0.03));

  const helios::AirColumn column(
    air, [&strong](double r) { return strong.GetHomogeneousShare(r); });
  std::vector<Hidden> none;
  std::vector<SubReturn> slabs;
  column.Append(none, slabs);
  double sum = 0.0;
  for (const SubReturn& r : slabs)
  {
    sum += r.Power;
  }
  CHECK(sum == Approx(rest).epsilon(0.01));
}

TEST_CASE("Droplets: those behind surfaces are not seen", "[Droplets]")
{
  const Droplets drops(MakeAir(), Stop, { 0.5e-3, 25.0, 2.0 }, Diameter);
  double all = 0.0, before = 0.0, behind = 0.0;
  for (int i = 0; i < 4000; ++i)
  {
    std::vector<Hidden> none, half = { { 20.0, 0.5 } };
    std::vector<SubReturn> open, hidden;
    drops.Append(7, i, none, open);
    drops.Append(7, i, half, hidden);
    for (const SubReturn& r : open)
    {
      (r.Range < 20.0 ? before : all) += 1.0;
    }
    for (const SubReturn& r : hidden)
    {
      (r.Range < 20.0 ? before : behind) += r.Range < 20.0 ? -1.0 : 1.0;
    }
  }
  CHECK(before == 0.0);
  CHECK(behind / all == Approx(0.5).epsilon(0.05));
}

TEST_CASE("Droplets: the rate of false echoes is Poisson's", "[Droplets]")
{
  // Pulses into the open: the only surface is aside.
  Bench bench(MakeScene({ { { 5, 5, 0 }, { 1, 0, 0 }, { 0, 0, 1 } } }));
  vtkHeliosScanner* scanner = bench.Scanner;
  scanner->SetWeather("rain 5 drops");
  scanner->SetRangeMin(2.0);
  scanner->SetRangeMax(25.0);
  scanner->SetDuration(0.1);
  scanner->GetBeamSampler()->SetBeamDivergence(1e-3);
  scanner->SetSamplingToTolerance();
  helios::Air air;
  REQUIRE(helios::ParseWeather("rain 5 drops", scanner->GetWavelength(), air).IsOk());
  const double aperture = scanner->GetReceiverDiameter();
  const double gain =
    scanner->GetAveragePower() * scanner->GetOpticalEfficiency() * 0.25 * aperture * aperture;
  // Threshold like a wall of reflectance 0.03 at 10 m: a share of the drops.
  const double threshold = gain * 0.03 / 100.0;
  scanner->GetEchoDetector()->SetDetectionThreshold(threshold);
  vtkPolyData* cloud = bench.Run();
  const double section = 0.25 * vtkMath::Pi() * air.DropletDiameter * air.DropletDiameter;
  const double k2 = std::pow(scanner->GetBeamSampler()->GetTruncation(), 2);
  const double mean = air.Extinction / (2.0 * section) *
    Integrate(2.0, 25.0,
      [&](double r)
      {
        // The drops up to a distance from the axis are strong enough: u of the squares.
        const double w2 = 0.25e-6 * r * r;
        const double centre = gain / (r * r) * std::exp(-2.0 * air.Extinction * r) * vtkMath::Pi() *
          2.0 / 18.8 * section * 2.0 / (vtkMath::Pi() * w2) / (1.0 - std::exp(-2.0 * k2));
        const double u = std::clamp(0.5 * std::log(centre / threshold) / k2, 0.0, 1.0);
        return u * vtkMath::Pi() * w2 * k2;
      });
  double pulses = 0.0;
  for (vtkIdType i = 0; i < cloud->GetNumberOfPoints(); ++i)
  {
    pulses += Value(cloud, names::ReturnNumber, i) == 1.0 ? 1.0 : 0.0;
    CHECK_FALSE(Value(cloud, names::CellIds, i) >= 0.0);
  }
  const double rate = 1.0 - std::exp(-mean);
  CHECK(rate > 0.01);
  CHECK(pulses / 10000.0 == Approx(rate).margin(4.0 * std::sqrt(rate / 10000.0)));
}

TEST_CASE("Droplets: wrong diameters are errors", "[Droplets]")
{
  Bench bench(MakeScene({ Wall(30.0) }));
  bench.Scanner->SetDropletDiameter(1.0);
  bench.Run();
  CHECK(bench.Log->HasError("DropletDiameter is 1 m, outside "));
}
