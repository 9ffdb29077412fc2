// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma GCC diagnostic ignored "-Wpsabi" // vectors are passed to inlined functions only
#include "heliosConeTest.h"

#include "heliosLeafFilter.h"
#include "heliosTriangleMesh.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace helios
{

namespace
{

constexpr double Error = 0x1p-47;   // of sums of a few products, relative to the largest of them
constexpr double Margin = 1e-9;     // of the cone's width
constexpr double Widest = 0.2;      // square of the sine of the half angle
constexpr int MaximumOutliers = 64; // tested one by one

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

/// An upper bound of the length.
double GetLength(const double a[3])
{
  return std::abs(a[0]) + std::abs(a[1]) + std::abs(a[2]);
}

/// The squared distance of a segment from the origin.
double GetSquareDistance(const double a[2], const double b[2])
{
  const double d[2] = { b[0] - a[0], b[1] - a[1] };
  const double square = d[0] * d[0] + d[1] * d[1];
  const double along = -(a[0] * d[0] + a[1] * d[1]);
  const double s = along <= 0.0 ? 0.0 : (along >= square ? 1.0 : along / square);
  const double x = a[0] + s * d[0];
  const double y = a[1] + s * d[1];
  return x * x + y * y;
}

bool AreSame(const double* a, const double* b)
{
  return a == b || (a[0] == b[0] && a[1] == b[1] && a[2] == b[2]);
}

/// Triangles in order, delayed by some steps, in which their corners are fetched from memory.
class FetchQueue
{
public:
  explicit FetchQueue(const TriangleMesh& mesh)
    : Mesh(mesh)
  {
  }

  template <typename UseT>
  void Add(vtkTypeInt32 triangle, UseT use)
  {
    __builtin_prefetch(this->Mesh.GetCorners() + 3 * static_cast<vtkIdType>(triangle));
    this->At(this->Size) = triangle;
    this->Advance(this->Size++, use);
  }

  /// Uses those that are left.
  template <typename UseT>
  void Finish(UseT use)
  {
    for (std::size_t i = 0; i < 2 * Step; ++i)
    {
      this->Advance(this->Size + i, use);
    }
  }

private:
  static constexpr std::size_t Step = 8;

  vtkTypeInt32& At(std::size_t i) { return this->Triangles[i % (2 * Step + 1)]; }

  template <typename UseT>
  void Advance(std::size_t last, UseT use)
  {
    if (last >= Step && last - Step < this->Size)
    {
      for (int corner = 0; corner < 3; ++corner)
      {
        __builtin_prefetch(this->Mesh.GetCorner(this->At(last - Step), corner));
      }
    }
    if (last >= 2 * Step && last - 2 * Step < this->Size)
    {
      use(this->At(last - 2 * Step));
    }
  }

  const TriangleMesh& Mesh;
  std::size_t Size = 0;
  vtkTypeInt32 Triangles[2 * Step + 1];
};

constexpr double NoLength = 1e-300; // of an edge

const vtkHeliosConeHit Unknown{ vtkHeliosConeHit::Mixed, -1, 0.0 };

} // namespace

ConeTest::ConeTest(
  const double origin[3], const double axis[3], double tanHalfAngle, const PlaneLimits& limits)
  : Origin(origin)
  , Tangent(tanHalfAngle)
  , Limits(limits)
{
  vtkHeliosRay ray;
  std::copy_n(origin, 3, ray.Origin);
  std::copy_n(axis, 3, ray.Direction);
  this->IsValid = this->Axis.Set(ray) && tanHalfAngle >= 0.0 && limits.Distance >= 0.0;
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
/// The frustum about the cone; false for a cone that is too wide.
bool ConeTest::SetHull(const BeamTree& tree, Frustum& hull, LeafFilter& filter) const
{
  const double* w = this->Frame[2];
  const double sineSquare = this->Tangent * this->Tangent / (1 + this->Tangent * this->Tangent);
  if (!(sineSquare < Widest))
  {
    return false;
  }
  hull.Axes = this->Axis.Axes;
  const double along = std::abs(w[hull.Axes.Z]);
  hull.IsForward = w[hull.Axes.Z] > 0.0;
  const int axes[3] = { hull.Axes.X, hull.Axes.Y, hull.Axes.Z };
  double slopeLow[2], slopeHigh[2];
  for (int i = 0; i < 2; ++i)
  {
    // The planes x = f z that touch the cone: (w_x - f w_z)^2 = sin^2 (1 + f^2).
    const double x = w[axes[i]];
    const double a = along * along - sineSquare;
    const double root =
      std::sqrt(sineSquare * std::max(0.0, x * x + along * along - sineSquare)) * (1 + Margin);
    slopeLow[i] = (x * along - root) / a - Error;
    slopeHigh[i] = (x * along + root) / a + Error;
  }
  const double origin[3] = { this->Origin[axes[0]], this->Origin[axes[1]], this->Origin[axes[2]] };
  if (!tree.SetFrustum(hull, origin, origin, slopeLow, slopeHigh))
  {
    return false;
  }
  filter.SetAxis(tree, hull, origin, origin, slopeLow, slopeHigh);
  filter.SetError(0.0);
  return true;
}

//------------------------------------------------------------------------------
/// Adds all triangles that may touch the cone, from front to back; false if add returns false, or
/// the cone is too wide.
template <typename AddT>
bool ConeTest::Walk(const BeamTree& tree, AddT add)
{
  for (const vtkTypeInt32 triangle : tree.GetOutliers())
  {
    if (!add(triangle))
    {
      return false;
    }
  }
  if (tree.IsEmpty())
  {
    return true;
  }
  Frustum hull;
  LeafFilter filter;
  if (!this->SetHull(tree, hull, filter))
  {
    return false;
  }
  // A depth h along the axis is at most h (w_z + T sqrt(1 - w_z^2)) along the frustum's Z.
  const double w = std::abs(this->Frame[2][hull.Axes.Z]);
  const double stretch = (w + this->Tangent * std::sqrt(std::max(0.0, 1 - w * w))) * (1 + Margin);
  BeamWalk walk(tree, hull);
  BeamTree::Leaf leaf;
  float limit = hull.GetLimit(this->Farthest * stretch);
  while (walk.GetNext(limit, leaf))
  {
    int isAlive[BeamTree::LeafSize];
    filter.FindAlive(leaf, limit, isAlive);
    for (int i = 0; i < leaf.Count; ++i)
    {
      if (isAlive[i] && !add(leaf.Triangles[i]))
      {
        return false;
      }
    }
    limit = hull.GetLimit(this->Farthest * stretch);
  }
  return true;
}

//------------------------------------------------------------------------------
vtkHeliosConeHit ConeTest::Run(const BeamTree& tree, ConeLayer* layer)
{
  if (layer)
  {
    layer->Size = 0;
  }
  const bool isKnown = this->IsValid && tree.GetOutliers().size() <= MaximumOutliers &&
    this->Walk(
      tree, [this, &tree](vtkTypeInt32 triangle) { return this->Add(tree.GetMesh(), triangle); });
  return isKnown ? this->Classify(layer) : Unknown;
}

//------------------------------------------------------------------------------
bool ConeTest::Collect(const BeamTree& tree, double nearest, std::size_t most, ConeView& view)
{
  constexpr std::size_t transient =
    4; // times as many before those that a triangle hides are dropped
  view.Triangles.clear();
  std::copy_n(&this->Frame[0][0], 9, &view.Frame[0][0]);
  FetchQueue queue(tree.GetMesh());
  const auto use = [&](vtkTypeInt32 triangle)
  { this->Add(tree.GetMesh(), triangle, nearest, view); };
  const bool isWhole = this->IsValid &&
    this->Walk(tree,
      [&](vtkTypeInt32 triangle)
      {
        queue.Add(triangle, use);
        return view.Triangles.size() <= transient * most;
      });
  queue.Finish(use);
  view.Farthest = this->Farthest;
  view.Finish();
  return isWhole && view.Triangles.size() <= most;
}

//------------------------------------------------------------------------------
/// Adds a triangle that may touch the cone to a view; one that covers it hides what is farther.
void ConeTest::Add(const TriangleMesh& mesh, vtkTypeInt32 triangle, double nearest, ConeView& view)
{
  Candidate& c = this->Candidates[0];
  this->SetCorners(mesh, triangle, c);
  const auto& p = c.Corners;
  if (std::max({ p[0][2], p[1][2], p[2][2] }) <= nearest || this->IsBeside(c))
  {
    return;
  }
  // A tree of one leaf has it twice.
  const std::size_t recent = std::min<std::size_t>(view.Triangles.size(), BeamTree::LeafSize);
  if (std::any_of(view.Triangles.end() - static_cast<std::ptrdiff_t>(recent), view.Triangles.end(),
        [triangle](const ConeTriangle& other) { return other.Cell == triangle; }))
  {
    return;
  }
  view.Triangles.emplace_back();
  view.Triangles.back().Cell = triangle;
  std::copy_n(&c.Corners[0][0], 9, &view.Triangles.back().Corners[0][0]);
  if (this->MayCover(c) && this->Touches(c) && c.Covers && c.IsBefore)
  {
    const Plane plane = this->GetPlane(c);
    this->Farthest =
      plane.Nearest > nearest ? std::min(this->Farthest, plane.Farthest) : this->Farthest;
  }
}

//------------------------------------------------------------------------------
void ConeTest::SetCorners(const TriangleMesh& mesh, vtkTypeInt32 triangle, Candidate& c) const
{
  c.Triangle = triangle;
  for (int corner = 0; corner < 3; ++corner)
  {
    c.Points[corner] = mesh.GetCorner(triangle, corner);
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

//------------------------------------------------------------------------------
/// Whether a triangle is beyond a side of the square about the cone.
bool ConeTest::IsBeside(const Candidate& c) const
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
/// Whether all corners are outside the square: otherwise the triangle does not cover the cone.
bool ConeTest::MayCover(const Candidate& c) const
{
  return std::all_of(c.Corners, c.Corners + 3,
    [this](const double* p)
    { return std::max(std::abs(p[0]), std::abs(p[1])) >= this->Tangent * p[2]; });
}

//------------------------------------------------------------------------------
/// Adds a triangle if it touches the cone; false once the cone is known to be mixed.
bool ConeTest::Add(const TriangleMesh& mesh, vtkTypeInt32 triangle)
{
  if (this->Count == MaximumCandidates && !this->DropFarther())
  {
    return false;
  }
  Candidate& c = this->Candidates[this->Count];
  this->SetCorners(mesh, triangle, c);
  if (!this->Touches(c))
  {
    return true;
  }
  if (!c.IsBefore && !c.Covers)
  {
    return false;
  }
  ++this->Count;
  const double range = TestTriangle(this->Axis, c.Points);
  if (range < this->Hit.Range || (range == this->Hit.Range && triangle < this->Hit.CellId))
  {
    this->Hit = { range, triangle };
    this->Farthest =
      this->GetPlane(c).Farthest + std::max(this->Limits.Distance, this->Limits.LayerDistance);
  }
  return true;
}

//------------------------------------------------------------------------------
/// Whether it may touch the cone; sets the candidate's terms from its corners.
bool ConeTest::Touches(Candidate& c) const
{
  const auto& p = c.Corners;
  const double lengths[3] = { GetLength(p[0]), GetLength(p[1]), GetLength(p[2]) };
  const double reach = std::max({ lengths[0], lengths[1], lengths[2] });
  const double lowest = std::min({ p[0][2], p[1][2], p[2][2] });
  if (std::max({ p[0][2], p[1][2], p[2][2] }) < -Error * reach)
  {
    return false;
  }
  c.IsBefore = lowest > Error * reach;
  for (int k = 0; k < 3; ++k)
  {
    const int i = (k + 1) % 3;
    const int j = (k + 2) % 3;
    Cross(p[i], p[j], c.Edges[k]);
    c.Errors[k] = Error * lengths[i] * lengths[j] * (1 + this->Tangent);
  }
  // The determinant of the edges' differences, which are exact or nearly so: they are small for
  // distant triangles.
  double a[3], b[3], n[3];
  for (int axis = 0; axis < 3; ++axis)
  {
    a[axis] = p[1][axis] - p[0][axis];
    b[axis] = p[2][axis] - p[0][axis];
  }
  Cross(a, b, n);
  const double determinant = Dot(n, p[0]);
  const double doubt = Error * reach * reach * (GetLength(a) + GetLength(b));
  c.Sign = determinant > doubt ? 1.0 : (determinant < -doubt ? -1.0 : 0.0);
  c.Covers = c.Sign != 0.0;
  bool isAxisInside = c.Sign != 0.0;
  double thickness = NoHit; // in the plane z = 1, of a triangle that may be edge-on
  for (int k = 0; k < 3; ++k)
  {
    const double* e = c.Edges[k];
    const double size = std::sqrt(e[0] * e[0] + e[1] * e[1]) * (1 + Margin);
    const double along = c.Sign * e[2];
    if (c.Sign != 0.0 && along + this->Tangent * size + c.Errors[k] < 0.0)
    {
      return false;
    }
    c.Covers = c.Covers && along - this->Tangent * size - c.Errors[k] > 0.0;
    isAxisInside = isAxisInside && along > -c.Errors[k];
    thickness = std::min(thickness, 2 * doubt / (p[k][2] * size));
  }
  if (c.Covers || isAxisInside || !c.IsBefore)
  {
    return true;
  }
  const double radius = this->Tangent + (c.Sign == 0.0 ? thickness : 0.0);
  return this->EdgeTouches(c, 0, radius) || this->EdgeTouches(c, 1, radius) ||
    this->EdgeTouches(c, 2, radius);
}

/// Whether an edge before the apex touches a cone: a disc of a radius in the plane z = 1.
bool ConeTest::EdgeTouches(const Candidate& c, int edge, double radius) const
{
  const double* p = c.Corners[(edge + 1) % 3];
  const double* q = c.Corners[(edge + 2) % 3];
  const double a[2] = { p[0] / p[2], p[1] / p[2] };
  const double b[2] = { q[0] / q[2], q[1] / q[2] };
  const double error = Error * std::max(GetLength(p) / p[2], GetLength(q) / q[2]);
  const double most = radius * (1 + Margin) + error;
  return GetSquareDistance(a, b) <= most * most;
}

//------------------------------------------------------------------------------
ConeTest::Plane ConeTest::GetPlane(const Candidate& c) const
{
  const auto& p = c.Corners;
  double a[3], b[3];
  for (int axis = 0; axis < 3; ++axis)
  {
    a[axis] = p[1][axis] - p[0][axis];
    b[axis] = p[2][axis] - p[0][axis];
  }
  Plane plane;
  double* n = plane.Normal;
  Cross(a, b, n);
  plane.Constant = Dot(n, p[0]);
  if (plane.Constant < 0.0)
  {
    plane.Constant = -plane.Constant;
    n[0] = -n[0];
    n[1] = -n[1];
    n[2] = -n[2];
  }
  plane.Across = std::sqrt(n[0] * n[0] + n[1] * n[1]);
  const double doubt = Error * GetLength(p[0]) * (GetLength(a) + GetLength(b));
  const double least = n[2] - this->Tangent * plane.Across - doubt;
  plane.Nearest = plane.Constant / (n[2] + this->Tangent * plane.Across + doubt);
  plane.Farthest = least > 0.0 ? plane.Constant / least * (1 + Margin) : NoHit;
  return plane;
}

/// Whether a triangle lies behind the plane by more than the tolerance.
bool ConeTest::IsBehind(const Candidate& c, const Plane& plane, double distance) const
{
  const double least = plane.Constant * (1 + distance / plane.Nearest + Margin);
  for (const auto& p : c.Corners)
  {
    const double doubt = Error * GetLength(plane.Normal) * GetLength(p);
    if (!(Dot(plane.Normal, p) - doubt > least))
    {
      return false;
    }
  }
  return true;
}

/// Whether the plane of a triangle is within the tolerance of another, over the cone.
bool ConeTest::IsOn(const Candidate& c, const Plane& plane, double distance) const
{
  const Plane other = this->GetPlane(c);
  if (!(plane.Farthest < NoHit && other.Farthest < NoHit))
  {
    return false;
  }
  // |h - h'| = |1 / h - 1 / h'| h h', and 1 / h = n . d / c.
  double slope[3];
  for (int axis = 0; axis < 3; ++axis)
  {
    slope[axis] = plane.Normal[axis] / plane.Constant - other.Normal[axis] / other.Constant;
  }
  const double across = std::sqrt(slope[0] * slope[0] + slope[1] * slope[1]);
  const double most = std::abs(slope[2]) + this->Tangent * across;
  return most * plane.Farthest * other.Farthest <= distance;
}

/// Whether another candidate adjoins an edge on its other side.
bool ConeTest::IsShared(int member, int edge) const
{
  const Candidate& c = this->Candidates[member];
  const double* from = c.Points[(edge + 1) % 3];
  const double* to = c.Points[(edge + 2) % 3];
  for (int i = 0; i < this->Count; ++i)
  {
    const Candidate& other = this->Candidates[i];
    for (int k = 0; i != member && k < 3; ++k)
    {
      const double* p = other.Points[(k + 1) % 3];
      const double* q = other.Points[(k + 2) % 3];
      const bool isSame = AreSame(from, p) && AreSame(to, q);
      const bool isReverse = AreSame(from, q) && AreSame(to, p);
      // Seen from the apex they have the same orientation if they traverse the edge in opposite
      // directions.
      if ((isReverse && c.Sign * other.Sign > 0.0) || (isSame && c.Sign * other.Sign < 0.0))
      {
        return true;
      }
    }
  }
  return false;
}

/// Makes room by dropping candidates beyond Farthest; false if there are none.
bool ConeTest::DropFarther()
{
  const auto isFarther = [this](const Candidate& c)
  {
    const auto& p = c.Corners;
    return c.Triangle != this->Hit.CellId &&
      std::min({ p[0][2], p[1][2], p[2][2] }) > this->Farthest;
  };
  Candidate* end = std::remove_if(this->Candidates, this->Candidates + this->Count, isFarther);
  this->Count = static_cast<int>(end - this->Candidates);
  return this->Count < MaximumCandidates;
}

/// The combined result of the candidates.
vtkHeliosConeHit ConeTest::Classify(ConeLayer* layer)
{
  if (this->Count == 0)
  {
    return { vtkHeliosConeHit::Empty, -1, NoHit };
  }
  Candidate* const end = this->Candidates + this->Count;
  Candidate* const hit = std::find_if(
    this->Candidates, end, [this](const Candidate& c) { return c.Triangle == this->Hit.CellId; });
  if (hit == end)
  {
    return Unknown;
  }
  std::swap(*hit, this->Candidates[0]);
  const int count = this->Count;
  const bool isPlane = this->AreOneSurface(this->Limits.Distance, this->Limits.AreAlike);
  if (layer && !isPlane && this->Limits.LayerDistance > 0.0)
  {
    this->Count = count;
    if (this->AreOneSurface(this->Limits.LayerDistance, this->Limits.AreSimilar) &&
      this->CountAtAxis() == 1)
    {
      this->SetLayer(*layer);
    }
    return Unknown;
  }
  if (layer && isPlane)
  {
    this->SetLayer(*layer);
  }
  return isPlane ? vtkHeliosConeHit{ vtkHeliosConeHit::OnePlane, this->Hit.CellId, this->Hit.Range }
                 : Unknown;
}

/// Whether the candidates are within a distance of the plane of the first, related to it, and cover
/// the cone without a gap. Those behind are moved to the end, and not counted any more.
bool ConeTest::AreOneSurface(double distance, const PlaneLimits::Relation& relation)
{
  const vtkTypeInt32 first = this->Candidates[0].Triangle;
  const Plane plane = this->GetPlane(this->Candidates[0]);
  bool isCovered = this->Candidates[0].Covers;
  for (int i = 1; i < this->Count;)
  {
    Candidate& c = this->Candidates[i];
    if (this->IsBehind(c, plane, distance))
    {
      std::swap(c, this->Candidates[--this->Count]);
      continue;
    }
    if (!this->IsOn(c, plane, distance) || (relation && !relation(first, c.Triangle)))
    {
      return false;
    }
    isCovered = isCovered || c.Covers;
    ++i;
  }
  for (int i = 0; i < this->Count && !isCovered; ++i)
  {
    for (int edge = 0; edge < 3; ++edge)
    {
      const Candidate& c = this->Candidates[i];
      if (c.Sign == 0.0 || (this->EdgeTouches(c, edge, this->Tangent) && !this->IsShared(i, edge)))
      {
        return false;
      }
    }
  }
  return true;
}

/// The candidates that the axis meets: without gaps, as many as anywhere in the cone.
int ConeTest::CountAtAxis() const
{
  return static_cast<int>(std::count_if(this->Candidates, this->Candidates + this->Count,
    [](const Candidate& c)
    {
      return c.Sign * c.Edges[0][2] > 0.0 && c.Sign * c.Edges[1][2] > 0.0 &&
        c.Sign * c.Edges[2][2] > 0.0;
    }));
}

/// Sets a layer to the candidates.
void ConeTest::SetLayer(ConeLayer& layer) const
{
  std::copy_n(&this->Frame[0][0], 9, &layer.Frame[0][0]);
  layer.Size = this->Count;
  for (int i = 0; i < this->Count; ++i)
  {
    const Candidate& c = this->Candidates[i];
    const Plane plane = this->GetPlane(c);
    ConeLayer::Piece& piece = layer.Pieces[i];
    piece.Cell = c.Triangle;
    for (int edge = 0; edge < 3; ++edge)
    {
      const double* e = c.Edges[edge];
      const double scale = c.Sign / std::max(GetLength(e), NoLength);
      for (int axis = 0; axis < 3; ++axis)
      {
        piece.Edges[edge][axis] = scale * e[axis];
      }
    }
    for (int axis = 0; axis < 3; ++axis)
    {
      piece.Inverse[axis] = plane.Normal[axis] / plane.Constant;
    }
  }
}

} // namespace helios
