// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Times of a large cloud; run by name: vtkHeliosViewerTests [benchmark]
#include "heliosCloudView.h"
#include "heliosViewerTest.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <ctime>
#include <iostream>

using namespace helios;
using namespace helios::viewer;
namespace names = vtkHeliosArrayNames;

namespace
{

/// Rolling ground of 1 km^2, as scanned on lines over it.
vtkSmartPointer<vtkPolyData> MakeGround(vtkIdType first, vtkIdType count, vtkIdType all)
{
  std::vector<Vec3> places;
  std::vector<double> times, pulses, amplitudes, ones, ranges, angles;
  for (vtkIdType i = first; i < first + count; ++i)
  {
    const double share = static_cast<double>(i) / static_cast<double>(all);
    const double x = 1000.0 * std::fmod(share * 2000.0, 1.0), y = 1000.0 * share;
    places.emplace_back(
      500000.0 + x, 5400000.0 + y, 20.0 * std::sin(0.01 * x) * std::cos(0.013 * y));
    times.push_back(1e-5 * static_cast<double>(i));
    pulses.push_back(static_cast<double>(i));
    amplitudes.push_back(1e-9 * (1.0 + share));
    ones.push_back(1.0);
    ranges.push_back(300.0 + x);
    angles.push_back(90.0 * share);
  }
  auto echoes = MakeEchoes(places);
  AddColumn(echoes, names::GpsTime, times);
  AddColumn(echoes, names::PulseIds, pulses);
  AddColumn(echoes, names::Amplitude, amplitudes);
  AddColumn(echoes, names::ReturnNumber, ones);
  AddColumn(echoes, names::NumberOfReturns, ones);
  AddColumn(echoes, names::ClassificationIds, ones);
  AddColumn(echoes, names::PartIds, ones);
  AddColumn(echoes, names::LegIds, ones);
  AddColumn(echoes, names::Range, ranges);
  AddColumn(echoes, names::IncidenceAngle, angles);
  return echoes;
}

template <typename Work>
double Time(Work work)
{
  const auto start = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

void Report(const char* what, double value, const char* unit)
{
  std::cout << what << ": " << value << " " << unit << std::endl;
}

} // namespace

TEST_CASE("Benchmark: a large cloud", "[.][benchmark]")
{
  const char* wanted = std::getenv("HELIOS_POINTS");
  const vtkIdType all = 1000000 * (wanted ? std::max(3, std::atoi(wanted)) : 20);
  Stage stage;
  stage.Window->SetSize(1280, 1024);
  Cloud cloud;
  cloud.SetOrigin({ 500500.0, 5400500.0, 0.0 });
  double append = 0.0;
  for (vtkIdType first = 0; first < all; first += 1000000)
  {
    const auto block = MakeGround(first, 1000000, all);
    append += Time([&] { cloud.Append(block); });
  }
  CloudView* made = nullptr;
  const double build = Time([&] { made = new CloudView(cloud, stage.Renderer); });
  const std::unique_ptr<CloudView> view(made);
  vtkCamera* camera = stage.Renderer->GetActiveCamera();
  camera->ParallelProjectionOff();
  camera->SetPosition(0.0, -1200.0, 600.0);
  camera->SetViewUp(0.0, 0.0, 1.0);
  stage.Renderer->ResetCameraClippingRange();
  const double first = Time([&] { stage.Window->Render(); });
  const double still = Time([&] { stage.Window->Render(); });
  camera->Azimuth(1.0);
  const double turned = Time([&] { stage.Window->Render(); });
  REQUIRE(view->GetNumberOfDrawnPoints() > 300000);

  std::optional<Echo> echo;
  const double pick = Time([&] { echo = view->Pick(640, 400, 5); });
  REQUIRE(echo);

  const double toMoving = Time([&] { view->SetInteracting(true); });
  REQUIRE(view->GetNumberOfDrawnPoints() <= 120000);
  const double sketch = Time([&] { stage.Window->Render(); });
  constexpr int frames = 100;
  const std::clock_t clock = std::clock();
  const double moving = Time(
    [&]
    {
      for (int i = 0; i < frames; ++i)
      {
        camera->Azimuth(1.0);
        stage.Window->Render();
      }
    });
  const double work = static_cast<double>(std::clock() - clock) / CLOCKS_PER_SEC;
  view->SetEyeDomeLighting(true);
  stage.Window->Render();
  const double shaded = Time(
    [&]
    {
      for (int i = 0; i < 5; ++i)
      {
        camera->Azimuth(1.0);
        stage.Window->Render();
      }
    });
  view->SetEyeDomeLighting(false);
  const double toStill = Time([&] { view->SetInteracting(false); });
  const double again = Time([&] { stage.Window->Render(); });
  const double recolor = Time([&] { view->SetColorBy(ColorBy::Amplitude); });
  const double recolored = Time([&] { stage.Window->Render(); });
  double seek = 0.0;
  for (int i = 1; i <= 10; ++i)
  {
    view->SetInteracting(true);
    seek += 0.1 *
      Time(
        [&]
        {
          view->SetTimeLimit(1e-6 * i * static_cast<double>(all));
          stage.Window->Render();
        });
  }
  const auto bytes = static_cast<double>(cloud.GetMemorySize() + view->GetMemorySize());
  Report("points", static_cast<double>(all), "");
  Report("append", 1e9 * append / static_cast<double>(all), "ns a point");
  Report("colours and sample", build, "s");
  Report("first picture", first, "s");
  Report("picture of all when still", still, "s");
  Report("picture of all after a turn", turned, "s");
  Report("pick among all", pick, "s");
  Report("start to move", toMoving, "s");
  Report("first picture while moving", sketch, "s");
  Report("moving", frames / moving, "frames/s");
  Report("moving, processor time", work / frames, "s a frame");
  Report("moving, eye-dome lighting", 5 / shaded, "frames/s");
  Report("stop moving", toStill + again, "s");
  Report("other colours", recolor, "s");
  Report("and their picture", recolored, "s");
  Report("seek while moving", seek, "s");
  Report("memory", bytes / static_cast<double>(all), "bytes a point");
}
