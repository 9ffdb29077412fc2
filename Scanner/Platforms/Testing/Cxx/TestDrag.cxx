// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosDrag.h"
#include "heliosFlightSpeed.h"
#include "heliosSpeedProfile.h"

#include <catch2/catch.hpp>

#include <cmath>

TEST_CASE("Drag: a force against linear drag", "[Drag]")
{
  // m = 1500 kg, F = 3000 N, k = 150 kg/s.
  const helios::LinearDrag drag{ 2.0, 0.1 };
  CHECK(drag.At(0.0, 10.0).Speed == Approx(12.642411176571).epsilon(1e-12));
  CHECK(drag.At(0.0, 10.0).Distance == Approx(73.575888234288).epsilon(1e-12));
  CHECK(drag.At(0.0, 60.0).Speed == Approx(19.950424956467).epsilon(1e-12));
  CHECK(drag.At(0.0, 60.0).Distance == Approx(1000.495750435333).epsilon(1e-12));
  // Energy after 30 s: work = kinetic + loss to drag, k integral of v^2.
  const helios::Travel end = drag.At(0.0, 30.0);
  const double kinetic = 750.0 * end.Speed * end.Speed;
  CHECK(3000.0 * end.Distance == Approx(1229872.241020719).epsilon(1e-12));
  CHECK(kinetic == Approx(270871.384632282).epsilon(1e-12));
  double lost = 0.0; // Simpson's rule
  const int steps = 3000;
  for (int i = 0; i <= steps; ++i)
  {
    const double v = drag.At(0.0, 30.0 * i / steps).Speed;
    lost += (i == 0 || i == steps ? 1.0 : (i % 2 ? 4.0 : 2.0)) * 150.0 * v * v * 30.0 / steps / 3.0;
  }
  CHECK(kinetic + lost == Approx(3000.0 * end.Distance).epsilon(1e-9));
}

TEST_CASE("Drag: linear drag forward, backward and without drag", "[Drag]")
{
  for (const double rate : { 0.0, 1e-12, 1e-3, 0.1, 3.0 })
  {
    for (const double pull : { -4.0, 0.5, 2.0 })
    {
      const helios::LinearDrag drag{ pull, rate };
      const helios::Travel travel = drag.At(7.0, 1.25);
      const helios::Travel back = drag.At(travel.Speed, -1.25);
      INFO("rate " << rate << ", pull " << pull);
      CHECK(back.Speed == Approx(7.0).epsilon(1e-13));
      CHECK(back.Distance == Approx(-travel.Distance).epsilon(1e-13));
      CHECK(drag.FindTime(7.0, travel.Speed) == Approx(1.25).epsilon(1e-12));
      if (pull > 0.0)
      {
        CHECK(drag.FindTimeTo(7.0, travel.Distance) == Approx(1.25).epsilon(1e-12));
      }
    }
  }
  CHECK(helios::LinearDrag{ 2.0, 0.0 }.At(3.0, 4.0).Distance == 28.0);
  CHECK(std::isinf(helios::LinearDrag{ 2.0, 0.1 }.FindTime(0.0, 20.0))); // the terminal speed
  CHECK(std::isinf(helios::LinearDrag{ 2.0, 0.1 }.FindTime(5.0, 4.0)));  // it accelerates
}

TEST_CASE("Drag: a tilted helicopter against quadratic drag", "[Drag]")
{
  // c = 1.225 kg/m, m = 1000 kg, g = 9.80665: x(10) and v(60) from rest.
  const double cases[3][3] = { { 2.0, 17.004391465585, 14.082587854000 },
    { 5.0, 42.167496731752, 25.404626987193 }, { 10.0, 83.568543218366, 37.271972915822 } };
  for (const auto& [tilt, way, speed] : cases)
  {
    const helios::QuadraticDrag drag{ 9.80665 * std::tan(tilt * std::acos(-1.0) / 180.0),
      1.225e-3 };
    INFO("tilt " << tilt);
    CHECK(drag.At(0.0, 10.0).Distance == Approx(way).epsilon(1e-11));
    CHECK(drag.At(0.0, 60.0).Speed == Approx(speed).epsilon(1e-11));
    const helios::Travel late = drag.At(0.0, 5000.0); // where tanh is 1
    CHECK(late.Speed == Approx(std::sqrt(drag.Drive / drag.Drag)).epsilon(1e-14));
  }
}

TEST_CASE("Drag: quadratic drag solves its equation from any speed", "[Drag]")
{
  for (const double c : { 0.0, 1e-15, 1e-6, 0.02, 0.7 })
  {
    for (const double drive : { -6.0, -1e-9, 0.0, 1e-9, 0.3, 7.0 })
    {
      const helios::QuadraticDrag drag{ drive, c };
      const double v0 = 9.0;
      const double end = drive < -1.0 ? 0.8 : 30.0;
      for (const double t : { 0.1 * end, 0.5 * end, end })
      {
        const double h = 1e-4;
        const helios::Travel a = drag.At(v0, t - h);
        const helios::Travel m = drag.At(v0, t);
        const helios::Travel b = drag.At(v0, t + h);
        INFO("drag " << c << ", drive " << drive << ", after " << t);
        CHECK(
          (b.Speed - a.Speed) / (2.0 * h) == Approx(drive - c * m.Speed * m.Speed).margin(2e-6));
        CHECK((b.Distance - a.Distance) / (2.0 * h) == Approx(m.Speed).epsilon(1e-7).margin(1e-7));
        // In one step, or in two.
        const helios::Travel first = drag.At(v0, 0.37 * t);
        const helios::Travel rest = drag.At(first.Speed, 0.63 * t);
        CHECK(first.Distance + rest.Distance == Approx(m.Distance).epsilon(1e-12));
        CHECK(rest.Speed == Approx(m.Speed).epsilon(1e-12).margin(1e-12));
      }
    }
  }
}

TEST_CASE("Drag: ramps of the drive are integrated to fourth order", "[Drag]")
{
  // Without drag v and x are polynomials for which RK4 is exact.
  const helios::DriveLimits free{ 5.0, -5.0, 2.0, 0.0, 0.01 };
  const auto ramp = helios::DrivePhase::Ramp(free, 3.0, 1.0, 4.0);
  CHECK(ramp.GetDuration() == 1.5);
  const double t = 1.234;
  CHECK(ramp.At(t).Speed == Approx(3.0 + t + t * t).epsilon(1e-14));
  CHECK(ramp.At(t).Distance == Approx(3.0 * t + t * t / 2.0 + t * t * t / 3.0).epsilon(1e-14));
  CHECK(ramp.At(t).Drive == 1.0 + 2.0 * t);
  // With drag the error falls by 16 when the step is halved.
  double ends[3];
  for (int i = 0; i < 3; ++i)
  {
    const helios::DriveLimits limits{ 5.0, -5.0, 2.0, 0.3, 0.1 / (1 << i) };
    ends[i] = helios::DrivePhase::Ramp(limits, 9.0, 0.0, 4.0).GetEnd().Distance;
  }
  CHECK((ends[0] - ends[1]) / (ends[1] - ends[2]) == Approx(16.0).epsilon(0.25));
  // For a realistic step and drag, half the step changes nothing.
  helios::DriveLimits limits{ 6.0, -4.0, 15.0, 0.02, 0.01 };
  const double coarse = helios::ChangeSpeed(limits, 0.0, 15.0).Distance;
  limits.Step = 0.005;
  CHECK(helios::ChangeSpeed(limits, 0.0, 15.0).Distance == Approx(coarse).margin(1e-9));
}

TEST_CASE("Drag: a change of speed ends at the target speed", "[Drag]")
{
  for (const double c : { 0.0, 0.005, 0.05 })
  {
    const helios::DriveLimits limits{ 6.0, -4.0, 15.0, c, 0.01 };
    for (const double from : { 0.0, 0.3, 5.0, 10.0 })
    {
      for (const double to : { 0.0, 0.2, 5.0, 10.7 })
      {
        const auto change = helios::ChangeSpeed(limits, from, to);
        INFO("drag " << c << ", from " << from << " to " << to);
        REQUIRE(change.Phases.empty() == (from == to));
        if (from != to)
        {
          const auto end = change.Phases.back().GetEnd();
          CHECK(end.Speed == Approx(to).margin(1e-12));
          CHECK(end.Drive == Approx(c * to * to).margin(1e-12));
          CHECK(change.Phases.front().At(0.0).Drive == c * from * from);
        }
      }
    }
  }
}

TEST_CASE("Drag: a straight line is flown to its end", "[Drag]")
{
  const helios::DriveLimits limits{ 6.0, -4.0, 15.0, 0.01, 0.01 };
  for (const double length : { 0.01, 1.0, 10.0, 300.0 })
  {
    for (const double brake : { 0.0, 7.0, 1000.0 })
    {
      double way = 0.0;
      double top = 0.0;
      for (const auto& phase : helios::FlyLine(limits, { length, 0.0, 0.0, 12.0, brake }))
      {
        way += phase.GetEnd().Distance;
        top = std::max(top, phase.GetEnd().Speed);
      }
      INFO("length " << length << ", brake " << brake);
      CHECK(way == Approx(length).epsilon(1e-11));
      CHECK(top <= 12.0 * (1.0 + 1e-12));
    }
  }
}

TEST_CASE("Drag: a vehicle stays below every speed limit and stops where required", "[Drag]")
{
  const std::vector<helios::Stretch> way = { { 30.0, 12.0, 3.0, -4.0, false },
    { 5.0, 3.0, 2.0, -5.0, false }, { 0.5, 20.0, 3.0, -4.0, false },
    { 100.0, 20.0, 0.1, -4.0, true }, { 4.0, 9.0, 3.0, -4.0, false } };
  for (const double rate : { 0.0, 0.05 })
  {
    const auto phases = helios::DriveStretches(way, rate);
    double speed = 0.0;
    double lengths[5] = {};
    for (const auto& phase : phases)
    {
      CHECK(phase.Speed == Approx(speed).margin(1e-9));
      for (int i = 0; i <= 10; ++i)
      {
        CHECK(phase.At(0.1 * i * phase.Duration).Speed <= way[phase.Stretch].Cap * (1.0 + 1e-12));
      }
      speed = phase.At(phase.Duration).Speed;
      lengths[phase.Stretch] = phase.At(phase.Duration).Distance;
      if (phase.Stretch == 3)
      {
        CHECK(speed >= -1e-9);
      }
    }
    for (int i = 0; i < 5; ++i)
    {
      CHECK(lengths[i] == Approx(way[i].Length).epsilon(1e-11));
    }
    // Without drag: v^2 = 2 a s from the stop at 135.5 m.
    CHECK(speed == Approx(std::sqrt(24.0)).epsilon(rate > 0.0 ? 0.1 : 1e-9));
  }
}
