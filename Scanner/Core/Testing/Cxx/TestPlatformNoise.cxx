// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosNoiseBench.h"

#include <catch2/catch.hpp>

#include <array>
#include <cmath>
#include <limits>

namespace names = vtkHeliosArrayNames;
using helios::Vec3;
using namespace helios::testing;
using Noise = vtkHeliosPlatformNoise;

namespace
{

using Values = std::array<double, 6>;

Values Get(Noise* noise, vtkIdType pulse, vtkIdType seed = 0)
{
  Values values;
  noise->GetValues(seed, pulse, values.data());
  return values;
}

/// Moments of a component about zero, the mean of powers 1 to 4.
std::array<double, 4> GetMoments(Noise* noise, int component, int count)
{
  std::array<double, 4> sums{};
  for (int i = 0; i < count; ++i)
  {
    const double x = Get(noise, i)[static_cast<std::size_t>(component)];
    for (std::size_t k = 0; k < 4; ++k)
    {
      sums[k] += std::pow(x, static_cast<double>(k + 1)) / count;
    }
  }
  return sums;
}

/// The noise of an echo's pulse.
Values At(NoiseBench& bench, vtkIdType row)
{
  return Get(bench.Noise, 5 + row, 11);
}

bool AreNear(const Vec3& a, const Vec3& b)
{
  return helios::testing::AreNear(a, b, 1e-13);
}

} // namespace

TEST_CASE("PlatformNoise: the moments of each distribution", "[PlatformNoise]")
{
  // n = 200000: five standard errors of each estimate
  constexpr int n = 200000;
  const double error = 5 / std::sqrt(1.0 * n);
  vtkNew<Noise> noise;
  CHECK_FALSE(noise->IsOn());
  CHECK(Get(noise, 3) == Values{});
  for (int component = 0; component < 6; ++component)
  {
    INFO("component " << component);
    noise->SetNormal(component, 0.0, 2.0);
    const auto normal = GetMoments(noise, component, n);
    CHECK(std::abs(normal[0]) < 2 * error);
    CHECK(std::abs(normal[1] - 4) < 4 * std::sqrt(2.0) * error);
    CHECK(std::abs(normal[3] - 48) < 16 * std::sqrt(96.0) * error);
    noise->SetUniform(component, -1.0, 3.0);
    const auto uniform = GetMoments(noise, component, n);
    CHECK(std::abs(uniform[0] - 1) < std::sqrt(16.0 / 12) * error);
    CHECK(std::abs(uniform[1] - 7.0 / 3) < std::sqrt(7.0) * error);
    noise->SetNone(component);
  }
  CHECK_FALSE(noise->IsOn());
  noise->SetNormal(Noise::POSITION_X, 7.0, 0.0);
  CHECK(Get(noise, 12345) == Values{ { 7, 0, 0, 0, 0, 0 } });
}

TEST_CASE("PlatformNoise: components are independent", "[PlatformNoise]")
{
  constexpr int n = 100000;
  vtkNew<Noise> noise;
  for (int component = 0; component < 6; ++component)
  {
    noise->SetNormal(component, 0.0, 1.0);
  }
  double products[6][6] = {};
  double lag[6] = {};
  Values before{};
  for (int i = 0; i < n; ++i)
  {
    const Values v = Get(noise, i);
    for (std::size_t a = 0; a < 6; ++a)
    {
      for (std::size_t b = 0; b < a; ++b)
      {
        products[a][b] += v[a] * v[b] / n;
      }
      lag[a] += v[a] * before[a] / n;
    }
    before = v;
  }
  for (std::size_t a = 0; a < 6; ++a)
  {
    CHECK(std::abs(lag[a]) < 5 / std::sqrt(1.0 * n));
    for (std::size_t b = 0; b < a; ++b)
    {
      INFO(a << " and " << b);
      CHECK(std::abs(products[a][b]) < 5 / std::sqrt(1.0 * n));
    }
  }
  const Values all = Get(noise, 77);
  noise->SetNone(Noise::POSITION_Y);
  CHECK(Get(noise, 77)[0] == all[0]);
  CHECK(Get(noise, 77)[5] == all[5]);
  CHECK(Get(noise, 77, 1)[0] != all[0]);
}

TEST_CASE("PlatformNoise: clipped values equal the limits", "[PlatformNoise]")
{
  constexpr int n = 100000;
  vtkNew<Noise> noise;
  noise->SetNormal(Noise::POSITION_Z, 0.0, 1.0);
  noise->SetClip(Noise::POSITION_Z, -1.0, 0.5);
  int low = 0, high = 0;
  for (int i = 0; i < n; ++i)
  {
    const double z = Get(noise, i)[2];
    REQUIRE((z >= -1 && z <= 0.5));
    low += z == -1;
    high += z == 0.5;
  }
  // The fractions of the normal distribution beyond them.
  const double shares[2] = { 0.5 * std::erfc(std::sqrt(0.5)),
    0.5 * std::erfc(0.5 * std::sqrt(0.5)) };
  CHECK(low / (1.0 * n) == Approx(shares[0]).margin(5 * std::sqrt(shares[0] / n)));
  CHECK(high / (1.0 * n) == Approx(shares[1]).margin(5 * std::sqrt(shares[1] / n)));
  noise->SetNoClip(Noise::POSITION_Z);
  bool isBeyond = false;
  for (int i = 0; i < 100; ++i)
  {
    isBeyond = isBeyond || std::abs(Get(noise, i)[2]) > 1.0;
  }
  CHECK(isBeyond);
}

TEST_CASE("PlatformNoise: a value holds for its lifespan", "[PlatformNoise]")
{
  vtkNew<Noise> noise;
  for (int component = 0; component < 6; ++component)
  {
    noise->SetUniform(component, 0.0, 1.0);
  }
  const Values first = Get(noise, 0), second = Get(noise, 1);
  noise->SetLifespan(Noise::POSITION_Y, 3);
  noise->SetLifespan(Noise::ATTITUDE_Z, 0);
  CHECK(noise->GetLifespan(Noise::POSITION_Y) == 3);
  for (vtkIdType pulse = 0; pulse < 6; ++pulse)
  {
    const Values v = Get(noise, pulse);
    CHECK(v[1] == (pulse < 3 ? first[1] : second[1]));
    CHECK(v[5] == first[5]);
    CHECK((v[0] == first[0]) == (pulse == 0));
  }
  CHECK(Get(noise, 1000000000000)[5] == first[5]);
}

TEST_CASE("PlatformNoise: motion moves points along surfaces", "[PlatformNoise]")
{
  NoiseBench bench;
  bench.Noise->SetNormal(Noise::POSITION_X, 0.0, 0.5);
  bench.Noise->SetNormal(Noise::POSITION_Y, 0.1, 0.2);
  bench.Noise->SetUniform(Noise::POSITION_Z, -1.0, 1.0);
  vtkPolyData* echoes = bench.Run();
  REQUIRE(echoes->GetNumberOfPoints() == 1000);
  for (vtkIdType i = 0; i < 1000; ++i)
  {
    const Values v = At(bench, i);
    const Vec3 origin(1 + v[0], 2 + v[1], 3 + v[2]);
    REQUIRE(AreNear(Vec3(bench.Pulses()->GetPoint(i)), origin));
    REQUIRE(AreNear(Vec3(echoes->GetPoint(i)), { origin[0], 40, origin[2] }));
    REQUIRE(AreNear(bench.TruePoint(i), { origin[0], 40, origin[2] }));
    REQUIRE(Value(echoes, names::Range, i) == Approx(38 - v[1]).epsilon(1e-14));
  }
}

TEST_CASE("PlatformNoise: navigation error moves points off surfaces", "[PlatformNoise]")
{
  NoiseBench bench;
  bench.Noise->SetModeToNavigationError();
  SECTION("of position: the opposite offset")
  {
    bench.Noise->SetNormal(Noise::POSITION_X, 0.0, 0.5);
    bench.Noise->SetNormal(Noise::POSITION_Y, 0.1, 0.2);
    vtkPolyData* echoes = bench.Run();
    REQUIRE(echoes->GetNumberOfPoints() == 1000);
    for (vtkIdType i = 0; i < 1000; ++i)
    {
      const Values v = At(bench, i);
      REQUIRE(Vec3(bench.Pulses()->GetPoint(i)) == Vec3(1, 2, 3));
      REQUIRE(AreNear(bench.TruePoint(i), { 1 + v[0], 40, 3 }));
      REQUIRE(AreNear(Vec3(echoes->GetPoint(i)), { 1, 40 - v[1], 3 }));
    }
  }
  SECTION("of attitude: the range is that of the true beam")
  {
    bench.Noise->SetNormal(Noise::ATTITUDE_Z, 0.0, 2.0);
    vtkPolyData* echoes = bench.Run();
    REQUIRE(echoes->GetNumberOfPoints() == 1000);
    for (vtkIdType i = 0; i < 1000; ++i)
    {
      const double yaw = vtkMath::RadiansFromDegrees(At(bench, i)[5]);
      REQUIRE(AreNear(Vec3(echoes->GetPoint(i)), { 1, 2 + 38 / std::cos(yaw), 3 }));
      REQUIRE(AreNear(bench.TruePoint(i), { 1 - 38 * std::tan(yaw), 40, 3 }));
    }
  }
}

TEST_CASE(
  "PlatformNoise: rotations are about the body axes, including the lever arm", "[PlatformNoise]")
{
  NoiseBench bench;
  bench.Tripod->SetHeading(90); // forward is x, towards the wall
  bench.Scanner->SetInputData(0, MakeScene({ { { 40, -50, -50 }, { 0, 100, 0 }, { 0, 0, 100 } } }));
  bench.Scanner->SetMountPosition(0, 0.5, 2);
  bench.Noise->SetNormal(Noise::ATTITUDE_X, 0.0, 2.0); // nose up, for any heading
  vtkPolyData* echoes = bench.Run();
  REQUIRE(echoes->GetNumberOfPoints() == 1000);
  for (vtkIdType i = 0; i < 1000; ++i)
  {
    const double up = vtkMath::RadiansFromDegrees(At(bench, i)[3]);
    const double c = std::cos(up), s = std::sin(up);
    const Vec3 origin(1 + 0.5 * c - 2 * s, 2, 3 + 0.5 * s + 2 * c);
    REQUIRE(AreNear(Vec3(bench.Pulses()->GetPoint(i)), origin));
    const double range = (40 - origin[0]) / c;
    REQUIRE(AreNear(Vec3(echoes->GetPoint(i)), { 40, 2, origin[2] + range * s }));
  }
  // All three: x, then y, then z of the body.
  bench.Noise->SetNormal(Noise::ATTITUDE_Y, 0.0, 3.0);
  bench.Noise->SetNormal(Noise::ATTITUDE_Z, 0.0, 4.0);
  bench.Run();
  vtkDataArray* directions = bench.Pulses()->GetPointData()->GetArray(names::Direction);
  for (vtkIdType i = 0; i < 100; ++i)
  {
    const Values v = At(bench, i);
    const helios::Quaternion a = helios::AxisAngle({ 0, 0, 1 }, -90) *
      helios::AxisAngle({ 1, 0, 0 }, v[3]) * helios::AxisAngle({ 0, 1, 0 }, v[4]) *
      helios::AxisAngle({ 0, 0, 1 }, v[5]);
    REQUIRE(AreNear(Vec3(directions->GetTuple3(i)), helios::Rotate(a, { 0, 1, 0 })));
  }
}

TEST_CASE("PlatformNoise: byte-identical for any number of threads and pieces", "[PlatformNoise]")
{
  NoiseBench bench;
  for (int component = 0; component < 6; ++component)
  {
    bench.Noise->SetNormal(component, 0.0, 0.1);
  }
  bench.Noise->SetLifespan(Noise::POSITION_X, 7);
  CheckThreadsAndPieces(bench);
}

TEST_CASE("PlatformNoise: the scanner executes again if it changes, and is unaffected without it",
  "[PlatformNoise]")
{
  NoiseBench bench;
  vtkPolyData* echoes = bench.Run();
  const std::string quiet = Bytes(echoes);
  bench.Noise->SetNormal(Noise::POSITION_X, 0.0, 0.5);
  CHECK(Bytes(bench.Run()) != quiet);
  bench.Noise->SetNone(Noise::POSITION_X);
  CHECK(Bytes(bench.Run()) == quiet);
  bench.Scanner->SetPlatformNoise(nullptr);
  CHECK(Bytes(bench.Run()) == quiet);
}

TEST_CASE("PlatformNoise: bad values are errors and change nothing", "[PlatformNoise]")
{
  vtkNew<Noise> noise;
  auto log = vtkSmartPointer<helios::ErrorObserver>::Take(helios::ErrorObserver::New());
  log->Watch(noise);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  noise->SetNormal(6, 0.0, 1.0);
  CHECK(log->HasError("Component is 6; give one of POSITION_X (0) to ATTITUDE_Z (5)."));
  noise->SetNormal(Noise::POSITION_X, 1.0, -0.5);
  CHECK(
    log->HasError("PositionX has mean 1 and stdev -0.5; give finite numbers, stdev 0 or more."));
  noise->SetNormal(Noise::ATTITUDE_Y, nan, 1.0);
  CHECK(log->HasError("AttitudeY has mean nan and stdev 1;"));
  noise->SetUniform(Noise::POSITION_Z, 3.0, 2.0);
  CHECK(
    log->HasError("PositionZ is uniform between 3 and 2; give finite numbers, the smaller first."));
  noise->SetClip(Noise::POSITION_Y, 1.0, nan);
  CHECK(log->HasError("PositionY is clipped to 1 and nan; give numbers, the smaller first."));
  noise->SetLifespan(Noise::ATTITUDE_X, -1);
  CHECK(log->HasError("AttitudeX has a lifespan of -1 pulses; give 0 (unlimited) to 1e15."));
  CHECK_FALSE(noise->IsOn());
  CHECK(noise->GetLifespan(Noise::ATTITUDE_X) == 1);
}
