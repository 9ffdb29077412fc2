// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma GCC diagnostic ignored "-Wpsabi" // vectors are passed to inlined functions only
#include "heliosCone.h"

#include "heliosLeafFilter.h"
#include "heliosPlacedTree.h"

#include <algorithm>
#include <cmath>

namespace helios
{

namespace
{

// rounding of sums of a few products, relative to the largest of them
constexpr double Error = 0x1p-47;
constexpr double Margin = 1e-9; // share of the cone's width
constexpr double Widest = 0.2;  // square of the sine of the half angle

double Dot(const double a[3], const double b[3])
{
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

void Cross(const double a[3], const double b[3], double c[3])
{
  c[0] = a[1] * b[2] - a[2] * b[1];
  c[1] = a[2] * b[0] - a[0] * b[2];
  c[2] = a[0] * b[1] - a[1] * b[0];
}

/// Returns an upper bound of the length.
double GetLength(const double a[3])
{
  return std::abs(a[0]) + std::abs(a[1]) + std::abs(a[2]);
}

double GetLargestLength(const ConeCandidate& c)
{
  const auto& p = c.Corners;
  return std::max({ GetLength(p[0]), GetLength(p[1]), GetLength(p[2]) });
}

/// Returns whether a segment is within a distance of the origin.
bool IsNear(const double a[2], const double b[2], double distance)
{
  const double d[2] = { b[0] - a[0], b[1] - a[1] };
  const double maximum = distance * distance;
  const double along = -(a[0] * d[0] + a[1] * d[1]);
  const double square = d[0] * d[0] + d[1] * d[1];
  if (along <= 0.0)
  {
    return a[0] * a[0] + a[1] * a[1] <= maximum;
  }
  if (along >= square)
  {
    return b[0] * b[0] + b[1] * b[1] <= maximum;
  }
  const double area = a[0] * d[1] - a[1] * d[0];
  return area * area <= maximum * square;
}

/// Computes the part of a segment, from 0 to 1, inside a disc about the origin; false if it is all
/// outside.
bool ClipToDisc(const double a[2], const double b[2], double radius, double part[2])
{
  const double d[2] = { b[0] - a[0], b[1] - a[1] };
  const double square = d[0] * d[0] + d[1] * d[1];
  const double along = a[0] * d[0] + a[1] * d[1];
  const double root =
    std::sqrt(along * along - square * (a[0] * a[0] + a[1] * a[1] - radius * radius));
  part[0] = square > 0.0 ? std::max(0.0, (-along - root) / square) : 0.0;
  part[1] = square > 0.0 ? std::min(1.0, (-along + root) / square) : 1.0;
  return root >= 0.0 && part[0] <= part[1]; // false for a NaN
}

/**
 * Returns whether a segment p = a + t (b - a) may enter a cone: f = x^2 + y^2 - T^2 z^2, a
 * quadratic function of t, is not positive somewhere before the apex.
 */
bool EntersCone(const double a[3], const double b[3], double tangent, double reach)
{
  const double d[3] = { b[0] - a[0], b[1] - a[1], b[2] - a[2] };
  double first = 0.0; // the part with z >= 0
  double last = 1.0;
  if (a[2] < 0.0 || b[2] < 0.0)
  {
    const double crossing = -a[2] / d[2];
    first = a[2] < 0.0 ? crossing : 0.0;
    last = b[2] < 0.0 ? crossing : 1.0;
  }
  const double square = tangent * tangent;
  const double error = Error * reach * reach * (1 + square);
  const double f0 = a[0] * a[0] + a[1] * a[1] - square * a[2] * a[2];
  const double f1 = a[0] * d[0] + a[1] * d[1] - square * a[2] * d[2];
  const double f2 = d[0] * d[0] + d[1] * d[1] - square * d[2] * d[2];
  const auto isInside = [=](double t) { return f0 + t * (2 * f1 + t * f2) <= error; };
  if (!(first <= last)) // also for a crossing at infinity
  {
    return isInside(0.0) || isInside(1.0);
  }
  const bool hasMinimum = f2 > 0.0 && -f1 > first * f2 && -f1 < last * f2;
  return isInside(first) || isInside(last) || (hasMinimum && isInside(-f1 / f2));
}

double GetSineSquare(double tangent)
{
  return tangent * tangent / (1 + tangent * tangent);
}

} // namespace

ConeSlopes::ConeSlopes(double x, double along, double tangent)
{
  // The planes x = f z that touch the cone: (w_x - f w_z)^2 = sin^2 (1 + f^2).
  const double sineSquare = GetSineSquare(tangent);
  const double a = along * along - sineSquare;
  const double root =
    std::sqrt(sineSquare * std::max(0.0, x * x + along * along - sineSquare)) * (1 + Margin);
  this->Low = (x * along - root) / a - Error;
  this->High = (x * along + root) / a + Error;
}

//------------------------------------------------------------------------------
Cone::Cone(const double origin[3], const double axis[3], double tanHalfAngle)
  : Origin(origin)
  , Tangent(tanHalfAngle)
{
  const double length = std::sqrt(Dot(axis, axis));
  double* w = this->Frame[2];
  for (int i = 0; i < 3; ++i)
  {
    w[i] = axis[i] / length;
  }
  // Duff et al., "Building an Orthonormal Basis, Revisited" (JCGT 6(1), 2017).
  const double sign = w[2] >= 0.0 ? 1.0 : -1.0;
  const double a = -1.0 / (sign + w[2]);
  const double b = w[0] * w[1] * a;
  const double u[3] = { 1.0 + sign * w[0] * w[0] * a, sign * b, -sign * w[0] };
  const double v[3] = { b, sign + w[1] * w[1] * a, -w[1] };
  // Turned by the golden ratio: cells across the cone are not parallel to walls and eaves.
  constexpr double cosine = 0.85065080835203993;
  constexpr double sine = 0.52573111211913361;
  for (int i = 0; i < 3; ++i)
  {
    this->Frame[0][i] = cosine * u[i] + sine * v[i];
    this->Frame[1][i] = cosine * v[i] - sine * u[i];
  }
}

//------------------------------------------------------------------------------
void Cone::CopyFrame(double frame[3][3]) const
{
  std::copy_n(&this->Frame[0][0], 9, &frame[0][0]);
}

//------------------------------------------------------------------------------
double Cone::GetStretch(const RayAxes& axes) const
{
  const double w = std::abs(this->Frame[2][axes.Z]);
  return (w + this->Tangent * std::sqrt(std::max(0.0, 1 - w * w))) * (1 + Margin);
}

//------------------------------------------------------------------------------
bool Cone::SetHull(const BeamTree& tree, const RayAxes& hullAxes, double error, Frustum& hull,
  LeafFilter& filter) const
{
  const double* w = this->Frame[2];
  if (!(GetSineSquare(this->Tangent) < Widest))
  {
    return false;
  }
  hull.Axes = hullAxes;
  const double along = std::abs(w[hull.Axes.Z]);
  hull.IsForward = w[hull.Axes.Z] > 0.0;
  const int axes[3] = { hull.Axes.X, hull.Axes.Y, hull.Axes.Z };
  double slopeLow[2], slopeHigh[2];
  for (int i = 0; i < 2; ++i)
  {
    const ConeSlopes slopes(w[axes[i]], along, this->Tangent);
    slopeLow[i] = slopes.Low;
    slopeHigh[i] = slopes.High;
  }
  const double origin[3] = { this->Origin[axes[0]], this->Origin[axes[1]], this->Origin[axes[2]] };
  if (!tree.SetFrustum(hull, origin, origin, slopeLow, slopeHigh, error))
  {
    return false;
  }
  filter.SetAxis(tree, hull, origin, origin, slopeLow, slopeHigh);
  filter.SetError(0.0);
  return true;
}

//------------------------------------------------------------------------------
void Cone::SetCorners(ConeCandidate& c) const
{
  for (int corner = 0; corner < 3; ++corner)
  {
    double p[3];
    for (int axis = 0; axis < 3; ++axis)
    {
      p[axis] = c.Points[corner][axis] - this->Origin[axis];
    }
    for (int axis = 0; axis < 3; ++axis)
    {
      c.Corners[corner][axis] = Dot(this->Frame[axis], p);
    }
  }
}

void Cone::SetCorners(const PlacedTree& placed, vtkTypeInt32 triangle, ConeCandidate& c) const
{
  c.Cell = placed.GetCell(triangle);
  double buffer[3][3];
  const double* points[3];
  placed.GetPoints(triangle, buffer, points);
  for (int corner = 0; corner < 3; ++corner)
  {
    std::copy_n(points[corner], 3, c.Points[corner]);
  }
  this->SetCorners(c);
}

//------------------------------------------------------------------------------
bool Cone::IsBeside(const ConeCandidate& c) const
{
  bool isBeside = false;
  for (int axis = 0; axis < 2; ++axis)
  {
    bool isAbove = true;
    bool isBelow = true;
    for (const auto& p : c.Corners)
    {
      const double reach = this->Tangent * p[2];
      isAbove = isAbove && p[axis] > reach;
      isBelow = isBelow && -p[axis] > reach;
    }
    isBeside = isBeside || isAbove || isBelow;
  }
  return isBeside;
}

//------------------------------------------------------------------------------
bool Cone::Touches(ConeCandidate& c) const
{
  const auto& p = c.Corners;
  const double reach = GetLargestLength(c);
  c.Reach = reach;
  if (std::max({ p[0][2], p[1][2], p[2][2] }) < -Error * reach)
  {
    return false;
  }
  c.IsBefore = std::min({ p[0][2], p[1][2], p[2][2] }) > Error * reach;
  this->SetEdges(c);
  this->SetNormal(c, reach);
  if (this->IsOutside(c))
  {
    return false;
  }
  if (c.Covers || !c.IsBefore)
  {
    std::fill_n(c.EdgeTouches, 3, !c.Covers);
    return c.Covers || this->TouchesBeside(c, reach);
  }
  const double radius = this->Tangent + (c.Sign == 0.0 ? this->GetThickness(c, reach) : 0.0);
  return this->SetEdgeTouches(c, radius) || (c.Sign != 0.0 && c.MayHoldAxis);
}

/// Sets the planes through the apex and the edges, and the corners in the plane z = 1.
void Cone::SetEdges(ConeCandidate& c) const
{
  const auto& p = c.Corners;
  const double lengths[3] = { GetLength(p[0]), GetLength(p[1]), GetLength(p[2]) };
  for (int k = 0; k < 3; ++k)
  {
    const int i = (k + 1) % 3;
    const int j = (k + 2) % 3;
    Cross(p[i], p[j], c.Edges[k]);
    c.Errors[k] = Error * lengths[i] * lengths[j] * (1 + this->Tangent);
    const double inverse = 1.0 / p[k][2]; // used if the triangle is before the apex
    c.Flat[k][0] = p[k][0] * inverse;
    c.Flat[k][1] = p[k][1] * inverse;
    c.FlatErrors[k] = Error * lengths[k] * inverse;
  }
}

/// Sets the normal and the determinant, from the corners' differences, which are exact or nearly
/// so: they are small for distant triangles.
void Cone::SetNormal(ConeCandidate& c, double reach) const
{
  const auto& p = c.Corners;
  double a[3], b[3];
  for (int axis = 0; axis < 3; ++axis)
  {
    a[axis] = p[1][axis] - p[0][axis];
    b[axis] = p[2][axis] - p[0][axis];
  }
  Cross(a, b, c.Normal);
  c.NormalDoubt = Error * reach * (GetLength(a) + GetLength(b));
  c.Determinant = Dot(c.Normal, p[0]);
  const double doubt = reach * c.NormalDoubt;
  c.Sign = c.Determinant > doubt ? 1.0 : (c.Determinant < -doubt ? -1.0 : 0.0);
}

/// Returns whether the cone is beyond an edge; sets what the axis and the whole cone have in common
/// with the triangle.
bool Cone::IsOutside(ConeCandidate& c) const
{
  c.Covers = c.Sign != 0.0;
  c.MayHoldAxis = true;
  bool isOutside = false;
  for (int k = 0; k < 3 && c.Sign != 0.0; ++k)
  {
    const double* e = c.Edges[k];
    const double width =
      this->Tangent * std::sqrt(e[0] * e[0] + e[1] * e[1]) * (1 + Margin) + c.Errors[k];
    const double along = c.Sign * e[2];
    isOutside = isOutside || along + width < 0.0;
    c.Covers = c.Covers && along - width > 0.0;
    c.MayHoldAxis = c.MayHoldAxis && along > -c.Errors[k];
  }
  return isOutside;
}

/// Returns whether a triangle that is not before the apex, and that no plane of an edge separates
/// from the cone, may touch it: the axis meets it, or an edge does, or the apex may be on it.
bool Cone::TouchesBeside(const ConeCandidate& c, double reach) const
{
  if (c.Sign != 0.0 && c.MayHoldAxis)
  {
    return true;
  }
  const auto& p = c.Corners;
  const double tolerance = Error * reach;
  bool isAround = c.Sign == 0.0; // its box, around the apex
  for (int axis = 0; axis < 3; ++axis)
  {
    isAround = isAround && std::min({ p[0][axis], p[1][axis], p[2][axis] }) <= tolerance &&
      std::max({ p[0][axis], p[1][axis], p[2][axis] }) >= -tolerance;
  }
  const double tangent = this->Tangent * (1 + Margin);
  return isAround || EntersCone(p[0], p[1], tangent, reach) ||
    EntersCone(p[1], p[2], tangent, reach) || EntersCone(p[2], p[0], tangent, reach);
}

/// Returns the thickness, in the plane z = 1, of a triangle that may be edge-on.
double Cone::GetThickness(const ConeCandidate& c, double reach) const
{
  double thickness = HUGE_VAL;
  for (int k = 0; k < 3; ++k)
  {
    const double* e = c.Edges[k];
    const double size = std::sqrt(e[0] * e[0] + e[1] * e[1]) * (1 + Margin);
    thickness = std::min(thickness, 2 * reach * c.NormalDoubt / (c.Corners[k][2] * size));
  }
  return thickness;
}

/// Sets the edges, before the apex, that touch a cone: a disc of a radius in the plane z = 1.
bool Cone::SetEdgeTouches(ConeCandidate& c, double radius) const
{
  for (int k = 0; k < 3; ++k)
  {
    const int i = (k + 1) % 3;
    const int j = (k + 2) % 3;
    const double error = std::max(c.FlatErrors[i], c.FlatErrors[j]);
    c.EdgeTouches[k] = IsNear(c.Flat[i], c.Flat[j], radius * (1 + Margin) + error);
  }
  return c.EdgeTouches[0] || c.EdgeTouches[1] || c.EdgeTouches[2];
}

//------------------------------------------------------------------------------
void Cone::SetPlane(ConeCandidate& c) const
{
  ConeCandidate::Plane& plane = c.Surface;
  const double sign = c.Determinant < 0.0 ? -1.0 : 1.0;
  plane.Constant = sign * c.Determinant;
  for (int axis = 0; axis < 3; ++axis)
  {
    plane.Normal[axis] = sign * c.Normal[axis];
    plane.Inverse[axis] = plane.Normal[axis] / plane.Constant;
  }
  const double* n = plane.Normal;
  const double spread = this->Tangent * std::sqrt(n[0] * n[0] + n[1] * n[1]) + c.NormalDoubt;
  const double minimum = n[2] - spread;
  const double doubt = c.Reach * c.NormalDoubt; // error of the constant
  plane.Nearest = std::max(0.0, plane.Constant - doubt) / (n[2] + spread);
  plane.Farthest = minimum > 0.0 ? (plane.Constant + doubt) / minimum * (1 + Margin) : HUGE_VAL;
}

/// Returns whether the direction in which the plane of a candidate is nearest meets the candidate.
bool Cone::HoldsNearest(const ConeCandidate& c) const
{
  const double* n = c.Surface.Normal;
  const double length = std::sqrt(n[0] * n[0] + n[1] * n[1]);
  const double scale = length > 0.0 ? this->Tangent / length : 0.0;
  const double d[3] = { scale * n[0], scale * n[1], 1.0 };
  bool isInside = c.Sign != 0.0;
  for (int k = 0; k < 3; ++k)
  {
    isInside = isInside && c.Sign * Dot(c.Edges[k], d) >= -c.Errors[k];
  }
  return isInside;
}

double Cone::GetNearestDepth(const ConeCandidate& c) const
{
  if (c.Covers || (c.IsBefore && this->HoldsNearest(c)))
  {
    return c.Surface.Nearest;
  }
  if (!c.IsBefore)
  {
    return 0.0;
  }
  // Else it is on an edge, along which 1 / depth is linear in the plane z = 1.
  double inverse = 0.0;
  for (int k = 0; k < 3; ++k)
  {
    const int i = (k + 1) % 3;
    const int j = (k + 2) % 3;
    const double error = std::max(c.FlatErrors[i], c.FlatErrors[j]);
    double part[2];
    if (ClipToDisc(c.Flat[i], c.Flat[j], this->Tangent * (1 + Margin) + error, part))
    {
      const double from = 1.0 / c.Corners[i][2];
      const double step = 1.0 / c.Corners[j][2] - from;
      inverse = std::max({ inverse, from + part[0] * step, from + part[1] * step });
    }
  }
  const double nearest = std::min({ c.Corners[0][2], c.Corners[1][2], c.Corners[2][2] });
  return inverse > 0.0 ? std::max(nearest, (1 - Margin) / inverse) : nearest;
}

} // namespace helios
