// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosLegPlan.h"

#include "heliosMessages.h"
#include "heliosPointArrays.h"
#include "heliosSceneCrs.h"
#include "heliosStatus.h"
#include "vtkHeliosArrayNames.h"
#include "vtkHeliosPlatform.h"

#include <vtkDoubleArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>

#include <algorithm>
#include <cmath>

namespace helios
{
namespace names = vtkHeliosArrayNames;

namespace
{

/// Limits a duration to the maximum of the leg.
double LimitDuration(const LegData& leg, double duration)
{
  return leg.MaximumDuration >= 0.0 ? std::min(duration, leg.MaximumDuration) : duration;
}

/// Returns the duration of a leg on a static platform: the duration of its head rotation.
double GetStandingTime(const LegData& leg)
{
  const double head = leg.GetHeadTime();
  const bool turns = head > 0.0;
  return turns ? LimitDuration(leg, head) : std::max(0.0, leg.MaximumDuration);
}

/// Plans the legs of a survey in order, on one clock.
class Planner
{
public:
  Planner(const SurveyData& survey, const LegPath& path, Messages& log)
    : Survey(survey)
    , Path(path)
    , Log(log)
  {
  }

  std::vector<LegPlan> Plan();

private:
  void PlanStandingLeg(std::size_t leg);
  bool PlanTrajectory(std::size_t first, std::size_t last);
  void ExplainFailure(std::size_t first);
  void PlanMovingLegs(vtkHeliosPlatform* platform, std::size_t first, std::size_t last);
  std::size_t FindEnd(std::size_t first) const;

  const SurveyData& Survey;
  const LegPath& Path;
  Messages& Log;
  std::vector<LegPlan> Plans;
  double Time = 0.0;
};

//------------------------------------------------------------------------------
std::vector<LegPlan> Planner::Plan()
{
  for (std::size_t leg = 0; leg < this->Survey.Legs.size();)
  {
    const std::size_t end = this->Survey.IsMoving(leg) ? this->FindEnd(leg) : leg + 1;
    if (!this->Survey.IsMoving(leg))
    {
      this->PlanStandingLeg(leg);
    }
    else if (!this->PlanTrajectory(leg, end))
    {
      return {};
    }
    leg = end;
  }
  return this->Plans;
}

//------------------------------------------------------------------------------
/// Returns the end of the trajectory with a leg: one past its last leg.
std::size_t Planner::FindEnd(std::size_t first) const
{
  std::size_t leg = first;
  while (!this->Survey.EndsTrajectory(leg))
  {
    ++leg;
  }
  return leg + 1;
}

//------------------------------------------------------------------------------
void Planner::PlanStandingLeg(std::size_t leg)
{
  const double duration = GetStandingTime(this->Survey.Legs[leg]);
  if (this->Survey.Fires(leg))
  {
    const auto platform = MakePlatform(this->Survey, this->Path, leg, leg + 1, this->Log);
    platform->SetStartTime(this->Time);
    this->Log.Listen(platform);
    this->Plans.push_back({ leg, platform, this->Time, duration });
  }
  this->Time += duration;
}

//------------------------------------------------------------------------------
bool Planner::PlanTrajectory(std::size_t first, std::size_t last)
{
  const auto platform = MakePlatform(this->Survey, this->Path, first, last, this->Log);
  platform->SetStartTime(this->Time);
  this->Log.Listen(platform);
  platform->Update();
  if (this->Log.HasError())
  {
    this->ExplainFailure(first);
    return false;
  }
  this->PlanMovingLegs(platform, first, last);
  return true;
}

//------------------------------------------------------------------------------
/// Adds the place of the trajectory to an error, unless it names the trajectory file.
void Planner::ExplainFailure(std::size_t first)
{
  const std::string& file = this->Survey.Legs[first].Trajectory.File;
  if (file.empty() || this->Log.GetLastError().find(file) == std::string::npos)
  {
    this->Log.Error("platform " + this->Survey.GetPlatform(first).Name +
      " cannot follow this trajectory; its waypoint 0 is the leg at " +
      this->Survey.Legs[first].Where);
  }
}

//------------------------------------------------------------------------------
/// Sets the times of legs to the times of their samples.
void Planner::PlanMovingLegs(vtkHeliosPlatform* platform, std::size_t first, std::size_t last)
{
  vtkPointData* samples = platform->GetOutput()->GetPointData();
  vtkDataArray* times = samples->GetArray(names::GpsTime);
  vtkDataArray* legs = samples->GetArray(names::LegIds);
  const vtkIdType count = times->GetNumberOfTuples();
  vtkIdType sample = 0;
  for (std::size_t leg = first; leg < last; ++leg)
  {
    while (sample < count && legs->GetTuple1(sample) < 0.0) // between two legs
    {
      ++sample;
    }
    const vtkIdType begin = sample;
    while (sample < count && legs->GetTuple1(sample) == static_cast<double>(leg))
    {
      ++sample;
    }
    if (this->Survey.Fires(leg) && sample > begin)
    {
      const double start = times->GetTuple1(begin);
      const double duration = times->GetTuple1(sample - 1) - start;
      this->Plans.push_back(
        { leg, platform, start, LimitDuration(this->Survey.Legs[leg], duration) });
    }
  }
  this->Time = times->GetTuple1(count - 1);
}

} // namespace

//------------------------------------------------------------------------------
std::vector<LegPlan> PlanLegs(const SurveyData& survey, vtkPolyData* scene,
  const LegOffsetNoise& offsets, const TrajectoryInputs& inputs, Messages& log)
{
  LegPath path;
  path.Inputs = inputs;
  path.Crs = scene ? GetCRS(scene) : std::string();
  if (!FindPositions(survey, scene, offsets, log, path.Positions))
  {
    return {};
  }
  return Planner(survey, path, log).Plan();
}

//------------------------------------------------------------------------------
TrajectorySampler::TrajectorySampler(const LegPlan& plan, double interval)
  : StartTime(plan.StartTime)
  , EndTime(plan.StartTime + plan.Duration)
  , Interval(interval)
{
  plan.Platform->Update();
  const Status status = this->Path.SetLeg(plan.Platform->GetOutput(), static_cast<int>(plan.Leg));
  if (!status.IsOk())
  {
    this->NumberOfSamples = 0;
  }
  else if (!this->Path.IsStatic())
  {
    const double steps = interval > 0.0 ? std::floor(plan.Duration / interval) : 0.0;
    this->NumberOfSamples = 2 + static_cast<vtkIdType>(steps);
    // The end is a separate sample unless the last step is there.
    if (steps > 0.0 && this->StartTime + steps * interval >= this->EndTime)
    {
      --this->NumberOfSamples;
    }
  }
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkPolyData> TrajectorySampler::GetSamples(vtkIdType first, vtkIdType count) const
{
  auto samples = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->SetNumberOfPoints(std::min(count, this->NumberOfSamples - first));
  samples->SetPoints(points);
  auto* times = AddPointArray<vtkDoubleArray>(samples, names::GpsTime);
  auto* orientations = AddPointArray<vtkDoubleArray>(samples, names::Orientation, 4);
  for (vtkIdType i = 0; i < points->GetNumberOfPoints(); ++i)
  {
    const double time = this->GetTime(first + i);
    const Pose pose = this->Path.GetPose(time);
    points->SetPoint(i, pose.Position.GetData());
    times->SetValue(i, time);
    orientations->SetTuple(i, pose.Orientation.GetData());
  }
  return samples;
}

//------------------------------------------------------------------------------
double TrajectorySampler::GetTime(vtkIdType sample) const
{
  const bool isLast = sample > 0 && sample + 1 == this->NumberOfSamples;
  return isLast ? this->EndTime : this->StartTime + static_cast<double>(sample) * this->Interval;
}

} // namespace helios
