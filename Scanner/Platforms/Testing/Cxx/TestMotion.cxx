// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosFlightMotion.h"
#include "heliosHermite.h"
#include "heliosMotion.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace
{

const double Pi = std::acos(-1.0);

/// The maximum deviation of samples from a piece, at any time [m], [rad].
std::pair<double, double> GetErrors(
  const helios::MotionPiece& piece, const std::vector<helios::MotionSample>& samples)
{
  double position = 0.0;
  double attitude = 0.0;
  for (std::size_t i = 1; i < samples.size(); ++i)
  {
    const auto& a = samples[i - 1];
    const auto& b = samples[i];
    const helios::HermiteSegment segment(
      a.Time, a.State.Position, a.State.Velocity, b.Time, b.State.Position, b.State.Velocity);
    for (int k = 1; k < 10; ++k) // ten times as dense
    {
      const auto truth = piece.At(a.Time + 0.1 * k * (b.Time - a.Time));
      position = std::max(position, (segment(0.1 * k) - truth.Position).Norm());
      const auto q = a.State.Orientation.Slerp(0.1 * k, b.State.Orientation).Normalized();
      const auto d = q.Conjugated() * truth.Orientation;
      attitude = std::max(
        attitude, 2.0 * std::sqrt(d.GetX() * d.GetX() + d.GetY() * d.GetY() + d.GetZ() * d.GetZ()));
    }
  }
  return { position, attitude };
}

} // namespace

TEST_CASE("Motion: a circle has the minimum number of samples", "[Motion]")
{
  // The cubic between two samples of a circle is R phi^4 / 384 off.
  const helios::MotionPiece circle{ 0, 2.0 * Pi,
    [](double t)
    {
      return helios::MotionState{ { 100.0 * std::cos(t), 100.0 * std::sin(t), 0.0 },
        { -100.0 * std::sin(t), 100.0 * std::cos(t), 0.0 },
        helios::AxisAngle({ 0.0, 0.0, 1.0 }, t * 180.0 / Pi) };
    } };
  const auto samples = helios::SamplePiece(circle);
  const auto errors = GetErrors(circle, samples);
  CHECK(errors.first < 1e-7);
  CHECK(errors.first > 1e-9);
  CHECK(errors.second < 1e-12); // it rotates at a constant rate
  const double needed = 2.0 * Pi / std::pow(384e-9, 0.25);
  CHECK(static_cast<double>(samples.size()) > needed);
  CHECK(static_cast<double>(samples.size()) < 4.0 * needed);
  CHECK(samples.front().Time == 0.0);
  CHECK(samples.back().Time == 2.0 * Pi);
}

TEST_CASE("Motion: a straight line at rest or at constant speed has two samples", "[Motion]")
{
  const helios::MotionPiece line{ 0, 3600.0,
    [](double t)
    {
      return helios::MotionState{ { 5e5 + 3.3 * t, 5e6 - 0.7 * t, 1.0 }, { 3.3, -0.7, 0.0 },
        helios::Quaternion() };
    } };
  CHECK(helios::SamplePiece(line).size() == 2);
}

TEST_CASE("Motion: samples of a flight are within 1e-7", "[Motion]")
{
  const helios::Copter copter{ 0.6, 0.45, 1.5, 0.5, 1.5, 20.0, 0.02, 0.01 };
  using helios::Passing;
  const double none = std::numeric_limits<double>::quiet_NaN();
  const auto path = helios::PlanFlight(
    { { { 0.0, 0.0, 30.0 }, 12.0, Passing::Stop }, { { 0.0, 200.0, 30.0 }, 10.0, Passing::Smooth },
      { { 200.0, 200.0, 60.0 }, 20.0, Passing::Through },
      { { 300.0, 400.0, 30.0 }, 10.0, Passing::Stop },
      { { 0.0, 500.0, 30.0 }, 1.0, Passing::Stop } },
    copter);
  double position = 0.0;
  double attitude = 0.0;
  std::size_t count = 0;
  for (const auto& piece : helios::FlyPath(path, copter, std::vector<double>(5, none), 0.0))
  {
    const auto samples = helios::SamplePiece(piece);
    const auto errors = GetErrors(piece, samples);
    position = std::max(position, errors.first);
    attitude = std::max(attitude, errors.second);
    count += samples.size();
  }
  CHECK(position < 1e-7);
  CHECK(attitude < 1e-7);
  CHECK(attitude > 1e-9);
  CHECK(count < 20000);
}

TEST_CASE("Motion: the body tilts to the thrust", "[Motion]")
{
  for (const double course : { -2.0, 0.0, 0.5 * Pi, 3.0 })
  {
    helios::Vec3 thrust(1.5, -2.5, 8.0);
    const auto q = helios::TiltTo(thrust, course);
    thrust.Normalize();
    CHECK((helios::Rotate(q, { 0.0, 0.0, 1.0 }) - thrust).Norm() < 1e-15);
    const auto nose = helios::Rotate(q, { 0.0, 1.0, 0.0 });
    CHECK(std::atan2(nose[1], nose[0]) == Approx(course).margin(1e-15));
  }
}
