// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Motions of parts compared with their closed forms.
#include "heliosPartMotion.h"

#include "heliosMovingParts.h"

#include <catch2/catch.hpp>

#include <cmath>

using helios::Motion;
using helios::MotionKind;
using helios::MotionSequence;
using helios::PartMotion;
using helios::Vec3;

namespace
{

constexpr double Radians = 0.017453292519943295;
constexpr auto None = MotionSequence::None;

Motion Make(MotionKind kind, const Vec3& vector, double angle = 0.0)
{
  Motion motion;
  motion.Kind = kind;
  motion.Vector = vector;
  motion.Angle = angle;
  return motion;
}

PartMotion Endless(const Motion& motion, const Vec3& centroid = Vec3(0, 0, 0))
{
  return PartMotion({ { { motion }, 0, None } }, centroid);
}

void CheckPoint(const Vec3& p, const Vec3& expected, double margin = 1e-12)
{
  INFO(p[0] << " " << p[1] << " " << p[2]);
  INFO((p - expected).Norm() * 1e12 << "e-12");
  CHECK((p - expected).Norm() <= margin);
}

} // namespace

TEST_CASE("PartMotion: a translation is k times its vector", "[PartMotion]")
{
  const PartMotion motion = Endless(Make(MotionKind::Translation, Vec3(0.1, -0.3, 1e-3)));
  CHECK(motion.GetMap(0) * Vec3(1, 2, 3) == Vec3(1, 2, 3));
  const helios::MotionMap map = motion.GetMap(1000000);
  CHECK_FALSE(map.Turns);
  CHECK(map.Shift[0] == 0.1 * 1e6);
  CHECK(map.Shift[1] == -0.3 * 1e6);
  CHECK(map.Shift[2] == 1e-3 * 1e6);
  CHECK(motion.FindNextMove(41) == 42);
}

TEST_CASE("PartMotion: a rotation by k times its angle, without drift", "[PartMotion]")
{
  Motion turn = Make(MotionKind::Rotation, Vec3(0, 0, 3), 0.75);
  turn.Center = Vec3(10, 20, 0);
  const PartMotion motion = Endless(turn);
  for (const vtkIdType k : { vtkIdType(1), vtkIdType(45), vtkIdType(1000001) })
  {
    const double angle = Radians * 0.25 * static_cast<double>(3 * k % 1440);
    CheckPoint(motion.GetMap(k) * Vec3(12, 20, 5),
      Vec3(10 + 2 * std::cos(angle), 20 + 2 * std::sin(angle), 5));
  }
}

TEST_CASE("PartMotion: a third of a rotation about the diagonal permutes the axes", "[PartMotion]")
{
  const PartMotion motion = Endless(Make(MotionKind::Rotation, Vec3(1, 1, 1), 120));
  CheckPoint(motion.GetMap(1) * Vec3(1, 2, 3), Vec3(3, 1, 2), 1e-15);
  CheckPoint(motion.GetMap(999999) * Vec3(1, 2, 3), Vec3(1, 2, 3));
}

TEST_CASE("PartMotion: exact far from the origin", "[PartMotion]")
{
  const Vec3 far(500000.25, 5500000.5, 100);
  Motion turn = Make(MotionKind::Rotation, Vec3(0, 0, 1), 90);
  turn.Center = far;
  CheckPoint(Endless(turn, far).GetMap(1000001) * (far + Vec3(1, 0, 0)), far + Vec3(0, 1, 0), 0.0);
}

TEST_CASE("PartMotion: helical motion", "[PartMotion]")
{
  Motion helix = Make(MotionKind::Helical, Vec3(0, 0, 2), 1.0);
  helix.Glide = 0.25;
  CheckPoint(Endless(helix).GetMap(720030) * Vec3(2, 0, 1),
    Vec3(2 * std::cos(30 * Radians), 1.0, 1 + 0.25 * 720030), 1e-10); // relative to 180 km
}

TEST_CASE("PartMotion: reflections", "[PartMotion]")
{
  const PartMotion mirror = Endless(Make(MotionKind::Reflection, Vec3(0, 5, 0)));
  CheckPoint(mirror.GetMap(1) * Vec3(1, 2, 3), Vec3(1, -2, 3), 0.0);
  CheckPoint(mirror.GetMap(2) * Vec3(1, 2, 3), Vec3(1, 2, 3), 0.0);

  Motion glide = Make(MotionKind::GlidePlane, Vec3(0, 1, 0));
  glide.Shift = Vec3(0.5, 0, 0);
  CheckPoint(Endless(glide).GetMap(3) * Vec3(1, 2, 3), Vec3(2.5, -2, 3), 1e-15);

  Motion rotary = Make(MotionKind::RotaryReflection, Vec3(0, 0, 1), 90);
  rotary.Center = Vec3(1, 0, 1);
  CheckPoint(Endless(rotary).GetMap(1) * Vec3(2, 0, 3), Vec3(1, 1, -1), 1e-15);
  CheckPoint(Endless(rotary).GetMap(4) * Vec3(2, 0, 3), Vec3(2, 0, 3), 1e-15);
}

TEST_CASE("PartMotion: rotation about the current centroid", "[PartMotion]")
{
  const Vec3 centroid(10, 0, 0);
  Motion spin = Make(MotionKind::Rotation, Vec3(0, 0, 1), 90);
  spin.IsSelf = true;
  CheckPoint(Endless(spin, centroid).GetMap(1) * Vec3(11, 0, 0), Vec3(10, 1, 0), 1e-15);

  // A planet: a step around the origin, and one around its own axis.
  const PartMotion planet(
    { { { Make(MotionKind::Rotation, Vec3(0, 0, 1), 2), spin }, 0, None } }, centroid);
  for (const int k : { 1, 7, 100001 })
  {
    const double path = 2 * k % 360 * Radians;
    const double all = 92 * k % 360 * Radians;
    CheckPoint(planet.GetMap(k) * Vec3(11, 0, 0),
      Vec3(10 * std::cos(path) + std::cos(all), 10 * std::sin(path) + std::sin(all), 0), 1e-11);
  }

  Motion arm = spin; // about a point beside the centroid, which moves on a circle
  arm.Center = Vec3(1, 0, 0);
  CheckPoint(Endless(arm, centroid).GetMap(1) * centroid, Vec3(11, -1, 0), 1e-15);
  CheckPoint(Endless(arm, centroid).GetMap(2) * centroid, Vec3(12, -2, 0), 1e-15);
}

TEST_CASE("PartMotion: motions of a step are applied in order", "[PartMotion]")
{
  const Motion move = Make(MotionKind::Translation, Vec3(1, 0, 0));
  const Motion turn = Make(MotionKind::Rotation, Vec3(0, 0, 1), 90);
  CheckPoint(PartMotion({ { { move, turn }, 0, None } }).GetMap(1) * Vec3(0, 0, 0), Vec3(0, 1, 0));
  CheckPoint(PartMotion({ { { turn, move }, 0, None } }).GetMap(1) * Vec3(0, 0, 0), Vec3(1, 0, 0));
}

TEST_CASE("PartMotion: sequences of motions", "[PartMotion]")
{
  const Motion x = Make(MotionKind::Translation, Vec3(1, 0, 0));
  const Motion y = Make(MotionKind::Translation, Vec3(0, 1, 0));
  const Motion rest;
  const Vec3 o(0, 0, 0);
  SECTION("and end")
  {
    const PartMotion motion({ { { x }, 3, 1 }, { { y }, 2, None } });
    CheckPoint(motion.GetMap(2) * o, Vec3(2, 0, 0), 0.0);
    CheckPoint(motion.GetMap(4) * o, Vec3(3, 1, 0), 0.0);
    CheckPoint(motion.GetMap(1000) * o, Vec3(3, 2, 0), 0.0);
    CHECK(motion.FindNextMove(0) == 1);
    CHECK(motion.FindNextMove(4) == 5);
    CHECK(motion.FindNextMove(5) == VTK_ID_MAX);
    CHECK(motion.FindLastMove(3) == 3);
    CHECK(motion.FindLastMove(1000000) == 5);
  }
  SECTION("a sequence that ends at rest")
  {
    const PartMotion motion({ { { x }, 3, 1 }, { { rest }, 2, 2 }, { { rest }, 2, 1 } });
    CHECK(motion.FindNextMove(2) == 3);
    CHECK(motion.FindNextMove(3) == VTK_ID_MAX);
    CHECK(motion.FindLastMove(2) == 2);
    CHECK(motion.FindLastMove(4001) == 3);
    CheckPoint(motion.GetMap(4001) * o, Vec3(3, 0, 0), 0.0);
  }
  SECTION("the last one continues")
  {
    const PartMotion motion({ { { x }, 3, 2 }, { { x }, 1, None }, { { y }, 0, 0 } });
    CheckPoint(motion.GetMap(1000003) * o, Vec3(3, 1000000, 0), 0.0);
    CHECK(motion.FindNextMove(1000003) == 1000004);
  }
  SECTION("the sequence repeats")
  {
    // once 2 x; then 3 y and 5 steps of rest, repeated
    const PartMotion motion({ { { x }, 2, 1 }, { { y }, 3, 2 }, { { rest }, 5, 1 } });
    CheckPoint(motion.GetMap(1) * o, Vec3(1, 0, 0), 0.0);
    CheckPoint(motion.GetMap(2) * o, Vec3(2, 0, 0), 0.0);
    CheckPoint(motion.GetMap(5) * o, Vec3(2, 3, 0), 0.0);
    CheckPoint(motion.GetMap(10) * o, Vec3(2, 3, 0), 0.0);
    CheckPoint(motion.GetMap(11) * o, Vec3(2, 4, 0), 0.0);
    CheckPoint(motion.GetMap(2 + 8 * 1000 + 2) * o, Vec3(2, 3002, 0), 0.0);
    CHECK(motion.FindNextMove(1) == 2);
    CHECK(motion.FindNextMove(4) == 5);
    CHECK(motion.FindNextMove(5) == 11);
    CHECK(motion.FindNextMove(2 + 8 * 1000 + 3) == 2 + 8 * 1001 + 1);
    CHECK(motion.FindLastMove(0) == 0);
    CHECK(motion.FindLastMove(2) == 2);
    CHECK(motion.FindLastMove(4) == 4);
    CHECK(motion.FindLastMove(10) == 5);
    CHECK(motion.FindLastMove(11) == 11);
    CHECK(motion.FindLastMove(2 + 8 * 1000 + 7) == 2 + 8 * 1000 + 3);
    CHECK(motion.IsMoving());
  }
  SECTION("all of them at rest")
  {
    CHECK_FALSE(PartMotion({ { { rest }, 2, 1 }, { { rest, rest }, 3, 0 } }).IsMoving());
    CHECK_FALSE(PartMotion({ { { rest }, 0, None } }).IsMoving());
    CHECK_FALSE(PartMotion({}).IsMoving());
  }
}

TEST_CASE("PartMotion: the centroid of placed triangles is the placed centroid", "[PartMotion]")
{
  const bool isFlat = GENERATE(true, false); // triangles without area count by their corners
  const double quaternion[4] = { 0.8, 0.1, -0.3, 0.5 };
  const double shift[3] = { 4e5, 5e6, 100.0 };
  const helios::Similarity place(quaternion, 2.5, shift);
  const double beside[3][3] = { { 4e5, 5e6, 0.0 }, { 4e5 + 9.0, 5e6, 0.0 },
    { 4e5, 5e6 + 9.0, 0.0 } };
  helios::CentroidSum own, placed, each;
  for (int i = 0; i < 20; ++i)
  {
    const double top = isFlat ? 0.0 : 1.0 + i % 3;
    const double corners[3][3] = { { 1.0 * i, 0.0, 0.0 }, { i + 2.0, 0.0, 0.0 },
      { i + 1.0, top, top } };
    double moved[3][3];
    for (int k = 0; k < 3; ++k)
    {
      place.Apply(corners[k], moved[k]);
    }
    own.Add(corners[0], corners[1], corners[2]);
    each.Add(moved[0], moved[1], moved[2]);
  }
  placed.Add(helios::CentroidSum(), place);
  placed.Add(own, place);
  const double mean[3] = { 10.5, 0.0, 0.0 };
  Vec3 expected = each.Get();
  isFlat ? place.Apply(mean, expected.GetData()) : void();
  CheckPoint(placed.Get(), expected, 2e-9);
  placed.Add(beside[0], beside[1], beside[2]);
  each.Add(beside[0], beside[1], beside[2]);
  CheckPoint(placed.Get(), isFlat ? Vec3(4e5 + 3.0, 5e6 + 3.0, 0.0) : each.Get(), 2e-9);
}
