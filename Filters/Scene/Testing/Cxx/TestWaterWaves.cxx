// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Waves on water against their spectrum.
#include "heliosErrorObserver.h"
#include "heliosMaterialTable.h"
#include "heliosWaveSpectrum.h"
#include "vtkHeliosSyntheticScene.h"
#include "vtkHeliosWaterWaves.h"

#include <vtkExecutive.h>
#include <vtkMath.h>
#include <vtkNew.h>
#include <vtkPolyData.h>

#include <catch2/catch.hpp>

#include <cmath>
#include <limits>
#include <vector>

using helios::Wind;

namespace
{

/// Simpson's rule.
template <typename FunctionT>
double Integrate(double from, double to, FunctionT f)
{
  constexpr int steps = 4000;
  const double step = (to - from) / steps;
  double sum = 0.0;
  for (int i = 0; i <= steps; ++i)
  {
    sum += (i == 0 || i == steps ? 1.0 : i % 2 == 1 ? 4.0 : 2.0) * f(from + step * i);
  }
  return sum * step / 3.0;
}

/// A plane of a size with the optics of water.
vtkSmartPointer<vtkPolyData> MakeWater(double size, int resolution)
{
  vtkNew<vtkHeliosSyntheticScene> plane;
  plane->SetSize(size);
  plane->SetResolution(resolution);
  plane->Update();
  vtkSmartPointer<vtkPolyData> water = plane->GetOutput();
  helios::MaterialTable materials = helios::GetMaterials(water);
  materials.at(0).Optics.Kind = helios::OpticsKind::Water;
  helios::SetMaterials(water, materials);
  return water;
}

} // namespace

TEST_CASE("WaterWaves: variance and slopes are those of the spectrum", "[WaterWaves]")
{
  const Wind wind{ GENERATE(3.0, 10.0), 30.0, 5000.0 };
  const double w0 = helios::GetPeakFrequency(wind);
  const double shortest = 0.5;
  const double last = std::sqrt(2.0 * vtkMath::Pi() * 9.80665 / shortest);
  const helios::WaveField field(wind, shortest, 3);
  const double variance =
    Integrate(0.6 * w0, last, [&](double w) { return helios::GetWaveEnergy(wind, w); });
  const double slopes = Integrate(0.6 * w0, last,
    [&](double w)
    { return helios::GetWaveEnergy(wind, w) * std::pow(w, 4) / (9.80665 * 9.80665); });
  CHECK(field.GetVariance() == Approx(variance).epsilon(0.05));
  CHECK(field.GetMeanSquareSlope() == Approx(slopes).epsilon(0.05));
  // waves below 0.6 of the peak do not matter
  CHECK(Integrate(0.3 * w0, 0.6 * w0, [&](double w) { return helios::GetWaveEnergy(wind, w); }) <
    1e-3 * variance);
  // Yamaguchi (1984): the integral of the spectrum, for a peak of 3.3
  const double alpha = 0.076 * std::pow(wind.Speed * wind.Speed / (wind.Fetch * 9.80665), 0.22);
  const double closed =
    alpha * 9.80665 * 9.80665 / std::pow(w0, 4) * (0.065 * std::pow(3.3, 0.803) + 0.135);
  CHECK(variance == Approx(closed).epsilon(0.03));
}

TEST_CASE("WaterWaves: heights have the variance, in space and in time", "[WaterWaves]")
{
  const helios::WaveField field({ 6.0, 0.0, 2000.0 }, 0.5, 5);
  double space = 0.0, time = 0.0;
  constexpr int count = 40000;
  for (int i = 0; i < count; ++i)
  {
    space += std::pow(field.GetHeight(37.0 * (i % 200), 41.0 * (i / 200), 0.0), 2) / count;
    time += std::pow(field.GetHeight(1.0, 2.0, 7.3 * i), 2) / count;
  }
  CHECK(space == Approx(field.GetVariance()).epsilon(0.1));
  CHECK(time == Approx(field.GetVariance()).epsilon(0.1));
}

TEST_CASE("WaterWaves: waves move with the wind, at the speed of the peak", "[WaterWaves]")
{
  const Wind wind{ 6.0, 0.0, 2000.0 };
  const helios::WaveField field(wind, 0.5, 5);
  const double speed = 9.80665 / helios::GetPeakFrequency(wind); // speed of phases
  const auto correlate = [&](double shift)
  {
    double sum = 0.0;
    for (int i = 0; i < 4000; ++i)
    {
      const double x = 13.7 * i, y = 5.1 * (i % 100);
      sum += field.GetHeight(x, y, 0.0) * field.GetHeight(x + shift, y, 0.5);
    }
    return sum / 4000.0 / field.GetVariance();
  };
  CHECK(correlate(0.5 * speed) > 0.5);
  CHECK(correlate(0.5 * speed) > correlate(-0.5 * speed) + 0.5);
}

TEST_CASE("WaterWaves: a mesh follows them, and keeps the rest of its slopes", "[WaterWaves]")
{
  const auto water = MakeWater(40.0, 80);
  vtkNew<vtkHeliosWaterWaves> waves;
  waves->SetInputData(water);
  waves->SetWindSpeed(7.0);
  waves->SetTime(2.5);
  waves->SetSeed(9);
  waves->Update();
  vtkPolyData* moved = waves->GetOutput();
  REQUIRE(moved->GetNumberOfPoints() == water->GetNumberOfPoints());
  double error = 0.0, highest = 0.0;
  for (vtkIdType i = 0; i < moved->GetNumberOfPoints(); ++i)
  {
    double p[3], q[3];
    water->GetPoint(i, p);
    moved->GetPoint(i, q);
    error = std::max({ error, std::abs(p[0] - q[0]), std::abs(p[1] - q[1]),
      std::abs(q[2] - p[2] - waves->GetHeight(p[0], p[1])) });
    highest = std::max(highest, q[2] - p[2]);
  }
  CHECK(error < 1e-12);
  CHECK(highest > 0.3 * waves->GetSignificantHeight());
  CHECK(highest < 1.5 * waves->GetSignificantHeight());

  const helios::WaveField field({ 7.0, 0.0, 1000.0 }, 0.5, 9);
  const double all = 0.003 + 0.00512 * 7.0;
  CHECK(field.GetMeanSquareSlope() > 0.0);
  CHECK(field.GetMeanSquareSlope() < all);
  CHECK(helios::GetMaterials(moved).at(0).Optics.MeanSquareSlope ==
    Approx(all - field.GetMeanSquareSlope()));
  CHECK(helios::GetMaterials(water).at(0).Optics.MeanSquareSlope == 0.0); // the input is as it was
}

TEST_CASE("WaterWaves: without wind the water is at rest", "[WaterWaves]")
{
  const auto water = MakeWater(4.0, 2);
  vtkNew<vtkHeliosWaterWaves> waves;
  waves->SetInputData(water);
  waves->SetWindSpeed(0.0);
  waves->Update();
  CHECK(waves->GetOutput()->GetPoints() == water->GetPoints());
  CHECK(waves->GetSignificantHeight() == 0.0);
}

TEST_CASE("WaterWaves: errors", "[WaterWaves]")
{
  vtkNew<vtkHeliosWaterWaves> waves;
  const auto log = vtkSmartPointer<helios::ErrorObserver>::Take(helios::ErrorObserver::New());
  log->Watch(waves);
  log->Watch(waves->GetExecutive());
  waves->SetInputData(MakeWater(4.0, 2));
  waves->SetTime(std::numeric_limits<double>::quiet_NaN());
  waves->Update();
  CHECK(log->HasError("and Time is nan; give finite numbers"));
}
