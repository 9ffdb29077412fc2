// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHeliosPlatform.h"

#include "heliosFloatCoordinates.h"
#include "heliosMotion.h"
#include "heliosSum.h"
#include "vtkHeliosArrayNames.h"

#include <vtkCellArray.h>
#include <vtkDataArray.h>
#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkIntArray.h>
#include <vtkMath.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>

#include <algorithm>
#include <cmath>

namespace names = vtkHeliosArrayNames;

namespace
{

/// Returns the first point that is not finite, or -1.
vtkIdType FindPointNotFinite(vtkPoints* points)
{
  for (vtkIdType i = 0; i < points->GetNumberOfPoints(); ++i)
  {
    double p[3];
    points->GetPoint(i, p);
    if (!std::isfinite(p[0]) || !std::isfinite(p[1]) || !std::isfinite(p[2]))
    {
      return i;
    }
  }
  return -1;
}

/// Adds an empty point array, allocated for all samples.
template <typename ArrayT>
void AddArray(vtkPolyData* output, ArrayT* array, const char* name, int components, vtkIdType count)
{
  array->SetName(name);
  array->SetNumberOfComponents(components);
  array->SetNumberOfTuples(count);
  output->GetPointData()->AddArray(array);
}

/// Adds one polyline through all points; one point is a vertex.
void AddCell(vtkPolyData* output)
{
  const vtkIdType count = output->GetNumberOfPoints();
  vtkNew<vtkCellArray> cells;
  cells->InsertNextCell(static_cast<int>(count));
  for (vtkIdType i = 0; i < count; ++i)
  {
    cells->InsertCellPoint(i);
  }
  if (count == 1)
  {
    output->SetVerts(cells);
  }
  else
  {
    output->SetLines(cells);
  }
}

} // namespace

//------------------------------------------------------------------------------
int vtkHeliosPlatform::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkPolyData* waypoints = vtkPolyData::GetData(inputVector[0], 0);
  vtkPolyData* output = vtkPolyData::GetData(outputVector, 0);
  std::vector<State> path;
  if (!this->CheckWaypoints(waypoints) || !this->Move(waypoints, path))
  {
    return 0;
  }
  this->BuildTrajectory(path, output);
  output->GetFieldData()->PassData(waypoints->GetFieldData());
  return 1;
}

//------------------------------------------------------------------------------
bool vtkHeliosPlatform::CheckWaypoints(vtkPolyData* waypoints)
{
  if (!waypoints || waypoints->GetNumberOfPoints() == 0)
  {
    vtkErrorMacro(<< "The input has no waypoints; give at least one point.");
    return false;
  }
  const vtkIdType bad = FindPointNotFinite(waypoints->GetPoints());
  if (bad >= 0)
  {
    const double* p = waypoints->GetPoint(bad);
    vtkErrorMacro(<< "Waypoint " << bad << " is (" << p[0] << ", " << p[1] << ", " << p[2]
                  << "); coordinates must be finite numbers.");
    return false;
  }
  const helios::Status status =
    helios::CheckFloatCoordinates(waypoints->GetPoints()->GetData(), "the list of waypoints");
  if (!status.IsOk())
  {
    vtkErrorMacro(<< status.Message());
    return false;
  }
  if (waypoints->GetPointData()->HasArray(names::LegIds) && !FindValues(waypoints, names::LegIds))
  {
    vtkErrorMacro(<< "The point array " << names::LegIds
                  << " of the waypoints must hold one number per waypoint.");
    return false;
  }
  return true;
}

//------------------------------------------------------------------------------
bool vtkHeliosPlatform::CheckSpeeds(vtkPolyData* waypoints, const char* kind)
{
  const vtkIdType count = waypoints->GetNumberOfPoints();
  if (count < 2)
  {
    vtkErrorMacro(<< kind << " needs two or more waypoints, the input has " << count
                  << "; add the end of the path, or use a static platform.");
    return false;
  }
  vtkDataArray* speeds = FindValues(waypoints, names::Speed);
  if (!speeds)
  {
    vtkErrorMacro(<< "The waypoints need the point array " << names::Speed
                  << ", one number per waypoint; add it, in m/s.");
    return false;
  }
  for (vtkIdType i = 0; i + 1 < count; ++i)
  {
    const double speed = speeds->GetTuple1(i);
    if (!(speed > 0.0) || !std::isfinite(speed))
    {
      vtkErrorMacro(<< names::Speed << " of waypoint " << i << " is " << speed
                    << " m/s; it must be positive and finite.");
      return false;
    }
  }
  return true;
}

//------------------------------------------------------------------------------
void vtkHeliosPlatform::AppendMotion(vtkPolyData* waypoints,
  const std::vector<helios::MotionPiece>& motion, std::vector<State>& path) const
{
  helios::Sum elapsed;
  vtkIdType leg = -1;
  for (const helios::MotionPiece& piece : motion)
  {
    const std::vector<helios::MotionSample> samples = helios::SamplePiece(piece);
    for (std::size_t i = piece.Waypoint == leg ? 1 : 0; i < samples.size(); ++i)
    {
      helios::Sum time = elapsed;
      time.Add(samples[i].Time);
      State state{};
      state.Time = std::max(path.empty() ? 0.0 : path.back().Time, this->StartTime + time.Get());
      std::copy_n(samples[i].State.Position.GetData(), 3, state.Position);
      std::copy_n(samples[i].State.Orientation.GetData(), 4, state.Orientation);
      std::copy_n(samples[i].State.Velocity.GetData(), 3, state.Velocity);
      state.LegId = GetLegId(waypoints, piece.Waypoint);
      path.push_back(state);
    }
    elapsed.Add(piece.Duration);
    leg = piece.Waypoint;
  }
}

//------------------------------------------------------------------------------
bool vtkHeliosPlatform::CheckDurations(
  vtkPolyData* waypoints, const std::vector<helios::MotionPiece>& motion, const char* cure)
{
  vtkDataArray* speeds = FindValues(waypoints, names::Speed);
  std::vector<double> durations(static_cast<std::size_t>(waypoints->GetNumberOfPoints()), 0.0);
  for (const helios::MotionPiece& piece : motion)
  {
    durations[static_cast<std::size_t>(piece.Waypoint)] += piece.Duration;
  }
  for (vtkIdType i = 0; i + 1 < waypoints->GetNumberOfPoints(); ++i)
  {
    double p[3], q[3];
    waypoints->GetPoint(i, p);
    waypoints->GetPoint(i + 1, q);
    const double way = std::sqrt(vtkMath::Distance2BetweenPoints(p, q));
    const double duration = durations[static_cast<std::size_t>(i)];
    if (!(duration <= 3600.0 + 1000.0 * way / speeds->GetTuple1(i)))
    {
      vtkErrorMacro(<< "Waypoint " << i + 1 << ", " << way << " m from waypoint " << i
                    << ", is reached only after " << duration << " s; " << cure);
      return false;
    }
  }
  return true;
}

//------------------------------------------------------------------------------
void vtkHeliosPlatform::BuildTrajectory(const std::vector<State>& path, vtkPolyData* output)
{
  const auto count = static_cast<vtkIdType>(path.size());
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->SetNumberOfPoints(count);
  output->SetPoints(points);

  vtkNew<vtkDoubleArray> time;
  vtkNew<vtkDoubleArray> orientation;
  vtkNew<vtkDoubleArray> velocity;
  vtkNew<vtkIntArray> legs;
  AddArray(output, time.Get(), names::GpsTime, 1, count);
  AddArray(output, orientation.Get(), names::Orientation, 4, count);
  AddArray(output, velocity.Get(), names::Velocity, 3, count);
  AddArray(output, legs.Get(), names::LegIds, 1, count);
  for (vtkIdType i = 0; i < count; ++i)
  {
    const State& state = path[static_cast<std::size_t>(i)];
    points->SetPoint(i, state.Position);
    time->SetValue(i, state.Time);
    orientation->SetTuple(i, state.Orientation);
    velocity->SetTuple(i, state.Velocity);
    legs->SetValue(i, state.LegId);
  }
  AddCell(output);
}

//------------------------------------------------------------------------------
vtkDataArray* vtkHeliosPlatform::FindValues(vtkPolyData* waypoints, const char* name)
{
  vtkDataArray* array = waypoints->GetPointData()->GetArray(name);
  const bool usable = array && array->GetNumberOfComponents() == 1 &&
    array->GetNumberOfTuples() == waypoints->GetNumberOfPoints();
  return usable ? array : nullptr;
}

//------------------------------------------------------------------------------
int vtkHeliosPlatform::GetLegId(vtkPolyData* waypoints, vtkIdType waypoint)
{
  vtkDataArray* legs = FindValues(waypoints, names::LegIds);
  return static_cast<int>(legs ? legs->GetTuple1(waypoint) : waypoint);
}

//------------------------------------------------------------------------------
void vtkHeliosPlatform::HeadingToOrientation(double x, double y, double orientation[4])
{
  const double half = 0.5 * std::atan2(-x, y); // about z, from the world's y axis
  orientation[0] = std::cos(half);
  orientation[1] = 0.0;
  orientation[2] = 0.0;
  orientation[3] = std::sin(half);
}

//------------------------------------------------------------------------------
void vtkHeliosPlatform::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "StartTime: " << this->StartTime << "\n";
}
