// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma GCC diagnostic ignored "-Wpsabi" // vectors are passed to inlined functions only
#include "heliosConeTest.h"

#include "heliosConeGroup.h"
#include "heliosConeWalk.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace helios
{

namespace
{

// rounding of sums of a few products, relative to the largest of them
constexpr double Error = 0x1p-47;
constexpr double Margin = 1e-9;     // share of depths
constexpr double NoLength = 1e-300; // length below which an edge is none
constexpr int MaximumOutliers = 64; // tested one by one

const vtkHeliosConeHit Unknown{ vtkHeliosConeHit::Unresolved, -1, 0.0 };

double Dot(const double a[3], const double b[3])
{
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/// Returns an upper bound of the length.
double GetLength(const double a[3])
{
  return std::abs(a[0]) + std::abs(a[1]) + std::abs(a[2]);
}

bool AreSame(const double* a, const double* b)
{
  return a[0] == b[0] && a[1] == b[1] && a[2] == b[2];
}

/// Returns whether another triangle adjoins an edge on its other side.
bool Adjoins(const ConeCandidate& c, int edge, const ConeCandidate& other)
{
  const double* from = c.Points[(edge + 1) % 3];
  const double* to = c.Points[(edge + 2) % 3];
  // Seen from the apex they have the same orientation if they traverse the edge in opposite
  // directions.
  for (int k = 0; k < 3; ++k)
  {
    if (AreSame(from, other.Points[k]))
    {
      const double product = c.Sign * other.Sign;
      return product > 0.0 ? AreSame(to, other.Points[(k + 2) % 3])
                           : product < 0.0 && AreSame(to, other.Points[(k + 1) % 3]);
    }
  }
  return false;
}

/// Returns whether a triangle lies behind a plane by more than a distance.
bool IsBehind(const ConeCandidate& c, const ConeCandidate::Plane& plane, double distance)
{
  const double minimum = plane.Constant * (1 + distance / plane.Nearest + Margin);
  const double error = Error * GetLength(plane.Normal);
  return std::all_of(c.Corners, c.Corners + 3,
    [&](const double* p) { return Dot(plane.Normal, p) - error * GetLength(p) > minimum; });
}

} // namespace

ConeTest::ConeTest(
  const double origin[3], const double axis[3], double tanHalfAngle, const PlaneLimits& limits)
  : Shape(origin, axis, tanHalfAngle)
  , Limits(limits)
{
  this->IsValid =
    SetAxis(origin, axis, this->Axis) && tanHalfAngle >= 0.0 && limits.OfPlane.Distance >= 0.0;
}

//------------------------------------------------------------------------------
vtkHeliosConeHit ConeTest::Run(const SceneTree& scene, ConeLayer* layer, const ConeGroup* group)
{
  if (layer)
  {
    layer->Size = 0;
  }
  this->Scene = &scene;
  if (!this->IsValid || scene.GetMesh().GetTree().GetOutliers().size() > MaximumOutliers)
  {
    return Unknown;
  }
  if (group && this->WalkGroup(*group))
  {
    return this->Classify(layer);
  }
  bool isKnown = this->Walk();
  if (isKnown && this->IsIncomplete)
  {
    this->Count = 0;
    isKnown = this->Walk();
  }
  return isKnown ? this->Classify(layer) : Unknown;
}

/// Adds the triangles that touch the cone; false once it is known to be mixed.
bool ConeTest::Walk()
{
  return WalkCone(this->Shape, this->Axis.Axes, *this->Scene, this->Farthest,
    [this](const PlacedTree& placed, vtkTypeInt32 triangle)
    { return this->Add(placed, triangle); });
}

/// Adds those of a group; false, and none is added, if one of them would make the cone mixed: only the trees know
/// whether it is hidden.
bool ConeTest::WalkGroup(const ConeGroup& group)
{
  const Cone& cone = this->Shape;
  const double distance = std::max(this->Limits.OfPlane.Distance, this->Limits.OfLayer.Distance);
  const ConeTriangles found =
    group.Select(cone.GetOrigin(), cone.GetAxis(2), cone.GetTangent(), distance);
  const bool isKnown = group.Visit(found.Touched,
    [this](const PlacedTree& placed, vtkTypeInt32 triangle)
    { return this->Add(placed, triangle); });
  if (!isKnown)
  {
    this->Count = 0;
    this->Hit = { NoHit, -1 };
    this->Farthest = NoHit;
    this->IsTraced = false;
    this->IsIncomplete = false;
  }
  return isKnown;
}

//------------------------------------------------------------------------------
/// Adds a triangle if it touches the cone; false once the cone is known to be mixed. The result does
/// not depend on the order of the triangles.
bool ConeTest::Add(const PlacedTree& placed, vtkTypeInt32 triangle)
{
  Member* c = this->Members + this->Count;
  this->Shape.SetCorners(placed, triangle, *c);
  if (!this->Shape.Touches(*c))
  {
    return true;
  }
  if (!c->IsBefore && !c->Covers)
  {
    return false;
  }
  if (this->Count == MaximumMembers)
  {
    if (!this->IsTraced && !this->TraceAxis())
    {
      return false;
    }
    this->Shape.SetPlane(*c);
    this->DropFarther();
    if (this->IsFarther(*c) || this->Count == MaximumMembers)
    {
      return this->IsFarther(*c);
    }
    this->Members[this->Count] = *c;
    c = this->Members + this->Count;
  }
  ++this->Count;
  c->Response = -1.0;
  this->Shape.SetPlane(*c);
  const double* const points[3] = { c->Points[0], c->Points[1], c->Points[2] };
  const double range = c->MayHoldAxis ? TestTriangle(this->Axis, points) : NoHit;
  if (range < this->Hit.Range || (range == this->Hit.Range && c->Cell < this->Hit.CellId))
  {
    this->SetHit(*c, range);
  }
  return true;
}

/// Sets the hit of the axis, with a triangle whose plane is known.
void ConeTest::SetHit(const Member& c, double range)
{
  const double before = this->Farthest;
  this->Hit = { range, c.Cell };
  this->Farthest =
    c.Surface.Farthest + std::max(this->Limits.OfPlane.Distance, this->Limits.OfLayer.Distance);
  this->IsIncomplete = this->IsIncomplete || this->Farthest > before;
}

/// Finds the hit of the axis; false if it hits nothing.
bool ConeTest::TraceAxis()
{
  this->IsTraced = true;
  vtkHeliosRay ray;
  std::copy_n(this->Axis.Origin, 3, ray.Origin);
  std::copy_n(this->Axis.Direction, 3, ray.Direction);
  const vtkHeliosHit hit = this->Scene->AddOutliers(ray, this->Scene->Intersect(ray));
  if (hit.CellId < 0)
  {
    return false;
  }
  Member c;
  c.Cell = hit.CellId;
  this->Scene->GetCellPoints(hit.CellId, c.Points);
  this->Shape.SetCorners(c);
  this->Shape.Touches(c);
  this->Shape.SetPlane(c);
  this->SetHit(c, hit.Range);
  return true;
}

/// Returns whether all of a member inside the cone is beyond Farthest.
bool ConeTest::IsFarther(const Member& c) const
{
  return c.Cell != this->Hit.CellId && this->Shape.GetNearestDepth(c) > this->Farthest;
}

/// Drops the members beyond Farthest.
void ConeTest::DropFarther()
{
  const auto isFarther = [this](const Member& c) { return this->IsFarther(c); };
  Member* end = std::remove_if(this->Members, this->Members + this->Count, isFarther);
  this->Count = static_cast<int>(end - this->Members);
}

//------------------------------------------------------------------------------
/// Returns the combined result of the members.
vtkHeliosConeHit ConeTest::Classify(ConeLayer* layer)
{
  if (this->Count == 0)
  {
    return { vtkHeliosConeHit::Empty, -1, NoHit };
  }
  Member* const end = this->Members + this->Count;
  Member* const hit = std::find_if(
    this->Members, end, [this](const Member& c) { return c.Cell == this->Hit.CellId; });
  if (hit == end)
  {
    return Unknown;
  }
  if (hit != this->Members)
  {
    std::swap(*hit, this->Members[0]);
  }
  const int count = this->Count;
  if (this->AreNear(this->Limits.OfPlane) && this->HasNoFreeEdges())
  {
    if (layer)
    {
      this->FindLayer(*layer);
    }
    return { vtkHeliosConeHit::PlanarFootprint, this->Hit.CellId, this->Hit.Range };
  }
  this->Count = count;
  if (layer && this->Limits.OfLayer.Distance > 0.0 && this->AreNear(this->Limits.OfLayer))
  {
    this->FindLayer(*layer);
  }
  return Unknown;
}

/// Returns whether the members differ little from the first. Those behind are moved to the end, and
/// not counted any more.
bool ConeTest::AreNear(const PlaneLimits::Difference& maximum)
{
  Member& first = this->Members[0];
  double folds = 0.0; // the sum of the distances at the rim
  for (int i = 1; i < this->Count;)
  {
    Member& c = this->Members[i];
    const bool isOn = this->GetDistance(c, first) <= maximum.Distance;
    if (isOn || this->IsFold(c, first))
    {
      folds += isOn ? 0.0 : this->GetFoldDistance(c, first);
      if (folds > maximum.Distance || !this->AreAlike(first, c, maximum.Contrast))
      {
        return false;
      }
      ++i;
    }
    else if (IsBehind(c, first.Surface, maximum.Distance) || this->IsFarther(c))
    {
      std::swap(c, this->Members[--this->Count]);
    }
    else
    {
      return false;
    }
  }
  return true;
}

/// The difference of 1 / depth on two planes, as a vector whose product with a direction (x, y, 1)
/// it is; and the largest product of the depths.
struct ConeTest::Gap
{
  Gap(const ConeCandidate::Plane& a, const ConeCandidate::Plane& b)
    : Scale(a.Farthest * b.Farthest)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      this->Slope[axis] = a.Inverse[axis] - b.Inverse[axis];
    }
  }
  double GetAcross(double tangent) const
  {
    return tangent * std::sqrt(this->Slope[0] * this->Slope[0] + this->Slope[1] * this->Slope[1]);
  }

  double Slope[3];
  double Scale;
};

/// Returns the largest distance of the planes of two triangles over the cone: |1 / h - 1 / h'| h
/// h'.
double ConeTest::GetDistance(const Member& a, const Member& b) const
{
  if (!(a.Surface.Farthest < NoHit && b.Surface.Farthest < NoHit))
  {
    return NoHit;
  }
  const Gap gap(a.Surface, b.Surface);
  return (std::abs(gap.Slope[2]) + gap.GetAcross(this->Shape.GetTangent())) * gap.Scale;
}

/// Returns whether a triangle begins at an edge of the first, across the whole cone, and ends
/// outside it.
bool ConeTest::IsFold(const Member& c, const Member& first)
{
  const auto* const end = c.EdgeTouches + 3;
  const auto* const edge = std::find(c.EdgeTouches, end, true);
  return c.IsBefore && std::count(c.EdgeTouches, end, true) == 1 &&
    Adjoins(c, static_cast<int>(edge - c.EdgeTouches), first);
}

/// Returns the largest distance of a triangle beyond a fold from the plane of the first, inside the
/// cone: on its side of the fold the difference has one sign.
double ConeTest::GetFoldDistance(const Member& c, const Member& first) const
{
  if (!(c.Surface.Farthest < NoHit && first.Surface.Farthest < NoHit))
  {
    return NoHit;
  }
  const Gap gap(c.Surface, first.Surface);
  double inside = 0.0; // the largest, of the corners
  for (const auto& d : c.Flat)
  {
    const double product = gap.Slope[0] * d[0] + gap.Slope[1] * d[1] + gap.Slope[2];
    inside = std::abs(product) > std::abs(inside) ? product : inside;
  }
  const double atAxis = inside < 0.0 ? -gap.Slope[2] : gap.Slope[2];
  return (atAxis + gap.GetAcross(this->Shape.GetTangent())) * gap.Scale;
}

bool ConeTest::AreAlike(Member& a, Member& b, double contrast) const
{
  if (!this->Limits.GetResponse)
  {
    return true;
  }
  const double first = this->GetResponse(a);
  const double second = this->GetResponse(b);
  return std::abs(first - second) <= contrast * std::max(first, second);
}

double ConeTest::GetResponse(Member& c) const
{
  if (c.Response < 0.0)
  {
    c.Response = this->Limits.GetResponse(c.Cell);
  }
  return c.Response;
}

//------------------------------------------------------------------------------
/// Returns how far the plane of a triangle is before another plane, at most, inside the cone;
/// negative if it is behind all over.
double ConeTest::GetLead(const Member& c, const Member& other) const
{
  if (!(c.Surface.Farthest < NoHit && other.Surface.Farthest < NoHit))
  {
    return NoHit;
  }
  const Gap gap(c.Surface, other.Surface);
  return (gap.Slope[2] + gap.GetAcross(this->Shape.GetTangent())) * gap.Scale;
}

/// Returns whether a member that covers the cone hides another, but for the permitted overlap.
bool ConeTest::IsBehindCover(const Member& c) const
{
  return std::any_of(this->Members, this->Members + this->Count,
    [&](const Member& other)
    { return other.Covers && &other != &c && this->GetLead(c, other) <= this->Limits.Overlap; });
}

/// Returns whether a member ends inside the cone, at an edge beyond which no other member
/// continues.
bool ConeTest::HasFreeEdge(int member) const
{
  const Member& c = this->Members[member];
  bool isFree = c.Sign == 0.0;
  for (int edge = 0; edge < 3 && !isFree; ++edge)
  {
    isFree = c.EdgeTouches[edge] && this->CountNeighbors(member, edge) == 0;
  }
  return isFree;
}

/// Returns whether the members cover the cone, without one that ends inside it before the others.
bool ConeTest::HasNoFreeEdges() const
{
  for (int i = 0; i < this->Count; ++i)
  {
    if (this->HasFreeEdge(i) && !this->IsBehindCover(this->Members[i]))
    {
      return false;
    }
  }
  return true;
}

/// Counts the members that adjoin an edge on its other side.
int ConeTest::CountNeighbors(int member, int edge) const
{
  const Member& c = this->Members[member];
  return static_cast<int>(std::count_if(this->Members, this->Members + this->Count,
    [&](const Member& other) { return &other != &c && Adjoins(c, edge, other); }));
}

//------------------------------------------------------------------------------
/// Returns whether every direction in the cone meets one member. Across an edge with one neighbor
/// their number does not change: it is the same everywhere.
bool ConeTest::IsSingleSurface() const
{
  for (int i = 0; i < this->Count; ++i)
  {
    const Member& c = this->Members[i];
    for (int edge = 0; edge < 3; ++edge)
    {
      if (c.Sign == 0.0 || (c.EdgeTouches[edge] && this->CountNeighbors(i, edge) != 1))
      {
        return false;
      }
    }
  }
  return this->CountNearAxis() == 1;
}

/// Sets the layer of the members, if they have one: the first of them, if it hides all others, or a
/// single surface.
void ConeTest::FindLayer(ConeLayer& layer)
{
  const Member& first = this->Members[0];
  const bool isHiding = first.Covers &&
    std::all_of(this->Members + 1, this->Members + this->Count,
      [&](const Member& c) { return this->GetLead(c, first) <= this->Limits.Overlap; });
  this->Count = isHiding ? 1 : this->Count;
  if (isHiding || this->IsSingleSurface())
  {
    this->SetLayer(layer);
  }
}

//------------------------------------------------------------------------------
/// Counts the members that a direction near the axis meets, which is rarely on an edge, unlike the
/// axis.
int ConeTest::CountNearAxis() const
{
  const double x = 0.0123 * this->Shape.GetTangent();
  const double y = 0.0271 * this->Shape.GetTangent();
  return static_cast<int>(std::count_if(this->Members, this->Members + this->Count,
    [&](const Member& c)
    {
      return std::all_of(c.Edges, c.Edges + 3,
        [&](const double* e) { return c.Sign * (e[0] * x + e[1] * y + e[2]) > 0.0; });
    }));
}

/// Sets a layer to the members, sorted by triangle.
void ConeTest::SetLayer(ConeLayer& layer) const
{
  this->Shape.CopyFrame(layer.Frame);
  layer.Size = this->Count;
  for (int i = 0; i < this->Count; ++i)
  {
    const Member& c = this->Members[i];
    const auto place = std::count_if(this->Members, this->Members + this->Count,
      [&c](const Member& other) { return other.Cell < c.Cell; });
    ConeLayer::Piece& piece = layer.Pieces[place];
    piece.Cell = c.Cell;
    for (int edge = 0; edge < 3; ++edge)
    {
      const double* e = c.Edges[edge];
      const double scale = c.Sign / std::max(GetLength(e), NoLength);
      for (int axis = 0; axis < 3; ++axis)
      {
        piece.Edges[edge][axis] = scale * e[axis];
      }
    }
    std::copy_n(c.Surface.Inverse, 3, piece.Inverse);
  }
}

} // namespace helios
