// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Whether the triangles of a scene leave a cone empty, or fill it with one plane.

#ifndef heliosConeTest_h
#define heliosConeTest_h

#include "heliosBeamTree.h"
#include "heliosConeLayer.h"
#include "heliosConeView.h"
#include "heliosPlaneLimits.h"
#include "vtkHeliosRay.h"

namespace helios
{

class LeafFilter;

/**
 * A cone in its own frame: the apex is the origin, the axis is z. A triangle, seen from the apex,
 * is the region where all three of N_k . d have the sign of its determinant, N_k being the cross
 * product of the corners of the edge opposite corner k; over the directions d = (x, y, 1) of the
 * cone N . d spans N_z -+ T |N_xy|. This distinguishes touching from covering without a division,
 * also with corners behind the apex. The remaining cases are decided in the plane z = 1, where
 * the cone is a disc.
 *
 * Rounding errs towards Mixed: signs count only beyond a bound of their error.
 */
class ConeTest
{
public:
  /// The limits must outlive the test.
  ConeTest(
    const double origin[3], const double axis[3], double tanHalfAngle, const PlaneLimits& limits);

  /// As ConeProbe::Probe().
  vtkHeliosConeHit Run(const BeamTree& tree, ConeLayer* layer);

  /// As ConeProbe::Collect().
  bool Collect(const BeamTree& tree, double nearest, std::size_t most, ConeView& view);

private:
  /// A triangle that may touch the cone.
  struct Candidate
  {
    vtkTypeInt32 Triangle;
    const double* Points[3];
    double Corners[3][3]; ///< in the frame of the cone
    double Edges[3][3];   ///< N_k
    double Errors[3];     ///< of N_k . d
    double Sign;          ///< of the determinant; 0 if unresolved
    bool IsBefore;        ///< all of it is before the apex
    bool Covers;          ///< the whole cone
  };
  /// The plane n . p = c in the frame of the cone, with c > 0.
  struct Plane
  {
    double Normal[3];
    double Constant;
    double Across;            ///< |n_xy|
    double Nearest, Farthest; ///< depth over the cone; Farthest may be infinite
  };

  bool SetHull(const BeamTree& tree, Frustum& hull, LeafFilter& filter) const;
  template <typename AddT>
  bool Walk(const BeamTree& tree, AddT add);
  bool Add(const TriangleMesh& mesh, vtkTypeInt32 triangle);
  void SetCorners(const TriangleMesh& mesh, vtkTypeInt32 triangle, Candidate& c) const;
  void Add(const TriangleMesh& mesh, vtkTypeInt32 triangle, double nearest, ConeView& view);
  bool IsBeside(const Candidate& c) const;
  bool MayCover(const Candidate& c) const;
  bool Touches(Candidate& c) const;
  bool EdgeTouches(const Candidate& c, int edge, double radius) const;
  Plane GetPlane(const Candidate& c) const;
  bool IsBehind(const Candidate& c, const Plane& plane, double distance) const;
  bool IsOn(const Candidate& c, const Plane& plane, double distance) const;
  bool IsShared(int member, int edge) const;
  bool DropFarther();
  vtkHeliosConeHit Classify(ConeLayer* layer);
  bool AreOneSurface(double distance, const PlaneLimits::Relation& relation);
  int CountAtAxis() const;
  void SetLayer(ConeLayer& layer) const;

  static constexpr int MaximumCandidates = ConeLayer::Capacity;

  const double* Origin;
  double Tangent;
  const PlaneLimits& Limits;
  double Frame[3][3]; ///< rows: two axes across, the axis
  TestRay Axis;
  bool IsValid;

  int Count = 0;
  Candidate Candidates[MaximumCandidates];
  vtkHeliosHit Hit{ NoHit, -1 }; ///< of the axis
  double Farthest = NoHit;       ///< depth beyond which hits are irrelevant
};

} // namespace helios

#endif
