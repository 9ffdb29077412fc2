// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Whether the triangles of a scene leave a cone empty, or fill it with one plane or one surface.

#ifndef heliosConeTest_h
#define heliosConeTest_h

#include "heliosCone.h"
#include "heliosConeLayer.h"
#include "heliosPlaneLimits.h"
#include "heliosTriangleTest.h"
#include "vtkHeliosRay.h"

namespace helios
{

class ConeGroup;
class SceneTree;

/// Tests one cone: gathers the triangles that touch it, from front to back, and classifies them.
/// What rounding leaves in doubt is Unresolved.
class ConeTest
{
public:
  /// The limits must outlive the test.
  ConeTest(
    const double origin[3], const double axis[3], double tanHalfAngle, const PlaneLimits& limits);

  /// Tests a scene, see ConeProbe::Probe().
  vtkHeliosConeHit Run(const SceneTree& scene, ConeLayer* layer, const ConeGroup* group);

private:
  /// A triangle that touches the cone.
  struct Member : ConeCandidate
  {
    double Response; ///< negative before it is asked for
  };
  struct Gap;

  bool Walk();
  bool WalkGroup(const ConeGroup& group);
  bool Add(const PlacedTree& placed, vtkTypeInt32 triangle);
  void SetHit(const Member& c, double range);
  bool TraceAxis();
  bool IsFarther(const Member& c) const;
  void DropFarther();
  vtkHeliosConeHit Classify(ConeLayer* layer);
  bool AreNear(const PlaneLimits::Difference& maximum);
  bool AreAlike(Member& a, Member& b, double contrast) const;
  double GetResponse(Member& c) const;
  double GetDistance(const Member& a, const Member& b) const;
  static bool IsFold(const Member& c, const Member& first);
  double GetFoldDistance(const Member& c, const Member& first) const;
  double GetLead(const Member& c, const Member& other) const;
  bool IsBehindCover(const Member& c) const;
  bool HasFreeEdge(int member) const;
  bool HasNoFreeEdges() const;
  int CountNeighbors(int member, int edge) const;
  bool IsSingleSurface() const;
  int CountNearAxis() const;
  void FindLayer(ConeLayer& layer);
  void SetLayer(ConeLayer& layer) const;

  static constexpr int MaximumMembers = ConeLayer::Capacity;

  Cone Shape;
  const PlaneLimits& Limits;
  const SceneTree* Scene = nullptr;
  TestRay Axis;
  bool IsValid;

  int Count = 0;
  Member Members[MaximumMembers + 1]; ///< the last one is not counted
  vtkHeliosHit Hit{ NoHit, -1 };      ///< first hit of the axis
  double Farthest = NoHit;            ///< depth beyond which hits are irrelevant
  bool IsTraced = false;              ///< whether the hit is the first of the whole scene
  bool IsIncomplete = false;          ///< whether Farthest has increased
};

} // namespace helios

#endif
