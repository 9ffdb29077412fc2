// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma GCC diagnostic ignored "-Wpsabi" // vectors are passed to inlined functions only
#include "heliosBeamEnergy.h"

#include "heliosPolygon.h"
#include "heliosRayVectors.h"

#include <algorithm>
#include <cmath>

namespace helios
{
namespace
{

constexpr double Pi = 3.14159265358979323846;
constexpr double WideAngle = 1e-3; // [rad], from which angles and tangents differ by 1e-6
constexpr double LongEdge = 4.5;   // in 1 / sqrt(a)
constexpr double Small = 0.3;      // argument of the series of an exponential

/// The nodes and weights of Gauss's rules on [-1, 1] (Abramowitz and Stegun, table 25.4), the
/// positive nodes.
struct Rule
{
  double Longest; // longest edge, in 1 / sqrt(a)
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

/**
 * Returns (1 - exp(-x)) / x to 1e-8: a series for y = x / 2^n, which is doubled n times. With g at
 * y, exp(-y) is 1 - y g, and g at 2 y is g (1 + exp(-y)) / 2.
 */
HELIOS_INLINE Doubles OneMinusExpOver(const Doubles& x, int doublings)
{
  Doubles y = x * std::ldexp(1.0, -doublings);
  const Doubles square = y * y;
  const Doubles low = 1.0 - 0.5 * y;
  const Doubles middle = 1.0 / 6.0 - y * (1.0 / 24.0);
  const Doubles high = 1.0 / 120.0 - y * (1.0 / 720.0) + square * (1.0 / 5040.0);
  Doubles g = low + square * (middle + square * high);
  for (int k = 0; k < doublings; ++k)
  {
    g = g * (1.0 - 0.5 * y * g);
    y = y + y;
  }
  return g;
}

/// Returns the squared angles of points of the cross-section by their squared radii, both 1 at the
/// rim.
Doubles GetStretch(const Doubles& squares, double tangent)
{
  Doubles stretch;
  for (int lane = 0; lane < QuadWidth; ++lane)
  {
    const double r = std::max(std::sqrt(squares[lane]), 1e-9);
    const double q = std::atan(r * tangent) / (r * std::atan(tangent));
    stretch[lane] = q * q;
  }
  return stretch;
}

HELIOS_INLINE double Sum(const Doubles& x)
{
  return (x[0] + x[1]) + (x[2] + x[3]);
}

/// Returns the squared size of polygons, in 1 / a, for which the Taylor series errs by a fraction
/// of the beam's energy (measured: TestBeamEnergy).
double GetSmallReach(double error)
{
  return 0.015 * std::pow(error / 2e-8, 0.38);
}

/// Returns the azimuth between two points, seen from the axis.
double GetAzimuth(double x0, double y0, double x1, double y1)
{
  return std::atan2(x0 * y1 - y0 * x1, x0 * x1 + y0 * y1);
}

} // namespace

BeamEnergy::BeamEnergy(double halfAngle, double truncation, double error)
  : Tangent(std::tan(halfAngle * truncation))
  , IsWide(halfAngle * truncation > WideAngle)
  , Exponent(2.0 * truncation * truncation)
  , Scale(-1.0 / std::expm1(-this->Exponent))
  , Doublings(std::max(0, static_cast<int>(std::ceil(std::log2(this->Exponent / Small)))))
  , Rim(this->Exponent * this->Scale * std::exp(-this->Exponent))
  , SmallReach(GetSmallReach(error) / this->Exponent)
{
}

//------------------------------------------------------------------------------
/// Adds the nodes of the part of an edge inside the circle: from + t step for t in [first, last].
void BeamEnergy::AddInside(const double from[2], const double step[2], double first, double last,
  Nodes& nodes, Sums& sums) const
{
  const double half = 0.5 * (last - first);
  const double middle = 0.5 * (last + first);
  const double length =
    2.0 * half * std::sqrt((step[0] * step[0] + step[1] * step[1]) * this->Exponent);
  if (length > LongEdge)
  {
    this->AddInside(from, step, first, middle, nodes, sums);
    this->AddInside(from, step, middle, last, nodes, sums);
    return;
  }
  const Rule* rule = Rules;
  while (length > rule->Longest) // the last one is long enough
  {
    ++rule;
  }
  if (nodes.Size + 2 * rule->Half > Nodes::Capacity)
  {
    this->AddNodes(nodes, sums);
  }
  const double cross = from[0] * step[1] - from[1] * step[0];
  sums.Area += 2.0 * half * cross;
  for (int i = 0; i < 2 * rule->Half; ++i)
  {
    const int node = i / 2;
    const double t = middle + (i % 2 == 0 ? half : -half) * rule->Nodes[node];
    const double weight = half * rule->Weights[node];
    const double place[2] = { from[0] + t * step[0], from[1] + t * step[1] };
    nodes.Add(place, weight * cross, weight * step[1], -weight * step[0]); // n ds
  }
}

//------------------------------------------------------------------------------
/// Evaluates the integrands at nodes, and removes these.
HELIOS_CLONES
void BeamEnergy::AddNodes(Nodes& nodes, Sums& sums) const
{
  const double origin[2] = { 0.0, 0.0 };
  while (nodes.Size % QuadWidth != 0)
  {
    nodes.Add(origin, 0.0, 0.0, 0.0);
  }
  Doubles energy = {}, sumX = {}, sumY = {}, sumXX = {}, sumXY = {}, sumYY = {};
  for (int i = 0; i < nodes.Size; i += QuadWidth)
  {
    const Doubles x = Load<Doubles>(nodes.X + i);
    const Doubles y = Load<Doubles>(nodes.Y + i);
    const Doubles square = x * x + y * y;
    const Doubles stretch = this->IsWide ? GetStretch(square, this->Tangent) : 1.0 + Doubles();
    const Doubles exponent = this->Exponent * stretch * square;
    const Doubles inside = OneMinusExpOver(exponent, this->Doublings);
    energy += Load<Doubles>(nodes.Turn + i) * stretch * inside; // times a factor: E / r^2
    const Doubles g = this->Rim - this->Exponent * this->Scale * (1.0 - exponent * inside);
    const Doubles gx = g * Load<Doubles>(nodes.OutwardX + i);
    const Doubles gy = g * Load<Doubles>(nodes.OutwardY + i);
    sumX += gx;
    sumY += gy;
    sumXX += x * gx;
    sumXY += y * gx;
    sumYY += y * gy;
  }
  sums.Energy += this->Scale * this->Exponent * Sum(energy);
  sums.X += Sum(sumX);
  sums.Y += Sum(sumY);
  sums.XX += Sum(sumXX);
  sums.XY += Sum(sumXY);
  sums.YY += Sum(sumYY);
  nodes.Size = 0;
}

//------------------------------------------------------------------------------
double BeamEnergy::GetIntensity(double x, double y) const
{
  double square = x * x + y * y;
  if (this->IsWide)
  {
    const double angle = std::atan(std::sqrt(square) * this->Tangent) / std::atan(this->Tangent);
    square = angle * angle;
  }
  return std::exp(-this->Exponent * square);
}

//------------------------------------------------------------------------------
/// Returns whether a polygon is inside the rim, and so small that the Taylor series is accurate
/// enough.
bool BeamEnergy::IsSmall(const Polygon& polygon) const
{
  if (this->IsWide)
  {
    return false;
  }
  double reach = 0.0;   // from the first corner, squared
  double maximum = 0.0; // from the axis, squared
  for (int i = 0; i < polygon.Size; ++i)
  {
    const double x = polygon.X[i];
    const double y = polygon.Y[i];
    const double dx = x - polygon.X[0];
    const double dy = y - polygon.Y[0];
    reach = std::max(reach, dx * dx + dy * dy);
    maximum = std::max(maximum, x * x + y * y);
  }
  return maximum < 1.0 && reach < this->SmallReach;
}

//------------------------------------------------------------------------------
/// Integrates by a Taylor series: with f at the centroid c, f(c + d) / f(c) = 1 - a d.d - 2 a c.d +
/// 2 a^2 (c.d)^2 + ..., and the moments of d over a polygon by Green's theorem.
EnergyMoments BeamEnergy::IntegrateSmall(const Polygon& polygon) const
{
  double area = 0.0, sumX = 0.0, sumY = 0.0, sumXX = 0.0, sumXY = 0.0, sumYY = 0.0;
  const double x0 = polygon.X[0];
  const double y0 = polygon.Y[0];
  for (int i = 2; i < polygon.Size; ++i)
  {
    const double ax = polygon.X[i - 1] - x0;
    const double ay = polygon.Y[i - 1] - y0;
    const double bx = polygon.X[i] - x0;
    const double by = polygon.Y[i] - y0;
    const double cross = ax * by - ay * bx;
    area += cross;
    sumX += cross * (ax + bx);
    sumY += cross * (ay + by);
    sumXX += cross * (ax * ax + ax * bx + bx * bx);
    sumXY += cross * (2.0 * (ax * ay + bx * by) + ax * by + bx * ay);
    sumYY += cross * (ay * ay + ay * by + by * by);
  }
  EnergyMoments m;
  if (!(area > 0.0))
  {
    return m;
  }
  const double meanX = sumX / (3.0 * area);
  const double meanY = sumY / (3.0 * area);
  // Central, per area.
  const double xx = sumXX / (6.0 * area) - meanX * meanX;
  const double xy = sumXY / (12.0 * area) - meanX * meanY;
  const double yy = sumYY / (6.0 * area) - meanY * meanY;
  const double x = x0 + meanX;
  const double y = y0 + meanY;
  const double a = this->Exponent;
  // Uses the intensity, whose integral over the plane is 1 / Scale; and half of the area.
  const double peak = 0.5 * area * a * this->Scale / Pi * std::exp(-a * (x * x + y * y));
  const double quadratic = x * x * xx + 2.0 * x * y * xy + y * y * yy;
  m.Energy = peak * (1.0 - a * (xx + yy) + 2.0 * a * a * quadratic);
  m.X = x * m.Energy - 2.0 * a * peak * (x * xx + y * xy);
  m.Y = y * m.Energy - 2.0 * a * peak * (x * xy + y * yy);
  m.XX = x * (2.0 * m.X - x * m.Energy) + peak * xx;
  m.XY = x * m.Y + y * m.X - x * y * m.Energy + peak * xy;
  m.YY = y * (2.0 * m.Y - y * m.Energy) + peak * yy;
  return m;
}

//------------------------------------------------------------------------------
EnergyMoments BeamEnergy::Integrate(const Polygon& polygon) const
{
  if (polygon.IsEmpty())
  {
    return EnergyMoments();
  }
  if (this->IsSmall(polygon))
  {
    return this->IntegrateSmall(polygon);
  }
  Sums sums;
  Nodes nodes;
  double azimuth = 0.0; // azimuth of the edges beyond the circle
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
    this->AddInside(from, step, first, last, nodes, sums);
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
  this->AddNodes(nodes, sums);
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
