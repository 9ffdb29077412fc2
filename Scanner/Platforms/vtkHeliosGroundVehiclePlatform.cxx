// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHeliosGroundVehiclePlatform.h"

#include "heliosConstants.h"
#include "heliosGroundPath.h"
#include "heliosMotion.h"
#include "heliosSpeedProfile.h"
#include "vtkHeliosArrayNames.h"

#include <vtkDataArray.h>
#include <vtkMath.h>
#include <vtkObjectFactory.h>
#include <vtkPolyData.h>

#include <algorithm>
#include <cmath>
#include <memory>

namespace names = vtkHeliosArrayNames;

vtkStandardNewMacro(vtkHeliosGroundVehiclePlatform);

namespace
{

/// The body: its pitch along an element.
struct Ride
{
  helios::GroundElement Element;
  double NextGrade = 0.0; // after the run of elements that contains this one
  double ToRunEnd = 0.0;  // from the end of this element [m]
  double Blend = 1.0;     // over which the body pitches to the next grade [m]

  double GetPitch(double s) const
  {
    const double left = this->ToRunEnd + this->Element.Length - s;
    const double share = std::max(0.0, 1.0 - left / this->Blend);
    return std::atan(this->Element.Grade + share * (this->NextGrade - this->Element.Grade));
  }

  helios::MotionState GetState(const helios::Travel& travel) const
  {
    const double cosine = 1.0 / std::hypot(1.0, this->Element.Grade);
    const double s = std::clamp(travel.Distance * cosine, 0.0, this->Element.Length);
    const helios::GroundElement::Place place = this->Element.At(s);
    const double v = travel.Speed * cosine;
    const double c = std::cos(place.Course);
    const double n = std::sin(place.Course);
    // The body's y axis along the path, or against it, and pitched.
    const double course = place.Course + (this->Element.Backward ? -vtkMath::Pi() : 0.0);
    const double yaw = 0.5 * (course - 0.5 * vtkMath::Pi());
    const double pitch = 0.5 * this->GetPitch(s);
    return { place.Position, { v * c, v * n, v * this->Element.Grade },
      helios::Quaternion(std::cos(yaw) * std::cos(pitch), std::cos(yaw) * std::sin(pitch),
        std::sin(yaw) * std::sin(pitch), std::sin(yaw) * std::cos(pitch)) };
  }
};

/// Returns whether two elements are driven without a change of slope between them.
bool IsSameRun(const helios::GroundElement& a, const helios::GroundElement& b)
{
  return a.Waypoint == b.Waypoint && a.Backward == b.Backward;
}

std::vector<Ride> MakeRides(const std::vector<helios::GroundElement>& path, double wheelbase)
{
  std::vector<Ride> rides(path.size());
  for (std::size_t i = path.size(); i-- > 0;)
  {
    const bool isLast = i + 1 == path.size();
    const bool sameRun = !isLast && IsSameRun(path[i], path[i + 1]);
    rides[i].Element = path[i];
    rides[i].NextGrade =
      isLast ? path[i].Grade : (sameRun ? rides[i + 1].NextGrade : path[i + 1].Grade);
    rides[i].ToRunEnd = sameRun ? rides[i + 1].ToRunEnd + path[i + 1].Length : 0.0;
  }
  double run = 0.0;
  for (std::size_t i = 0; i < rides.size(); ++i)
  {
    const bool sameRun = i > 0 && IsSameRun(path[i - 1], path[i]);
    run = sameRun ? run : rides[i].ToRunEnd + path[i].Length;
    rides[i].Blend = std::min(run, wheelbase);
  }
  return rides;
}

/// Returns a pause at a waypoint: at rest, for zero time.
helios::MotionPiece Pause(vtkIdType waypoint, const helios::MotionState& state)
{
  return { waypoint, 0.0, [state](double) { return state; } };
}

/// Returns the motion, leg after leg; legs of zero length are pauses.
std::vector<helios::MotionPiece> MakeMotion(
  const std::vector<Ride>& rides, const std::vector<helios::SpeedPhase>& phases, vtkIdType legs)
{
  std::vector<helios::MotionPiece> motion;
  std::size_t phase = 0;
  for (vtkIdType leg = 0; leg < legs; ++leg)
  {
    const std::size_t first = phase;
    for (; phase < phases.size() &&
         rides[phases[phase].Stretch].Element.Waypoint == static_cast<std::size_t>(leg);
         ++phase)
    {
      const helios::SpeedPhase part = phases[phase];
      const auto ride = std::make_shared<Ride>(rides[part.Stretch]);
      motion.push_back(
        { leg, part.Duration, [ride, part](double t) { return ride->GetState(part.At(t)); } });
    }
    if (phase == first)
    {
      motion.push_back(Pause(leg,
        motion.empty() ? rides.front().GetState({ 0.0, 0.0 })
                       : motion.back().At(motion.back().Duration)));
    }
  }
  return motion;
}

} // namespace

//------------------------------------------------------------------------------
bool vtkHeliosGroundVehiclePlatform::Move(vtkPolyData* waypoints, std::vector<State>& path)
{
  if (!this->CheckSpeeds(waypoints, "A vehicle's path") || !this->CheckPath(waypoints))
  {
    return false;
  }
  vtkDataArray* speeds = FindValues(waypoints, names::Speed);
  std::vector<helios::GroundWaypoint> points;
  for (vtkIdType i = 0; i < waypoints->GetNumberOfPoints(); ++i)
  {
    points.push_back({ helios::Vec3(waypoints->GetPoint(i)), speeds->GetTuple1(i) });
  }
  const helios::Steering steering{ this->Wheelbase,
    vtkMath::RadiansFromDegrees(this->MaximumSteeringAngle),
    vtkMath::RadiansFromDegrees(this->SteeringRate), this->LateralAcceleration,
    this->TurnDeviation };
  const std::vector<helios::GroundElement> elements = helios::PlanGroundPath(points, steering);

  std::vector<helios::Stretch> stretches;
  for (const helios::GroundElement& element : elements)
  {
    if (!this->CheckClimb(static_cast<vtkIdType>(element.Waypoint), element.Grade))
    {
      return false;
    }
    const double slope = std::hypot(1.0, element.Grade);
    const double pull = helios::StandardGravity * element.Grade / slope;
    stretches.push_back(
      { element.Length * slope, element.Cap, this->EngineForce / this->Mass - pull,
        -this->BrakeForce / this->Mass - pull, element.Stops });
  }
  const auto motion = MakeMotion(MakeRides(elements, this->Wheelbase),
    helios::DriveStretches(stretches, this->Drag / this->Mass), waypoints->GetNumberOfPoints() - 1);
  if (!this->CheckDurations(waypoints, motion, "raise EngineForce, or lower Drag or Mass."))
  {
    return false;
  }
  this->AppendMotion(waypoints, motion, path);
  return true;
}

//------------------------------------------------------------------------------
bool vtkHeliosGroundVehiclePlatform::CheckPath(vtkPolyData* waypoints)
{
  double length = 0.0;
  for (vtkIdType i = 1; i < waypoints->GetNumberOfPoints(); ++i)
  {
    double p[3], q[3];
    waypoints->GetPoint(i - 1, p);
    waypoints->GetPoint(i, q);
    const double way = std::hypot(q[0] - p[0], q[1] - p[1]);
    if (way == 0.0 && q[2] != p[2])
    {
      vtkErrorMacro(<< "Waypoint " << i << " is " << q[2] - p[2] << " m straight above waypoint "
                    << i - 1 << ", where no vehicle can drive; move it aside, or fly.");
      return false;
    }
    if (!(way < 1e9))
    {
      vtkErrorMacro(<< "Waypoint " << i << " is " << way << " m from waypoint " << i - 1
                    << ", too far to drive; move it closer.");
      return false;
    }
    length += way;
  }
  if (length == 0.0)
  {
    vtkErrorMacro(<< "All waypoints are at one place; move one, or use a static platform.");
    return false;
  }
  return true;
}

//------------------------------------------------------------------------------
bool vtkHeliosGroundVehiclePlatform::CheckClimb(vtkIdType waypoint, double grade)
{
  const double force = this->Mass * helios::StandardGravity * grade / std::hypot(1.0, grade);
  const double degrees = vtkMath::DegreesFromRadians(std::atan(grade));
  if (!(force < this->EngineForce))
  {
    vtkErrorMacro(<< "Waypoint " << waypoint + 1 << " cannot be reached: the slope of " << degrees
                  << " degrees needs more than " << force << " N, EngineForce is "
                  << this->EngineForce << " N; raise it, lower Mass or the waypoint.");
    return false;
  }
  if (!(-force < this->BrakeForce))
  {
    vtkErrorMacro(<< "Waypoint " << waypoint + 1 << " cannot be reached safely: the slope of "
                  << degrees << " degrees needs more than " << -force
                  << " N to brake, BrakeForce is " << this->BrakeForce
                  << " N; raise it, lower Mass or raise the waypoint.");
    return false;
  }
  return true;
}

//------------------------------------------------------------------------------
void vtkHeliosGroundVehiclePlatform::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Mass: " << this->Mass << "\n";
  os << indent << "EngineForce: " << this->EngineForce << "\n";
  os << indent << "BrakeForce: " << this->BrakeForce << "\n";
  os << indent << "Drag: " << this->Drag << "\n";
  os << indent << "Wheelbase: " << this->Wheelbase << "\n";
  os << indent << "MaximumSteeringAngle: " << this->MaximumSteeringAngle << "\n";
  os << indent << "SteeringRate: " << this->SteeringRate << "\n";
  os << indent << "LateralAcceleration: " << this->LateralAcceleration << "\n";
  os << indent << "TurnDeviation: " << this->TurnDeviation << "\n";
}
