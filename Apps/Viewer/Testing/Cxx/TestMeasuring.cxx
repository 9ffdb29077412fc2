// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosCloudView.h"
#include "heliosMeasureTool.h"
#include "heliosSectionTool.h"
#include "heliosViewerTest.h"

#include <catch2/catch.hpp>

using namespace helios;
using namespace helios::viewer;

TEST_CASE("Measure: distance, horizontal and vertical part")
{
  CHECK(DescribeDistance({ 1, 1, 1 }, { 3, 0, 3 }) ==
    "distance 3.000 m, horizontal 2.236 m, vertical 2.000 m");
  CHECK(DescribeDistance({ 0, 0, 5 }, { 0, 3, 1 }) ==
    "distance 5.000 m, horizontal 3.000 m, vertical -4.000 m");
}

TEST_CASE("Section: the slab is vertical, along the line, and has its thickness")
{
  const auto slab = MakeSlab({ 10, 10, 7 }, { 13, 14, -2 }, 2.0);
  REQUIRE(slab);
  CHECK(slab->Normal[2] == 0.0);
  CHECK(slab->Normal.Dot(Vec3(3, 4, 0)) == Approx(0.0).margin(1e-12));
  CHECK(slab->Contains({ 16, 18, 100 }));
  const Vec3 side = slab->Normal;
  CHECK(slab->Contains(Vec3(10, 10, 0) + 0.99 * side));
  CHECK_FALSE(slab->Contains(Vec3(10, 10, 0) + 1.01 * side));
  CHECK_FALSE(slab->Contains(Vec3(10, 10, 0) - 1.01 * side));
  CHECK_FALSE(MakeSlab({ 1, 2, 3 }, { 1, 2, 9 }, 1.0)); // above each other
}

TEST_CASE("Section: only points in the slab are drawn and picked, far from the origin too")
{
  const bool isWhole = GENERATE(true, false); // all points, or those found for every pixel
  const Vec3 origin = GENERATE(Vec3(0, 0, 0), Vec3(476000, 5473000, 0));
  Stage stage;
  Cloud cloud;
  cloud.SetOrigin(origin);
  std::vector<Vec3> places;
  for (const Vec3& place : { Vec3(5, 0, 0), Vec3(0, 5, 0), Vec3(-5, 0, 0), Vec3(0, -5, 0) })
  {
    places.push_back(place + origin);
  }
  cloud.Append(MakeEchoes(places));
  CloudView view(cloud, stage.Renderer);
  view.SetWholeLimit(isWhole ? 1000 : 0);
  view.SetColorBy(ColorBy::One);
  view.SetColor({ 250, 120, 10 });
  view.SetPointSize(4.0);
  view.SetSection(MakeSlab(origin + Vec3(-1, 0, 0), origin + Vec3(1, 0, 0), 1.0)); // along x
  stage.Render();
  CHECK(stage.GetColorAt(5, 0) == Rgb{ 250, 120, 10 });
  CHECK(stage.GetColorAt(-5, 0) == Rgb{ 250, 120, 10 });
  CHECK(stage.GetColorAt(0, 5) == Black);
  CHECK(stage.GetColorAt(0, -5) == Black);
  CHECK(view.Pick(Stage::ToPixel(5), Stage::ToPixel(0), 4.0));
  CHECK_FALSE(view.Pick(Stage::ToPixel(0), Stage::ToPixel(5), 4.0));
  view.SetSection(std::nullopt);
  stage.Render();
  CHECK(stage.GetColorAt(0, 5) == Rgb{ 250, 120, 10 });
}
