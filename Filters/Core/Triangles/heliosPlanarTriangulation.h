// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Triangles between points of a plane that have given sides.

#ifndef heliosPlanarTriangulation_h
#define heliosPlanarTriangulation_h

#include "vtkHeliosFiltersCoreModule.h" // For export macro

#include <array>
#include <cstddef>
#include <utility>
#include <vector>

namespace helios
{

/**
 * A constrained Delaunay triangulation, built by a sweep. All decisions are by the exact sign of
 * ComputeTurn(), so it ends for any points. A point is within the sides if a ray from it crosses an
 * odd number of them (even-odd rule).
 */
class VTKHELIOSFILTERSCORE_EXPORT PlanarTriangulation
{
public:
  using Point = std::array<double, 2>;

  /// Triangulates points, no two of which are the same.
  void Build(std::vector<Point> points);

  /**
   * Adds a side between two points, as pieces where others are on it. A side that is there already
   * is removed from the boundary. Of two sides that cross, one makes a detour to the closest end.
   */
  void AddSide(int from, int to);

  /// Returns the area between crossing sides and their detours; infinite if a detour had no end.
  double GetDetourArea() const { return this->DetourArea; }

  /// Returns three points per triangle within the sides, counterclockwise.
  std::vector<int> FindInside();

private:
  /// Corners are counterclockwise; a neighbour and a side are opposite to a corner.
  struct Triangle
  {
    std::array<int, 3> Corners;
    std::array<int, 3> Neighbors{ -1, -1, -1 };
    std::array<bool, 3> IsFixed{};
    std::array<bool, 3> IsSide{}; // side of the boundary
  };
  using Edge = std::pair<int, int>;

  /// A triangle, and one of its corners or of the sides opposite to them.
  struct Spot
  {
    int Triangle = -1;
    int Corner = 0;
  };

  double Turn(int a, int b, int c) const;
  void BuildFirst(const std::vector<int>& order, std::size_t count);
  void AddPoint(int point, int last);
  int AddTriangle(int a, int b, int c);
  void Link(int triangle, int corner, int neighbor);
  bool IsInCircle(int a, int b, int c, int d) const;
  void Legalize(std::vector<Spot>& spots);
  void Flip(int triangle, int corner);
  int FindCorner(int triangle, int point) const;
  Spot FindOpposite(const Spot& spot) const;
  Spot FindEdge(int a, int b) const;
  template <typename Visitor>
  void VisitTriangles(int point, Visitor visit) const;
  bool IsAhead(int from, int to, int point) const;
  Spot FindStart(int from, int& to) const;
  bool AddPiece(Edge piece, std::vector<Edge>& rest);
  bool FindCrossed(Spot spot, Edge& piece, std::vector<Edge>& crossed, Edge& blocking) const;
  void FlipCrossed(Edge piece, std::vector<Edge> crossed);
  bool FlipEdge(const Edge& edge, Edge& flipped);
  void Detour(Edge piece, Edge blocking, std::vector<Edge>& rest);
  void Mark(const Spot& spot, bool isFixed, bool isToggled);

  std::vector<Point> Points;
  std::vector<Triangle> Triangles;
  std::vector<int> TriangleOfPoint;
  // The hull, counterclockwise; the triangle at the edge to the next point.
  std::vector<int> Next;
  std::vector<int> Previous;
  std::vector<int> HullTriangle;
  double DetourArea = 0.0;
  std::size_t Detours = 0;
};

} // namespace helios

#endif
