// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma GCC diagnostic ignored "-Wpsabi" // vectors are passed to inlined functions only
#include "heliosConeGroup.h"

#include "heliosConeWalk.h"
#include "heliosRayVectors.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace helios
{

namespace
{

// rounding of sums of a few products, relative to the largest of them
constexpr double Error = 0x1p-44;
constexpr double Margin = 1e-6;        // share of a cone's width
constexpr double WidestTangent = 0.05; // tangent of a cone
constexpr double SteepestSlope = 2.0;  // slope of an axis, along the main axis of the first one
constexpr double Endless = HUGE_VAL;
constexpr std::size_t MaximumOutliers = 4;
constexpr int MaximumInstances = 4;

/// Cones as one for WalkCone(): the frustum about them.
class Cones
{
public:
  Cones(const ConeAxis* cones, std::size_t count, double tangent, bool doMove = false)
    : First(cones)
    , Count(count)
    , Tangent(tangent)
    , InstancesMove(doMove)
  {
  }

  /// Sets the main axis of the first cone; false if it has none.
  bool SetAxes(RayAxes& axes) const
  {
    TestRay ray;
    const bool isUsable = SetAxis(this->First->Origin, this->First->Axis, ray);
    axes = ray.Axes;
    return isUsable;
  }

  bool SetHull(const BeamTree& tree, const RayAxes& axes, double error, Frustum& hull,
    LeafFilter& filter) const;
  double GetStretch(const RayAxes& /*axes*/) const { return 1.0; } // the depth is not limited

  /// Returns the largest coordinate of the apexes, without its sign.
  double GetReach() const
  {
    double reach = 0.0;
    std::for_each(this->First, this->First + this->Count,
      [&reach](const ConeAxis& cone) { reach = std::max(reach, GetLargest(cone.Origin)); });
    return reach;
  }

  /// Returns the cones in the frame of an instance.
  std::vector<ConeAxis> GetLocal(const Similarity& place) const
  {
    std::vector<ConeAxis> local(this->Count);
    for (std::size_t i = 0; i < this->Count; ++i)
    {
      place.ApplyInverseToPoint(this->First[i].Origin, local[i].Origin);
      place.ApplyInverse(this->First[i].Axis, local[i].Axis);
    }
    return local;
  }

  double GetTangent() const { return this->Tangent; }

  /// Counts one more instance; false if they are too many, or if it moves.
  bool CountInstance(const PlacedTree& placed) const
  {
    return ++this->Instances <= MaximumInstances && !(this->InstancesMove && placed.HasMotion());
  }

private:
  bool SetBounds(const RayAxes& axes, bool isForward, double low[3], double high[3],
    double slopeLow[2], double slopeHigh[2]) const;

  const ConeAxis* First;
  std::size_t Count;
  double Tangent;
  bool InstancesMove; ///< those that have a motion
  mutable int Instances = 0;
};

/// Sets the intervals of the apexes and of the slopes of all rays; false if they are too steep.
bool Cones::SetBounds(const RayAxes& axes, bool isForward, double low[3], double high[3],
  double slopeLow[2], double slopeHigh[2]) const
{
  const int places[3] = { axes.X, axes.Y, axes.Z };
  std::fill_n(low, 3, Endless);
  std::fill_n(high, 3, -Endless);
  std::fill_n(slopeLow, 2, Endless);
  std::fill_n(slopeHigh, 2, -Endless);
  const double sign = isForward ? 1.0 : -1.0;
  bool areUsable = true;
  for (std::size_t i = 0; i < this->Count; ++i)
  {
    const ConeAxis& cone = this->First[i];
    const double along = sign * cone.Axis[axes.Z];
    const double largest = std::max(std::abs(cone.Axis[axes.X]), std::abs(cone.Axis[axes.Y]));
    areUsable = areUsable && largest <= SteepestSlope * along;
    for (int axis = 0; axis < 3; ++axis)
    {
      low[axis] = std::min(low[axis], cone.Origin[places[axis]]);
      high[axis] = std::max(high[axis], cone.Origin[places[axis]]);
    }
    for (int axis = 0; axis < 2; ++axis)
    {
      const ConeSlopes slopes(cone.Axis[places[axis]], along, this->Tangent);
      slopeLow[axis] = std::min(slopeLow[axis], slopes.Low);
      slopeHigh[axis] = std::max(slopeHigh[axis], slopes.High);
    }
  }
  return areUsable;
}

/// Sets the frustum about the cones; false if there is none.
bool Cones::SetHull(
  const BeamTree& tree, const RayAxes& axes, double error, Frustum& hull, LeafFilter& filter) const
{
  double low[3], high[3], slopeLow[2], slopeHigh[2];
  hull.Axes = axes;
  hull.IsForward = this->First->Axis[axes.Z] > 0.0;
  if (!this->SetBounds(axes, hull.IsForward, low, high, slopeLow, slopeHigh) ||
    !tree.SetFrustum(hull, low, high, slopeLow, slopeHigh, error))
  {
    return false;
  }
  filter.SetAxis(tree, hull, low, high, slopeLow, slopeHigh);
  // In the filter all rays cross in one point, at most as far before the frustum as the apexes are apart per slope.
  const double before = filter.GetDepth() - hull.Start * hull.Scale;
  double rest = 0.0;
  for (int axis = 0; axis < 2; ++axis)
  {
    const double steepest = std::max(std::abs(slopeLow[axis]), std::abs(slopeHigh[axis]));
    rest = std::max(rest,
      (high[axis] - low[axis] + steepest * (high[2] - low[2])) * hull.Scale +
        (slopeHigh[axis] - slopeLow[axis]) * before);
  }
  return filter.SetError(rest);
}

/// Walks the tree of an instance, for WalkInstances().
template <typename AddT>
bool WalkInstance(const Cones& cones, const PlacedTree& placed, const double& farthest, AddT add)
{
  const Similarity& place = placed.GetPlace();
  const std::vector<ConeAxis> moved = cones.GetLocal(place);
  const Cones local(moved.data(), moved.size(), cones.GetTangent());
  RayAxes axes;
  return cones.CountInstance(placed) && local.SetAxes(axes) &&
    WalkTree(local, axes, placed.GetTree(), placed.GetError(cones.GetReach()), 1.0 / place.Scale,
      farthest, [&](vtkTypeInt32 triangle) { return add(placed, triangle); });
}

} // namespace

namespace
{

/// Returns an upper bound of the lengths of vectors.
HELIOS_INLINE Doubles GetLength(const Doubles v[3])
{
  return Max<Doubles>(v[0], -v[0]) + Max<Doubles>(v[1], -v[1]) + Max<Doubles>(v[2], -v[2]);
}

HELIOS_INLINE Doubles GetDot(const Doubles v[3], const double w[3])
{
  return v[0] * w[0] + v[1] * w[1] + v[2] * w[2];
}

} // namespace

bool ConeGroup::Add(const PlacedTree& placed, vtkTypeInt32 triangle)
{
  if (this->Count == Capacity)
  {
    return false;
  }
  double buffer[3][3];
  const double* points[3];
  placed.GetPoints(triangle, buffer, points);
  for (int corner = 0; corner < 3; ++corner)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      this->Points[corner][axis][this->Count] = points[corner][axis];
    }
  }
  this->Entries[this->Count++] = { placed, triangle };
  return true;
}

//------------------------------------------------------------------------------
bool ConeGroup::Find(const SceneTree& scene, const ConeAxis* cones, std::size_t count,
  double tangent, const MomentSpan& span)
{
  this->Count = 0;
  const bool doMove = !scene.IsAtRest(span);
  const Cones all(cones, count, tangent, doMove);
  RayAxes axes;
  return count > 0 && !(doMove && !scene.HasBoxes(span)) && tangent >= 0.0 &&
    tangent < WidestTangent && scene.GetMesh().GetTree().GetOutliers().size() <= MaximumOutliers &&
    all.SetAxes(axes) &&
    WalkCone(all, axes, scene, Endless,
      [this](const PlacedTree& placed, vtkTypeInt32 triangle)
      { return this->Add(placed, triangle); });
}

//------------------------------------------------------------------------------
HELIOS_CLONES
ConeTriangles ConeGroup::Select(
  const double origin[3], const double axis[3], double tangent, double distance) const
{
  ConeTriangles result{ 0, 0 };
  const double width = tangent * (1 + Margin);
  double nearest[Capacity];
  double cover = Endless; // depth at which one covers the cone
  for (int first = 0; first < this->Count; first += QuadWidth)
  {
    Doubles p[3][3];
    Doubles reach = Doubles();
    for (int corner = 0; corner < 3; ++corner)
    {
      Doubles length = Doubles();
      for (int k = 0; k < 3; ++k)
      {
        p[corner][k] = Load<Doubles>(&this->Points[corner][k][first]) - origin[k];
        length = length + Max<Doubles>(p[corner][k], -p[corner][k]);
      }
      reach = Max(reach, length);
    }
    Doubles sign = Doubles();
    Doubles determinant = Doubles();
    Doubles normal[3] = {};
    Masks isOutside = Masks();
    Masks covers = Masks() - 1;
    const Doubles error = Error * reach * reach;
    const Doubles doubt = 8 * error * reach;
    for (int k = 0; k < 3; ++k)
    {
      const Doubles* a = p[(k + 1) % 3];
      const Doubles* b = p[(k + 2) % 3];
      const Doubles e[3] = { a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2],
        a[0] * b[1] - a[1] * b[0] };
      if (k == 0)
      {
        determinant = e[0] * p[0][0] + e[1] * p[0][1] + e[2] * p[0][2];
        sign = determinant > doubt ? Doubles() + 1.0
                                   : (determinant < -doubt ? Doubles() - 1.0 : Doubles());
      }
      const Doubles rim = width * GetLength(e) + error;
      const Doubles along = sign * GetDot(e, axis);
      isOutside = isOutside | (along + rim < 0.0);
      covers = covers & (along - rim > 0.0);
      for (int i = 0; i < 3; ++i)
      {
        normal[i] = normal[i] + e[i];
      }
    }
    // In the cone a plane is at the depths determinant / (normal . (axis + offset)).
    const Doubles slope = GetDot(normal, axis);
    const Doubles across[3] = { normal[0] - slope * axis[0], normal[1] - slope * axis[1],
      normal[2] - slope * axis[2] };
    const Doubles rim = width * GetLength(across) + 4 * error;
    const Doubles steep = Max<Doubles>(slope, -slope);
    const Doubles constant = Max<Doubles>(determinant, -determinant);
    const Doubles near = (constant - doubt) / (steep + rim);
    const Doubles far = steep > rim ? (constant + doubt) / (steep - rim) : Doubles() + Endless;
    Store(nearest + first, near);
    const int size = std::min(QuadWidth, this->Count - first);
    for (int lane = 0; lane < size; ++lane)
    {
      result.Touched |= (isOutside[lane] ? 0u : 1u) << (first + lane);
      result.Covering |= (covers[lane] && !isOutside[lane] ? 1u : 0u) << (first + lane);
      cover = covers[lane] && !isOutside[lane] ? std::min(cover, far[lane]) : cover;
    }
  }
  const double last = cover * (1 + Margin) + distance;
  for (std::uint32_t bits = result.Touched; bits != 0; bits &= bits - 1)
  {
    const int i = __builtin_ctz(bits);
    const std::uint32_t isHidden = nearest[i] > last ? 1u : 0u;
    result.Touched &= ~(isHidden << i);
    result.Covering &= ~(isHidden << i);
  }
  return result;
}

//------------------------------------------------------------------------------
HELIOS_CLONES
void ConeGroup::Meet(
  std::uint32_t bit, const vtkHeliosRay* rays, std::size_t count, vtkHeliosHit* hits) const
{
  const Entry& entry = this->Entries[__builtin_ctz(bit)];
  double buffer[3][3];
  const double* points[3];
  entry.Placed.GetPoints(entry.Triangle, buffer, points);
  const vtkIdType cell = entry.Placed.GetCell(entry.Triangle);
  const TrianglePlane plane = GetPlane(points);
  double corners[3][3];
  ComputeOffsets<double>(rays->Origin, points, corners);
  RangeTerms<double> terms;
  terms.Set(plane, corners);
  for (std::size_t first = 0; first < count; first += QuadWidth)
  {
    const std::size_t last = count - 1;
    const vtkHeliosRay& a = rays[first];
    const vtkHeliosRay& b = rays[std::min(first + 1, last)];
    const vtkHeliosRay& c = rays[std::min(first + 2, last)];
    const vtkHeliosRay& d = rays[std::min(first + 3, last)];
    RayTerms<Doubles> lanes = {};
    for (int k = 0; k < 3; ++k)
    {
      lanes.Origin[k] = Doubles() + a.Origin[k];
      lanes.Direction[k] =
        Doubles{ a.Direction[k], b.Direction[k], c.Direction[k], d.Direction[k] };
    }
    const Doubles maximum = { a.MaximumRange, b.MaximumRange, c.MaximumRange, d.MaximumRange };
    Masks isFine, isX, isY;
    SetTerms<Doubles, Masks>(lanes, isFine, isX, isY);
    const Doubles range = GetRange(lanes, plane, terms);
    const Masks isHit = isFine & (range > 0.0) & (range <= maximum);
    const std::size_t size = std::min<std::size_t>(QuadWidth, count - first);
    for (std::size_t lane = 0; lane < size; ++lane)
    {
      hits[first + lane] =
        isHit[lane] ? vtkHeliosHit{ range[lane], cell } : vtkHeliosHit{ NoHit, -1 };
    }
  }
}

} // namespace helios
