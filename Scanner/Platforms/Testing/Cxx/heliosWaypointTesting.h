// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Creates waypoints and reads trajectories, for the tests.

#ifndef heliosWaypointTesting_h
#define heliosWaypointTesting_h

#include "heliosHermite.h"
#include "vtkHeliosArrayNames.h"

#include <vtkDataArray.h>
#include <vtkDoubleArray.h>
#include <vtkMath.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <algorithm>
#include <array>
#include <string>
#include <vector>

namespace helios
{

using Point = std::array<double, 3>;

/// Waypoints, and their speeds if given.
inline vtkSmartPointer<vtkPolyData> MakeWaypoints(
  const std::vector<Point>& positions, const std::vector<double>& speeds = {})
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (const Point& p : positions)
  {
    points->InsertNextPoint(p.data());
  }
  auto waypoints = vtkSmartPointer<vtkPolyData>::New();
  waypoints->SetPoints(points);
  vtkNew<vtkDoubleArray> array;
  array->SetName(vtkHeliosArrayNames::Speed);
  for (const double speed : speeds)
  {
    array->InsertNextValue(speed);
  }
  if (!speeds.empty())
  {
    waypoints->GetPointData()->AddArray(array);
  }
  return waypoints;
}

/// Adds a point array with one component.
inline void AddValues(vtkPolyData* waypoints, const char* name, const std::vector<double>& values)
{
  vtkNew<vtkDoubleArray> array;
  array->SetName(name);
  for (const double value : values)
  {
    array->InsertNextValue(value);
  }
  waypoints->GetPointData()->AddArray(array);
}

/// The behaviour of a multicopter at its waypoints.
enum Mode
{
  Stop,
  Smooth,
  Through
};

inline vtkSmartPointer<vtkPolyData> MakeFlight(
  const std::vector<Point>& positions, const std::vector<double>& speeds, Mode mode)
{
  auto waypoints = MakeWaypoints(positions, speeds);
  AddValues(
    waypoints, vtkHeliosArrayNames::StopAndTurn, std::vector<double>(speeds.size(), mode == Stop));
  AddValues(
    waypoints, vtkHeliosArrayNames::SmoothTurn, std::vector<double>(speeds.size(), mode == Smooth));
  return waypoints;
}

/// A value of a point array.
inline double Value(vtkPolyData* data, const char* name, vtkIdType point, int component = 0)
{
  return data->GetPointData()->GetArray(name)->GetComponent(point, component);
}

/// A vector of the body at a sample, in the world.
inline Point BodyToWorld(vtkPolyData* path, vtkIdType sample, const Point& v)
{
  double q[4];
  path->GetPointData()->GetArray(vtkHeliosArrayNames::Orientation)->GetTuple(sample, q);
  double m[3][3];
  vtkMath::QuaternionToMatrix3x3(q, m);
  Point world;
  vtkMath::Multiply3x3(m, v.data(), world.data());
  return world;
}

/// The forward axis of the body at a sample, in the world.
inline Point ForwardAt(vtkPolyData* path, vtkIdType sample)
{
  return BodyToWorld(path, sample, { 0.0, 1.0, 0.0 });
}

/// The position between samples as in the scanner, searched from a sample at or before the time.
inline Vec3 PositionAt(vtkPolyData* path, double time)
{
  vtkIdType i = 0;
  for (vtkIdType high = path->GetNumberOfPoints() - 1; i + 1 < high;)
  {
    const vtkIdType middle = (i + high) / 2;
    (Value(path, vtkHeliosArrayNames::GpsTime, middle) <= time ? i : high) = middle;
  }
  double v0[3], v1[3];
  path->GetPointData()->GetArray(vtkHeliosArrayNames::Velocity)->GetTuple(i, v0);
  path->GetPointData()->GetArray(vtkHeliosArrayNames::Velocity)->GetTuple(i + 1, v1);
  const double t0 = Value(path, vtkHeliosArrayNames::GpsTime, i);
  const double t1 = Value(path, vtkHeliosArrayNames::GpsTime, i + 1);
  const HermiteSegment segment(
    t0, Vec3(path->GetPoint(i)), Vec3(v0), t1, Vec3(path->GetPoint(i + 1)), Vec3(v1));
  return segment(t1 > t0 ? std::clamp((time - t0) / (t1 - t0), 0.0, 1.0) : 1.0);
}

/// The distance of a sample from a point.
inline double GetMiss(vtkPolyData* path, vtkIdType sample, const Point& point)
{
  double p[3];
  path->GetPoint(sample, p);
  return std::sqrt(vtkMath::Distance2BetweenPoints(p, point.data()));
}

/// The samples of a leg, [first, last].
inline std::array<vtkIdType, 2> FindLeg(vtkPolyData* path, int leg)
{
  std::array<vtkIdType, 2> ends{ -1, -1 };
  for (vtkIdType i = 0; i < path->GetNumberOfPoints(); ++i)
  {
    if (Value(path, vtkHeliosArrayNames::LegIds, i) == static_cast<double>(leg))
    {
      ends[0] = ends[0] < 0 ? i : ends[0];
      ends[1] = i;
    }
  }
  return ends;
}

/// Why a trajectory is not valid; empty if it is: times must not decrease, a
/// leg starts when the one before ends, no jumps, velocities match the positions.
inline std::string FindFlaw(vtkPolyData* path, double tolerance)
{
  for (vtkIdType i = 1; i < path->GetNumberOfPoints(); ++i)
  {
    const double t0 = Value(path, vtkHeliosArrayNames::GpsTime, i - 1);
    const double t1 = Value(path, vtkHeliosArrayNames::GpsTime, i);
    const double leg0 = Value(path, vtkHeliosArrayNames::LegIds, i - 1);
    const double leg1 = Value(path, vtkHeliosArrayNames::LegIds, i);
    Point mean{};
    Point way{};
    for (int k = 0; k < 3; ++k)
    {
      mean[k] = 0.5 * (t1 - t0) *
        (Value(path, vtkHeliosArrayNames::Velocity, i - 1, k) +
          Value(path, vtkHeliosArrayNames::Velocity, i, k));
      way[k] = path->GetPoint(i)[k] - path->GetPoint(i - 1)[k];
    }
    const double gap = std::sqrt(vtkMath::Distance2BetweenPoints(mean.data(), way.data()));
    if (!(t1 >= t0))
    {
      return "time goes back at sample " + std::to_string(i);
    }
    if (leg1 != leg0 && (leg1 != leg0 + 1.0 || t1 != t0))
    {
      return "legs do not join at sample " + std::to_string(i);
    }
    if (!(gap <= tolerance))
    {
      return "a jump of " + std::to_string(gap) + " at sample " + std::to_string(i);
    }
  }
  return {};
}

} // namespace helios

#endif
