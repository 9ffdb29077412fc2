// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosEditArea.h"

#include <vtkMath.h>

#include <catch2/catch.hpp>

#include <cmath>

using helios::Vec3;
using helios::viewer::FlyArea;

namespace
{

helios::SurveyEdit MakeEdit(const Vec3& corner, const Vec3& opposite)
{
  helios::SurveyEdit edit;
  edit.PlatformModel.Type = helios::PlatformType::LinearPath;
  edit.Settings.ScanAngle = 30.0;
  edit.Height = 100.0;
  edit.HasArea = true;
  edit.Corners[0] = corner;
  edit.Corners[1] = opposite;
  return edit;
}

double GetAcross(const helios::EditLeg& leg)
{
  return leg.Settings.Leg.Position[1];
}

} // namespace

TEST_CASE("EditArea: the fewest lines, at most 2 h tan(a) (1 - overlap) apart, cover a rectangle")
{
  const double swath = 200.0 * std::tan(vtkMath::RadiansFromDegrees(30.0));
  for (const double overlap : { 0.0, 20.0, 60.0, 95.0 })
  {
    for (const double width : { 1.0, 115.0, 500.0 })
    {
      INFO("overlap " << overlap << ", width " << width);
      auto edit = MakeEdit({ 10.0, 700.0, 5.0 }, { 810.0, 700.0 - width, 2.0 });
      edit.Overlap = overlap;
      REQUIRE(FlyArea(edit).IsOk());
      const std::size_t lines = edit.Legs.size() / 2;
      const double last =
        lines > 1 ? std::abs(GetAcross(edit.Legs.front()) - GetAcross(edit.Legs.back())) : 0.0;
      const double spacing = swath * (1.0 - 0.01 * overlap);
      CHECK(last <= spacing * double(lines - 1) + 1e-6);
      CHECK(last + swath >= width - 1e-6);
      const bool isFewest = lines == 1 || spacing * double(lines - 2) + swath < width;
      CHECK(isFewest);
      for (std::size_t i = 0; i < edit.Legs.size(); ++i)
      {
        const Vec3 position = edit.Legs[i].Settings.Leg.Position;
        CHECK(position[0] == ((i + 1) % 4 < 2 ? 10.0 : 810.0)); // back and forth
        CHECK(position[2] == 105.0);
        CHECK(edit.Legs[i].Settings.Leg.Active == (i % 2 == 0));
      }
    }
  }
  auto narrow = MakeEdit({ 0, 0, 0 }, { 10, 20, 0 });
  REQUIRE(FlyArea(narrow).IsOk());
  CHECK(narrow.Legs[0].Settings.Leg.Position[0] == narrow.Legs[1].Settings.Leg.Position[0]);
}

TEST_CASE("EditArea: no rectangle, and too many lines")
{
  auto edit = MakeEdit({ 0, 0, 0 }, { 100, 0, 0 });
  CHECK(FlyArea(edit).Message() == "the corners span no rectangle: click an opposite corner");
  edit.Corners[1] = { 1e5, 1e5, 0 };
  edit.Overlap = 95.0;
  CHECK(FlyArea(edit).Message() ==
    "more than 1000 flight lines: raise the height, or lower the overlap");
  CHECK(edit.Legs.empty());
  edit.HasArea = false; // nothing is done
  CHECK(FlyArea(edit).IsOk());
}
