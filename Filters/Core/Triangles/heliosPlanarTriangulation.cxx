// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosPlanarTriangulation.h"

#include "heliosTriangleArea.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace helios
{

namespace
{

constexpr std::size_t DetoursPerPoint = 8; // more than sides that touch need

constexpr int After(int corner)
{
  return corner == 2 ? 0 : corner + 1;
}

constexpr int Before(int corner)
{
  return corner == 0 ? 2 : corner - 1;
}

} // namespace

//------------------------------------------------------------------------------
double PlanarTriangulation::Turn(int a, int b, int c) const
{
  return ComputeTurn(this->Points[a].data(), this->Points[b].data(), this->Points[c].data());
}

//------------------------------------------------------------------------------
/// Adds the points from left to right: each point is outside the hull of the previous ones.
void PlanarTriangulation::Build(std::vector<Point> points)
{
  this->Points = std::move(points);
  this->Triangles.clear();
  this->TriangleOfPoint.assign(this->Points.size(), -1);
  this->Next.assign(this->Points.size(), -1);
  this->Previous = this->HullTriangle = this->Next;
  this->DetourArea = 0.0;
  this->Detours = 0;
  std::vector<int> order(this->Points.size());
  std::iota(order.begin(), order.end(), 0);
  std::sort(
    order.begin(), order.end(), [this](int a, int b) { return this->Points[a] < this->Points[b]; });
  std::size_t count = 2;
  while (count < order.size() && this->Turn(order[0], order[1], order[count]) == 0.0)
  {
    ++count;
  }
  if (count >= order.size())
  {
    return;
  }
  this->BuildFirst(order, count);
  for (std::size_t i = count + 1; i < order.size(); ++i)
  {
    this->AddPoint(order[i], order[i - 1]);
  }
}

//------------------------------------------------------------------------------
/// Adds the points on a line, and the first point beside it.
void PlanarTriangulation::BuildFirst(const std::vector<int>& order, std::size_t count)
{
  const int apex = order[count];
  const bool isLeft = this->Turn(order[0], order[1], apex) > 0.0;
  std::vector<int> line(order.begin(), order.begin() + static_cast<std::ptrdiff_t>(count));
  if (!isLeft)
  {
    std::reverse(line.begin(), line.end());
  }
  for (std::size_t i = 0; i + 1 < line.size(); ++i)
  {
    const int triangle = this->AddTriangle(line[i], line[i + 1], apex);
    if (i > 0)
    {
      this->Link(triangle, 1, triangle - 1);
      this->Link(triangle - 1, 0, triangle);
    }
    this->HullTriangle[line[i]] = triangle;
  }
  this->HullTriangle[line.back()] = static_cast<int>(this->Triangles.size()) - 1;
  this->HullTriangle[apex] = 0;
  line.push_back(apex);
  for (std::size_t i = 0; i < line.size(); ++i)
  {
    const int next = line[(i + 1) % line.size()];
    this->Next[line[i]] = next;
    this->Previous[next] = line[i];
  }
}

//------------------------------------------------------------------------------
/// Connects a point with the edges of the hull that face it; they begin or end at the last point.
void PlanarTriangulation::AddPoint(int point, int last)
{
  int first = last;
  while (this->Turn(this->Previous[first], first, point) < 0.0)
  {
    first = this->Previous[first];
  }
  int end = last;
  while (this->Turn(end, this->Next[end], point) < 0.0)
  {
    end = this->Next[end];
  }
  std::vector<Spot> spots;
  int before = -1;
  for (int at = first; at != end; at = this->Next[at])
  {
    const int other = this->HullTriangle[at];
    const int triangle = this->AddTriangle(this->Next[at], at, point);
    const int corner = Before(this->FindCorner(other, at));
    this->Link(triangle, 2, other);
    this->Link(other, corner, triangle);
    if (before >= 0)
    {
      this->Link(triangle, 0, before);
      this->Link(before, 1, triangle);
    }
    before = triangle;
    spots.push_back({ triangle, 2 });
  }
  if (spots.empty())
  {
    return; // only where products of coordinates are infinite
  }
  this->HullTriangle[first] = spots.front().Triangle;
  this->HullTriangle[point] = before;
  this->Next[first] = point;
  this->Previous[point] = first;
  this->Next[point] = end;
  this->Previous[end] = point;
  this->Legalize(spots);
}

//------------------------------------------------------------------------------
int PlanarTriangulation::AddTriangle(int a, int b, int c)
{
  const auto triangle = static_cast<int>(this->Triangles.size());
  this->Triangles.emplace_back().Corners = { a, b, c };
  this->TriangleOfPoint[a] = this->TriangleOfPoint[b] = this->TriangleOfPoint[c] = triangle;
  return triangle;
}

//------------------------------------------------------------------------------
void PlanarTriangulation::Link(int triangle, int corner, int neighbor)
{
  this->Triangles[triangle].Neighbors[corner] = neighbor;
}

//------------------------------------------------------------------------------
/// Returns whether d is certainly in the circle of a, b, c: Shewchuk's bound of the rounded
/// determinant.
bool PlanarTriangulation::IsInCircle(int a, int b, int c, int d) const
{
  constexpr double bound = 0x1.4000000000018p-50;
  double x[3];
  double y[3];
  double lift[3];
  const int corners[3] = { a, b, c };
  for (int i = 0; i < 3; ++i)
  {
    x[i] = this->Points[corners[i]][0] - this->Points[d][0];
    y[i] = this->Points[corners[i]][1] - this->Points[d][1];
    lift[i] = x[i] * x[i] + y[i] * y[i];
  }
  double sum = 0.0;
  double size = 0.0;
  for (int i = 0; i < 3; ++i)
  {
    const double left = x[After(i)] * y[Before(i)];
    const double right = y[After(i)] * x[Before(i)];
    sum += lift[i] * (left - right);
    size += lift[i] * (std::abs(left) + std::abs(right));
  }
  return sum > bound * size;
}

//------------------------------------------------------------------------------
/// Flips sides until no opposite corner is in a circle. Only certain ones are flipped, so it ends.
void PlanarTriangulation::Legalize(std::vector<Spot>& spots)
{
  while (!spots.empty())
  {
    const Spot spot = spots.back();
    spots.pop_back();
    const Triangle& own = this->Triangles[spot.Triangle];
    const int neighbor = own.Neighbors[spot.Corner];
    if (neighbor < 0 || own.IsFixed[spot.Corner])
    {
      continue;
    }
    const int a = own.Corners[spot.Corner];
    const int b = own.Corners[After(spot.Corner)];
    const int c = own.Corners[Before(spot.Corner)];
    const int d = this->Triangles[neighbor].Corners[this->FindOpposite(spot).Corner];
    if (this->IsInCircle(a, b, c, d) && this->Turn(a, d, b) < 0.0 && this->Turn(a, d, c) > 0.0)
    {
      this->Flip(spot.Triangle, spot.Corner);
      spots.push_back({ spot.Triangle, 0 });
      spots.push_back({ neighbor, 0 });
    }
  }
}

//------------------------------------------------------------------------------
/// Replaces triangle (a, b, c) and its neighbour (d, c, b) by (a, b, d) and (a, d, c).
void PlanarTriangulation::Flip(int triangle, int corner)
{
  const int neighbor = this->Triangles[triangle].Neighbors[corner];
  const int opposite = this->FindOpposite({ triangle, corner }).Corner;
  const Triangle t = this->Triangles[triangle];
  const Triangle n = this->Triangles[neighbor];
  const int b = After(corner);
  const int c = Before(corner);
  const int ofB = Before(opposite); // in the neighbour
  const int ofC = After(opposite);
  const int d = n.Corners[opposite];
  const auto get = [](const Triangle& from, int at, Triangle& to, int place)
  {
    to.Neighbors[place] = from.Neighbors[at];
    to.IsFixed[place] = from.IsFixed[at];
    to.IsSide[place] = from.IsSide[at];
  };
  Triangle first{ { t.Corners[corner], t.Corners[b], d } };
  Triangle second{ { t.Corners[corner], d, t.Corners[c] } };
  get(n, ofC, first, 0);
  first.Neighbors[1] = neighbor;
  get(t, c, first, 2);
  get(n, ofB, second, 0);
  get(t, b, second, 1);
  second.Neighbors[2] = triangle;
  this->Triangles[triangle] = first;
  this->Triangles[neighbor] = second;
  const auto relink = [this](int outer, int from, int to, int start)
  {
    if (outer < 0)
    {
      this->HullTriangle[start] = to;
      return;
    }
    std::array<int, 3>& all = this->Triangles[outer].Neighbors;
    *std::find(all.begin(), all.end(), from) = to;
  };
  relink(first.Neighbors[0], neighbor, triangle, t.Corners[b]);
  relink(second.Neighbors[1], triangle, neighbor, t.Corners[c]);
  this->TriangleOfPoint[t.Corners[corner]] = this->TriangleOfPoint[t.Corners[b]] = triangle;
  this->TriangleOfPoint[d] = triangle;
  this->TriangleOfPoint[t.Corners[c]] = neighbor;
}

//------------------------------------------------------------------------------
int PlanarTriangulation::FindCorner(int triangle, int point) const
{
  const std::array<int, 3>& corners = this->Triangles[triangle].Corners;
  return corners[0] == point ? 0 : corners[1] == point ? 1 : 2;
}

//------------------------------------------------------------------------------
/// Returns the neighbour at a side, and its corner opposite to that.
PlanarTriangulation::Spot PlanarTriangulation::FindOpposite(const Spot& spot) const
{
  const Triangle& own = this->Triangles[spot.Triangle];
  const int neighbor = own.Neighbors[spot.Corner];
  return { neighbor, After(this->FindCorner(neighbor, own.Corners[After(spot.Corner)])) };
}

//------------------------------------------------------------------------------
/// Calls a function with each triangle at a point and the point's corner, until it returns true.
template <typename Visitor>
void PlanarTriangulation::VisitTriangles(int point, Visitor visit) const
{
  const int start = this->TriangleOfPoint[point];
  for (const bool isForward : { true, false })
  {
    for (int triangle = start; triangle >= 0;)
    {
      const int corner = this->FindCorner(triangle, point);
      if (visit(triangle, corner))
      {
        return;
      }
      const int next = isForward ? After(corner) : Before(corner);
      triangle = this->Triangles[triangle].Neighbors[next];
      if (triangle == start)
      {
        return;
      }
    }
  }
}

//------------------------------------------------------------------------------
PlanarTriangulation::Spot PlanarTriangulation::FindEdge(int a, int b) const
{
  Spot found;
  this->VisitTriangles(a,
    [&](int triangle, int corner)
    {
      const std::array<int, 3>& corners = this->Triangles[triangle].Corners;
      const bool isAfter = corners[After(corner)] == b;
      if (isAfter || corners[Before(corner)] == b)
      {
        found = { triangle, isAfter ? Before(corner) : After(corner) };
      }
      return found.Triangle >= 0;
    });
  return found;
}

//------------------------------------------------------------------------------
/// Returns whether a point on a line is on the half that starts at a point and has another.
bool PlanarTriangulation::IsAhead(int from, int to, int point) const
{
  return (this->Points[to] < this->Points[from]) == (this->Points[point] < this->Points[from]);
}

//------------------------------------------------------------------------------
/// Returns the triangle at a point where the way to another leaves it through the opposite side. If
/// that runs along an edge instead, the other is its end.
PlanarTriangulation::Spot PlanarTriangulation::FindStart(int from, int& to) const
{
  Spot found;
  this->VisitTriangles(from,
    [&](int triangle, int corner)
    {
      const std::array<int, 3>& corners = this->Triangles[triangle].Corners;
      for (const int point : { corners[After(corner)], corners[Before(corner)] })
      {
        if (point == to || (this->Turn(from, to, point) == 0.0 && this->IsAhead(from, to, point)))
        {
          to = point;
          return true;
        }
      }
      if (this->Turn(from, to, corners[After(corner)]) < 0.0 &&
        this->Turn(from, to, corners[Before(corner)]) > 0.0)
      {
        found = { triangle, corner };
      }
      return found.Triangle >= 0;
    });
  return found;
}

//------------------------------------------------------------------------------
void PlanarTriangulation::AddSide(int from, int to)
{
  std::vector<Edge> rest{ { from, to } };
  while (!rest.empty())
  {
    const Edge piece = rest.back();
    rest.pop_back();
    if (piece.first != piece.second && !this->AddPiece(piece, rest))
    {
      this->DetourArea = std::numeric_limits<double>::infinity();
      return;
    }
  }
}

//------------------------------------------------------------------------------
/// Adds a side up to the first point on it; the others go to the rest. False: there is no way.
bool PlanarTriangulation::AddPiece(Edge piece, std::vector<Edge>& rest)
{
  const int end = piece.second;
  const Spot start = this->FindStart(piece.first, piece.second);
  if (start.Triangle >= 0)
  {
    std::vector<Edge> crossed;
    Edge blocking{ -1, -1 };
    if (!this->FindCrossed(start, piece, crossed, blocking))
    {
      return false;
    }
    if (blocking.first >= 0)
    {
      this->Detour({ piece.first, end }, blocking, rest);
      return this->Detours++ < DetoursPerPoint * this->Points.size();
    }
    this->FlipCrossed(piece, crossed);
  }
  rest.emplace_back(piece.second, end);
  const Spot edge = this->FindEdge(piece.first, piece.second);
  if (edge.Triangle < 0)
  {
    return false;
  }
  this->Mark(edge, true, true);
  return true;
}

//------------------------------------------------------------------------------
/// Finds the edges that a piece crosses, up to a point on it, where it then ends, or to a side.
bool PlanarTriangulation::FindCrossed(
  Spot spot, Edge& piece, std::vector<Edge>& crossed, Edge& blocking) const
{
  for (std::size_t i = 0; i < this->Triangles.size(); ++i)
  {
    const Triangle& own = this->Triangles[spot.Triangle];
    const Edge edge{ own.Corners[After(spot.Corner)], own.Corners[Before(spot.Corner)] };
    if (own.IsFixed[spot.Corner])
    {
      blocking = edge;
      return true;
    }
    if (own.Neighbors[spot.Corner] < 0)
    {
      return false;
    }
    crossed.push_back(edge);
    const Spot next = this->FindOpposite(spot);
    const int point = this->Triangles[next.Triangle].Corners[next.Corner];
    const double turn = point == piece.second ? 0.0 : this->Turn(piece.first, piece.second, point);
    if (turn == 0.0)
    {
      piece.second = point;
      return true;
    }
    spot = { next.Triangle, turn > 0.0 ? After(next.Corner) : Before(next.Corner) };
  }
  return false;
}

//------------------------------------------------------------------------------
/// Flips the edges that cross a piece until none does (S. W. Sloan, 1993).
void PlanarTriangulation::FlipCrossed(Edge piece, std::vector<Edge> crossed)
{
  const auto [a, b] = piece;
  const std::size_t maximum = (crossed.size() + 1) * (crossed.size() + 1); // more than needed
  std::size_t failures = 0;
  for (std::size_t pass = 0; !crossed.empty() && failures <= crossed.size() && pass < maximum;
       ++pass)
  {
    std::vector<Edge> left;
    for (const Edge& edge : crossed)
    {
      Edge flipped;
      if (!this->FlipEdge(edge, flipped))
      {
        left.push_back(edge);
        ++failures;
        continue;
      }
      failures = 0;
      const auto [c, d] = flipped;
      if (c != a && c != b && d != a && d != b &&
        (this->Turn(a, b, c) > 0.0) != (this->Turn(a, b, d) > 0.0))
      {
        left.push_back(flipped);
      }
    }
    crossed = std::move(left);
  }
}

//------------------------------------------------------------------------------
/// Flips an edge; false if its two triangles do not form a convex quadrilateral.
bool PlanarTriangulation::FlipEdge(const Edge& edge, Edge& flipped)
{
  const Spot spot = this->FindEdge(edge.first, edge.second);
  if (spot.Triangle < 0 || this->Triangles[spot.Triangle].Neighbors[spot.Corner] < 0)
  {
    return false;
  }
  const Triangle& own = this->Triangles[spot.Triangle];
  const Spot other = this->FindOpposite(spot);
  const int a = own.Corners[spot.Corner];
  const int d = this->Triangles[other.Triangle].Corners[other.Corner];
  flipped = { a, d };
  const bool isConvex = this->Turn(a, d, own.Corners[After(spot.Corner)]) < 0.0 &&
    this->Turn(a, d, own.Corners[Before(spot.Corner)]) > 0.0;
  if (isConvex)
  {
    this->Flip(spot.Triangle, spot.Corner);
  }
  return isConvex;
}

//------------------------------------------------------------------------------
/// Leads one of two crossing sides over an end of the other, where the area between is smallest.
void PlanarTriangulation::Detour(Edge piece, Edge blocking, std::vector<Edge>& rest)
{
  const int ends[4] = { blocking.first, blocking.second, piece.first, piece.second };
  int best = 0;
  double minimum = std::numeric_limits<double>::infinity();
  for (int i = 0; i < 4; ++i)
  {
    const auto [a, b] = i < 2 ? piece : blocking;
    const double area = 0.5 * std::abs(this->Turn(a, b, ends[i]));
    if (area < minimum)
    {
      best = i;
      minimum = area;
    }
  }
  this->DetourArea += minimum;
  if (best < 2)
  {
    rest.emplace_back(ends[best], piece.second);
    rest.emplace_back(piece.first, ends[best]);
    return;
  }
  const Spot spot = this->FindEdge(blocking.first, blocking.second);
  const bool isSide = this->Triangles[spot.Triangle].IsSide[spot.Corner];
  this->Mark(spot, false, isSide);
  rest.push_back(piece);
  if (isSide)
  {
    rest.emplace_back(blocking.first, ends[best]);
    rest.emplace_back(ends[best], blocking.second);
  }
}

//------------------------------------------------------------------------------
void PlanarTriangulation::Mark(const Spot& spot, bool isFixed, bool isToggled)
{
  const Spot other =
    this->Triangles[spot.Triangle].Neighbors[spot.Corner] < 0 ? spot : this->FindOpposite(spot);
  const bool isSide = this->Triangles[spot.Triangle].IsSide[spot.Corner] != isToggled;
  for (const Spot& each : { spot, other })
  {
    this->Triangles[each.Triangle].IsFixed[each.Corner] = isFixed;
    this->Triangles[each.Triangle].IsSide[each.Corner] = isSide;
  }
}

//------------------------------------------------------------------------------
/// Finds the triangles inside from the outer ones inwards: every side of the boundary changes
/// between outside and inside.
std::vector<int> PlanarTriangulation::FindInside()
{
  std::vector<signed char> isInside(this->Triangles.size(), -1); // -1: not known
  std::vector<int> reached;
  for (std::size_t i = 0; i < this->Triangles.size(); ++i)
  {
    for (int corner = 0; corner < 3 && isInside[i] < 0; ++corner)
    {
      if (this->Triangles[i].Neighbors[corner] < 0)
      {
        isInside[i] = this->Triangles[i].IsSide[corner] ? 1 : 0;
        reached.push_back(static_cast<int>(i));
      }
    }
  }
  for (std::size_t i = 0; i < reached.size(); ++i)
  {
    const Triangle& own = this->Triangles[reached[i]];
    for (int corner = 0; corner < 3; ++corner)
    {
      const int neighbor = own.Neighbors[corner];
      if (neighbor >= 0 && isInside[neighbor] < 0)
      {
        const bool inside = (isInside[reached[i]] == 1) != own.IsSide[corner];
        isInside[neighbor] = inside ? 1 : 0;
        reached.push_back(neighbor);
      }
    }
  }
  std::vector<int> corners;
  for (std::size_t i = 0; i < this->Triangles.size(); ++i)
  {
    if (isInside[i] == 1)
    {
      corners.insert(
        corners.end(), this->Triangles[i].Corners.begin(), this->Triangles[i].Corners.end());
    }
  }
  return corners;
}

} // namespace helios
