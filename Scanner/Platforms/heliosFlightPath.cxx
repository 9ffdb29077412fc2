// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosFlightPath.h"

#include "heliosConstants.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace helios
{
namespace
{

const double Pi = std::acos(-1.0);

/// Sharper turns than this are stops.
const double SharpestTurn = 150.0 / 180.0 * Pi;

/// The minimum horizontal part of the direction in a turn; steeper ones are stops.
constexpr double SteepestTurn = 0.3;

double GetAngle(const Vec3& a, const Vec3& b)
{
  return std::atan2(a.Cross(b).Norm(), a.Dot(b));
}

/// Returns the unit direction of the turn from one direction to another.
Vec3 GetSide(const Vec3& from, const Vec3& to)
{
  Vec3 side = to - from.Dot(to) * from;
  if (side.Norm() < 1e-12)
  {
    side = std::abs(from[2]) < 0.9 ? Vec3(-from[1], from[0], 0.0) : Vec3(0.0, from[2], -from[1]);
  }
  side.Normalize();
  return side;
}

/// Returns the minimum horizontal part of the directions in a turn by an angle.
double GetFlattest(const Vec3& along, const Vec3& side, double angle)
{
  double minimum = 1.0;
  for (int i = 0; i <= 32; ++i)
  {
    const double a = angle * i / 32.0;
    const Vec3 direction = std::cos(a) * along + std::sin(a) * side;
    minimum = std::min(minimum, std::hypot(direction[0], direction[1]));
  }
  return minimum;
}

class Planner
{
public:
  Planner(const std::vector<FlightWaypoint>& waypoints, const Copter& copter)
    : Waypoints(waypoints)
    , Machine(copter)
    , Lateral(std::min(StandardGravity * std::tan(copter.Roll),
        0.7 * std::sqrt(copter.Thrust * copter.Thrust - StandardGravity * StandardGravity)))
  {
  }

  FlightPath Plan()
  {
    this->Path.Corners.resize(this->Waypoints.size());
    this->Path.Lines.resize(this->Waypoints.size() - 1);
    for (std::size_t i = 0; i < this->Waypoints.size(); ++i)
    {
      this->Path.Corners[i].Mode = i == 0 ? Passing::Stop : this->Waypoints[i].Mode;
      this->Path.Corners[i].Speed = this->GetWantedSpeed(i);
    }
    // Each pass that does not fit slows down a corner; after some dozen passes it is a stop, which
    // fits.
    bool fits = false;
    for (std::size_t i = 0; i < 100 + 60 * this->Waypoints.size() && !fits; ++i)
    {
      fits = this->Fits();
    }
    if (!fits)
    {
      for (FlightCorner& corner : this->Path.Corners)
      {
        this->Stop(corner);
      }
      this->Fits();
    }
    for (std::size_t i = 1; i < this->Waypoints.size(); ++i)
    {
      if (this->Waypoints[i].Mode != Passing::Stop &&
        this->Path.Corners[i].Speed < this->GetWantedSpeed(i))
      {
        this->Path.Slowed.push_back(i);
      }
    }
    return this->Path;
  }

private:
  /// Returns the vector of a leg; 0 for a leg of zero length.
  Vec3 GetDirection(std::size_t leg) const
  {
    Vec3 way = this->Waypoints[leg + 1].Position - this->Waypoints[leg].Position;
    way.Normalize();
    return way;
  }

  /// Returns the requested speed at a waypoint, allowed by the legs on both sides.
  double GetWantedSpeed(std::size_t i) const
  {
    if (i == 0 || this->Waypoints[i].Mode == Passing::Stop)
    {
      return 0.0;
    }
    double speed = this->GetCruise(i - 1, this->GetDirection(i - 1));
    if (i + 1 < this->Waypoints.size())
    {
      speed = std::min(speed, this->GetCruise(i, this->GetDirection(i)));
    }
    return speed;
  }

  double GetCruise(std::size_t leg, const Vec3& direction) const
  {
    return std::min(this->Waypoints[leg].Speed, this->Machine.GetTopSpeed(direction));
  }

  /// The inputs of a leg's layout.
  struct Terms
  {
    Passing Modes[2];
    double Speeds[2];
    Vec3 Before; // the final direction of the previous leg

    bool operator==(const Terms& b) const
    {
      return this->Modes[0] == b.Modes[0] && this->Modes[1] == b.Modes[1] &&
        this->Speeds[0] == b.Speeds[0] && this->Speeds[1] == b.Speeds[1] &&
        this->Before == b.Before;
    }
  };

  Terms GetTerms(std::size_t leg) const
  {
    const FlightCorner& a = this->Path.Corners[leg];
    const FlightCorner& b = this->Path.Corners[leg + 1];
    return { { a.Mode, b.Mode }, { a.Speed, b.Speed },
      leg > 0 ? this->Path.Lines[leg - 1].Direction : Vec3(0.0, 0.0, 0.0) };
  }

  /// Lays out all legs except those that already fit; where one does not fit, the speeds are
  /// reduced.
  bool Fits()
  {
    bool fits = true;
    this->Laid.resize(this->Path.Lines.size());
    for (std::size_t leg = 0; leg < this->Path.Lines.size(); ++leg)
    {
      const Terms terms = this->GetTerms(leg);
      if (this->Laid[leg] == terms)
      {
        continue;
      }
      if (leg + 1 < this->Laid.size())
      {
        this->Laid[leg + 1].reset(); // it starts at the end of this one
      }
      const bool turns = this->LayCorner(leg);
      const bool isLaid = this->LayLine(leg) && turns;
      if (isLaid && this->CanChange(leg))
      {
        this->Laid[leg] = terms;
        continue;
      }
      this->Laid[leg].reset();
      fits = false;
    }
    return fits;
  }

  void Stop(FlightCorner& corner)
  {
    corner.Mode = Passing::Stop;
    corner.Speed = 0.0;
  }

  /// Slows down a corner, down to a stop.
  void Slow(std::size_t i, double share)
  {
    FlightCorner& corner = this->Path.Corners[i];
    corner.Speed *= share;
    if (corner.Speed < std::max(0.01, 0.02 * this->GetWantedSpeed(i)))
    {
      this->Stop(corner);
    }
  }

  /// The geometry of a corner: the length to reach the bank, at a rate, and the radius of that
  /// bank, or of the yaw rate.
  struct Style
  {
    double Curvature;
    double Ramp;
  };

  Style GetStyle(double speed, double flattest) const
  {
    const double radius = std::max(
      speed * speed / this->Lateral, speed / (this->Machine.YawRate * flattest * flattest));
    const double pull = speed * speed / radius;
    return { 1.0 / radius, speed * pull / (StandardGravity * this->Machine.RollRate) };
  }

  /// Lays the turn after a waypoint that is passed through: the start of a leg.
  bool LayCorner(std::size_t leg)
  {
    FlightCorner& corner = this->Path.Corners[leg];
    FlightLine& line = this->Path.Lines[leg];
    const Vec3& from = this->Waypoints[leg].Position;
    Vec3 way = this->Waypoints[leg + 1].Position - from;
    line.Start = from;
    if (corner.Mode == Passing::Smooth)
    {
      line.Start = this->GetBendEnd(corner);
    }
    if (corner.Mode != Passing::Through)
    {
      return true;
    }
    const double distance = way.Normalize();
    corner.Start = from;
    corner.Along = this->Path.Lines[leg - 1].Direction;
    corner.Side = GetSide(corner.Along, way);
    const double angle = GetAngle(corner.Along, way);
    const double flattest = GetFlattest(corner.Along, corner.Side, std::min(Pi, 1.5 * angle));
    if (distance == 0.0 || angle > SharpestTurn || flattest < SteepestTurn)
    {
      this->Stop(corner);
      return false;
    }
    const Style style = this->GetStyle(corner.Speed, flattest);
    const auto bend =
      FindTurn(distance * std::cos(angle), distance * std::sin(angle), style.Curvature, style.Ramp);
    if (!bend || bend->GetAngle() > std::min(Pi, 1.5 * angle))
    {
      this->Slow(leg, 0.8);
      return false;
    }
    corner.Bend = *bend;
    line.Start = this->GetBendEnd(corner);
    return true;
  }

  /// Lays the straight part of a leg, up to the turn that cuts the corner at its end.
  bool LayLine(std::size_t leg)
  {
    FlightLine& line = this->Path.Lines[leg];
    FlightCorner& next = this->Path.Corners[leg + 1];
    const Vec3& to = this->Waypoints[leg + 1].Position;
    line.Direction = to - line.Start;
    line.Length = line.Direction.Normalize();
    const Vec3 way = this->GetDirection(leg);
    if (this->Path.Corners[leg].Mode != Passing::Through)
    {
      // A turn that cut the last corner may end after the next waypoint.
      line.Length = line.Direction.Dot(way) < 0.0 ? -line.Length : line.Length;
      line.Direction = way;
    }
    line.Cruise = this->GetCruise(leg, line.Direction);
    const bool isLast = leg + 1 == this->Path.Lines.size();
    if (next.Mode == Passing::Smooth && !isLast && !this->CutCorner(leg))
    {
      return false;
    }
    if (way.Norm() == 0.0 && next.Mode != Passing::Stop)
    {
      this->Stop(next);
      return false;
    }
    if (line.Length < 0.0)
    {
      this->Slow(leg, 0.8);
      this->Slow(leg + 1, 0.8);
      return false;
    }
    return true;
  }

  /// Shortens a leg by the tangent of the turn at its end.
  bool CutCorner(std::size_t leg)
  {
    FlightLine& line = this->Path.Lines[leg];
    FlightCorner& corner = this->Path.Corners[leg + 1];
    const Vec3 way = this->GetDirection(leg + 1);
    const double angle = GetAngle(line.Direction, way);
    corner.Along = line.Direction;
    corner.Side = GetSide(corner.Along, way);
    const double flattest = GetFlattest(corner.Along, corner.Side, angle);
    if (way.Norm() == 0.0 || angle > SharpestTurn || flattest < SteepestTurn)
    {
      this->Stop(corner);
      return false;
    }
    const Style style = this->GetStyle(corner.Speed, flattest);
    corner.Bend = Turn(angle, style.Curvature, style.Ramp);
    const double tangent =
      corner.Bend.At(corner.Bend.GetLength()).Forward / (1.0 + std::cos(angle));
    corner.Start = this->Waypoints[leg + 1].Position - tangent * line.Direction;
    line.Length -= tangent;
    return true;
  }

  static Vec3 GetBendEnd(const FlightCorner& corner)
  {
    const Turn::Point end = corner.Bend.At(corner.Bend.GetLength());
    return corner.Start + end.Forward * corner.Along + end.Left * corner.Side;
  }

  /// Returns whether a leg is long enough for its change of speed.
  bool CanChange(std::size_t leg)
  {
    const FlightLine& line = this->Path.Lines[leg];
    const double entry = this->Path.Corners[leg].Speed;
    const double exit = this->Path.Corners[leg + 1].Speed;
    const std::size_t faster = entry > exit ? leg : leg + 1;
    const bool isTooFast = std::max(entry, exit) > line.Cruise;
    if (isTooFast ||
      (entry != exit &&
        ChangeSpeed(this->Machine.GetLimits(line.Direction), entry, exit).Distance > line.Length))
    {
      this->Slow(faster, 0.9);
      return false;
    }
    return true;
  }

  const std::vector<FlightWaypoint>& Waypoints;
  Copter Machine;
  double Lateral; // [m/s^2]
  FlightPath Path;
  std::vector<std::optional<Terms>> Laid; // for legs that fit
};

} // namespace

//------------------------------------------------------------------------------
DriveLimits Copter::GetLimits(const Vec3& direction) const
{
  const double g = StandardGravity;
  const double flat = std::hypot(direction[0], direction[1]);
  const double up = direction[2];
  const double tilt = std::tan(this->Pitch);
  const double reach = std::sqrt(this->Thrust * this->Thrust - g * g * flat * flat);
  DriveLimits limits{ reach - g * up, -reach - g * up, 0.0, this->Drag, this->Step };
  // tan(tilt) = q flat / (g + q up), and q up never exceeds half of the weight.
  const auto tighten = [&](double maximum, double minimum)
  {
    limits.Maximum = maximum > 0.0 ? std::min(limits.Maximum, maximum) : limits.Maximum;
    limits.Minimum = minimum < 0.0 ? std::max(limits.Minimum, minimum) : limits.Minimum;
  };
  tighten(tilt * g / (flat - tilt * up), -tilt * g / (flat + tilt * up));
  tighten(up < 0.0 ? -0.5 * g / up : 0.0, up > 0.0 ? -0.5 * g / up : 0.0);
  // d(tilt)/dq = flat g / ((g + q up)^2 + (q flat)^2), largest nearest to q = -g up.
  const double q = std::clamp(-g * up, limits.Minimum, limits.Maximum);
  const double slowest = (g + q * up) * (g + q * up) + q * q * flat * flat;
  limits.Rate = this->PitchRate * (flat > 0.0 ? std::min(g, slowest / (g * flat)) : g);
  return limits;
}

//------------------------------------------------------------------------------
FlightPath PlanFlight(const std::vector<FlightWaypoint>& waypoints, const Copter& copter)
{
  return Planner(waypoints, copter).Plan();
}

} // namespace helios
