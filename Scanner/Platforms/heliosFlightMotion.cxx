// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosFlightMotion.h"

#include "heliosConstants.h"

#include <cmath>

namespace helios
{
namespace
{

const double Pi = std::acos(-1.0);

bool HasCourse(const Vec3& direction)
{
  return std::hypot(direction[0], direction[1]) > 1e-6;
}

double GetCourse(const Vec3& direction)
{
  return std::atan2(direction[1], direction[0]);
}

/// Returns the thrust per unit of mass, for a drive along a direction and a lateral acceleration.
Vec3 GetThrust(const Vec3& along, double drive)
{
  return Vec3(0.0, 0.0, StandardGravity) + drive * along;
}

/// Makes a piece that rests, and turns on the spot from a course by an angle.
MotionPiece Hover(vtkIdType leg, const Vec3& position, double course, double angle, double rate)
{
  const double duration = std::abs(angle) / rate;
  const double turn = angle < 0.0 ? -rate : rate;
  return { leg, duration,
    [=](double t)
    {
      return MotionState{ position, Vec3(0.0, 0.0, 0.0),
        TiltTo({ 0.0, 0.0, StandardGravity }, course + turn * t) };
    } };
}

/// Returns a part of a straight line, from a distance along it.
MotionPiece Straight(
  vtkIdType leg, const FlightLine& line, double start, double course, const DrivePhase& phase)
{
  return { leg, phase.GetDuration(),
    [=](double t)
    {
      const DrivePhase::State state = phase.At(t);
      return MotionState{ line.Start + (start + state.Distance) * line.Direction,
        state.Speed * line.Direction, TiltTo(GetThrust(line.Direction, state.Drive), course) };
    } };
}

/// Returns a part of a turn at constant speed, from a length along it; the nose keeps its angle to
/// the path.
MotionPiece Bend(vtkIdType leg, const FlightCorner& corner, double start, double length,
  double offset, double drag)
{
  const double v = corner.Speed;
  return { leg, length / v,
    [=](double t)
    {
      const Turn::Point p = corner.Bend.At(start + v * t);
      const double c = std::cos(p.Heading);
      const double s = std::sin(p.Heading);
      const Vec3 along = c * corner.Along + s * corner.Side;
      const Vec3 inward = c * corner.Side - s * corner.Along;
      return MotionState{ corner.Start + p.Forward * corner.Along + p.Left * corner.Side, v * along,
        TiltTo(GetThrust(along, drag * v * v) + v * v * p.Curvature * inward,
          GetCourse(along) + offset) };
    } };
}

/// Flies all legs in order.
class Pilot
{
public:
  Pilot(const FlightPath& path, const Copter& copter, double brakeDistance)
    : Path(path)
    , Machine(copter)
    , BrakeDistance(brakeDistance)
  {
  }

  std::vector<MotionPiece> Fly(const std::vector<double>& courses)
  {
    this->Course = this->GetFirstCourse(courses);
    for (std::size_t leg = 0; leg < this->Path.Lines.size(); ++leg)
    {
      const std::size_t before = this->Motion.size();
      this->Leave(leg, courses[leg]);
      this->FlyStraight(leg);
      this->TurnIn(leg);
      if (this->Motion.size() == before) // a leg without length
      {
        this->Motion.push_back(
          Hover(static_cast<vtkIdType>(leg), this->Path.Lines[leg].Start, this->Course, 0.0, 1.0));
      }
    }
    return this->Motion;
  }

private:
  /// Returns the course of the first stop or leg with a course; otherwise north.
  double GetFirstCourse(const std::vector<double>& courses) const
  {
    for (std::size_t leg = 0; leg < this->Path.Lines.size(); ++leg)
    {
      if (std::isfinite(courses[leg]) || HasCourse(this->Path.Lines[leg].Direction))
      {
        return this->GetDeparture(leg, courses[leg], 0.0);
      }
    }
    return 0.5 * Pi;
  }

  double GetDeparture(std::size_t leg, double course, double keep) const
  {
    if (std::isfinite(course))
    {
      return course;
    }
    const Vec3& way = this->Path.Lines[leg].Direction;
    return HasCourse(way) ? GetCourse(way) : keep;
  }

  /// Adds the turn on the spot, or the rest of the turn at the waypoint where a leg starts.
  void Leave(std::size_t leg, double course)
  {
    const FlightCorner& corner = this->Path.Corners[leg];
    const auto id = static_cast<vtkIdType>(leg);
    const Vec3& way = this->Path.Lines[leg].Direction;
    if (corner.Mode == Passing::Stop)
    {
      const double goal = this->GetDeparture(leg, course, this->Course);
      const double turn = std::remainder(goal - this->Course, 2.0 * Pi);
      if (turn != 0.0)
      {
        this->Motion.push_back(
          Hover(id, this->Path.Lines[leg].Start, this->Course, turn, this->Machine.YawRate));
      }
      this->Course += turn;
      this->Offset = HasCourse(way) ? this->Course - GetCourse(way) : 0.0;
      return;
    }
    const double length = corner.Bend.GetLength();
    const double flown = corner.Mode == Passing::Smooth ? 0.5 * length : 0.0;
    this->AddBend(id, corner, flown, length - flown);
    this->Course = HasCourse(way) ? GetCourse(way) + this->Offset : this->Course;
  }

  void FlyStraight(std::size_t leg)
  {
    const FlightLine& line = this->Path.Lines[leg];
    const double entry = this->Path.Corners[leg].Speed;
    const double exit = this->Path.Corners[leg + 1].Speed;
    if (!(line.Length > 0.0))
    {
      return;
    }
    double start = 0.0;
    for (const DrivePhase& phase : FlyLine(this->Machine.GetLimits(line.Direction),
           { line.Length, entry, exit, line.Cruise, this->BrakeDistance }))
    {
      this->Motion.push_back(
        Straight(static_cast<vtkIdType>(leg), line, start, this->Course, phase));
      start += phase.GetEnd().Distance;
    }
  }

  /// Adds the first half of a turn that cuts the corner.
  void TurnIn(std::size_t leg)
  {
    const FlightCorner& corner = this->Path.Corners[leg + 1];
    if (corner.Mode == Passing::Smooth && leg + 1 < this->Path.Lines.size())
    {
      this->AddBend(static_cast<vtkIdType>(leg), corner, 0.0, 0.5 * corner.Bend.GetLength());
    }
  }

  void AddBend(vtkIdType leg, const FlightCorner& corner, double start, double length)
  {
    if (length > 0.0)
    {
      this->Motion.push_back(Bend(leg, corner, start, length, this->Offset, this->Machine.Drag));
    }
  }

  const FlightPath& Path;
  Copter Machine;
  double BrakeDistance;
  double Course = 0.0;
  double Offset = 0.0; // angle of the nose from the path
  std::vector<MotionPiece> Motion;
};

} // namespace

//------------------------------------------------------------------------------
Quaternion TiltTo(const Vec3& thrust, double course)
{
  const double yaw = course - 0.5 * Pi;
  const double right = std::cos(yaw) * thrust[0] + std::sin(yaw) * thrust[1];
  const double forward = std::cos(yaw) * thrust[1] - std::sin(yaw) * thrust[0];
  const double pitch = std::atan2(-forward, thrust[2]);
  const double roll = std::atan2(right, std::hypot(forward, thrust[2]));
  return Quaternion(std::cos(0.5 * yaw), 0.0, 0.0, std::sin(0.5 * yaw)) *
    Quaternion(std::cos(0.5 * pitch), std::sin(0.5 * pitch), 0.0, 0.0) *
    Quaternion(std::cos(0.5 * roll), 0.0, std::sin(0.5 * roll), 0.0);
}

//------------------------------------------------------------------------------
std::vector<MotionPiece> FlyPath(const FlightPath& path, const Copter& copter,
  const std::vector<double>& courses, double brakeDistance)
{
  return Pilot(path, copter, brakeDistance).Fly(courses);
}

} // namespace helios
