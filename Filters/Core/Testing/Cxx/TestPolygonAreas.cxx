// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Triangles of thousands of random polygons in any plane, near and far from the origin: their area
// equals the area of the rings to 1e-9, they face along its normal, and they overlap nowhere.
#include "heliosPolygonTesting.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <map>
#include <utility>
#include <vector>

namespace
{

using helios::PolygonPlane;
using helios::PolygonShape;
using helios::Vec3;
using Place = std::pair<double, double>;

/// Checks the triangles of rings, the first of which is the boundary.
void CheckArea(const std::vector<std::vector<Vec3>>& rings)
{
  PolygonShape shape;
  Vec3 vector = helios::GetRingVector(rings[0]);
  for (const std::vector<Vec3>& ring : rings)
  {
    shape.AddRing(ring);
  }
  double expected = 0.5 * vector.Normalize();
  for (std::size_t i = 1; i < rings.size(); ++i)
  {
    expected -= 0.5 * helios::GetRingVector(rings[i]).Norm();
  }
  const double area = shape.GetArea(vector);
  CHECK(shape.IsSimple);
  CHECK(area == Approx(expected).epsilon(1e-9));
  CHECK(shape.GetSize() == Approx(expected).epsilon(1e-9));
}

/// A closed way through random places, where two sides that cross are exchanged until none do.
std::vector<Place> MakeSimple(int count, bool isOnGrid, std::mt19937& random)
{
  std::uniform_real_distribution<double> place(0.0, 20.0);
  std::vector<Place> ring;
  while (static_cast<int>(ring.size()) < count)
  {
    const Place next{ place(random), place(random) };
    const Place rounded{ std::floor(next.first), std::floor(next.second) };
    const Place added = isOnGrid ? rounded : next;
    if (std::find(ring.begin(), ring.end(), added) == ring.end())
    {
      ring.push_back(added);
    }
  }
  const auto turn = [](const Place& a, const Place& b, const Place& c)
  {
    return (b.first - a.first) * (c.second - a.second) -
      (b.second - a.second) * (c.first - a.first);
  };
  const auto length = [](const Place& a, const Place& b)
  { return std::hypot(a.first - b.first, a.second - b.second); };
  for (bool isChanged = true; isChanged;)
  {
    isChanged = false;
    for (std::size_t i = 0; i + 2 < ring.size(); ++i)
    {
      for (std::size_t k = i + 2; k < ring.size(); ++k)
      {
        const Place &a = ring[i], &b = ring[i + 1], &c = ring[k], &d = ring[(k + 1) % ring.size()];
        const bool isShorter =
          length(a, c) + length(b, d) < (length(a, b) + length(c, d)) * (1.0 - 1e-12);
        const bool isNear =
          turn(a, b, c) * turn(a, b, d) <= 0.0 && turn(c, d, a) * turn(c, d, b) <= 0.0;
        if (a != d && isShorter && isNear)
        {
          std::reverse(ring.begin() + static_cast<std::ptrdiff_t>(i) + 1,
            ring.begin() + static_cast<std::ptrdiff_t>(k) + 1);
          isChanged = true;
        }
      }
    }
  }
  return ring;
}

std::vector<Vec3> PlaceRing(const std::vector<Place>& ring, const PolygonPlane& plane)
{
  std::vector<Vec3> placed;
  for (const Place& each : ring)
  {
    placed.push_back(plane.Place(each.first, each.second));
  }
  return placed;
}

/// Cells of a grid that are connected by sides, and the rings round them: at a corner with two
/// cells across, each ring turns left, so that rings touch there.
class Cells
{
public:
  Cells(int size, double share, std::mt19937& random)
    : Size(size)
    , IsSet(static_cast<std::size_t>(size * size))
  {
    std::bernoulli_distribution choose(share);
    std::generate(this->IsSet.begin(), this->IsSet.end(), [&] { return choose(random); });
    this->IsSet[static_cast<std::size_t>(size / 2 * size + size / 2)] = true;
    this->Connect();
  }

  std::vector<std::vector<Place>> FindRings(bool turnsLeft) const
  {
    std::multimap<Corner, Corner> sides; // triangles of cells, counterclockwise
    for (int y = 0; y < this->Size; ++y)
    {
      for (int x = 0; x < this->Size; ++x)
      {
        this->AddSides(x, y, sides);
      }
    }
    std::vector<std::vector<Place>> rings;
    while (!sides.empty())
    {
      rings.emplace_back();
      const Corner start = sides.begin()->first;
      Corner step{ 0, 0 };
      Corner at = start;
      do
      {
        rings.back().emplace_back(at.first, at.second);
        at = RemoveSide(at, step, turnsLeft, sides);
      } while (at != start);
    }
    // The longest way round is the boundary, as it has the largest box.
    const auto width = [](const std::vector<Place>& ring)
    {
      const auto ends = std::minmax_element(ring.begin(), ring.end());
      return ends.second->first - ends.first->first;
    };
    std::stable_sort(rings.begin(), rings.end(),
      [&](const auto& a, const auto& b) { return width(a) > width(b); });
    return rings;
  }

  double CountSet() const
  {
    return static_cast<double>(std::count(this->IsSet.begin(), this->IsSet.end(), true));
  }

private:
  using Corner = std::pair<int, int>;

  bool Has(int x, int y) const
  {
    return x >= 0 && y >= 0 && x < this->Size && y < this->Size &&
      this->IsSet[static_cast<std::size_t>(y * this->Size + x)];
  }

  /// Leaves the cells that are connected to the one in the middle.
  void Connect()
  {
    std::vector<bool> reached(this->IsSet.size(), false);
    std::vector<Corner> open{ { this->Size / 2, this->Size / 2 } };
    while (!open.empty())
    {
      const auto [x, y] = open.back();
      open.pop_back();
      if (!this->Has(x, y) || reached[static_cast<std::size_t>(y * this->Size + x)])
      {
        continue;
      }
      reached[static_cast<std::size_t>(y * this->Size + x)] = true;
      open.insert(open.end(), { { x + 1, y }, { x - 1, y }, { x, y + 1 }, { x, y - 1 } });
    }
    this->IsSet = reached;
  }

  void AddSides(int x, int y, std::multimap<Corner, Corner>& sides) const
  {
    if (!this->Has(x, y))
    {
      return;
    }
    this->Has(x, y - 1) ? sides.end() : sides.insert({ { x, y }, { x + 1, y } });
    this->Has(x + 1, y) ? sides.end() : sides.insert({ { x + 1, y }, { x + 1, y + 1 } });
    this->Has(x, y + 1) ? sides.end() : sides.insert({ { x + 1, y + 1 }, { x, y + 1 } });
    this->Has(x - 1, y) ? sides.end() : sides.insert({ { x, y + 1 }, { x, y } });
  }

  static Corner RemoveSide(
    const Corner& at, Corner& step, bool turnsLeft, std::multimap<Corner, Corner>& sides)
  {
    auto [chosen, end] = sides.equal_range(at);
    for (auto each = chosen; each != end; ++each)
    {
      const int turn = step.first * (each->second.second - at.second) -
        step.second * (each->second.first - at.first);
      chosen = (turnsLeft ? turn > 0 : turn < 0) ? each : chosen;
    }
    const Corner next = chosen->second;
    step = { next.first - at.first, next.second - at.second };
    sides.erase(chosen);
    return next;
  }

  int Size;
  std::vector<bool> IsSet;
};

} // namespace

TEST_CASE("PolygonAreas: 2000 simple polygons", "[PolygonTriangulator]")
{
  std::mt19937 random(11);
  for (int run = 0; run < 2000; ++run)
  {
    INFO("run " << run);
    const PolygonPlane plane = helios::MakePlane(run, random);
    CheckArea({ PlaceRing(MakeSimple(4 + run % 37, false, random), plane) });
  }
}

TEST_CASE("PolygonAreas: polygons with collinear corners", "[PolygonTriangulator]")
{
  std::mt19937 random(12);
  for (int run = 0; run < 1000; ++run)
  {
    INFO("run " << run);
    const PolygonPlane plane = helios::MakePlane(run, random);
    std::vector<Place> ring = MakeSimple(5 + run % 20, true, random);
    std::vector<Place> split; // every side in two or three pieces
    for (std::size_t i = 0; i < ring.size(); ++i)
    {
      const Place& a = ring[i];
      const Place& b = ring[(i + 1) % ring.size()];
      split.push_back(a);
      for (const double t : { 0.25, 0.5 })
      {
        split.emplace_back(a.first + t * (b.first - a.first), a.second + t * (b.second - a.second));
      }
    }
    CheckArea({ PlaceRing(split, plane) });
  }
}

TEST_CASE("PolygonAreas: holes that touch each other and the boundary", "[PolygonTriangulator]")
{
  std::mt19937 random(13);
  std::size_t holes = 0;
  for (int run = 0; run < 2000; ++run)
  {
    INFO("run " << run);
    const PolygonPlane plane = helios::MakePlane(run, random);
    const Cells cells(4 + run % 8, 0.4 + 0.05 * (run % 11), random);
    std::vector<std::vector<Vec3>> rings;
    for (const std::vector<Place>& ring : cells.FindRings(run % 2 == 0))
    {
      rings.push_back(PlaceRing(ring, plane));
    }
    holes += rings.size() - 1;
    CheckArea(rings);
    PolygonShape shape;
    std::for_each(rings.begin(), rings.end(), [&](const auto& ring) { shape.AddRing(ring); });
    CHECK(std::abs(shape.GetArea(plane.GetNormal())) == Approx(cells.CountSet()).epsilon(1e-8));
  }
  CHECK(holes > 2000);
}
