// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Outlines of masks against shapes of known areas.
#include "heliosContourRings.h"
#include "heliosMaskMaking.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>

using helios::ComputeRingArea;
using helios::ContourRing;
using helios::FindRings;
using helios::MakeDisc;
using helios::MakeMask;
using helios::MaskImage;
using helios::SimplifyRing;

namespace
{

constexpr double Pi = 3.14159265358979323846;
constexpr double Middle = 127.5;

double ComputeAreaOf(const std::vector<ContourRing>& rings)
{
  double area = 0.0;
  for (const ContourRing& ring : rings)
  {
    area += ComputeRingArea(ring);
  }
  return area;
}

double ComputeDistance(
  const std::array<double, 2>& p, const std::array<double, 2>& a, const std::array<double, 2>& b)
{
  const double dx = b[0] - a[0];
  const double dy = b[1] - a[1];
  const double square = dx * dx + dy * dy;
  const double share =
    square > 0.0 ? std::clamp(((p[0] - a[0]) * dx + (p[1] - a[1]) * dy) / square, 0.0, 1.0) : 0.0;
  return std::hypot(p[0] - a[0] - share * dx, p[1] - a[1] - share * dy);
}

/// Returns the largest distance of the points of a ring from another ring.
double ComputeDistance(const ContourRing& from, const ContourRing& to)
{
  double largest = 0.0;
  for (const auto& point : from)
  {
    double nearest = 1e9;
    for (std::size_t i = 0; i < to.size(); ++i)
    {
      nearest = std::min(nearest, ComputeDistance(point, to[i], to[(i + 1) % to.size()]));
    }
    largest = std::max(largest, nearest);
  }
  return largest;
}

} // namespace

TEST_CASE("ContourRings: a smooth disc has its area and radius", "[ContourRings]")
{
  const double radius = 50.25;
  const std::vector<ContourRing> rings = FindRings(MakeDisc(128, radius), Middle);
  REQUIRE(rings.size() == 1);
  CHECK(ComputeRingArea(rings[0]) == Approx(Pi * radius * radius).epsilon(1e-3));
  for (const auto& point : rings[0])
  {
    CHECK(std::hypot(point[0] - 64.0, point[1] - 64.0) == Approx(radius).margin(0.12));
  }
}

TEST_CASE("ContourRings: they end at the border, whole masks have the image's", "[ContourRings]")
{
  const std::vector<ContourRing> all =
    FindRings(MakeMask(5, 3, [](double, double) { return 1.0; }), Middle);
  REQUIRE(all.size() == 1);
  CHECK(ComputeRingArea(all[0]) == Approx(15.0).epsilon(1e-14));
  CHECK(FindRings(MakeMask(5, 3, [](double, double) { return 0.0; }), Middle).empty());
  const MaskImage left = MakeMask(8, 4, [](double x, double) { return x < 3.0 ? 1.0 : 0.0; });
  const std::vector<ContourRing> half = FindRings(left, Middle);
  REQUIRE(half.size() == 1);
  CHECK(ComputeRingArea(half[0]) == Approx(12.0).epsilon(1e-14));
}

TEST_CASE("ContourRings: holes are negative, islands in them positive", "[ContourRings]")
{
  const MaskImage mask = MakeMask(64, 64,
    [](double x, double y)
    {
      const double r = std::hypot(x - 32.0, y - 32.0);
      return r < 8.0 || (r > 16.0 && r < 28.0) ? 1.0 : 0.0;
    });
  std::vector<ContourRing> rings = FindRings(mask, Middle);
  REQUIRE(rings.size() == 3);
  std::sort(rings.begin(), rings.end(),
    [](const auto& a, const auto& b) { return ComputeRingArea(a) < ComputeRingArea(b); });
  CHECK(ComputeRingArea(rings[0]) == Approx(-Pi * 256.0).epsilon(0.02));
  CHECK(ComputeRingArea(rings[1]) == Approx(Pi * 64.0).epsilon(0.05));
  CHECK(ComputeRingArea(rings[2]) == Approx(Pi * 784.0).epsilon(0.02));
}

TEST_CASE("ContourRings: the value at a saddle joins corners or separates them", "[ContourRings]")
{
  // Values a above and b below in a checkerboard: the saddle has the mean of both.
  const auto count = [](unsigned char above)
  {
    const MaskImage mask{ 2, 2, { above, 10, 10, above } };
    return FindRings(mask, Middle).size();
  };
  CHECK(count(250) == 1); // 130
  CHECK(count(240) == 2); // 125
}

TEST_CASE("ContourRings: rings of any mask are closed and their areas add up", "[ContourRings]")
{
  std::uint32_t state = 7;
  const auto random = [&state]()
  {
    state = state * 1664525U + 1013904223U;
    return (state >> 8) / 16777216.0;
  };
  for (int round = 0; round < 20; ++round)
  {
    const MaskImage mask = MakeMask(23, 17, [&](double, double) { return random(); });
    const MaskImage other = MakeMask(23, 17,
      [&](double x, double y)
      { return 1.0 - mask.Get(static_cast<int>(x), static_cast<int>(y)) / 255.0; });
    CHECK(ComputeAreaOf(FindRings(mask, Middle)) + ComputeAreaOf(FindRings(other, Middle)) ==
      Approx(23.0 * 17.0).epsilon(1e-12));
  }
}

TEST_CASE("ContourRings: simplified rings keep area and place with fewer points", "[ContourRings]")
{
  for (const double radius : { 3.0, 20.0, 100.0 })
  {
    const MaskImage mask = MakeMask(256, 256,
      [radius](double x, double y) { return std::hypot(x - 130.0, y - 120.0) < radius ? 1 : 0; });
    const std::vector<ContourRing> rings = FindRings(mask, Middle);
    REQUIRE(rings.size() == 1);
    const ContourRing simple = SimplifyRing(rings[0], 0.5, mask);
    CAPTURE(radius, rings[0].size(), simple.size());
    CHECK(ComputeRingArea(simple) == Approx(ComputeRingArea(rings[0])).epsilon(1e-8));
    CHECK(
      ComputeDistance(rings[0], simple) < 1.0); // half a pixel, and the move that keeps the area
    CHECK(ComputeDistance(simple, rings[0]) < 1.0);
    CHECK((radius < 10.0 || 7 * simple.size() < rings[0].size()));
  }
}

TEST_CASE("ContourRings: a ring at the border stays within the image", "[ContourRings]")
{
  const MaskImage mask = MakeMask(
    64, 64, [](double x, double y) { return std::hypot(x - 10.0, y - 32.0) < 30.0 ? 1.0 : 0.0; });
  const std::vector<ContourRing> rings = FindRings(mask, Middle);
  REQUIRE(rings.size() == 1);
  const ContourRing simple = SimplifyRing(rings[0], 0.5, mask);
  CHECK(ComputeRingArea(simple) == Approx(ComputeRingArea(rings[0])).epsilon(1e-5));
  CHECK(std::all_of(
    simple.begin(), simple.end(), [](const auto& p) { return p[0] >= 0.0 && p[0] <= 64.0; }));
}

TEST_CASE("ContourRings: a ring as narrow as the tolerance is kept", "[ContourRings]")
{
  const MaskImage mask =
    MakeMask(8, 8, [](double x, double y) { return x < 4 && x > 3 && y > 3 && y < 4; });
  const std::vector<ContourRing> rings = FindRings(mask, Middle);
  REQUIRE(rings.size() == 1);
  CHECK(ComputeRingArea(SimplifyRing(rings[0], 0.5, mask)) ==
    Approx(ComputeRingArea(rings[0])).epsilon(1e-8));
}
