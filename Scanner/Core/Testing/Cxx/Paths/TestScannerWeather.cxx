// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Echoes of fog, and through it, against integrals.
#include "heliosConstants.h"
#include "heliosOpticsBench.h"
#include "heliosWeather.h"
#include "vtkHeliosEchoDetector.h"

#include <vtkMath.h>
#include <vtkTable.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

using namespace helios::testing;
using helios::Air;
using helios::ParseWeather;
namespace names = vtkHeliosArrayNames;

namespace
{

constexpr double Start = 2.0; // start of the range gate [m]

/// A ray in air before a wall.
struct AirBench : RayBench
{
  AirBench(double wall, double extinction, double lidarRatio)
    : RayBench(MakeScene({ Wall(wall) }))
    , Distance(wall)
  {
    this->Scanner->SetAtmosphericExtinction(extinction);
    this->Scanner->SetAtmosphericLidarRatio(lidarRatio);
    this->Scanner->SetRangeMin(Start);
    this->Scanner->SetDuration(1e-5);
    this->Scanner->GenerateWaveformsOn();
  }

  /// The power of a surface of a response at a range.
  double GetPower(double range, double response) const
  {
    const double aperture = this->Scanner->GetReceiverDiameter() / range;
    return this->Scanner->GetAveragePower() * this->Scanner->GetOpticalEfficiency() * 0.25 *
      aperture * aperture * std::exp(-2.0 * this->Scanner->GetAtmosphericExtinction() * range) *
      response;
  }

  /// The waveform at a time [ns], by Simpson's rule.
  double GetSample(double time) const
  {
    const double sigma = this->Scanner->GetPulseLength() / helios::FwhmPerSigma;
    const auto pulse = [&](double range)
    {
      const double x = (time - 2.0 / helios::SpeedOfLight * range) / sigma;
      return std::exp(-0.5 * x * x);
    };
    const double beta =
      this->Scanner->GetAtmosphericExtinction() / this->Scanner->GetAtmosphericLidarRatio();
    constexpr int steps = 40000;
    const double step = (this->Distance - Start) / steps;
    double sum = 0.0;
    for (int i = 0; i <= steps; ++i)
    {
      const double range = Start + step * i;
      const double weight = i == 0 || i == steps ? 1.0 : i % 2 == 1 ? 4.0 : 2.0;
      sum += weight * this->GetPower(range, vtkMath::Pi() * beta) * pulse(range);
    }
    return sum * step / 3.0 + this->GetPower(this->Distance, 0.5) * pulse(this->Distance);
  }

  double Distance;
};

/// Ranges and amplitudes of a beam, half on a near wall.
std::vector<double> ScanHalves(bool isAdaptive)
{
  Bench bench(MakeScene({ { { 0.0, 12.0, -5.0 }, { 5, 0, 0 }, { 0, 0, 10 } }, Wall(30.0) }));
  bench.Scanner->SetWeather("fog 0.1");
  bench.Scanner->SetRangeMin(Start);
  bench.Scanner->SetDuration(1e-5);
  bench.Scanner->SetRangeAccuracy(0.0);
  bench.Scanner->GetBeamSampler()->SetBeamDivergence(1e-3);
  bench.Scanner->GetBeamSampler()->SetPatternToVogel();
  bench.Scanner->GetBeamSampler()->SetNumberOfSubRays(20000);
  if (isAdaptive)
  {
    bench.Scanner->SetSamplingToTolerance();
  }
  vtkPolyData* cloud = bench.Run();
  std::vector<double> values;
  for (vtkIdType i = 0; i < cloud->GetNumberOfPoints(); ++i)
  {
    values.push_back(Value(cloud, names::Range, i));
    values.push_back(Value(cloud, names::Amplitude, i));
  }
  return values;
}

Air GetAir(const std::string& weather, double wavelength = 1064.0)
{
  Air air;
  CHECK(ParseWeather(weather, wavelength, air).IsOk());
  return air;
}

std::string GetFault(const std::string& weather)
{
  Air air;
  return ParseWeather(weather, 1064.0, air).Message();
}

} // namespace

TEST_CASE("ScannerWeather: the waveform of fog is pulse and backscatter convolved")
{
  const double extinction = GENERATE(0.004, 0.02, 0.1);
  AirBench bench(40.0, extinction, 18.8);
  bench.Scanner->GetEchoDetector()->SetDetectionThreshold(1e-12);
  bench.Run();
  auto* table = vtkTable::SafeDownCast(bench.Scanner->GetOutputDataObject(1));
  REQUIRE(table->GetNumberOfRows() == 1);
  vtkDataArray* samples = table->GetFieldData()->GetArray(names::Samples);
  const double start = table->GetValueByName(0, names::StartTime).ToDouble();
  const double bin = table->GetValueByName(0, names::BinSize).ToDouble();
  REQUIRE(samples->GetNumberOfTuples() > 500);
  for (vtkIdType i = 0; i < samples->GetNumberOfTuples(); i += 37)
  {
    const double expected = bench.GetSample(start + static_cast<double>(i) * bin);
    const double scale = bench.GetSample(2.0 / helios::SpeedOfLight * (Start + 0.5));
    CHECK(samples->GetComponent(i, 0) == Approx(expected).epsilon(1e-3).margin(2e-4 * scale));
  }
}

TEST_CASE("ScannerWeather: walls in fog are fainter by Beer's law, at any depth")
{
  const double range = GENERATE(5.0, 30.0, 80.0);
  AirBench thin(range, 0.02, 0.0);
  vtkPolyData* cloud = thin.Run();
  REQUIRE(cloud->GetNumberOfPoints() == 1);
  CHECK(Value(cloud, names::Amplitude, 0) == Approx(thin.GetPower(range, 0.5)).epsilon(1e-9));
  AirBench thick(range, 0.02, 1e5); // the fog itself returns next to nothing
  cloud = thick.Run();
  const vtkIdType last = cloud->GetNumberOfPoints() - 1;
  CHECK(Value(cloud, names::Amplitude, last) == Approx(thick.GetPower(range, 0.5)).epsilon(1e-3));
  CHECK(Value(cloud, names::MaterialIds, last) == 0);
}

TEST_CASE("ScannerWeather: fog has a near echo, of nothing in the scene")
{
  AirBench bench(60.0, 0.05, 18.8);
  bench.Scanner->SetWeather("fog 0.08");
  vtkPolyData* cloud = bench.Run();
  REQUIRE(cloud->GetNumberOfPoints() >= 1);
  CHECK(Value(cloud, names::Range, 0) < Start + 1.0);
  CHECK(Value(cloud, names::CellIds, 0) == -1);
  CHECK(Value(cloud, names::MaterialIds, 0) == -1);
  CHECK(Value(cloud, names::PartIds, 0) == -1);
  // and also where the beam meets nothing
  Bench sky(MakeScene({ { { 5, 5, 0 }, { 1, 0, 0 }, { 0, 0, 1 } } }));
  sky.Scanner->SetWeather("fog 0.08");
  sky.Scanner->SetRangeMin(Start);
  sky.Scanner->SetDuration(1e-5);
  const bool isAdaptive = GENERATE(false, true);
  if (isAdaptive)
  {
    sky.Scanner->SetSamplingToTolerance();
  }
  sky.Run();
  REQUIRE(sky.Scanner->GetOutput()->GetNumberOfPoints() == 1);
  CHECK(Value(sky.Scanner->GetOutput(), names::Range, 0) < Start + 1.0);
}

TEST_CASE("ScannerWeather: what hides a part of the beam hides the fog behind it")
{
  const std::vector<double> fixed = ScanHalves(false);
  const std::vector<double> adaptive = ScanHalves(true);
  REQUIRE(fixed.size() == 6);
  REQUIRE(adaptive.size() == 6);
  for (std::size_t i = 0; i < 6; i += 2)
  {
    CHECK(adaptive[i] == Approx(fixed[i]).margin(1e-3));
    CHECK(adaptive[i + 1] == Approx(fixed[i + 1]).epsilon(0.01));
  }
}

TEST_CASE("ScannerWeather: no weather is as before")
{
  const auto run = [](const std::string& weather)
  {
    Bench bench(MakeScene({ Wall(30.0) }));
    bench.Scanner->SetWeather(weather);
    return Bytes(bench.Run());
  };
  CHECK(run("") == run("clear"));
  CHECK(run("") != run("rain 20"));
}

TEST_CASE("Weather: laws")
{
  CHECK(GetAir("fog 0.2", 905.0).Extinction == Approx(3.912 / 0.2 * 1e-3));
  CHECK(GetAir("fog 0.2").LidarRatio == 18.8);
  CHECK(GetAir("dust 0.8", 1550.0).Extinction ==
    Approx(3.912e-3 / 0.8 * std::pow(1550.0 / 550.0, -0.3)));
  CHECK(
    GetAir("smoke 3", 532.0).Extinction == Approx(3.912e-3 / 3.0 * std::pow(532.0 / 550.0, -0.82)));
  CHECK(GetAir("rain 10").Extinction == Approx(1.076 * std::pow(10.0, 0.67) / 4.342945e3));
  CHECK(GetAir("snow 2").Extinction ==
    Approx((5.42e-5 * 1064.0 + 5.4958776) * std::pow(2.0, 1.38) / 4.342945e3));
  CHECK(GetAir("sleet 2").Extinction ==
    Approx((1.023e-4 * 1064.0 + 3.7855466) * std::pow(2.0, 0.72) / 4.342945e3));
  CHECK(GetAir("rain 10").DropletDiameter == 0.0);
  CHECK(GetAir("rain 10 drops").DropletDiameter == Approx(0.895e-3 * std::pow(10.0, 0.21)));
  CHECK(GetAir("clear").LidarRatio == 0.0);
  CHECK(GetAir("  ").LidarRatio == 0.0);
}

TEST_CASE("Weather: errors")
{
  CHECK(GetFault("fog") == "give fog and the visibility in km, from 0.005 to 1000");
  CHECK(GetFault("rain much") == "give rain and mm/h, from 0 to 300, and drops for single ones");
  CHECK(GetFault("snow 1 2") == "give snow and mm/h of water, from 0 to 50");
  CHECK(GetFault("snow 1 drops") == "give snow and mm/h of water, from 0 to 50");
  CHECK(
    GetFault("rain 1 drops 2") == "give rain and mm/h, from 0 to 300, and drops for single ones");
  CHECK(GetFault("clear sky") ==
    "give clear, fog, smoke or dust and the visibility in km, or rain, snow or sleet and mm/h, "
    "such "
    "as \"fog 0.2\"");
  Bench bench(MakeScene({ Wall(30.0) }));
  bench.Scanner->SetWeather("frogs 7");
  bench.Run();
  CHECK(bench.Log->HasError("Weather is \"frogs 7\"; give clear, fog, smoke or dust"));
  Bench second(MakeScene({ Wall(30.0) }));
  second.Scanner->SetAtmosphericLidarRatio(-1.0);
  second.Run();
  CHECK(second.Log->HasError("AtmosphericLidarRatio is -1 sr, outside "));
}
