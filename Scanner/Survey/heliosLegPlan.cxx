// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosLegPlan.h"

#include "heliosMessages.h"
#include "heliosSurveyCrs.h"
#include "vtkHeliosArrayNames.h"
#include "vtkHeliosGroundSnap.h"
#include "vtkHeliosLinearPathPlatform.h"
#include "vtkHeliosStaticPlatform.h"

#include <vtkDoubleArray.h>
#include <vtkIntArray.h>
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

/// An empty array of the points of a data set.
template <typename ArrayT>
ArrayT* AddArray(vtkPolyData* data, const char* name, int components = 1)
{
  vtkNew<ArrayT> array;
  array->SetName(name);
  array->SetNumberOfComponents(components);
  array->SetNumberOfTuples(data->GetNumberOfPoints());
  data->GetPointData()->AddArray(array);
  return array;
}

/// The legs [first, last) as waypoints.
vtkSmartPointer<vtkPolyData> MakeWaypoints(
  const SurveyData& survey, const std::vector<Vec3>& positions, std::size_t first, std::size_t last)
{
  auto waypoints = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->SetNumberOfPoints(static_cast<vtkIdType>(last - first));
  waypoints->SetPoints(points);
  auto* speed = AddArray<vtkDoubleArray>(waypoints, names::Speed);
  auto* ids = AddArray<vtkIntArray>(waypoints, names::LegIds);
  for (std::size_t leg = first; leg < last; ++leg)
  {
    const auto i = static_cast<vtkIdType>(leg - first);
    points->SetPoint(i, positions[leg].GetData());
    speed->SetValue(i, survey.Legs[leg].Speed);
    ids->SetValue(i, static_cast<int>(leg));
  }
  return waypoints;
}

/// The positions of all legs in the scene's system; false after an error.
bool FindPositions(
  const SurveyData& survey, vtkPolyData* scene, Messages& log, std::vector<Vec3>& positions)
{
  for (const LegData& leg : survey.Legs)
  {
    positions.emplace_back();
    if (!TransformPosition(leg, scene, log, positions.back()))
    {
      return false;
    }
  }
  return true;
}

/// Puts the positions of legs that are on the ground there; false after an error.
bool PutOnGround(
  const SurveyData& survey, vtkPolyData* scene, Messages& log, std::vector<Vec3>& positions)
{
  const auto isOnGround = [](const LegData& leg) { return leg.OnGround; };
  if (std::none_of(survey.Legs.begin(), survey.Legs.end(), isOnGround))
  {
    return true;
  }
  const auto legs = MakeWaypoints(survey, positions, 0, positions.size());
  auto* onGround = AddArray<vtkIntArray>(legs, names::OnGround);
  for (std::size_t i = 0; i < positions.size(); ++i)
  {
    onGround->SetValue(static_cast<vtkIdType>(i), survey.Legs[i].OnGround ? 1 : 0);
  }
  vtkNew<vtkHeliosGroundSnap> snap;
  log.Listen(snap);
  snap->SetInputDataObject(0, legs);
  snap->SetInputDataObject(1, scene);
  snap->Update();
  if (log.HasError())
  {
    log.Error(survey.FileName +
      ": legs with onGround need ground below them; point 0, 1 ... are the "
      "legs, the first at " +
      survey.Legs.front().Where);
    return false;
  }
  for (std::size_t i = 0; i < positions.size(); ++i)
  {
    positions[i] = Vec3(snap->GetOutput()->GetPoint(static_cast<vtkIdType>(i)));
  }
  return true;
}

/// What is left of a duration where a leg has a longest one.
double LimitDuration(const LegData& leg, double duration)
{
  return leg.MaximumDuration >= 0.0 ? std::min(duration, leg.MaximumDuration) : duration;
}

/// How long a leg lasts on a platform that stands: the head's turn.
double GetStandingTime(const LegData& leg)
{
  const double head = leg.GetHeadTime();
  const bool turns = leg.HeadRotateSpeed != 0.0 && head >= 0.0;
  return turns ? LimitDuration(leg, head) : std::max(0.0, leg.MaximumDuration);
}

std::vector<LegPlan> PlanStandingLegs(
  const SurveyData& survey, const std::vector<Vec3>& positions, Messages& log)
{
  std::vector<LegPlan> plans;
  double time = 0.0;
  for (std::size_t leg = 0; leg < positions.size(); ++leg)
  {
    const double duration = GetStandingTime(survey.Legs[leg]);
    if (survey.Fires(leg))
    {
      auto platform = vtkSmartPointer<vtkHeliosStaticPlatform>::New();
      platform->SetInputData(MakeWaypoints(survey, positions, leg, leg + 1));
      platform->SetStartTime(time);
      log.Listen(platform);
      plans.push_back({ leg, platform, time, duration });
    }
    time += duration;
  }
  return plans;
}

std::vector<LegPlan> PlanMovingLegs(
  const SurveyData& survey, const std::vector<Vec3>& positions, Messages& log)
{
  std::vector<LegPlan> plans;
  auto platform = vtkSmartPointer<vtkHeliosLinearPathPlatform>::New();
  platform->SetInputData(MakeWaypoints(survey, positions, 0, positions.size()));
  log.Listen(platform);
  platform->Update();
  vtkPointData* samples = platform->GetOutput()->GetPointData();
  vtkDataArray* times = samples->GetArray(names::GpsTime);
  vtkDataArray* legs = samples->GetArray(names::LegIds);
  if (log.HasError() || !times || !legs)
  {
    return plans;
  }
  vtkIdType sample = 0;
  const vtkIdType count = times->GetNumberOfTuples();
  for (std::size_t leg = 0; leg < survey.Legs.size(); ++leg)
  {
    const vtkIdType first = sample;
    for (; sample < count && legs->GetTuple1(sample) == static_cast<double>(leg); ++sample)
    {
    }
    if (survey.Fires(leg) && sample > first)
    {
      const double start = times->GetTuple1(first);
      const double duration = times->GetTuple1(sample - 1) - start;
      plans.push_back({ leg, platform, start, LimitDuration(survey.Legs[leg], duration) });
    }
  }
  return plans;
}

} // namespace

//------------------------------------------------------------------------------
std::vector<LegPlan> PlanLegs(const SurveyData& survey, vtkPolyData* scene, Messages& log)
{
  std::vector<Vec3> positions;
  if (!FindPositions(survey, scene, log, positions) || !PutOnGround(survey, scene, log, positions))
  {
    return {};
  }
  return survey.IsMoving() ? PlanMovingLegs(survey, positions, log)
                           : PlanStandingLegs(survey, positions, log);
}

//------------------------------------------------------------------------------
TrajectorySampler::TrajectorySampler(const LegPlan& plan, double interval)
  : StartTime(plan.StartTime)
  , EndTime(plan.StartTime + plan.Duration)
  , Interval(interval)
{
  plan.Platform->Update();
  const std::string problem =
    this->Path.SetLeg(plan.Platform->GetOutput(), static_cast<int>(plan.Leg));
  if (!problem.empty())
  {
    this->NumberOfSamples = 0;
  }
  else if (!this->Path.IsStatic())
  {
    const double steps = interval > 0.0 ? std::floor(plan.Duration / interval) : 0.0;
    this->NumberOfSamples = 2 + static_cast<vtkIdType>(steps);
    // The end is a sample of its own unless the last step is there already.
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
  auto* times = AddArray<vtkDoubleArray>(samples, names::GpsTime);
  auto* orientations = AddArray<vtkDoubleArray>(samples, names::Orientation, 4);
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
