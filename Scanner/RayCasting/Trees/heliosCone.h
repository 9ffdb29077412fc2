// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// A cone and the triangles that it touches.

#ifndef heliosCone_h
#define heliosCone_h

#include "heliosBeamTree.h"

namespace helios
{

class LeafFilter;
class PlacedTree;

/// The slopes x / z of the planes that touch a cone about a unit axis with the parts x and along on z,
/// rounded outwards; the cone is narrower than along.
struct ConeSlopes
{
  ConeSlopes(double x, double along, double tangent);

  double Low, High;
};

/// A triangle in the frame of a cone: the apex is the origin, the axis is z.
struct ConeCandidate
{
  /// The plane n . p = c, with c > 0.
  struct Plane
  {
    double Normal[3];
    double Inverse[3]; ///< n / c: 1 / depth in the direction (x, y, 1) is its product with that
    double Constant;
    double Nearest, Farthest; ///< depth over the cone; Farthest may be infinite
  };

  vtkIdType Cell;
  double Points[3][3]; ///< the corners in the world
  double Corners[3][3];
  double Reach;         ///< an upper bound of their distances
  double Edges[3][3];   ///< N_k, the cross product of the corners of the edge opposite corner k
  double Errors[3];     ///< errors of N_k . d
  double Flat[3][2];    ///< the corners in the plane z = 1, if the triangle is before the apex
  double FlatErrors[3]; ///< errors of Flat
  double Normal[3];     ///< normal as long as twice the area
  double NormalDoubt;   ///< the error of its product with a unit direction
  double Determinant;   ///< determinant of the corners
  double Sign;          ///< sign of the determinant; 0 if unresolved
  bool IsBefore;        ///< the whole triangle is before the apex
  bool Covers;          ///< the whole cone
  bool MayHoldAxis;     ///< the axis may hit it
  bool EdgeTouches[3];  ///< whether an edge touches the cone; none if it covers the cone
  Plane Surface;        ///< set by Cone::SetPlane()
};

/**
 * A triangle, seen from the apex, is the region where all three of N_k . d have the sign of its
 * determinant; over the directions d = (x, y, 1) of the cone N . d spans N_z -+ T |N_xy|. This
 * distinguishes touching from covering without a division, also with corners behind the apex. The
 * remaining cases are decided in the plane z = 1, where the cone is a disc.
 *
 * Signs count only beyond a bound of their error: a triangle that touches is never excluded, one
 * that covers is certain to.
 */
class Cone
{
public:
  /// The origin must outlive the cone; the axis is a unit vector.
  Cone(const double origin[3], const double axis[3], double tanHalfAngle);

  const double* GetOrigin() const { return this->Origin; }
  const double* GetAxis(int axis) const { return this->Frame[axis]; }
  double GetTangent() const { return this->Tangent; }

  /// Returns the largest distance along the main axis of a ray for a unit of depth: w_z + T sqrt(1
  /// - w_z^2).
  double GetStretch(const RayAxes& axes) const;

  /// Copies the rows: two axes across, the axis; in the world.
  void CopyFrame(double frame[3][3]) const;

  /// Sets the frustum about the cone; false for a cone that is too wide. Error: see
  /// BeamTree::SetFrustum().
  bool SetHull(const BeamTree& tree, const RayAxes& axes, double error, Frustum& hull,
    LeafFilter& filter) const;

  /// Sets the corners of a candidate from its points.
  void SetCorners(ConeCandidate& c) const;

  /// Sets the cell, the points and the corners of a candidate.
  void SetCorners(const PlacedTree& placed, vtkTypeInt32 triangle, ConeCandidate& c) const;

  /// Returns whether a triangle is beyond a side of the square about the cone.
  bool IsBeside(const ConeCandidate& c) const;

  /// Returns whether it may touch the cone; sets the candidate's terms from its corners.
  bool Touches(ConeCandidate& c) const;

  /// Sets the plane of a candidate that touches.
  void SetPlane(ConeCandidate& c) const;

  /// Returns the smallest depth of the part inside the cone, or slightly less, of a candidate that
  /// touches and has its plane.
  double GetNearestDepth(const ConeCandidate& c) const;

private:
  void SetEdges(ConeCandidate& c) const;
  void SetNormal(ConeCandidate& c, double reach) const;
  bool IsOutside(ConeCandidate& c) const;
  bool SetEdgeTouches(ConeCandidate& c, double radius) const;
  bool HoldsNearest(const ConeCandidate& c) const;
  bool TouchesBeside(const ConeCandidate& c, double reach) const;
  double GetThickness(const ConeCandidate& c, double reach) const;

  const double* Origin;
  double Tangent;
  double Frame[3][3]; ///< rows: two axes across, the axis
};

} // namespace helios

#endif
