// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosBeamEnergy.h"

#include "heliosPolygon.h"

#include <algorithm>
#include <cmath>

namespace helios
{
namespace
{

constexpr double Pi = 3.14159265358979323846;
constexpr double WideAngle = 1e-3; // [rad], from which angles and tangents differ by 1e-6
constexpr double LongEdge = 4.5;   // in 1 / sqrt(a)

/// The nodes and weights of Gauss's rules on [-1, 1] (Abramowitz and Stegun, table 25.4), the
/// positive nodes.
struct Rule
{
  double Longest; // of the edges, in 1 / sqrt(a)
  int Half;
  double Nodes[5];
  double Weights[5];
};

constexpr Rule Rules[] = {
  { 0.2, 1, { 0.577350269189626 }, { 1.0 } },
  { 1.0, 2, { 0.339981043584856, 0.861136311594053 }, { 0.652145154862546, 0.347854845137454 } },
  { 2.0, 3, { 0.238619186083197, 0.661209386466265, 0.932469514203152 },
    { 0.467913934572691, 0.360761573048139, 0.171324492379170 } },
  { LongEdge, 5,
    { 0.148874338981631, 0.433395394129247, 0.679409568299024, 0.865063366688985,
      0.973906528517172 },
    { 0.295524224714753, 0.269266719309996, 0.219086362515982, 0.149451349150581,
      0.066671344308688 } },
};

/// 1 - exp(-x) to 1e-14, relative.
double OneMinusExp(double x)
{
  return x < 0.01 ? -std::expm1(-x) : 1.0 - std::exp(-x);
}

/// The azimuth between two points, seen from the axis.
double GetAzimuth(double x0, double y0, double x1, double y1)
{
  return std::atan2(x0 * y1 - y0 * x1, x0 * x1 + y0 * y1);
}

} // namespace

BeamEnergy::BeamEnergy(double halfAngle, double truncation)
  : Tangent(std::tan(halfAngle * truncation))
  , IsWide(halfAngle * truncation > WideAngle)
  , Exponent(2.0 * truncation * truncation)
  , Scale(-1.0 / std::expm1(-this->Exponent))
  , Rim(this->Exponent * this->Scale * std::exp(-this->Exponent))
{
}

//------------------------------------------------------------------------------
/// Adds the part of an edge inside the circle: from + t step for t in [first, last].
void BeamEnergy::AddInside(
  const double from[2], const double step[2], double first, double last, Sums& sums) const
{
  const double half = 0.5 * (last - first);
  const double middle = 0.5 * (last + first);
  const double length =
    2.0 * half * std::sqrt((step[0] * step[0] + step[1] * step[1]) * this->Exponent);
  if (length > LongEdge)
  {
    this->AddInside(from, step, first, middle, sums);
    this->AddInside(from, step, middle, last, sums);
    return;
  }
  const Rule* rule = Rules;
  while (length > rule->Longest) // the last one is long enough
  {
    ++rule;
  }
  double energy = 0.0; // the sums of E / r^2, g, x g, y g
  double g = 0.0;
  double xg = 0.0;
  double yg = 0.0;
  for (int i = 0; i < 2 * rule->Half; ++i)
  {
    const int node = i / 2;
    const double t = middle + (i % 2 == 0 ? half : -half) * rule->Nodes[node];
    const double x = from[0] + t * step[0];
    const double y = from[1] + t * step[1];
    const double square = std::max(x * x + y * y, 1e-18);
    double q = square;
    if (this->IsWide)
    {
      const double angle = std::atan(std::sqrt(square) * this->Tangent) / std::atan(this->Tangent);
      q = angle * angle;
    }
    const double inside = OneMinusExp(this->Exponent * q);
    const double atNode =
      rule->Weights[node] * (this->Rim - this->Exponent * this->Scale * (1.0 - inside));
    energy += rule->Weights[node] * this->Scale * inside / square;
    g += atNode;
    xg += x * atNode;
    yg += y * atNode;
  }
  const double cross = from[0] * step[1] - from[1] * step[0];
  sums.Energy += half * cross * energy;
  sums.Area += 2.0 * half * cross;
  // n ds = (step_y, -step_x) dt.
  sums.X += half * step[1] * g;
  sums.Y -= half * step[0] * g;
  sums.XX += half * step[1] * xg;
  sums.XY += half * step[1] * yg;
  sums.YY -= half * step[0] * yg;
}

//------------------------------------------------------------------------------
EnergyMoments BeamEnergy::Integrate(const Polygon& polygon) const
{
  Sums sums;
  double azimuth = 0.0; // of the edges beyond the circle
  for (int i = 0; i < polygon.Size; ++i)
  {
    const int j = polygon.GetNext(i);
    const double from[2] = { polygon.X[i], polygon.Y[i] };
    const double step[2] = { polygon.X[j] - from[0], polygon.Y[j] - from[1] };
    const double a = step[0] * step[0] + step[1] * step[1];
    const double b = from[0] * step[0] + from[1] * step[1];
    const double c = from[0] * from[0] + from[1] * from[1] - 1.0;
    const double d = b * b - a * c;
    double first = 0.0;
    double last = 0.0;
    if (d > 0.0 && a > 0.0)
    {
      const double root = std::sqrt(d);
      first = std::clamp((-b - root) / a, 0.0, 1.0);
      last = std::clamp((-b + root) / a, 0.0, 1.0);
    }
    if (!(last > first))
    {
      azimuth += GetAzimuth(from[0], from[1], polygon.X[j], polygon.Y[j]);
      continue;
    }
    this->AddInside(from, step, first, last, sums);
    if (first > 0.0)
    {
      azimuth += GetAzimuth(from[0], from[1], from[0] + first * step[0], from[1] + first * step[1]);
    }
    if (last < 1.0)
    {
      azimuth +=
        GetAzimuth(from[0] + last * step[0], from[1] + last * step[1], polygon.X[j], polygon.Y[j]);
    }
  }
  const double scale = 1.0 / (2.0 * Pi * this->Exponent);
  EnergyMoments moments;
  moments.Energy = (sums.Energy + azimuth) / (2.0 * Pi);
  moments.X = scale * sums.X;
  moments.Y = scale * sums.Y;
  // f(1) is Rim / pi, and the area half of the sum.
  const double rest =
    moments.Energy / (2.0 * this->Exponent) - 0.5 * scale * this->Rim * (sums.Area + azimuth);
  moments.XX = rest + scale * sums.XX;
  moments.XY = scale * sums.XY;
  moments.YY = rest + scale * sums.YY;
  return moments;
}

} // namespace helios
