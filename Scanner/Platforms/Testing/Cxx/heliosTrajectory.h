// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Makes waypoints and reads trajectories, for the tests.

#ifndef heliosTrajectory_h
#define heliosTrajectory_h

#include "vtkHeliosArrayNames.h"

#include <vtkDataArray.h>
#include <vtkDoubleArray.h>
#include <vtkMath.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <array>
#include <vector>

namespace helios
{

using Point = std::array<double, 3>;

/// Waypoints, and their speeds where there are any.
inline vtkSmartPointer<vtkPolyData> MakeWaypoints(const std::vector<Point>& positions,
  const std::vector<double>& speeds = {})
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

/// A number of a point array.
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

} // namespace helios

#endif
