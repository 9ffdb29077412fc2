// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosGroundPath.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace helios
{
namespace
{

const double Pi = std::acos(-1.0);

/// Largest angle of a forward turn; for larger ones the car reverses.
const double LargestTurn = 1.5 * Pi;

/// The pose of the car in x, y.
struct Stand
{
  Vec3 Position;
  double Course; // heading [rad]

  /// Returns the position of a point ahead and to the left.
  std::pair<double, double> See(const Vec3& point) const
  {
    const double x = point[0] - this->Position[0];
    const double y = point[1] - this->Position[1];
    const double c = std::cos(this->Course);
    const double s = std::sin(this->Course);
    return { c * x + s * y, c * y - s * x };
  }
};

/// A path from a pose to a waypoint.
struct Approach
{
  std::vector<GroundElement> Elements;
  double Length = 0.0;

  Stand GetEnd(const Stand& start) const
  {
    if (this->Elements.empty())
    {
      return start;
    }
    const GroundElement& last = this->Elements.back();
    const GroundElement::Place place = last.At(last.Length);
    return { place.Position, place.Course };
  }

  void AddTurn(const Stand& from, const Turn& bend, bool right, double cap)
  {
    GroundElement element{};
    element.Start = from.Position;
    element.Course = from.Course;
    element.Length = bend.GetLength();
    element.IsTurn = true;
    element.Right = right;
    element.Bend = bend;
    element.Cap = cap;
    this->Add(element);
  }

  void AddStraight(const Stand& from, double length, double cap)
  {
    GroundElement element{};
    element.Start = from.Position;
    element.Course = from.Course;
    element.Length = length;
    element.Cap = cap;
    this->Add(element);
  }

  void Add(const GroundElement& element)
  {
    if (element.Length > 0.0)
    {
      this->Elements.push_back(element);
      this->Length += element.Length;
    }
  }
};

/// The geometry of a bend.
struct BendStyle
{
  double Curvature;
  double Speed;
};

class Planner
{
public:
  explicit Planner(const Steering& steering)
    : Car(steering)
    , Tightest(steering.GetCurvature(steering.MaximumAngle))
  {
  }

  Approach Plan(const Stand& stand, const GroundWaypoint& from, const Vec3& target) const
  {
    for (const BendStyle& style : this->GetStyles(stand, from.Speed, target))
    {
      if (const auto way = this->GoForward(stand, target, style, from.Speed))
      {
        return *way;
      }
    }
    return this->BackUp(stand, from, target);
  }

private:
  /// Returns the length in which the steering reaches a curvature at a speed: d(angle)/ds is at
  /// most Wheelbase d(curvature)/ds.
  double GetRamp(const BendStyle& style) const
  {
    return style.Speed * this->Car.Wheelbase * style.Curvature / this->Car.Rate;
  }

  double GetBendSpeed(double curvature, double cap) const
  {
    return std::min(cap, std::sqrt(this->Car.LateralAcceleration / curvature));
  }

  /// Returns the bends from full speed to the tightest, finally at minimum speed.
  std::vector<BendStyle> GetStyles(const Stand& stand, double cap, const Vec3& target) const
  {
    const auto [ahead, left] = stand.See(target);
    const double bearing = std::atan2(std::abs(left), ahead);
    const double swing =
      1.0 - std::cos(bearing); // distance of a bend from the straight line, in radii
    const double wide = cap * cap / this->Car.LateralAcceleration;
    const double narrow = 1.0 / this->Tightest;
    double radius =
      std::max(narrow, swing * wide > this->Car.Deviation ? this->Car.Deviation / swing : wide);
    std::vector<BendStyle> styles;
    for (; radius > narrow; radius *= 0.7)
    {
      styles.push_back({ 1.0 / radius, this->GetBendSpeed(1.0 / radius, cap) });
    }
    for (double share = 1.0; share > 0.1; share *= 0.5)
    {
      styles.push_back({ this->Tightest, share * this->GetBendSpeed(this->Tightest, cap) });
    }
    return styles;
  }

  /// Returns a turn and a straight line.
  std::optional<Approach> GoForward(
    const Stand& stand, const Vec3& target, const BendStyle& style, double cap) const
  {
    const auto [ahead, left] = stand.See(target);
    const bool right = left < 0.0;
    const auto bend = FindTurn(ahead, std::abs(left), style.Curvature, this->GetRamp(style));
    if (!bend || bend->GetAngle() > LargestTurn)
    {
      return std::nullopt;
    }
    Approach way;
    way.AddTurn(stand, *bend, right, style.Speed);
    const Stand after = way.GetEnd(stand);
    way.AddStraight(after, std::max(0.0, after.See(target).first), cap);
    return way;
  }

  /// Returns the shortest of several three-point turns.
  Approach BackUp(const Stand& stand, const GroundWaypoint& from, const Vec3& target) const
  {
    const BendStyle crawl{ this->Tightest, 0.25 * this->GetBendSpeed(this->Tightest, from.Speed) };
    const bool right = stand.See(target).second < 0.0;
    Approach best;
    for (int straight = 0; best.Elements.empty(); straight = 2 * straight + 1)
    {
      for (int step = 0; step <= 16; ++step)
      {
        Approach way =
          this->Reverse(stand, crawl, right, step * Pi / 18.0, straight / this->Tightest);
        Stand after = way.GetEnd(stand);
        after.Course -= way.Elements.empty() ? 0.0 : Pi;
        const auto forward = this->GoForward(after, target, crawl, from.Speed);
        const bool better =
          best.Elements.empty() || (forward && way.Length + forward->Length < best.Length);
        if (forward && better && !way.Elements.empty())
        {
          way.Elements.back().Stops = true;
          for (const GroundElement& element : forward->Elements)
          {
            way.Add(element);
          }
          best = way;
        }
      }
    }
    return best;
  }

  /// Drives backward: a turn that swings the front round, and a straight line.
  Approach Reverse(
    const Stand& stand, const BendStyle& style, bool right, double angle, double straight) const
  {
    Approach way;
    const Stand back{ stand.Position, stand.Course + Pi };
    way.AddTurn(back, Turn(angle, style.Curvature, this->GetRamp(style)), right, style.Speed);
    way.AddStraight(way.GetEnd(back), straight, style.Speed);
    for (GroundElement& element : way.Elements)
    {
      element.Backward = true;
    }
    return way;
  }

  Steering Car;
  double Tightest;
};

/// Raises the forward part of a path to the next waypoint.
void Climb(Approach& way, double z0, double z1)
{
  double forward = 0.0;
  for (const GroundElement& element : way.Elements)
  {
    forward += element.Backward ? 0.0 : element.Length;
  }
  double z = z0;
  for (GroundElement& element : way.Elements)
  {
    element.Start[2] = z;
    element.Grade = element.Backward ? 0.0 : (z1 - z0) / forward;
    z += element.Grade * element.Length;
  }
}

} // namespace

//------------------------------------------------------------------------------
GroundElement::Place GroundElement::At(double s) const
{
  const Turn::Point p = this->IsTurn ? this->Bend.At(s) : Turn::Point{ s, 0.0, 0.0, 0.0 };
  const double side = this->Right ? -1.0 : 1.0;
  const double c = std::cos(this->Course);
  const double n = std::sin(this->Course);
  const double left = side * p.Left;
  return { this->Start + Vec3(c * p.Forward - n * left, n * p.Forward + c * left, this->Grade * s),
    this->Course + side * p.Heading, side * p.Curvature };
}

//------------------------------------------------------------------------------
std::vector<GroundElement> PlanGroundPath(
  const std::vector<GroundWaypoint>& waypoints, const Steering& steering)
{
  const Planner planner(steering);
  std::vector<GroundElement> path;
  Stand stand{ waypoints[0].Position, 0.5 * Pi };
  bool stands = true;
  for (std::size_t i = 0; i + 1 < waypoints.size(); ++i)
  {
    const Vec3& from = waypoints[i].Position;
    const Vec3& to = waypoints[i + 1].Position;
    if (from[0] == to[0] && from[1] == to[1])
    {
      continue;
    }
    stand.Course = stands ? std::atan2(to[1] - from[1], to[0] - from[0]) : stand.Course;
    stands = false;
    Approach way = planner.Plan(stand, waypoints[i], to);
    Climb(way, from[2], to[2]);
    if (way.Elements.front().Backward && !path.empty())
    {
      path.back().Stops = true;
    }
    for (GroundElement& element : way.Elements)
    {
      element.Waypoint = i;
      path.push_back(element);
    }
    stand = { to, way.GetEnd(stand).Course };
  }
  return path;
}

} // namespace helios
