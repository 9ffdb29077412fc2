// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// A survey running in the background: the echoes of a run, up to the requested time.
#include "heliosBeamFan.h"
#include "heliosCloud.h"
#include "heliosSimulation.h"
#include "heliosStepFiles.h"
#include "vtkHeliosArrayNames.h"
#include "vtkHeliosSurveyReader.h"

#include <vtkDataArray.h>
#include <vtkPointData.h>

#include <catch2/catch.hpp>

#include <chrono>
#include <cmath>
#include <limits>
#include <thread>

using namespace helios;
using namespace helios::viewer;

namespace
{

constexpr double Forever = std::numeric_limits<double>::infinity();

vtkSmartPointer<vtkHeliosSurvey> Read(const StepFiles& files)
{
  vtkNew<vtkHeliosSurveyReader> reader;
  reader->SetFileName((files.Folder / "survey.xml").c_str());
  REQUIRE(reader->Read());
  return reader->GetSurvey();
}

/// Takes echoes until a condition holds; the echoes in order.
template <typename Condition>
std::vector<vtkSmartPointer<vtkPolyData>> CollectUntil(Simulation& run, Condition isThere)
{
  std::vector<vtkSmartPointer<vtkPolyData>> all;
  for (int i = 0; i < 6000; ++i)
  {
    for (const auto& block : run.CollectEchoes())
    {
      all.push_back(block);
    }
    if (isThere())
    {
      return all;
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
  FAIL("it did not come");
  return all;
}

std::vector<double> GetRanges(const std::vector<vtkSmartPointer<vtkPolyData>>& blocks)
{
  std::vector<double> ranges;
  for (vtkPolyData* block : blocks)
  {
    vtkDataArray* array = block->GetPointData()->GetArray(vtkHeliosArrayNames::Range);
    for (vtkIdType i = 0; i < block->GetNumberOfPoints(); ++i)
    {
      ranges.push_back(array->GetTuple1(i));
    }
  }
  return ranges;
}

bool IsAllTaken(const Simulation& run)
{
  return run.GetPhase() == Simulation::Phase::Finished &&
    run.GetCollectedPulses() == run.GetNumberOfPulses();
}

} // namespace

TEST_CASE(
  "Simulation: stops at the requested time, resumes, and gives the echoes of one run", "[Viewer]")
{
  const StepFiles files;
  const auto survey = Read(files);
  Simulation run(survey);
  run.Start();
  run.SetTarget(0.25);
  auto blocks = CollectUntil(run, [&run] { return run.GetCollectedTime() >= 0.25; });
  std::this_thread::sleep_for(std::chrono::milliseconds(50));
  CHECK(run.CollectEchoes().empty());     // waiting
  CHECK(run.GetCollectedPulses() == 500); // at 2 kHz
  CHECK(run.GetPhase() == Simulation::Phase::Running);
  run.SetTarget(Forever);
  for (const auto& block : CollectUntil(run, [&run] { return IsAllTaken(run); }))
  {
    blocks.push_back(block);
  }
  CHECK(run.GetPhase() == Simulation::Phase::Finished);
  CHECK(run.GetCollectedTime() == run.GetEndTime());
  CHECK(run.GetComputingSeconds() > 0.0);

  vtkNew<vtkHeliosSurveySource> whole;
  whole->SetSurvey(survey);
  whole->Update();
  CHECK(GetRanges(blocks) == GetRanges({ whole->GetOutput() }));
}

TEST_CASE("Simulation: any time is reached, also one between two pulses", "[Viewer]")
{
  const StepFiles files;
  const auto survey = Read(files);
  Simulation run(survey);
  run.Start();
  run.SetTarget(0.0);
  CollectUntil(run, [&run] { return run.GetPhase() == Simulation::Phase::Running; });
  for (int i = 1; i <= 40; ++i)
  {
    const double time = i / 40.0 * 0.3 + (i % 4) * 1e-14;
    run.SetTarget(time);
    CollectUntil(run, [&run, time] { return run.HasCollected(time); });
  }
  CHECK_FALSE(run.HasCollected(0.31));
}

TEST_CASE("Simulation: platform pose by time", "[Viewer]")
{
  const StepFiles files;
  Simulation run(Read(files));
  run.Start();
  CollectUntil(run, [&run] { return run.GetPhase() != Simulation::Phase::Loading; });
  REQUIRE(run.GetLegs().size() == 1);
  const SimulatedLeg& leg = run.GetLegs().front();
  CHECK(leg.IsMoving);
  CHECK(leg.Type == PlatformType::LinearPath);
  CHECK(leg.LineFrequency == 10.0);
  CHECK(leg.LastPulse == 2000);
  for (const double time : { 0.0, 0.123, 0.5, 1.0 })
  {
    CHECK((leg.GetPose(time).Position - Vec3(-10.0 + 20.0 * time, 0.0, 100.0)).Norm() < 1e-6);
  }
  CHECK(leg.GetPose(-1.0).Position[0] == Approx(-10.0));
  CHECK(leg.GetPose(9.0).Position[0] == Approx(10.0));
  CHECK(FindLeg(run.GetLegs(), 0.5) == &leg);
  CHECK(FindLeg({}, 0.5) == nullptr);
}

TEST_CASE("Simulation: a failure is reported and ends the simulation", "[Viewer]")
{
  const StepFiles files;
  const auto survey = Read(files);
  files.Write("ground.obj", "v 0 0\n");
  Simulation run(survey);
  run.Start();
  CollectUntil(run, [&run] { return run.GetPhase() == Simulation::Phase::Failed; });
  CHECK(run.GetMessage().find("ground.obj:1") != std::string::npos);
  CHECK(run.GetLegs().empty());
}

TEST_CASE("Simulation: can be aborted at any moment", "[Viewer]")
{
  const StepFiles files;
  for (int i = 0; i < 10; ++i)
  {
    Simulation run(Read(files));
    run.Start();
    run.SetTarget(Forever);
    std::this_thread::sleep_for(std::chrono::milliseconds(i));
  }
  SUCCEED("no thread is left behind");
}

TEST_CASE("BeamFan: the last points before a time", "[Viewer]")
{
  const StepFiles files;
  Simulation run(Read(files));
  run.Start();
  run.SetTarget(Forever);
  Cloud cloud;
  CHECK(FindNewestPoints(cloud, Forever, 0.1, 10).empty());
  for (const auto& block : CollectUntil(run, [&run] { return IsAllTaken(run); }))
  {
    cloud.Append(block);
  }
  // The platform moves at 20 m/s and looks down: points of [0.4 s, 0.5 s] are at x in [-2 m, 0].
  const auto ends = FindNewestPoints(cloud, 0.5, 0.1, 20);
  CHECK(ends.size() > 10);
  CHECK(ends.size() <= 20);
  for (const Vec3& end : ends)
  {
    CHECK(end[0] > -2.1);
    CHECK(end[0] < 0.1);
  }
  CHECK(FindNewestPoints(cloud, Forever, 10.0, 50).size() <= 50);
  CHECK(FindNewestPoints(cloud, -1.0, 0.1, 50).empty());
  CHECK(FindNewestPoints(cloud, 0.5, 0.1, 0).empty());
}
