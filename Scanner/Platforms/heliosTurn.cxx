// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosTurn.h"

#include "heliosRoot.h"

#include <algorithm>
#include <cmath>

namespace helios
{
namespace
{

const double Pi = std::acos(-1.0);

/// Gauss-Legendre nodes and weights of order 16.
constexpr double Nodes[4] = { 0.18343464249564980, 0.52553240991632899, 0.79666647741362674,
  0.96028985649753623 };
constexpr double Weights[4] = { 0.36268378337836198, 0.31370664587788729, 0.22238103445337447,
  0.10122853629037626 };

/// The target after a turn: its distance to the left of the path, and ahead.
struct Aim
{
  double Left;
  double Ahead;
};

Aim AimAt(double forward, double left, const Turn& turn)
{
  const Turn::Point end = turn.At(turn.GetLength());
  const double x = forward - end.Forward;
  const double y = left - end.Left;
  const double c = std::cos(end.Heading);
  const double s = std::sin(end.Heading);
  return { c * y - s * x, c * x + s * y };
}

} // namespace

//------------------------------------------------------------------------------
Turn::Turn(double angle, double curvature, double ramp)
  : Angle(angle)
  , Curvature(curvature)
  , Ramp(ramp)
{
  if (angle < curvature * ramp)
  {
    this->Curvature = std::sqrt(angle * curvature / ramp);
    this->Ramp = this->Curvature * (ramp / curvature);
  }
  this->Arc = std::max(0.0, angle / curvature - ramp);
  if (this->Ramp > 0.0)
  {
    this->ArcStart = this->AlongRamp({}, this->Ramp, this->Curvature / this->Ramp);
  }
  this->ArcStart.Curvature = this->Curvature;
  this->ArcEnd = this->AlongArc(this->Arc);
}

//------------------------------------------------------------------------------
Turn::Point Turn::At(double s) const
{
  if (s < this->Ramp)
  {
    return this->AlongRamp({}, s, this->Curvature / this->Ramp);
  }
  s -= this->Ramp;
  if (s <= this->Arc || this->Ramp == 0.0)
  {
    return this->AlongArc(std::min(s, this->Arc));
  }
  const double rest = std::min(s - this->Arc, this->Ramp);
  return this->AlongRamp(this->ArcEnd, rest, -this->Curvature / this->Ramp);
}

//------------------------------------------------------------------------------
Turn::Point Turn::AlongArc(double s) const
{
  const double half = 0.5 * this->Curvature * s;
  const double chord = half != 0.0 ? s * (std::sin(half) / half) : s;
  Point p = this->ArcStart;
  p.Forward += chord * std::cos(p.Heading + half);
  p.Left += chord * std::sin(p.Heading + half);
  p.Heading += 2.0 * half;
  return p;
}

//------------------------------------------------------------------------------
Turn::Point Turn::AlongRamp(const Point& from, double s, double rate) const
{
  const auto heading = [&](double l)
  { return from.Heading + l * (from.Curvature + 0.5 * rate * l); };
  const int panels =
    1 + static_cast<int>(std::abs(heading(s) - from.Heading) + 0.5 * std::abs(rate) * s * s);
  const double half = 0.5 * s / panels;
  Point p = from;
  for (int i = 0; i < panels; ++i)
  {
    const double middle = (2 * i + 1) * half;
    for (int k = 0; k < 4; ++k)
    {
      const double a = heading(middle - half * Nodes[k]);
      const double b = heading(middle + half * Nodes[k]);
      p.Forward += half * Weights[k] * (std::cos(a) + std::cos(b));
      p.Left += half * Weights[k] * (std::sin(a) + std::sin(b));
    }
  }
  p.Heading = heading(s);
  p.Curvature = from.Curvature + rate * s;
  return p;
}

//------------------------------------------------------------------------------
std::optional<Turn> FindTurn(double forward, double left, double curvature, double ramp)
{
  const auto miss = [&](double angle)
  { return AimAt(forward, left, Turn(angle, curvature, ramp)).Left; };
  constexpr int steps = 120;
  double before = miss(0.0);
  if (before <= 0.0 && forward >= 0.0)
  {
    return Turn(0.0, curvature, ramp);
  }
  for (int i = 1; i <= steps; ++i)
  {
    const double angle = 2.0 * Pi * i / steps;
    const double after = miss(angle);
    if (before > 0.0 && after <= 0.0)
    {
      const Turn turn(FindRoot(miss, 2.0 * Pi * (i - 1) / steps, angle), curvature, ramp);
      if (AimAt(forward, left, turn).Ahead >= 0.0)
      {
        return turn;
      }
    }
    before = after;
  }
  return std::nullopt;
}

} // namespace helios
