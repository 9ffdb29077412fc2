// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosGroundPath.h"
#include "heliosTurn.h"

#include <catch2/catch.hpp>

#include <cmath>

namespace
{

const double Pi = std::acos(-1.0);

} // namespace

TEST_CASE("Turn: the circle of the bicycle model, closed after one period", "[Turn]")
{
  // Wheelbase 2.5 m.
  const double cases[4][2] = { { 5.0, 28.575130756903 }, { 10.0, 14.178204549044 },
    { 20.0, 6.868693548637 }, { 30.0, 4.330127018922 } };
  const helios::Steering steering{ 2.5, 1.0, 1.0, 1.0, 1.0 };
  for (const auto& [degrees, radius] : cases)
  {
    const double curvature = steering.GetCurvature(degrees * Pi / 180.0);
    CHECK(1.0 / curvature == Approx(radius).epsilon(1e-12));
    const helios::Turn circle(2.0 * Pi, curvature, 0.0);
    CHECK(circle.GetLength() == Approx(2.0 * Pi * radius).epsilon(1e-12));
    const auto end = circle.At(circle.GetLength());
    CHECK(std::hypot(end.Forward, end.Left) < 1e-9);
    CHECK(end.Heading == Approx(2.0 * Pi).epsilon(1e-15));
    const auto half = circle.At(0.5 * circle.GetLength());
    CHECK(half.Left == Approx(2.0 * radius).epsilon(1e-12));
    CHECK(std::abs(half.Forward) < 1e-12 * radius);
  }
  // 5 m/s at 20 degrees: the yaw rate and the period.
  const double rate = 5.0 * steering.GetCurvature(20.0 * Pi / 180.0);
  CHECK(rate == Approx(0.727940468532).epsilon(1e-11));
  CHECK(2.0 * Pi / rate == Approx(8.631454876862).epsilon(1e-12));
}

TEST_CASE("Turn: a ramp is a clothoid", "[Turn]")
{
  // Fresnel's integrals C(1) and S(1) (Abramowitz and Stegun, table 7.7).
  const double ramp = 10.0;
  const double curvature = Pi / ramp;
  const helios::Turn turn(Pi, curvature, ramp);
  const auto half = turn.At(ramp);
  CHECK(half.Forward / ramp == Approx(0.7798934003768228).epsilon(1e-13));
  CHECK(half.Left / ramp == Approx(0.4382591473903548).epsilon(1e-13));
  CHECK(half.Heading == Approx(0.5 * Pi).epsilon(1e-14));
  CHECK(half.Curvature == Approx(curvature).epsilon(1e-14));
  const auto end = turn.At(turn.GetLength());
  CHECK(end.Heading == Approx(Pi).epsilon(1e-14));
  CHECK(std::abs(end.Curvature) < 1e-14);
  CHECK(end.Forward == Approx(0.0).margin(1e-13)); // the second half mirrors the first
  CHECK(end.Left == Approx(2.0 * half.Left).epsilon(1e-13));
}

TEST_CASE("Turn: position, heading and curvature are consistent", "[Turn]")
{
  for (const double angle : { 0.05, 0.8, 3.0, 6.0 })
  {
    const helios::Turn turn(angle, 0.4, 1.7);
    const double step = 1e-5;
    for (double s = step; s < turn.GetLength() - step; s += 0.0371)
    {
      const auto a = turn.At(s - step);
      const auto p = turn.At(s);
      const auto b = turn.At(s + step);
      INFO("angle " << angle << " at " << s);
      CHECK((b.Forward - a.Forward) / (2.0 * step) == Approx(std::cos(p.Heading)).margin(1e-8));
      CHECK((b.Left - a.Left) / (2.0 * step) == Approx(std::sin(p.Heading)).margin(1e-8));
      CHECK((b.Heading - a.Heading) / (2.0 * step) == Approx(p.Curvature).margin(2e-5));
      CHECK(p.Curvature <= 0.4 * (1.0 + 1e-14));
      CHECK(std::abs(b.Curvature - a.Curvature) <= 2.0 * step * 0.4 / 1.7 * (1.0 + 1e-6));
    }
    CHECK(turn.At(turn.GetLength()).Heading == Approx(angle).epsilon(1e-14));
  }
}

TEST_CASE("Turn: finds the first turn that leads to a point", "[Turn]")
{
  const double radius = 5.0;
  int found = 0;
  for (double x = -30.0; x <= 30.0; x += 0.77)
  {
    for (double y = 0.0; y <= 30.0; y += 0.77)
    {
      const auto arc = helios::FindTurn(x, y, 1.0 / radius, 0.0);
      INFO("to " << x << ", " << y);
      // With arcs exactly the points outside the circle are reached.
      CHECK(arc.has_value() == (std::hypot(x, y - radius) >= radius));
      const auto bend = helios::FindTurn(x, y, 1.0 / radius, 2.0);
      for (const auto& turn : { arc, bend })
      {
        if (turn)
        {
          const auto end = turn->At(turn->GetLength());
          const double ahead =
            (x - end.Forward) * std::cos(end.Heading) + (y - end.Left) * std::sin(end.Heading);
          const double left =
            (y - end.Left) * std::cos(end.Heading) - (x - end.Forward) * std::sin(end.Heading);
          CHECK(ahead >= 0.0);
          CHECK(std::abs(left) < 1e-11);
          ++found;
        }
      }
    }
  }
  CHECK(found > 4000);
}

TEST_CASE("GroundPath: reachable points by a turn, others by a manoeuvre", "[Turn]")
{
  const helios::Steering steering{ 2.5, Pi / 6.0, 10.0, 2.0, 0.0 };
  for (double x = -12.0; x <= 12.0; x += 0.61)
  {
    for (double y = -12.0; y <= 12.0; y += 0.61)
    {
      const auto path = helios::PlanGroundPath(
        { { { 0.0, -20.0, 0.0 }, 5.0 }, { { 0.0, 0.0, 0.0 }, 5.0 }, { { x, y, 1.0 }, 5.0 } },
        steering);
      INFO("to " << x << ", " << y);
      int backward = 0;
      int stops = 0;
      for (const auto& element : path)
      {
        backward += element.Backward ? 1 : 0;
        stops += element.Stops ? 1 : 0;
      }
      const double clearance = std::hypot(std::abs(x) - 4.330127018922, y) - 4.330127018922;
      CHECK((backward == 0 || clearance < 1.0 || (y < 0.0 && std::abs(x) < 6.0)));
      CHECK((backward > 0 || clearance > -0.5)); // steering takes a distance
      CHECK(stops == (backward > 0 ? 2 : 0));
      const auto end = path.back().At(path.back().Length);
      CHECK((end.Position - helios::Vec3(x, y, 1.0)).Norm() < 1e-9);
    }
  }
}
