// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHeliosMulticopterPlatform.h"

#include "heliosConstants.h"
#include "heliosFlightMotion.h"
#include "vtkHeliosArrayNames.h"

#include <vtkDataArray.h>
#include <vtkMath.h>
#include <vtkObjectFactory.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>

#include <cmath>

namespace names = vtkHeliosArrayNames;

vtkStandardNewMacro(vtkHeliosMulticopterPlatform);

namespace
{

/// Returns the array value of a waypoint; the default if missing.
double GetValue(vtkDataArray* array, vtkIdType waypoint, double otherwise)
{
  return array ? array->GetTuple1(waypoint) : otherwise;
}

helios::Passing GetPassing(bool stops, bool smooth)
{
  return smooth ? helios::Passing::Smooth
                : (stops ? helios::Passing::Stop : helios::Passing::Through);
}

} // namespace

//------------------------------------------------------------------------------
bool vtkHeliosMulticopterPlatform::Move(vtkPolyData* waypoints, std::vector<State>& path)
{
  if (!this->CheckSpeeds(waypoints, "A flight") || !this->CheckWaypointArrays(waypoints) ||
    !this->CheckPath(waypoints))
  {
    return false;
  }
  vtkDataArray* speeds = FindValues(waypoints, names::Speed);
  vtkDataArray* stops = FindValues(waypoints, names::StopAndTurn);
  vtkDataArray* smooth = FindValues(waypoints, names::SmoothTurn);
  vtkDataArray* yaws = FindValues(waypoints, names::YawAtDeparture);
  std::vector<helios::FlightWaypoint> points;
  std::vector<double> courses;
  for (vtkIdType i = 0; i < waypoints->GetNumberOfPoints(); ++i)
  {
    points.push_back({ helios::Vec3(waypoints->GetPoint(i)), speeds->GetTuple1(i),
      GetPassing(GetValue(stops, i, 1.0) != 0.0, GetValue(smooth, i, 0.0) != 0.0) });
    courses.push_back(vtkMath::RadiansFromDegrees(90.0 - GetValue(yaws, i, vtkMath::Nan())));
  }
  const double thrust =
    this->MaximumThrust > 0.0 ? this->MaximumThrust / this->Mass : 2.0 * helios::StandardGravity;
  const helios::Copter copter{ vtkMath::RadiansFromDegrees(this->MaximumPitch),
    vtkMath::RadiansFromDegrees(this->MaximumRoll), vtkMath::RadiansFromDegrees(this->PitchRate),
    vtkMath::RadiansFromDegrees(this->RollRate), vtkMath::RadiansFromDegrees(this->YawRate), thrust,
    this->DragCoefficient / this->Mass, this->TimeStep };

  const helios::FlightPath flight = helios::PlanFlight(points, copter);
  if (!this->SlowdownEnabled && !flight.Slowed.empty())
  {
    vtkWarningMacro(<< "SlowdownEnabled is off, but waypoint " << flight.Slowed.front()
                    << (flight.Slowed.size() > 1 ? " and others are" : " is")
                    << " passed more slowly than " << names::Speed
                    << ", or stopped at, since the turn does not fit; lower " << names::Speed
                    << " or raise MaximumRoll.");
  }
  const auto motion = helios::FlyPath(flight, copter, courses, this->SlowdownDistance);
  if (!this->CheckDurations(
        waypoints, motion, "raise MaximumThrust or MaximumPitch, or lower DragCoefficient."))
  {
    return false;
  }
  this->AppendMotion(waypoints, motion, path);
  return true;
}

//------------------------------------------------------------------------------
bool vtkHeliosMulticopterPlatform::CheckWaypointArrays(vtkPolyData* waypoints)
{
  for (const char* name : { names::StopAndTurn, names::SmoothTurn, names::YawAtDeparture })
  {
    if (waypoints->GetPointData()->HasArray(name) && !FindValues(waypoints, name))
    {
      vtkErrorMacro(<< "The point array " << name
                    << " of the waypoints must hold one number per waypoint.");
      return false;
    }
  }
  return true;
}

//------------------------------------------------------------------------------
bool vtkHeliosMulticopterPlatform::CheckPath(vtkPolyData* waypoints)
{
  const double weight = this->Mass * helios::StandardGravity;
  if (this->MaximumThrust > 0.0 && !(this->MaximumThrust > 1.01 * weight))
  {
    vtkErrorMacro(<< "Waypoint 1 cannot be reached: MaximumThrust is " << this->MaximumThrust
                  << " N, " << this->Mass << " kg need more than " << 1.01 * weight
                  << " N to fly; raise it or lower Mass.");
    return false;
  }
  if (this->DragCoefficient > this->Mass)
  {
    vtkErrorMacro(<< "Waypoint 1 cannot be reached: DragCoefficient is " << this->DragCoefficient
                  << " kg/m, too high for " << this->Mass
                  << " kg to fly; lower it to less than Mass per metre.");
    return false;
  }
  for (vtkIdType i = 1; i < waypoints->GetNumberOfPoints(); ++i)
  {
    double p[3], q[3];
    waypoints->GetPoint(i - 1, p);
    waypoints->GetPoint(i, q);
    const double way = std::hypot(q[0] - p[0], q[1] - p[1], q[2] - p[2]);
    if (!(way < 1e9))
    {
      vtkErrorMacro(<< "Waypoint " << i << " is " << way << " m from waypoint " << i - 1
                    << ", too far to fly; move it closer.");
      return false;
    }
  }
  return true;
}

//------------------------------------------------------------------------------
void vtkHeliosMulticopterPlatform::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Mass: " << this->Mass << "\n";
  os << indent << "MaximumThrust: " << this->MaximumThrust << "\n";
  os << indent << "DragCoefficient: " << this->DragCoefficient << "\n";
  os << indent << "MaximumPitch: " << this->MaximumPitch << "\n";
  os << indent << "MaximumRoll: " << this->MaximumRoll << "\n";
  os << indent << "PitchRate: " << this->PitchRate << "\n";
  os << indent << "RollRate: " << this->RollRate << "\n";
  os << indent << "YawRate: " << this->YawRate << "\n";
  os << indent << "SlowdownEnabled: " << this->SlowdownEnabled << "\n";
  os << indent << "SlowdownDistance: " << this->SlowdownDistance << "\n";
  os << indent << "TimeStep: " << this->TimeStep << "\n";
}
