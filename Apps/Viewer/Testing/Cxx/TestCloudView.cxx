// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosCloudView.h"
#include "heliosViewerTest.h"

#include <catch2/catch.hpp>

#include <vtkFieldData.h>
#include <vtkNew.h>
#include <vtkStringArray.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

using namespace helios;
using namespace helios::viewer;
namespace names = vtkHeliosArrayNames;

namespace
{

/// Four points with different values, on the axes 5 m from the centre: east, north, west, south.
vtkSmartPointer<vtkPolyData> MakeFour()
{
  return MakeEchoes({ { 5, 0, 0 }, { 0, 5, 1 }, { -5, 0, 2 }, { 0, -5, 3 } });
}

std::vector<Rgb> GetFourColors(Stage& stage)
{
  stage.Render();
  return { stage.GetColorAt(5, 0), stage.GetColorAt(0, 5), stage.GetColorAt(-5, 0),
    stage.GetColorAt(0, -5) };
}

} // namespace

TEST_CASE("CloudView: points are drawn at their pixels, with their size and colour")
{
  Stage stage;
  Cloud cloud;
  cloud.SetOrigin({ 0, 0, 0 });
  cloud.Append(MakeFour());
  CloudView view(cloud, stage.Renderer);
  view.SetColorBy(ColorBy::One);
  view.SetColor({ 250, 120, 10 });
  view.SetPointSize(4.0);
  CHECK(GetFourColors(stage) == std::vector<Rgb>(4, { 250, 120, 10 }));
  CHECK(stage.CountPixels({ 250, 120, 10 }) == 4 * 16);
  CHECK(stage.CountPixels(Black) == 200 * 200 - 64);
  view.SetPointSize(6.0);
  stage.Render();
  CHECK(stage.CountPixels({ 250, 120, 10 }) == 4 * 36);
  view.SetVisible(false);
  stage.Render();
  CHECK(stage.CountPixels(Black) == 200 * 200);
}

TEST_CASE("CloudView: a distant origin does not move the picture")
{
  Stage stage;
  Cloud cloud;
  const Vec3 origin(500000.0, 5400000.0, 300.0);
  cloud.SetOrigin(origin);
  cloud.Append(MakeEchoes({ origin + Vec3(5, 0, 0), origin + Vec3(0, -5, 0) }));
  CloudView view(cloud, stage.Renderer);
  view.SetColorBy(ColorBy::One);
  view.SetPointSize(4.0);
  stage.Render();
  CHECK(stage.GetColorAt(5, 0) == Rgb{ 200, 205, 210 });
  CHECK(stage.GetColorAt(0, -5) == Rgb{ 200, 205, 210 });
  CHECK(stage.CountPixels(Black) == 200 * 200 - 32);
}

TEST_CASE("CloudView: colours follow the values")
{
  Stage stage;
  Cloud cloud;
  cloud.SetOrigin({ 0, 0, 0 });
  auto echoes = MakeFour();
  AddColumn(echoes, names::Amplitude, { 1e-9, 1e-8, 1e-7, 1e-6 });
  AddColumn(echoes, names::ReturnNumber, { 1, 2, 3, 9 });
  AddColumn(echoes, names::ClassificationIds, { 2, 5, 6, 9 });
  AddColumn(echoes, names::GpsTime, { 0, 1, 2, 3 });
  AddColumn(echoes, names::PartIds, { 0, 1, 2, 12 });
  AddColumn(echoes, names::LegIds, { 3, 3, 4, -1 });
  AddColumn(echoes, names::Range, { 10, 20, 30, 40 });
  AddColumn(echoes, names::IncidenceAngle, { 0, 30, 60, 90 });
  cloud.Append(echoes);
  CloudView view(cloud, stage.Renderer);
  view.SetPointSize(4.0);
  const Ramp ramp = MakeRamp(RampPart());
  const std::vector<Rgb> thirds = { ramp[0], ramp[85], ramp[170], ramp[255] };

  SECTION("height")
  {
    REQUIRE(view.SetRange(0.0, 3.0));
    CHECK(GetFourColors(stage) == thirds);
  }
  SECTION("amplitude, by its logarithm")
  {
    view.SetColorBy(ColorBy::Amplitude);
    REQUIRE(view.SetRange(1e-9, 1e-6));
    const std::vector<Rgb> colors = GetFourColors(stage);
    for (std::size_t i = 0; i < 4; ++i)
    {
      for (std::size_t c = 0; c < 3; ++c)
      {
        CHECK(std::abs(colors[i][c] - thirds[i][c]) <= 4); // the amplitudes' 0.07 %
      }
    }
  }
  SECTION("amounts")
  {
    view.SetColorBy(ColorBy::Time);
    REQUIRE(view.SetRange(0.0, 3.0));
    CHECK(GetFourColors(stage) == thirds);
    view.SetColorBy(ColorBy::Range);
    REQUIRE(view.SetRange(10.0, 40.0));
    CHECK(GetFourColors(stage) == thirds);
    view.SetColorBy(ColorBy::Incidence);
    REQUIRE(view.SetRange(0.0, 90.0));
    const std::vector<Rgb> colors = GetFourColors(stage);
    CHECK(colors[0] == thirds[0]);
    CHECK(colors[3] == thirds[3]);
  }
  SECTION("classes, parts, legs, returns")
  {
    view.SetColorBy(ColorBy::Class);
    CHECK(GetFourColors(stage) ==
      std::vector<Rgb>{ GetClassColor(2), GetClassColor(5), GetClassColor(6), GetClassColor(9) });
    view.SetColorBy(ColorBy::Part);
    CHECK(GetFourColors(stage) ==
      std::vector<Rgb>{
        GetDistinctColor(0), GetDistinctColor(1), GetDistinctColor(2), GetDistinctColor(0) });
    view.SetColorBy(ColorBy::Leg);
    CHECK(GetFourColors(stage) ==
      std::vector<Rgb>{
        GetDistinctColor(3), GetDistinctColor(3), GetDistinctColor(4), CloudColors::Unknown });
    view.SetColorBy(ColorBy::ReturnNumber);
    const std::vector<Rgb> colors = GetFourColors(stage);
    CHECK(colors[0] == view.GetColors().Map(1));
    CHECK(colors[3] == view.GetColors().Map(5));
    CHECK(colors[0] != colors[1]);
  }
  SECTION("unknown values are grey")
  {
    view.SetColorBy(ColorBy::Material);
    CHECK(GetFourColors(stage) == std::vector<Rgb>(4, CloudColors::Unknown));
  }
}

TEST_CASE("CloudView: an empty range or one that is not finite is refused")
{
  Stage stage;
  Cloud cloud;
  cloud.Append(MakeFour());
  CloudView view(cloud, stage.Renderer);
  CHECK_FALSE(view.SetRange(1.0, 1.0));
  CHECK_FALSE(view.SetRange(std::nan(""), 1.0));
  CHECK_FALSE(view.SetRange(0.0, HUGE_VAL));
}

TEST_CASE("CloudView: the automatic range excludes 2 % at either end and follows the cloud")
{
  std::vector<Vec3> places;
  for (int i = 0; i <= 1000; ++i)
  {
    places.emplace_back(0.0, 0.0, 0.1 * i);
  }
  places.emplace_back(0.0, 0.0, 1e6);
  Stage stage;
  Cloud cloud;
  cloud.Append(MakeEchoes(places));
  CloudView view(cloud, stage.Renderer);
  CHECK(std::abs(view.GetLow() - 2.0) < 0.2);
  CHECK(std::abs(view.GetHigh() - 98.0) < 0.2);
  for (Vec3& place : places)
  {
    place[2] += 1000.0;
  }
  cloud.Append(MakeEchoes(places));
  view.Update();
  CHECK(view.GetHigh() > 1000.0);
  REQUIRE(view.SetRange(5.0, 6.0));
  cloud.Append(MakeEchoes(places));
  view.Update();
  CHECK(view.GetHigh() == 6.0);
  view.SetAutomaticRange();
  CHECK(view.GetHigh() > 1000.0);
}

TEST_CASE("CloudView: the legend has the title, ticks and colours of the map")
{
  Stage stage;
  Cloud cloud;
  auto echoes = MakeFour();
  AddColumn(echoes, names::ClassificationIds, { 2, 5, 6, 6 });
  AddColumn(echoes, names::Intensity, { 1, 2, 3, 4 });
  cloud.Append(echoes);
  CloudView view(cloud, stage.Renderer);
  CHECK(view.GetLegend().Title == "Height [m]");
  view.SetRange(0.0, 3.0);
  const Legend& legend = view.GetLegend();
  REQUIRE(legend.Marks.size() == 4);
  for (std::size_t i = 0; i < 4; ++i)
  {
    CHECK(legend.Marks[i].Text == std::to_string(i));
    CHECK(legend.Marks[i].Position == Approx(static_cast<double>(i) / 3.0));
  }
  CHECK(legend.Colors.back() == MakeRamp(RampPart())[255]);
  view.SetRampPart({ 0.0, 0.5 });
  CHECK(view.GetLegend().Colors.back() == MakeRamp({ 0.0, 0.5 })[255]);
  view.SetColorBy(ColorBy::Amplitude);
  CHECK(view.GetLegend().Title == "Intensity");
  view.SetColorBy(ColorBy::Class);
  CHECK(view.GetLegend().Title == "Class");
  REQUIRE(view.GetLegend().Marks.size() == 3);
  CHECK(view.GetLegend().Marks[0].Text == "ground");
  CHECK(view.GetLegend().Colors[0] == GetClassColor(2));
  view.SetColorBy(ColorBy::One);
  CHECK(view.GetLegend().Colors.empty());
}

TEST_CASE("CloudView: the legend has the names of parts and materials, else their numbers")
{
  Stage stage;
  Cloud cloud;
  auto echoes = MakeFour();
  AddColumn(echoes, names::PartIds, { 0, 1, 1, 2 });
  AddColumn(echoes, names::MaterialIds, { 0, 0, 1, 1 });
  const auto addNames = [&](const char* name, const std::vector<std::string>& texts)
  {
    vtkNew<vtkStringArray> array;
    array->SetName(name);
    for (const std::string& text : texts)
    {
      array->InsertNextValue(text);
    }
    echoes->GetFieldData()->AddArray(array);
  };
  addNames(names::PartName, { "house", "" });
  addNames(names::MaterialName, { "brick", "glass" });
  cloud.Append(echoes);
  CloudView view(cloud, stage.Renderer);
  const auto getTexts = [&](ColorBy by)
  {
    view.SetColorBy(by);
    std::vector<std::string> texts;
    for (const Legend::Mark& mark : view.GetLegend().Marks)
    {
      texts.push_back(mark.Text);
    }
    return texts;
  };
  CHECK(getTexts(ColorBy::Part) == std::vector<std::string>{ "house", "1", "2" });
  CHECK(getTexts(ColorBy::Material) == std::vector<std::string>{ "brick", "glass" });
}

TEST_CASE("CloudView: the clip box hides exactly the points outside")
{
  Stage stage;
  Cloud cloud;
  cloud.SetOrigin({ 0, 0, 0 });
  cloud.Append(MakeEchoes({ { 2, 2, 0 }, { 2, -2, 0 }, { -2, 2, 0 }, { 4, 2, 0 }, { 2, 2.5, 9 } }));
  CloudView view(cloud, stage.Renderer);
  view.SetColorBy(ColorBy::One);
  view.SetPointSize(3.0);
  const double box[6] = { 0.0, 3.0, 0.0, 3.0, -1.0, 1.0 };
  REQUIRE(view.SetClipBox(box));
  stage.Render();
  CHECK(stage.CountPixels({ 200, 205, 210 }) == 5 * 9);
  view.SetClipping(true);
  stage.Render();
  CHECK(stage.GetColorAt(2, 2) == Rgb{ 200, 205, 210 });
  CHECK(stage.CountPixels({ 200, 205, 210 }) == 9);
  CHECK(view.Pick(Stage::ToPixel(2), Stage::ToPixel(2), 3.0));
  CHECK_FALSE(view.Pick(Stage::ToPixel(4), Stage::ToPixel(2), 3.0));
  CHECK_FALSE(view.Pick(Stage::ToPixel(2), Stage::ToPixel(2.5), 3.0));
  view.SetClipping(false);
  stage.Render();
  CHECK(stage.CountPixels({ 200, 205, 210 }) == 5 * 9);
  CHECK(view.Pick(Stage::ToPixel(4), Stage::ToPixel(2), 3.0));
  const double bad[6] = { 3.0, 0.0, 0.0, 3.0, -1.0, 1.0 };
  CHECK_FALSE(view.SetClipBox(bad));
}

TEST_CASE("CloudView: a clip box may be set before there are points")
{
  Stage stage;
  Cloud cloud;
  CloudView view(cloud, stage.Renderer);
  const double box[6] = { 1000.0, 1001.0, 2000.0, 2001.0, -1.0, 1.0 };
  REQUIRE(view.SetClipBox(box));
  view.SetClipping(true);
  view.SetColorBy(ColorBy::One);
  view.SetPointSize(3.0);
  cloud.Append(MakeEchoes({ { 1000, 2000, 0 }, { 1005, 2000, 0 } }));
  view.Update();
  stage.Render();
  CHECK(stage.GetColorAt(0.05, 0.05) == Rgb{ 200, 205, 210 });
  CHECK(stage.GetColorAt(5, 0) == Black);
}

TEST_CASE("CloudView: the time limit hides later points")
{
  Stage stage;
  Cloud cloud;
  cloud.Append(MakeField(300000));
  CloudView view(cloud, stage.Renderer);
  CHECK(view.GetNumberOfDrawnPoints() == 300000);
  for (const double limit : { -1.0, 0.0, 1000.5, 131071.0, 131072.0, 200000.0, 1e9 })
  {
    view.SetTimeLimit(limit);
    const double expected = std::min(300000.0, std::floor(limit) + 1.0);
    CHECK(view.GetNumberOfDrawnPoints() == static_cast<vtkIdType>(expected));
  }
}

TEST_CASE("CloudView: the time limit works for points in any order, and hides none without time")
{
  Stage stage;
  Cloud cloud;
  cloud.SetOrigin({ 0, 0, 0 });
  auto echoes = MakeFour();
  AddColumn(echoes, names::GpsTime, { 30, 10, std::nan(""), 20 });
  cloud.Append(echoes);
  CloudView view(cloud, stage.Renderer);
  view.SetColorBy(ColorBy::One);
  view.SetTimeLimit(15.0);
  const std::vector<Rgb> colors = GetFourColors(stage);
  const Rgb one = { 200, 205, 210 };
  CHECK(colors == std::vector<Rgb>{ Black, one, one, Black });
  CHECK_FALSE(view.Pick(Stage::ToPixel(5), Stage::ToPixel(0), 3.0));
  CHECK(view.Pick(Stage::ToPixel(0), Stage::ToPixel(5), 3.0)->Row == 1);
  view.SetTimeLimit(20.0);
  CHECK(GetFourColors(stage) == std::vector<Rgb>{ Black, one, one, one });
}

TEST_CASE("CloudView: a growing cloud is drawn completely")
{
  Stage stage;
  Cloud cloud;
  cloud.SetOrigin({ 0, 0, 0 });
  CloudView view(cloud, stage.Renderer);
  view.SetColorBy(ColorBy::One);
  view.SetPointSize(3.0);
  stage.Render();
  CHECK(stage.CountPixels(Black) == 200 * 200);
  cloud.Append(MakeEchoes({ { 3, 3, 0 } }));
  view.Update();
  stage.Render();
  CHECK(stage.CountPixels({ 200, 205, 210 }) == 9);
  cloud.Append(MakeEchoes({ { -3, 3, 0 }, { -3, -3, 0 } }));
  view.Update();
  stage.Render();
  CHECK(stage.GetColorAt(-3, 3) == Rgb{ 200, 205, 210 });
  CHECK(stage.CountPixels({ 200, 205, 210 }) == 27);
  cloud.Clear();
  view.Update();
  stage.Render();
  CHECK(stage.CountPixels(Black) == 200 * 200);
  cloud.Append(MakeEchoes({ { 1, -1, 0 } }));
  view.Update();
  stage.Render();
  CHECK(stage.GetColorAt(1, -1) == Rgb{ 200, 205, 210 });
}

TEST_CASE("CloudView: eye-dome lighting darkens depth edges only")
{
  std::vector<Vec3> places; // a square plate 5 m above a floor
  for (int i = 0; i < 400; ++i)
  {
    for (int j = 0; j < 400; ++j)
    {
      const double x = 0.05 * i - 10.0, y = 0.05 * j - 10.0;
      places.emplace_back(x, y, std::abs(x) < 4.0 && std::abs(y) < 4.0 ? 5.0 : 0.0);
    }
  }
  Stage stage;
  Cloud cloud;
  cloud.SetOrigin({ 0, 0, 0 });
  cloud.Append(MakeEchoes(places));
  CloudView view(cloud, stage.Renderer);
  view.SetColorBy(ColorBy::One);
  view.SetPointSize(2.0);
  stage.Renderer->ResetCameraClippingRange();
  stage.Render();
  CHECK(stage.GetColorAt(0, 4.1) == Rgb{ 200, 205, 210 });
  view.SetEyeDomeLighting(true);
  stage.Render();
  int darkest = 255; // across the plate's edge
  for (int y = 137; y < 143; ++y)
  {
    darkest = std::min<int>(darkest, stage.GetPixel(100, y)[0]);
  }
  CHECK(darkest < 100);
  CHECK(stage.GetColorAt(0, 0)[0] > 190);
  view.SetEyeDomeLighting(false);
  stage.Render();
  CHECK(stage.GetColorAt(0, 4.1) == Rgb{ 200, 205, 210 });
}

TEST_CASE("CloudView: eye-dome lighting leaves sparse points visible")
{
  std::vector<Vec3> places; // scattered in a cube, as leaves are
  for (int i = 0; i < 1000; ++i)
  {
    places.emplace_back(18.0 * std::fmod(i * 0.7548776662466927, 1.0) - 9.0,
      18.0 * std::fmod(i * 0.5698402909980532, 1.0) - 9.0,
      18.0 * std::fmod(i * 0.3802775690976141, 1.0));
  }
  Stage stage;
  Cloud cloud;
  cloud.SetOrigin({ 0, 0, 0 });
  cloud.Append(MakeEchoes(places));
  CloudView view(cloud, stage.Renderer);
  view.SetColorBy(ColorBy::One);
  stage.Renderer->ResetCameraClippingRange();
  stage.Render();
  view.SetEyeDomeLighting(true);
  stage.Render();
  int darkest = 255, count = 0;
  double sum = 0.0;
  for (int i = 0; i < 200 * 200; ++i)
  {
    const int red = stage.GetPixel(i % 200, i / 200)[0];
    if (red > 0)
    {
      darkest = std::min(darkest, red);
      sum += red;
      ++count;
    }
  }
  CHECK(count > 2500);
  CHECK(darkest >= 88);           // 0.45 of 200, less rounding
  CHECK(sum / count > 0.7 * 200); // most are shaded little
}
