// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosSurfaceDistance.h"

#include <CGAL/AABB_traits_3.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/Simple_cartesian.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace helios
{

namespace
{

/// Returns the nearest point on a segment.
Vec3 GetNearest(const Vec3& p, const Vec3& a, const Vec3& b)
{
  const Vec3 ab = b - a;
  const double squared = ab.SquaredNorm();
  const double t = squared > 0.0 ? ab.Dot(p - a) / squared : 0.0;
  return t <= 0.0 ? a : t >= 1.0 ? b : a + ab * t;
}

/**
 * Returns the nearest point on a triangle: the foot of the perpendicular if it is inside, else on a
 * side that has it outside. Differences from the point keep slivers accurate.
 */
Vec3 GetNearest(const Vec3& p, const Triangle& t)
{
  const Vec3 normal = (t[1] - t[0]).Cross(t[2] - t[0]);
  const double squared = normal.SquaredNorm();
  const Vec3 d[3] = { t[0] - p, t[1] - p, t[2] - p };
  Vec3 nearest = p - normal * (squared > 0.0 ? -normal.Dot(d[0]) / squared : 0.0);
  double minimum = std::numeric_limits<double>::infinity();
  for (int i = 0; i < 3; ++i)
  {
    const int next = (i + 1) % 3;
    if (normal.Dot(d[i].Cross(d[next])) < 0.0 || !(squared > 0.0))
    {
      const Vec3 q = GetNearest(p, t[i], t[next]);
      const double distance = (q - p).SquaredNorm();
      nearest = distance < minimum ? q : nearest;
      minimum = std::min(distance, minimum);
    }
  }
  return nearest;
}

/// Number of cuts that make a piece: three along each of many small triangles in a row beside it.
constexpr int MaximumLevel = 3000;

/// A convex polygon in space, a piece of a triangle.
struct Piece
{
  static constexpr int MaximumSize = 16;

  std::array<Vec3, MaximumSize> Corners;
  int Size = 0;
  int Level = 0;
  vtkIdType Hint = 0;

  void Add(const Vec3& corner) { this->Corners[this->Size++] = corner; }

  Vec3 GetCentre() const
  {
    Vec3 sum(0.0, 0.0, 0.0);
    for (int i = 0; i < this->Size; ++i)
    {
      sum = sum + this->Corners[i];
    }
    return sum * (1.0 / this->Size);
  }

  /// Returns the longest vector between two corners.
  Vec3 GetDiameter() const
  {
    Vec3 longest(0.0, 0.0, 0.0);
    for (int i = 0; i < this->Size; ++i)
    {
      for (int j = 0; j < i; ++j)
      {
        const Vec3 d = this->Corners[i] - this->Corners[j];
        longest = d.SquaredNorm() > longest.SquaredNorm() ? d : longest;
      }
    }
    return longest;
  }

  double GetDistance(const Triangle& triangle) const
  {
    double largest = 0.0;
    for (int i = 0; i < this->Size; ++i)
    {
      largest = std::max(largest, helios::GetDistance(this->Corners[i], triangle));
    }
    return largest;
  }
};

/// Splits a piece by a plane: the part along the normal, and the rest. Either may be empty.
void Cut(const Piece& piece, const Vec3& point, const Vec3& normal, Piece& along, Piece& rest)
{
  along.Size = rest.Size = 0;
  along.Level = rest.Level = piece.Level + 1;
  along.Hint = rest.Hint = piece.Hint;
  double side[Piece::MaximumSize];
  for (int i = 0; i < piece.Size; ++i)
  {
    side[i] = normal.Dot(piece.Corners[i] - point);
  }
  bool isAlong = false;
  bool isRest = false;
  for (int i = 0; i < piece.Size; ++i)
  {
    const int next = (i + 1) % piece.Size;
    const Vec3& p = piece.Corners[i];
    if (side[i] >= 0.0)
    {
      along.Add(p);
      isAlong = isAlong || side[i] > 0.0;
    }
    if (side[i] <= 0.0)
    {
      rest.Add(p);
      isRest = isRest || side[i] < 0.0;
    }
    if ((side[i] > 0.0 && side[next] < 0.0) || (side[i] < 0.0 && side[next] > 0.0))
    {
      const Vec3 q = p + (piece.Corners[next] - p) * (side[i] / (side[i] - side[next]));
      along.Add(q);
      rest.Add(q);
    }
  }
  along.Size = isAlong || !isRest ? along.Size : 0;
  rest.Size = isRest ? rest.Size : 0;
}

} // namespace

double GetDistance(const Vec3& point, const Triangle& triangle)
{
  return (GetNearest(point, triangle) - point).Norm();
}

//------------------------------------------------------------------------------
class SurfaceDistance::Tree
{
  using Kernel = CGAL::Simple_cartesian<double>;

  static Kernel::Point_3 MakePoint(const Vec3& p) { return { p[0], p[1], p[2] }; }

  /// A triangle as an AABB primitive: computed on demand, not stored twice.
  struct Primitive
  {
    using Id = const Triangle*;
    using Point = Kernel::Point_3;
    using Datum = Kernel::Triangle_3;
    using Datum_reference = Datum;
    using Point_reference = Point;

    explicit Primitive(Id triangle)
      : Source(triangle)
    {
    }
    Id id() const { return this->Source; }
    Datum datum() const
    {
      const Triangle& t = *this->Source;
      return { MakePoint(t[0]), MakePoint(t[1]), MakePoint(t[2]) };
    }
    Point reference_point() const { return MakePoint((*this->Source)[0]); }

    Id Source;
  };

  /// CGAL's own nearest point is inaccurate on slivers in double precision.
  struct Traits : public CGAL::AABB_traits_3<Kernel, Primitive>
  {
    struct Closest_point
    {
      Kernel::Point_3 operator()(const Kernel::Point_3& query, const Primitive& primitive,
        const Kernel::Point_3& known) const
      {
        const Vec3 p(query.x(), query.y(), query.z());
        const Kernel::Point_3 nearest = MakePoint(GetNearest(p, *primitive.id()));
        return CGAL::squared_distance(query, nearest) < CGAL::squared_distance(query, known)
          ? nearest
          : known;
      }
    };
    Closest_point closest_point_object() const { return Closest_point(); }
  };

public:
  Tree(const std::vector<Triangle>& surface, StopCheck& check)
    : First(surface.data())
  {
    for (const Triangle& triangle : surface)
    {
      check.Count();
      this->Boxes.insert(Primitive(&triangle));
    }
    const Traits& traits = this->Boxes.traits();
    using Split = StoppableSplit<Traits::Split_primitives>;
    this->Boxes.custom_build(
      traits.compute_bbox_object(), Split(traits.split_primitives_object(), check));
  }

  /// Returns the triangle nearest to a point, given a near one as a hint.
  vtkIdType Find(const Vec3& p, vtkIdType hint) const
  {
    const Triangle* near = this->First + hint;
    const Vec3 q = GetNearest(p, *near);
    return this->Boxes.closest_point_and_primitive(MakePoint(p), { MakePoint(q), near }).second -
      this->First;
  }

private:
  const Triangle* First;
  CGAL::AABB_tree<Traits> Boxes;
};

//------------------------------------------------------------------------------
/// One measurement: the pieces still to be bounded, and the bound so far.
class SurfaceDistance::Walk
{
public:
  Walk(const SurfaceDistance& target, double limit, double enough)
    : Target(target)
    , Limit(limit)
    , Enough(enough)
  {
  }

  Result Measure(const Triangle& triangle, vtkIdType hint)
  {
    Piece whole;
    whole.Hint = hint;
    std::for_each(triangle.begin(), triangle.end(), [&whole](const Vec3& p) { whole.Add(p); });
    this->Pieces.push_back(whole);
    while (!this->Pieces.empty())
    {
      const Piece piece = this->Pieces.back();
      this->Pieces.pop_back();
      if (!this->Treat(piece))
      {
        break;
      }
    }
    return this->Found;
  }

private:
  /// Bounds a piece or splits it; false: it is too far away.
  bool Treat(Piece piece)
  {
    const Vec3 centre = piece.GetCentre();
    piece.Hint = this->Target.Boxes->Find(centre, piece.Hint);
    const Triangle& near = this->Target.Surface[static_cast<std::size_t>(piece.Hint)];
    const double distance = helios::GetDistance(centre, near);
    this->Reached = std::max(this->Reached, distance);
    const Vec3 diameter = piece.GetDiameter();
    const bool isTiny = diameter.Norm() < 1e-3 * this->Limit || piece.Level > MaximumLevel;
    if (this->Accept(piece, near, isTiny || piece.Level > 6))
    {
      return true;
    }
    if (distance > this->Limit || isTiny)
    {
      this->Found.Bound = std::max(this->Found.Bound, distance + diameter.Norm());
      this->Found.Worst = piece.Hint;
      return false;
    }
    if (piece.Size > Piece::MaximumSize - 4 || !this->CutOut(piece, near, diameter.Norm()))
    {
      Piece halves[2];
      Cut(piece, centre, diameter, halves[0], halves[1]);
      this->Push(halves[0]);
      this->Push(halves[1]);
    }
    return true;
  }

  /// Returns whether a bound is tight enough: not above the distance at another point of the
  /// triangle, or within the limit.
  bool Accept(const Piece& piece, const Triangle& near, bool isFair)
  {
    const double bound = piece.GetDistance(near);
    const bool isTight = bound <= std::max(this->Enough, this->Reached);
    const bool isGood = isTight || (isFair && bound <= this->Limit);
    if (isGood)
    {
      this->Found.Bound = std::max(this->Found.Bound, bound);
      this->Found.Use(piece.Hint);
    }
    return isGood;
  }

  /// Splits along the sides of the nearest triangle if it is not tiny; false if nothing changes.
  bool CutOut(const Piece& piece, const Triangle& near, double diameter)
  {
    const Vec3 sides[3] = { near[1] - near[0], near[2] - near[1], near[0] - near[2] };
    const double size =
      std::max({ sides[0].SquaredNorm(), sides[1].SquaredNorm(), sides[2].SquaredNorm() });
    if (diameter * diameter > 16.0 * size)
    {
      return false;
    }
    const Vec3 normal = sides[0].Cross(sides[1]);
    Piece inside = piece;
    Piece off[3];
    for (int i = 0; i < 3; ++i)
    {
      Piece along;
      Cut(inside, near[i], normal.Cross(sides[i]), along, off[i]);
      inside = along;
      if (inside.Size == 0)
      {
        return false;
      }
    }
    if (off[0].Size + off[1].Size + off[2].Size == 0)
    {
      return false;
    }
    for (const Piece& rest : off)
    {
      this->Push(rest);
    }
    if (!this->Accept(inside, near, inside.Level > 6))
    {
      this->Push(inside);
    }
    return true;
  }

  void Push(const Piece& piece)
  {
    if (piece.Size > 0)
    {
      this->Pieces.push_back(piece);
    }
  }

  const SurfaceDistance& Target;
  double Limit;
  double Enough;
  Result Found;
  double Reached = 0.0; ///< the largest known distance of a point of the triangle
  std::vector<Piece> Pieces;
};

//------------------------------------------------------------------------------
void SurfaceDistance::Result::Use(vtkIdType triangle)
{
  const auto end = this->Used.begin() + std::min(this->NumberOfUsed, MaximumUsed);
  if (std::find(this->Used.begin(), end, triangle) == end && this->NumberOfUsed <= MaximumUsed)
  {
    if (end != this->Used.end())
    {
      *end = triangle;
    }
    ++this->NumberOfUsed;
  }
}

//------------------------------------------------------------------------------
SurfaceDistance::SurfaceDistance(std::vector<Triangle> surface, StopCheck& check)
  : Surface(std::move(surface))
  , Boxes(std::make_unique<Tree>(this->Surface, check))
{
}

//------------------------------------------------------------------------------
SurfaceDistance::~SurfaceDistance() = default;

//------------------------------------------------------------------------------
SurfaceDistance::Result SurfaceDistance::Measure(
  const Triangle& triangle, double limit, double enough, vtkIdType hint) const
{
  return Walk(*this, limit, enough).Measure(triangle, hint);
}

} // namespace helios
