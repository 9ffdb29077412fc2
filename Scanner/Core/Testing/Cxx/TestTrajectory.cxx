// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosTrajectory.h"

#include "vtkHeliosArrayNames.h"

#include <catch2/catch.hpp>
#include <vtkDoubleArray.h>
#include <vtkIntArray.h>
#include <vtkMath.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <cmath>
#include <limits>

namespace names = vtkHeliosArrayNames;

namespace
{

vtkDoubleArray* AddArray(vtkPolyData* data, const char* name, int components)
{
  vtkNew<vtkDoubleArray> array;
  array->SetName(name);
  array->SetNumberOfComponents(components);
  array->SetNumberOfTuples(data->GetNumberOfPoints());
  array->Fill(0.0);
  data->GetPointData()->AddArray(array);
  return array;
}

/// Samples of a motion at given times; with its velocity on request.
template <typename MotionT>
vtkSmartPointer<vtkPolyData> MakePath(
  const std::vector<double>& times, const MotionT& motion, bool withVelocity)
{
  auto path = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->SetNumberOfPoints(static_cast<vtkIdType>(times.size()));
  path->SetPoints(points);
  vtkDoubleArray* gps = AddArray(path, names::GpsTime, 1);
  vtkDoubleArray* velocity = withVelocity ? AddArray(path, names::Velocity, 3) : nullptr;
  for (std::size_t i = 0; i < times.size(); ++i)
  {
    helios::Vec3 p, v;
    motion(times[i], p, v);
    const auto id = static_cast<vtkIdType>(i);
    points->SetPoint(id, p.GetData());
    gps->SetValue(id, times[i]);
    if (velocity)
    {
      velocity->SetTuple(id, v.GetData());
    }
  }
  return path;
}

/// Polynomials of degree 3 in each coordinate.
void Cubic(double t, helios::Vec3& p, helios::Vec3& v)
{
  p = { 1.0 + t * (2.0 + t * (3.0 + 4.0 * t)), t * t * (5.0 - t), -7.0 * t };
  v = { 2.0 + t * (6.0 + 12.0 * t), t * (10.0 - 3.0 * t), -7.0 };
}

helios::Vec3 PositionAt(const helios::Trajectory& trajectory, double time)
{
  helios::Trajectory::Cursor cursor;
  helios::Rotation attitude;
  return trajectory.GetPosition(time, cursor, attitude);
}

} // namespace

TEST_CASE("Trajectory: with velocities a cubic is exact", "[Trajectory]")
{
  helios::Trajectory trajectory;
  REQUIRE(trajectory.Set(MakePath({ 0.0, 0.5, 2.0, 5.0 }, Cubic, true)).IsOk());
  for (double t = 0.0; t <= 5.0; t += 0.0625)
  {
    helios::Vec3 p, v;
    Cubic(t, p, v);
    INFO("t = " << t);
    for (int k = 0; k < 3; ++k)
    {
      CHECK(PositionAt(trajectory, t)[k] == Approx(p[k]).epsilon(1e-14).margin(1e-13));
      CHECK(trajectory.GetPose(t).Position[k] == PositionAt(trajectory, t)[k]);
    }
  }
}

TEST_CASE("Trajectory: without velocities it is linear", "[Trajectory]")
{
  helios::Trajectory trajectory;
  REQUIRE(trajectory.Set(MakePath({ 0.0, 2.0 }, Cubic, false)).IsOk());
  helios::Vec3 end, v;
  Cubic(2.0, end, v);
  CHECK(PositionAt(trajectory, 0.5)[0] == 1.0 + 0.25 * (end[0] - 1.0));
  CHECK(PositionAt(trajectory, 0.5)[1] == 0.25 * end[1]);
}

TEST_CASE("Trajectory: constant velocity equals the straight line to the bit", "[Trajectory]")
{
  const helios::Vec3 p0(500000.1, 5500000.7, 300.3);
  const helios::Vec3 way(700.3, -300.7, 11.1);
  const double duration = way.Norm() / 25.3;
  const helios::Vec3 speed = (25.3 / way.Norm()) * way;
  for (const double start : { 0.0, 1e5, 1.4e9 })
  {
    const auto motion = [&](double t, helios::Vec3& p, helios::Vec3& v)
    {
      p = t > start ? p0 + way : p0;
      v = speed;
    };
    helios::Trajectory curved, straight;
    REQUIRE(curved.Set(MakePath({ start, start + duration }, motion, true)).IsOk());
    REQUIRE(straight.Set(MakePath({ start, start + duration }, motion, false)).IsOk());
    int different = 0;
    for (double s = 0.0; s < 1.0; s += 1e-4)
    {
      const double t = start + s * duration;
      different += PositionAt(curved, t) == PositionAt(straight, t) ? 0 : 1;
    }
    INFO("start " << start);
    CHECK(different == 0);
  }
}

TEST_CASE("Trajectory: the orientation rotates at a constant rate, or holds", "[Trajectory]")
{
  auto path = MakePath({ 0.0, 1.0, 2.0 }, Cubic, true);
  vtkDoubleArray* turns = AddArray(path, names::Orientation, 4);
  for (int i = 0; i < 3; ++i)
  {
    const helios::Quaternion q = helios::AxisAngle({ 0.0, 0.0, 1.0 }, 20.0 * i);
    turns->SetTuple4(i, q[0], q[1], q[2], q[3]);
  }
  helios::Trajectory trajectory;
  REQUIRE(trajectory.Set(path).IsOk());
  // x of the body in the world, by both ways to a pose
  const auto getAngle = [&trajectory](double time)
  {
    helios::Trajectory::Cursor cursor;
    helios::Rotation attitude;
    trajectory.GetPosition(time, cursor, attitude);
    const helios::Vec3 x =
      helios::Rotation(trajectory.GetPose(time).Orientation) * helios::Vec3(1.0, 0.0, 0.0);
    CHECK(attitude.M[1][0] == Approx(x[1]).margin(1e-15));
    return vtkMath::DegreesFromRadians(std::atan2(x[1], x[0]));
  };
  CHECK(getAngle(0.75) == Approx(15.0));
  CHECK(getAngle(1.5) == Approx(30.0));
  trajectory.SetInterpolatesOrientation(false);
  CHECK(getAngle(0.75) == Approx(0.0).margin(1e-12));
  CHECK(getAngle(1.5) == Approx(20.0));
  CHECK(getAngle(2.0) == Approx(40.0));
  helios::Vec3 p, v;
  Cubic(0.75, p, v);
  CHECK(PositionAt(trajectory, 0.75)[0] == Approx(p[0])); // still moves
}

TEST_CASE("Trajectory: the samples of one leg", "[Trajectory]")
{
  auto path = MakePath({ 0.0, 1.0, 1.0, 3.0 }, Cubic, true);
  helios::Trajectory leg;
  CHECK(leg.SetLeg(path, 1).Message() == "the trajectory has no samples of leg 1");
  vtkNew<vtkIntArray> legs;
  legs->SetName(names::LegIds);
  for (const int id : { 0, 0, 1, 1 })
  {
    legs->InsertNextValue(id);
  }
  path->GetPointData()->AddArray(legs);
  REQUIRE(leg.SetLeg(path, 1).IsOk());
  CHECK(leg.GetStartTime() == 1.0);
  CHECK(leg.GetEndTime() == 3.0);
  CHECK(leg.GetPose(2.0).Position[0] == Approx(49.0).epsilon(1e-15));
  CHECK(leg.GetPose(0.0).Position[0] == 10.0); // before: the start
  CHECK(leg.GetPose(9.0).Position[2] == -21.0);
  CHECK(leg.SetLeg(path, 2).Message() == "the trajectory has no samples of leg 2");
}

TEST_CASE("Trajectory: bad velocities are errors", "[Trajectory]")
{
  auto path = MakePath({ 0.0, 1.0 }, Cubic, true);
  helios::Trajectory trajectory;
  SECTION("not a number")
  {
    path->GetPointData()
      ->GetArray(names::Velocity)
      ->SetComponent(1, 2, std::numeric_limits<double>::quiet_NaN());
    CHECK(trajectory.Set(path).Message() ==
      "sample 1 of the trajectory is not finite, or its orientation is not a unit quaternion");
  }
  SECTION("two components")
  {
    AddArray(path, names::Velocity, 2);
    CHECK(trajectory.Set(path).Message() ==
      "the array Velocity of the trajectory needs 3 components: x, y, z");
  }
}
