// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosPose.h"

#include <catch2/catch.hpp>

namespace
{

void CheckNear(const helios::Vec3& a, double x, double y, double z)
{
  CHECK(a[0] == Approx(x).margin(1e-15));
  CHECK(a[1] == Approx(y).margin(1e-15));
  CHECK(a[2] == Approx(z).margin(1e-15));
}

} // namespace

TEST_CASE("AxisAngle: right-handed", "[Pose]")
{
  CheckNear(helios::Rotate(helios::AxisAngle({ 0, 0, 2 }, 90), { 1, 0, 0 }), 0, 1, 0);
  CheckNear(helios::Rotate(helios::AxisAngle({ 1, 0, 0 }, 90), { 0, 1, 0 }), 0, 0, 1);
}

TEST_CASE("Rotation: equals its quaternion, and composes", "[Pose]")
{
  const helios::Quaternion a = helios::AxisAngle({ 1, 2, 3 }, 40);
  const helios::Quaternion b = helios::AxisAngle({ -2, 1, 0.5 }, 75);
  const helios::Vec3 v(0.3, -0.7, 0.2);
  const helios::Vec3 expected = helios::Rotate(a, helios::Rotate(b, v));
  const helios::Vec3 together = (helios::Rotation(a) * helios::Rotation(b)) * v;
  CheckNear(together, expected[0], expected[1], expected[2]);
}

TEST_CASE("Pose: the lever arm rotates with the attitude", "[Pose]")
{
  const helios::Pose platform{ { 10, 20, 30 }, helios::AxisAngle({ 0, 0, 1 }, 90) };
  const helios::Pose mount{ { 1, 0, 0.5 }, helios::AxisAngle({ 1, 0, 0 }, 90) };
  const helios::Pose scanner = platform * mount;
  CheckNear(scanner.Position, 10, 21, 30.5);
  // y of the scanner: up by the mount, independent of the heading
  CheckNear(helios::Rotate(scanner.Orientation, { 0, 1, 0 }), 0, 0, 1);
}
