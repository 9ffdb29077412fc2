// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// CloudView: levels of detail, picking, memory.
#include "heliosCloudView.h"
#include "heliosViewerTest.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>

using namespace helios;
using namespace helios::viewer;
namespace names = vtkHeliosArrayNames;

TEST_CASE("CloudView: a camera reset shows the whole cloud, also if it is drawn in part")
{
  Stage stage;
  Cloud cloud;
  cloud.Append(MakeField(900000));
  CloudView view(cloud, stage.Renderer);
  for (const bool isWhole : { true, false })
  {
    view.SetWholeLimit(isWhole ? 2000000 : 1000);
    for (const bool isMoving : { false, true })
    {
      view.SetInteracting(isMoving);
      double bounds[6], expected[6];
      stage.Renderer->ComputeVisiblePropBounds(bounds);
      cloud.GetBounds(expected);
      for (int i = 0; i < 6; ++i)
      {
        CHECK(std::abs(bounds[i] + cloud.GetOrigin()[i / 2] - expected[i]) < 1e-6);
      }
    }
  }
  view.SetVisible(false);
  double bounds[6];
  stage.Renderer->ComputeVisiblePropBounds(bounds);
  CHECK(bounds[0] > bounds[1]);
}

TEST_CASE("CloudView: an even sample is drawn during motion, everything at rest")
{
  Stage stage;
  Cloud cloud;
  cloud.SetOrigin({ 0, 0, 0 });
  cloud.Append(MakeField(900000));
  CloudView view(cloud, stage.Renderer);
  view.SetColorBy(ColorBy::One);
  view.SetPointSize(1.0);
  CHECK(view.GetNumberOfDrawnPoints() == 900000);
  view.SetInteracting(true);
  const vtkIdType sample = view.GetNumberOfDrawnPoints();
  CHECK(sample <= static_cast<vtkIdType>(CloudView::MaximumSample));
  CHECK(sample > 90000);
  stage.Render();
  // 180 x 180 pixels with about 3.4 points each: all quarters are equal.
  int quarters[4] = { 0, 0, 0, 0 };
  for (int i = 0; i < 200 * 200; ++i)
  {
    quarters[(i % 200 < 100) + 2 * (i / 200 < 100)] += stage.GetPixel(i % 200, i / 200) != Black;
  }
  const int most = *std::max_element(quarters, quarters + 4);
  CHECK(most > 7000);
  CHECK(*std::min_element(quarters, quarters + 4) > 0.97 * most);
  view.SetTimeLimit(450000.0);
  CHECK(std::abs(view.GetNumberOfDrawnPoints() - 0.5 * sample) < 0.02 * sample);
  view.SetTimeLimit(HUGE_VAL);
  view.SetInteracting(false);
  CHECK(view.GetNumberOfDrawnPoints() == 900000);
}

TEST_CASE("CloudView: of a large cloud the visible points are drawn, with the same picture")
{
  Stage stage;
  Cloud cloud;
  cloud.SetOrigin({ 0, 0, 0 });
  auto field = MakeField(300000);
  for (vtkIdType i = 0; i < 300000; ++i)
  {
    double p[3];
    field->GetPoint(i, p);
    p[2] = 0.0003 * static_cast<double>(i);
    field->GetPoints()->SetPoint(i, p);
  }
  cloud.Append(field);
  CloudView view(cloud, stage.Renderer);
  view.SetPointSize(GENERATE(1.0, 3.0));
  stage.Renderer->GetActiveCamera()->Elevation(20.0);
  stage.Renderer->ResetCameraClippingRange();
  const auto countDifferences = [&]
  {
    view.SetWholeLimit(2000000);
    stage.Render();
    std::vector<Rgb> whole;
    for (int i = 0; i < 200 * 200; ++i)
    {
      whole.push_back(stage.GetPixel(i % 200, i / 200));
    }
    view.SetWholeLimit(1000);
    stage.Render();
    int different = 0;
    for (int i = 0; i < 200 * 200; ++i)
    {
      different += stage.GetPixel(i % 200, i / 200) != whole[static_cast<std::size_t>(i)];
    }
    return different;
  };
  CHECK(countDifferences() < 400);
  CHECK(view.GetNumberOfDrawnPoints() < 200 * 200);
  CHECK(view.GetNumberOfDrawnPoints() > 15000);
  view.SetTimeLimit(20000.0);
  CHECK(countDifferences() < 400);
  stage.Renderer->GetActiveCamera()->Azimuth(30.0); // seen from elsewhere
  stage.Renderer->ResetCameraClippingRange();
  CHECK(countDifferences() < 400);
  const double box[6] = { -3.0, 4.0, -5.0, 4.0, -1.0, 4.0 };
  REQUIRE(view.SetClipBox(box));
  view.SetClipping(true);
  CHECK(countDifferences() < 400);
  view.SetColorBy(ColorBy::Time);
  CHECK(countDifferences() < 400);
  view.SetVisible(false);
  stage.Render();
  CHECK(stage.CountPixels(Black) == 200 * 200);
}

TEST_CASE("CloudView: slow frames reduce the sample during motion, fast ones increase it")
{
  Stage stage;
  Cloud cloud;
  cloud.Append(MakeField(900000));
  CloudView view(cloud, stage.Renderer);
  view.SetEyeDomeLighting(true);
  view.ReportFrame(1.0);
  CHECK(view.GetNumberOfDrawnPoints() == 900000); // still
  view.SetInteracting(true);
  const auto sample = static_cast<double>(view.GetNumberOfDrawnPoints());
  view.ReportFrame(0.1);
  CHECK(view.GetNumberOfDrawnPoints() == static_cast<vtkIdType>(sample));
  CHECK_FALSE(stage.Renderer->GetPass());
  view.ReportFrame(0.1);
  CHECK(std::abs(view.GetNumberOfDrawnPoints() / sample - 0.5) < 0.02);
  for (int i = 0; i < 20; ++i)
  {
    view.ReportFrame(0.1);
  }
  CHECK(view.GetNumberOfDrawnPoints() > 19000);
  view.ReportFrame(0.05);
  CHECK(view.GetNumberOfDrawnPoints() < 0.3 * sample);
  for (int i = 0; i < 20; ++i)
  {
    view.ReportFrame(0.01);
  }
  CHECK(view.GetNumberOfDrawnPoints() == static_cast<vtkIdType>(sample));
  view.SetInteracting(false);
  CHECK(stage.Renderer->GetPass());
  CHECK(view.GetNumberOfDrawnPoints() == 900000);
}

TEST_CASE("CloudView: a pick selects the front echo")
{
  Stage stage;
  Cloud cloud;
  cloud.SetOrigin({ 0, 0, 0 });
  cloud.Append(MakeField(200000));
  auto planted = MakeEchoes({ { 2.0, 3.0, -40.0 }, { 2.0, 3.0, 20.0 }, { 2.02, 3.0, 10.0 } });
  AddColumn(planted, names::PulseIds, { 777001, 777002, 777003 });
  AddColumn(planted, names::ReturnNumber, { 3, 1, 2 });
  cloud.Append(planted);
  CloudView view(cloud, stage.Renderer);
  stage.Renderer->ResetCameraClippingRange();
  stage.Render();
  const auto echo = view.Pick(Stage::ToPixel(2.0), Stage::ToPixel(3.0), 4.0);
  REQUIRE(echo);
  CHECK(echo->Row == 200001);
  CHECK(echo->PulseId == 777002);
  CHECK(echo->ReturnNumber == 1);
  CHECK(echo->Position[2] == 20.0);
  CHECK_FALSE(view.Pick(Stage::ToPixel(9.8), Stage::ToPixel(9.8), 4.0));
}

TEST_CASE("CloudView: a pick beside all points selects the nearest one")
{
  Stage stage;
  Cloud cloud;
  cloud.SetOrigin({ 0, 0, 0 });
  cloud.Append(MakeEchoes({ { 0.4, 0.0, 0.0 }, { -0.7, 0.0, 50.0 }, { 0.0, 0.0, 200.0 } }));
  CloudView view(cloud, stage.Renderer);
  stage.Render(); // the last point is behind the camera
  CHECK(view.Pick(100.0, 100.0, 10.0)->Row == 0);
  CHECK_FALSE(view.Pick(100.0, 100.0, 3.0));
}

TEST_CASE("CloudView: at most 40 bytes per point for cloud and display")
{
  Stage stage;
  Cloud cloud;
  for (int block = 0; block < 10; ++block)
  {
    auto echoes = MakeField(500000);
    AddColumn(echoes, names::Amplitude, std::vector<double>(500000, 1e-9));
    cloud.Append(echoes);
  }
  CloudView view(cloud, stage.Renderer);
  view.SetInteracting(true);
  view.SetInteracting(false);
  REQUIRE(cloud.GetNumberOfPoints() == 5000000);
  const auto bytes = static_cast<double>(cloud.GetMemorySize() + view.GetMemorySize());
  CHECK(bytes <= 40.0 * 5e6);
  CHECK(bytes >= 34.0 * 5e6); // all data counted
}
