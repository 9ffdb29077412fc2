// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Triangles of masks, and triangles that are cut by them.
#include "heliosCutoutClipper.h"
#include "heliosCutoutShape.h"
#include "heliosMaskMaking.h"

#include <catch2/catch.hpp>

#include <array>
#include <cmath>

using helios::CutoutBand;
using helios::CutoutClipper;
using helios::CutoutPieces;
using helios::CutoutShape;
using helios::MakeDisc;
using helios::MakeMask;
using helios::MaskImage;
using helios::TextureWrap;

namespace
{

using Point = std::array<double, 2>;
using Corners = std::array<Point, 3>;

constexpr double Pi = 3.14159265358979323846;
constexpr std::array<TextureWrap, 2> Repeat{ TextureWrap::Repeat, TextureWrap::Repeat };

/// Returns the area of pieces, of a triangle whose area is 1; all have its orientation.
double ComputeArea(const CutoutPieces& pieces)
{
  double area = 0.0;
  for (std::size_t i = 0; i < pieces.Corners.size(); i += 3)
  {
    const auto get = [&](std::size_t k)
    { return pieces.Points[static_cast<std::size_t>(pieces.Corners[i + k])]; };
    const Point a = get(0), b = get(1), c = get(2);
    const double twice = (b[0] - a[0]) * (c[1] - a[1]) - (c[0] - a[0]) * (b[1] - a[1]);
    CHECK(twice > 0.0);
    area += twice;
  }
  return area;
}

/// Returns the area that is left of two triangles of a rectangle, of its own.
double CutRectangle(const CutoutBand& band, const Point& low, const Point& high,
  std::array<TextureWrap, 2> wrap = Repeat)
{
  CutoutClipper clipper(band, wrap);
  CutoutPieces pieces;
  REQUIRE(clipper.Clip({ low, Point{ high[0], low[1] }, high }, pieces));
  const double first = ComputeArea(pieces);
  REQUIRE(clipper.Clip({ low, high, Point{ low[0], high[1] } }, pieces));
  return 0.5 * (first + ComputeArea(pieces));
}

/// A mask that is opaque below a line through the lower left and upper right corner.
MaskImage MakeHalf()
{
  return MakeMask(64, 64, [](double x, double y) { return 0.5 + x - y; });
}

} // namespace

TEST_CASE("CutoutShape: triangles have the area of the mask", "[CutoutShape]")
{
  const double radius = 79.2; // 30 % of the image
  const CutoutShape shape = CutoutShape::Cut(MakeDisc(256, radius), 0.5);
  REQUIRE(shape.GetBands().size() == 1);
  const CutoutBand& band = shape.GetBands()[0];
  CHECK(band.Area == Approx(Pi * radius * radius / 65536.0).epsilon(1e-3));
  CHECK(band.GetNumberOfTriangles() < 60);
  CHECK(CutRectangle(band, { 0, 0 }, { 1, 1 }) == Approx(band.Area).epsilon(1e-9));
}

TEST_CASE("CutoutShape: all, nothing, and thresholds", "[CutoutShape]")
{
  const auto grey = [](double value)
  { return MakeMask(4, 4, [value](double, double) { return value; }); };
  CHECK(CutoutShape::Cut(grey(1.0), 0.5).IsWhole());
  CHECK(CutoutShape::Cut(grey(0.0), 0.5).GetBands().empty());
  CHECK(CutoutShape::Cut(grey(0.4), 0.5).GetBands().empty());
  CHECK(CutoutShape::Cut(grey(0.4), 0.4).IsWhole()); // 102 of 255: at least the threshold
  CHECK(CutoutShape::Cut(grey(0.4), 0.404).GetBands().empty());
}

TEST_CASE("CutoutShape: eighths of opacity have all the light of a mask", "[CutoutShape]")
{
  const MaskImage mask = MakeMask(256, 256, [](double x, double) { return x / 256.0; });
  const CutoutShape shape = CutoutShape::Blend(mask);
  CHECK(shape.GetBands().size() == 8);
  double light = 0.0;
  double area = 0.0;
  for (const CutoutBand& band : shape.GetBands())
  {
    light += band.Opacity * band.Area;
    area += band.Area;
  }
  CHECK(light == Approx(0.5).epsilon(2e-3));
  CHECK(area == Approx(1.0).epsilon(5e-3)); // but for the pixels without any opacity
  const CutoutShape whole = CutoutShape::Blend(MakeMask(4, 4, [](double, double) { return 0.4; }));
  CHECK(whole.IsWhole());
  REQUIRE(whole.GetBands().size() == 1);
  CHECK(whole.GetBands()[0].Opacity == Approx(0.4));
}

TEST_CASE("CutoutShape: noise has its area, too", "[CutoutShape]")
{
  std::uint32_t state = 3;
  const MaskImage mask = MakeMask(96, 96,
    [&state](double, double)
    {
      state = state * 1664525U + 1013904223U;
      return state >> 31 == 0 ? 0.0 : 1.0;
    });
  double truth = 0.0;
  for (const auto& ring : helios::FindRings(mask, 127.5))
  {
    truth += helios::ComputeRingArea(ring);
  }
  const CutoutShape shape = CutoutShape::Cut(mask, 0.5);
  REQUIRE(shape.GetBands().size() == 1);
  CHECK(shape.GetBands()[0].Area * 96 * 96 == Approx(truth).epsilon(1e-3));
}

TEST_CASE("CutoutClipper: parts of a texture, repeated and turned", "[CutoutClipper]")
{
  const CutoutShape shape = CutoutShape::Cut(MakeHalf(), 0.5);
  const CutoutBand& half = shape.GetBands()[0];
  CHECK(half.Area == Approx(0.5).epsilon(1e-3));
  CHECK(CutRectangle(half, { 0.5, 0.0 }, { 1.0, 0.5 }) == Approx(1.0).epsilon(2e-3));
  CHECK(CutRectangle(half, { 0.0, 0.5 }, { 0.5, 1.0 }) == Approx(0.0).margin(2e-3));
  CHECK(CutRectangle(half, { 0.25, 0.25 }, { 0.75, 0.75 }) == Approx(0.5).epsilon(1e-2));
  CHECK(CutRectangle(half, { -3.0, 2.0 }, { 4.0, 5.0 }) == Approx(half.Area).epsilon(1e-9));
  CHECK(CutRectangle(half, { 0.5, 0.0 }, { 1.5, 1.0 }) == Approx(half.Area).epsilon(1e-9));
  CHECK(CutRectangle(half, { 1.0, 0.0 }, { 0.0, 1.0 }) == Approx(half.Area).epsilon(1e-9));
}

TEST_CASE("CutoutClipper: mirrored textures meet at their borders", "[CutoutClipper]")
{
  const MaskImage mask = MakeMask(64, 64, [](double x, double) { return x < 16.0 ? 1.0 : 0.0; });
  const CutoutShape shape = CutoutShape::Cut(mask, 0.5);
  const CutoutBand& band = shape.GetBands()[0];
  const std::array<TextureWrap, 2> mirror{ TextureWrap::Mirror, TextureWrap::Mirror };
  CHECK(CutRectangle(band, { -0.25, 0.0 }, { 0.25, 1.0 }, mirror) == Approx(1.0).epsilon(1e-6));
  CHECK(CutRectangle(band, { -0.25, 0.0 }, { 0.25, 1.0 }) == Approx(0.5).epsilon(1e-6));
  CHECK(CutRectangle(band, { 1.75, -1.0 }, { 2.25, 1.0 }, mirror) == Approx(1.0).epsilon(1e-6));
}

TEST_CASE("CutoutClipper: what cannot be cut is told", "[CutoutClipper]")
{
  const CutoutShape shape = CutoutShape::Cut(MakeHalf(), 0.5);
  const CutoutBand& half = shape.GetBands()[0];
  CutoutPieces pieces;
  CHECK_FALSE(CutoutClipper(half, Repeat)
                .Clip(Corners{ Point{ 0, 0 }, Point{ 1e6, 0 }, Point{ 0, 1e6 } }, pieces));
  const std::array<TextureWrap, 2> clamp{ TextureWrap::Clamp, TextureWrap::Clamp };
  CHECK_FALSE(CutoutClipper(half, clamp)
                .Clip(Corners{ Point{ 0, 0 }, Point{ 1.5, 0 }, Point{ 0, 1 } }, pieces));
  CHECK(CutRectangle(half, { -0.005, -0.005 }, { 1.005, 1.005 }, clamp) ==
    Approx(half.Area / 1.0201).epsilon(1e-3));
  CHECK(CutoutClipper(half, Repeat)
          .Clip(Corners{ Point{ 0, 0 }, Point{ 1, 1 }, Point{ 0.5, 0.5 } }, pieces));
  CHECK(pieces.Corners.empty());
}
