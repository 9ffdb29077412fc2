// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// The column of water below a surface, and its glint, against closed forms and integrals.
#include "heliosConstants.h"
#include "heliosFresnel.h"
#include "heliosGlint.h"
#include "heliosOpticsBench.h"
#include "heliosWater.h"

#include <vtkMath.h>
#include <vtkTable.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <vector>

using namespace helios::testing;
using helios::Material;
using helios::OpticsKind;
using helios::Vec3;
namespace names = vtkHeliosArrayNames;

namespace
{

constexpr double Green = 532.0;
constexpr double Height = 10.0;     // height of the scanner over the water [m]
constexpr double RoughSlope = 0.25; // mean square

Material MakeWater(double attenuation, double backscatter)
{
  Material water = MakeMaterial(OpticsKind::Water);
  water.Optics.RefractiveIndex = helios::WaterIndex;
  water.Optics.Attenuation = attenuation;
  water.Optics.Backscatter = backscatter;
  return water;
}

/// A ray straight down on water of a depth [m].
struct WaterBench : RayBench
{
  WaterBench(const Material& water, double depth)
    : RayBench(MakeOpticalScene({ Wall(Height) }, water, { Wall(Height + depth) }))
    , Depth(depth)
    , Water(water)
  {
    this->Scanner->SetWavelength(Green);
    this->Scanner->SetPulseLength(2.0);
    this->Scanner->SetDuration(1e-5);
    this->Scanner->GenerateWaveformsOn();
  }

  double GetBottomRange() const
  {
    return Height + this->Water.Optics.RefractiveIndex * this->Depth;
  }

  /// The share of the energy that a depth receives [1], and the power of a surface of a response there.
  double GetPower(double depth, double response) const
  {
    const double n = this->Water.Optics.RefractiveIndex;
    const double face = 1.0 - std::pow((n - 1.0) / (n + 1.0), 2);
    const double area = std::pow(n * Height + depth, 2); // n^2 A
    const double aperture = this->Scanner->GetReceiverDiameter();
    const double air = helios::AtmosphericExtinction(
      this->Scanner->GetAtmosphericVisibility(), this->Scanner->GetWavelength());
    return this->Scanner->GetAveragePower() * this->Scanner->GetOpticalEfficiency() * 0.25 *
      aperture * aperture / area * face * face *
      std::exp(-2.0 * air * Height - 2.0 * this->Water.Optics.Attenuation * depth) * response;
  }

  /// The waveform at a time [ns]: pulse, exponential and bottom, by Simpson's rule.
  double GetSample(double time) const
  {
    const double sigma = this->Scanner->GetPulseLength() / helios::FwhmPerSigma;
    const double n = this->Water.Optics.RefractiveIndex;
    const auto pulse = [&](double depth)
    {
      const double x = (time - 2.0 / helios::SpeedOfLight * (Height + n * depth)) / sigma;
      return std::exp(-0.5 * x * x);
    };
    const double response = vtkMath::Pi() * this->Water.Optics.Backscatter; // per metre
    constexpr int steps = 20000;
    double sum = 0.0;
    for (int i = 0; i <= steps; ++i)
    {
      const double depth = this->Depth * i / steps;
      const double weight = i == 0 || i == steps ? 1.0 : i % 2 == 1 ? 4.0 : 2.0;
      sum += weight * this->GetPower(depth, response) * pulse(depth);
    }
    const double glint = std::pow((n - 1.0) / (n + 1.0), 2) / (4.0 * RoughSlope);
    return sum * this->Depth / steps / 3.0 + this->GetPower(this->Depth, 0.5) * pulse(this->Depth) +
      this->GetAmplitude(Height) / 0.5 * glint * pulse(0.0);
  }

  double Depth;
  Material Water;
};

vtkTable* GetWaveforms(const Bench& bench)
{
  return vtkTable::SafeDownCast(bench.Scanner->GetOutputDataObject(1));
}

} // namespace

TEST_CASE("ScannerWater: the waveform is pulse, two-way exponential and bottom convolved")
{
  const double attenuation = GENERATE(0.116, 0.403, 2.0);
  Material water = MakeWater(attenuation, 5e-3);
  water.Optics.MeanSquareSlope = RoughSlope; // without the mirror's reflection
  WaterBench bench(water, 4.0);
  bench.Run();
  vtkTable* table = GetWaveforms(bench);
  REQUIRE(table->GetNumberOfRows() == 1);
  vtkDataArray* samples = table->GetFieldData()->GetArray(names::Samples);
  const double start = table->GetValueByName(0, names::StartTime).ToDouble();
  const double bin = table->GetValueByName(0, names::BinSize).ToDouble();
  const double column = bench.GetSample(2.0 / helios::SpeedOfLight * (Height + 0.3));
  const double bottom = 2.0 / helios::SpeedOfLight * bench.GetBottomRange();
  double largest = 0.0;
  for (vtkIdType i = 0; i < samples->GetNumberOfTuples() && start + i * bin < bottom + 5.0; i += 3)
  {
    const double expected = bench.GetSample(start + static_cast<double>(i) * bin);
    largest = std::max(largest, std::abs(samples->GetComponent(i, 0) - expected));
  }
  CHECK(samples->GetNumberOfTuples() > 100);
  CHECK(column > 0.0);
  CHECK(largest < 2e-4 * bench.GetSample(bottom) + 2e-4 * column);
}

TEST_CASE("ScannerWater: the bottom of clear water is found to 1 cm, and named")
{
  const double depth = GENERATE(0.5, 2.0, 10.0);
  WaterBench bench(MakeWater(0.116, 2.6e-4), depth);
  vtkPolyData* cloud = bench.Run();
  const vtkIdType last = cloud->GetNumberOfPoints() - 1;
  REQUIRE(last == 1); // the surface, and the bottom
  CHECK(Value(cloud, names::Range, 0) == Approx(Height).margin(0.3));
  CHECK(Value(cloud, names::MaterialIds, 0) == 1);
  const double expected = bench.GetBottomRange();
  CHECK(Value(cloud, names::Range, last) == Approx(expected).margin(0.01 * helios::WaterIndex));
  CHECK(Value(cloud, names::MaterialIds, last) == 0);
  CHECK(GetTruth(cloud, last)[1] == Approx(Height + depth).margin(1e-9));
}

TEST_CASE("ScannerWater: near infrared ends at the surface")
{
  Material water = MakeWater(0.116, 2.6e-4);
  water.Optics.MeanSquareSlope = 0.02;
  WaterBench bench(water, 2.0);
  bench.Scanner->SetWavelength(1064.0);
  vtkPolyData* cloud = bench.Run();
  REQUIRE(cloud->GetNumberOfPoints() == 1);
  CHECK(Value(cloud, names::Range, 0) == Approx(Height).margin(1e-3));
  bench.Scanner->SetWavelength(Green);
  CHECK(bench.Run()->GetNumberOfPoints() == 2);
}

TEST_CASE("ScannerWater: the glint of a rough surface is that of its slopes")
{
  const double degrees = GENERATE(0.0, 5.0, 15.0, 25.0);
  const double a = vtkMath::RadiansFromDegrees(degrees);
  Material water = MakeWater(20.0, 0.0);
  water.Optics.MeanSquareSlope = 0.03;
  RayBench bench(MakeOpticalScene(
    { Across({ 0, Height, 0 }, { std::sin(a), -std::cos(a), 0.0 }, 5.0) }, water, {}));
  bench.Scanner->SetWavelength(Green);
  vtkPolyData* cloud = bench.Run();
  REQUIRE(cloud->GetNumberOfPoints() == 1);
  const double rho = std::pow(0.34 / 2.34, 2);
  const double slope = std::tan(a) * std::tan(a) / 0.03;
  const double expected = rho / (4.0 * 0.03 * std::pow(std::cos(a), 5)) * std::exp(-slope);
  CHECK(Value(cloud, names::Amplitude, 0) ==
    Approx(bench.GetAmplitude(Height) / 0.5 * expected).epsilon(1e-9));
}

TEST_CASE("Glint: all directions together reflect what a facet does")
{
  // A smooth lobe of few slopes: the reflectance over all directions of incidence and return, which
  // for backscatter is the integral of the response over the facets' slopes, 4 pi cos^5 wide.
  const double s2 = 0.01;
  double sum = 0.0;
  constexpr int steps = 4000;
  for (int i = 0; i < steps; ++i)
  {
    const double tangent = 6.0 * std::sqrt(s2) * (i + 0.5) / steps;
    const double cosine = 1.0 / std::sqrt(1.0 + tangent * tangent);
    const double probability = 4.0 * std::pow(cosine, 5) * helios::GetGlint(1.0, s2, cosine);
    sum += probability * 2.0 * tangent * 6.0 * std::sqrt(s2) / steps; // over pi s^2
  }
  CHECK(sum == Approx(1.0).epsilon(1e-6));
}

TEST_CASE("ScannerWater: adaptive and fixed beams agree on the column")
{
  const auto run = [](bool isAdaptive)
  {
    Bench bench(
      MakeOpticalScene({ Wall(Height) }, MakeWater(0.4, 3e-3), { Wall(Height + 1.5, 20.0) }));
    bench.Scanner->SetWavelength(Green);
    bench.Scanner->SetDuration(1e-5);
    bench.Scanner->SetRangeAccuracy(0.0);
    bench.Scanner->GetBeamSampler()->SetBeamDivergence(4e-3);
    bench.Scanner->GetBeamSampler()->SetPatternToVogel();
    bench.Scanner->GetBeamSampler()->SetNumberOfSubRays(2000);
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
  };
  const std::vector<double> fixed = run(false);
  const std::vector<double> adaptive = run(true);
  REQUIRE(fixed.size() == 4);
  REQUIRE(adaptive.size() == 4);
  for (std::size_t i = 0; i < 4; i += 2)
  {
    CHECK(adaptive[i] == Approx(fixed[i]).margin(1e-3));
    CHECK(adaptive[i + 1] == Approx(fixed[i + 1]).epsilon(0.02));
  }
}

TEST_CASE("ScannerWater: a medium that scatters attenuates")
{
  WaterBench bench(MakeWater(0.0, 1e-3), 2.0);
  bench.Run();
  CHECK(
    bench.Log->HasError("material 1 of the scene, default, has backscatter 0.001000 1/(m sr) and "
                        "attenuation 0.000000 1/m; what scatters attenuates: give the first "
                        "within [0, 1e6], and then the second within [0.001, 1e6]"));
  Material rough = MakeWater(0.1, 0.0);
  rough.Optics.MeanSquareSlope = 2.0;
  WaterBench second(rough, 2.0);
  second.Run();
  CHECK(second.Log->HasError("has mean square slope 2.000000; give it within [0, 1]"));
}

TEST_CASE("Water: absorption has the wavelengths of the literature")
{
  CHECK(helios::GetPureWaterAbsorption(532.0) == Approx(0.0447));
  CHECK(helios::GetPureWaterAbsorption(1064.0) == Approx(14.0));
  CHECK(helios::GetPureWaterAbsorption(300.0) == Approx(0.00663)); // value at 400 nm
  CHECK(helios::GetPureWaterAbsorption(2000.0) == Approx(1000.0));
  CHECK(helios::GetPureWaterAbsorption(541.0) == Approx(std::sqrt(0.0447 * 0.0565)));
  helios::MaterialOptics volume;
  volume.Kind = OpticsKind::Volume;
  volume.GroupIndex = 1.52; // given: kept
  CHECK(helios::GetOpticsAt(volume, 1064.0) == volume);
  volume.GroupIndex = 0.0;
  CHECK(helios::GetOpticsAt(volume, 1064.0).GroupIndex == volume.RefractiveIndex);
}
