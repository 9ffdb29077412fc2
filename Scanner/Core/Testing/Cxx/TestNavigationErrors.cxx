// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Slow errors, boresight, lever arm error and clock offset of vtkHeliosPlatformNoise.
#include "heliosNoiseBench.h"

#include <vtkMath.h>

#include <catch2/catch.hpp>

#include <array>
#include <cmath>
#include <limits>
#include <vector>

namespace names = vtkHeliosArrayNames;
using helios::Vec3;
using namespace helios::testing;
using Noise = vtkHeliosPlatformNoise;

namespace
{

using Values = std::array<double, 6>;

Values Get(Noise* noise, double time, vtkIdType seed = 0)
{
  Values values;
  noise->GetSlowErrors(seed, time, values.data());
  return values;
}

/// Samples of a component, every step [s].
std::vector<double> Sample(Noise* noise, int component, int count, double step, vtkIdType seed = 0)
{
  std::vector<double> samples;
  for (int i = 0; i < count; ++i)
  {
    samples.push_back(Get(noise, step * i, seed)[static_cast<std::size_t>(component)]);
  }
  return samples;
}

/// The mean of the products of samples that are a lag apart.
double GetCovariance(const std::vector<double>& x, std::size_t lag)
{
  double sum = 0.0;
  for (std::size_t i = 0; i + lag < x.size(); ++i)
  {
    sum += x[i] * x[i + lag];
  }
  return sum / static_cast<double>(x.size() - lag);
}

/**
 * The standard error of GetCovariance() over n samples that are r correlated with the next, variance
 * 1 (Bartlett): the sum over all differences k of r(k)^2 + r(k + lag) r(k - lag), over n, with
 * r(k) = r^|k|.
 */
double GetStandardError(double r, int lag, std::size_t n)
{
  double sum = 0.0;
  for (int k = -4000; k <= 4000; ++k)
  {
    sum += std::pow(r, 2 * std::abs(k)) + std::pow(r, std::abs(k + lag) + std::abs(k - lag));
  }
  return std::sqrt(sum / static_cast<double>(n));
}

bool AreNear(const Vec3& a, const Vec3& b)
{
  return helios::testing::AreNear(a, b, 1e-12);
}

} // namespace

TEST_CASE("NavigationErrors: RMS and autocorrelation of slow errors", "[NavigationErrors]")
{
  // Every T / 4: r = exp(-1/4); all within four standard errors of the formula.
  constexpr int n = 40000;
  const double r = std::exp(-0.25);
  vtkNew<Noise> noise;
  for (int component = 0; component < 6; ++component)
  {
    INFO("component " << component);
    const double rms = 0.5 + component;
    const double time = 10.0 * (1 + component);
    noise->SetSlowError(component, rms, time);
    CHECK(noise->GetSlowErrorRMS(component) == rms);
    CHECK(noise->GetSlowErrorTime(component) == time);
    const auto x = Sample(noise, component, n, 0.25 * time);
    for (const int lag : { 0, 1, 2, 4, 8, 16, 40 })
    {
      INFO("lag " << lag);
      const double expected = std::pow(r, lag);
      CHECK(GetCovariance(x, static_cast<std::size_t>(lag)) / (rms * rms) ==
        Approx(expected).margin(4 * GetStandardError(r, lag, n) + 0.002));
    }
  }
}

TEST_CASE("NavigationErrors: slow errors are normally distributed", "[NavigationErrors]")
{
  // Independent samples: 40 T apart, also of the interpolated steps between knots.
  constexpr int n = 40000;
  vtkNew<Noise> noise;
  noise->SetSlowError(Noise::POSITION_Z, 1.0, 1.0);
  double moments[5] = {};
  for (const double x : Sample(noise, Noise::POSITION_Z, n, 40.1234))
  {
    for (int k = 1; k < 5; ++k)
    {
      moments[k] += std::pow(x, k) / n;
    }
  }
  const double error = 4 / std::sqrt(1.0 * n);
  CHECK(std::abs(moments[1]) < error);
  CHECK(std::abs(moments[2] - 1) < std::sqrt(2.0) * error + 0.002);
  CHECK(std::abs(moments[3]) < std::sqrt(15.0) * error);
  CHECK(std::abs(moments[4] - 3) < std::sqrt(96.0) * error + 0.01);
}

TEST_CASE("NavigationErrors: slow errors are continuous", "[NavigationErrors]")
{
  // Increments over s have the variance 2 (1 - exp(-s / T)); at s = 1e-5 T, within a step of T / 256
  // that is linear, they are sqrt(2 / 256) s 256 / T at most in RMS.
  vtkNew<Noise> noise;
  noise->SetSlowError(Noise::ATTITUDE_X, 1.0, 100.0);
  double largest = 0.0;
  for (int i = -5000; i < 5000; ++i)
  {
    const double time = 1.7 * i;
    const double before = Get(noise, time)[3];
    largest = std::max(largest, std::abs(Get(noise, time + 1e-3)[3] - before));
  }
  CHECK(largest > 0.0);
  CHECK(largest < 6 * std::sqrt(2.0 / 256) * 256 * 1e-5);
}

TEST_CASE("NavigationErrors: components and seeds are independent", "[NavigationErrors]")
{
  constexpr int n = 20000;
  vtkNew<Noise> noise;
  for (int component = 0; component < 6; ++component)
  {
    noise->SetSlowError(component, 1.0, 1.0);
  }
  double products[6][6] = {};
  double other = 0.0;
  for (int i = 0; i < n; ++i)
  {
    const Values v = Get(noise, 10.0 * i);
    for (std::size_t a = 0; a < 6; ++a)
    {
      for (std::size_t b = 0; b < a; ++b)
      {
        products[a][b] += v[a] * v[b] / n;
      }
    }
    other += v[0] * Get(noise, 10.0 * i, 1)[0] / n;
  }
  for (std::size_t a = 0; a < 6; ++a)
  {
    for (std::size_t b = 0; b < a; ++b)
    {
      CHECK(std::abs(products[a][b]) < 5 / std::sqrt(1.0 * n));
    }
  }
  CHECK(std::abs(other) < 5 / std::sqrt(1.0 * n));
}

TEST_CASE("NavigationErrors: slow errors displace points by their value at the GPS time",
  "[NavigationErrors]")
{
  NoiseBench bench;
  bench.Noise->SetSlowError(Noise::POSITION_X, 0.5, 1e-2);
  bench.Noise->SetSlowError(Noise::POSITION_Y, 0.2, 1e-2);
  CHECK(bench.Noise->IsOn());
  CHECK(bench.Noise->HasErrors());
  CHECK_FALSE(bench.Noise->HasNoise());
  vtkPolyData* echoes = bench.Run();
  REQUIRE(echoes->GetNumberOfPoints() == 1000);
  for (vtkIdType i = 0; i < 1000; ++i)
  {
    const Values v = Get(bench.Noise, bench.Time(i), 11);
    REQUIRE(Vec3(bench.Pulses()->GetPoint(i)) == Vec3(1, 2, 3));
    REQUIRE(AreNear(bench.TruePoint(i), { 1 + v[0], 40, 3 }));
    REQUIRE(AreNear(Vec3(echoes->GetPoint(i)), { 1, 40 - v[1], 3 }));
  }
  bench.Noise->SetSlowError(Noise::POSITION_X, 0.0, 1.0);
  bench.Noise->SetSlowError(Noise::POSITION_Y, 0.0, 1.0);
  bench.Noise->SetSlowError(Noise::ATTITUDE_Z, 2.0, 1e-2);
  bench.Run();
  for (vtkIdType i = 0; i < 1000; ++i)
  {
    const double yaw = vtkMath::RadiansFromDegrees(Get(bench.Noise, bench.Time(i), 11)[5]);
    REQUIRE(AreNear(bench.TruePoint(i), { 1 - 38 * std::tan(yaw), 40, 3 }));
  }
}

TEST_CASE("NavigationErrors: motion is known, errors are not", "[NavigationErrors]")
{
  NoiseBench bench;
  bench.Noise->SetNormal(Noise::POSITION_X, 0.0, 0.5);
  bench.Noise->SetSlowError(Noise::POSITION_Z, 0.3, 1e-2);
  bench.Noise->SetClockOffset(1e-3); // the tripod stands still
  vtkPolyData* echoes = bench.Run();
  for (vtkIdType i = 0; i < 1000; ++i)
  {
    double jitter[6];
    bench.Noise->GetValues(11, 5 + i, jitter);
    const Values v = Get(bench.Noise, bench.Time(i), 11);
    REQUIRE(AreNear(Vec3(bench.Pulses()->GetPoint(i)), { 1 + jitter[0], 2, 3 }));
    REQUIRE(AreNear(Vec3(echoes->GetPoint(i)), { 1 + jitter[0], 40, 3 }));
    REQUIRE(AreNear(bench.TruePoint(i), { 1 + jitter[0], 40, 3 + v[2] }));
  }
}

TEST_CASE("NavigationErrors: boresight turns the beam about the mount", "[NavigationErrors]")
{
  NoiseBench bench;
  bench.Scanner->SetMountPosition(0.2, 0.5, -0.3);
  bench.Scanner->SetBeamOrigin(0.0, 0.1, 0.05);
  bench.Noise->SetBoresight(1.0, 2.0, 3.0);
  bench.Noise->SetLeverArmError(0.01, 0.02, 0.03);
  vtkPolyData* echoes = bench.Run();
  const auto boresight = helios::AxisAngle({ 1, 0, 0 }, 1) * helios::AxisAngle({ 0, 1, 0 }, 2) *
    helios::AxisAngle({ 0, 0, 1 }, 3);
  const Vec3 origin =
    Vec3(1.2, 2.5, 2.7) + Vec3(0.01, 0.02, 0.03) + helios::Rotate(boresight, { 0, 0.1, 0.05 });
  const Vec3 direction = helios::Rotate(boresight, { 0, 1, 0 });
  const double range = (40 - origin[1]) / direction[1];
  REQUIRE(AreNear(bench.TruePoint(0), origin + range * direction));
  REQUIRE(AreNear(Vec3(echoes->GetPoint(0)), { 1.2, 2.6 + range, 2.75 }));
  CHECK(AreNear(Vec3(bench.Pulses()->GetPoint(0)), { 1.2, 2.6, 2.75 }));
}

TEST_CASE(
  "NavigationErrors: a clock offset shifts points along the trajectory", "[NavigationErrors]")
{
  NoiseBench bench;
  // A flight along x, 10 m/s from x = 0 at 0 s; the wall is at y = 40.
  vtkNew<vtkPolyData> flight;
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkDoubleArray> times;
  times->SetName(names::GpsTime);
  vtkNew<vtkDoubleArray> orientations;
  orientations->SetName(names::Orientation);
  orientations->SetNumberOfComponents(4);
  for (int i = 0; i < 2; ++i)
  {
    points->InsertNextPoint(10.0 * i, 0.0, 0.0);
    times->InsertNextValue(i);
    orientations->InsertNextTuple4(1, 0, 0, 0);
  }
  flight->SetPoints(points);
  flight->GetPointData()->AddArray(times);
  flight->GetPointData()->AddArray(orientations);
  bench.Scanner->SetInputData(1, flight);
  bench.Scanner->SetStartTime(0.5);
  bench.Noise->SetClockOffset(2e-3);
  vtkPolyData* echoes = bench.Run();
  REQUIRE(echoes->GetNumberOfPoints() > 100);
  for (vtkIdType i = 0; i < 100; ++i)
  {
    const double x = 10.0 * bench.Time(i);
    REQUIRE(AreNear(Vec3(echoes->GetPoint(i)), { x, 40, 0 }));
    REQUIRE(AreNear(bench.TruePoint(i), { x + 0.02, 40, 0 }));
  }
}

TEST_CASE("NavigationErrors: byte-identical for any number of threads and pieces, and without "
          "errors",
  "[NavigationErrors]")
{
  NoiseBench bench;
  const std::string quiet = Bytes(bench.Run());
  for (int component = 0; component < 6; ++component)
  {
    bench.Noise->SetSlowError(component, 0.1, 0.01 * (1 + component));
  }
  bench.Noise->SetBoresight(0.1, 0.2, 0.3);
  CHECK(CheckThreadsAndPieces(bench) != quiet);
  for (int component = 0; component < 6; ++component)
  {
    bench.Noise->SetSlowError(component, 0.0, 1.0);
  }
  bench.Noise->SetBoresight(0, 0, 0);
  CHECK_FALSE(bench.Noise->IsOn());
  CHECK(Bytes(bench.Run()) == quiet);
}

TEST_CASE("NavigationErrors: a grade sets the RMS of all slow errors", "[NavigationErrors]")
{
  vtkNew<Noise> noise;
  noise->SetSlowError(Noise::POSITION_X, 5.0, 300.0);
  REQUIRE(noise->SetGrade("tactical"));
  const double expected[6] = { 0.05, 0.05, 0.05, 0.025, 0.025, 0.080 };
  for (int component = 0; component < 6; ++component)
  {
    CHECK(noise->GetSlowErrorRMS(component) == expected[component]);
    CHECK(noise->GetSlowErrorTime(component) == (component == 0 ? 300.0 : 60.0));
  }
  CHECK(noise->HasErrors());
}

TEST_CASE("NavigationErrors: bad values are errors and change nothing", "[NavigationErrors]")
{
  vtkNew<Noise> noise;
  auto log = vtkSmartPointer<helios::ErrorObserver>::Take(helios::ErrorObserver::New());
  log->Watch(noise);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  noise->SetSlowError(-1, 1.0, 1.0);
  CHECK(log->HasError("Component is -1; give one of POSITION_X (0) to ATTITUDE_Z (5)."));
  noise->SetSlowError(Noise::POSITION_Y, -0.5, 60.0);
  CHECK(log->HasError("PositionY has a slow error of RMS -0.5 and correlation time 60 s; give a "
                      "finite RMS, 0 or more, and 1e-3 to 1e9 s."));
  noise->SetSlowError(Noise::ATTITUDE_Z, 1.0, 0.0);
  CHECK(log->HasError("AttitudeZ has a slow error of RMS 1 and correlation time 0 s;"));
  noise->SetBoresight(0.0, 181.0, 0.0);
  CHECK(log->HasError("Boresight is 0, 181, 0 deg; give angles from -180 to 180."));
  noise->SetLeverArmError(0.0, 0.0, nan);
  CHECK(log->HasError("LeverArmError is 0, 0, nan m; give finite numbers."));
  CHECK_FALSE(noise->SetGrade("best"));
  CHECK(log->HasError("Grade is \"best\"; give one of consumer tactical survey navigation."));
  CHECK_FALSE(noise->IsOn());
  CHECK(noise->GetSlowErrorTime(Noise::POSITION_Y) == 60.0);
  CHECK(std::isnan(noise->GetSlowErrorRMS(6)));
  CHECK(std::isnan(noise->GetSlowErrorTime(-1)));
}
