// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosWaypoints.h"

#include "heliosMessages.h"
#include "heliosPointArrays.h"
#include "heliosRandom.h"
#include "heliosSurveyCrs.h"
#include "vtkHeliosArrayNames.h"
#include "vtkHeliosGroundSnap.h"

#include <vtkDoubleArray.h>
#include <vtkIntArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>

#include <algorithm>
#include <cstdint>

namespace helios
{
namespace names = vtkHeliosArrayNames;

namespace
{

/// Transforms the positions of all legs to the scene's system; false after an error.
bool TransformPositions(
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

/// Adds normally distributed noise to every position, independent for each leg.
void MoveByChance(const LegOffsetData& offset, vtkIdType seed, std::vector<Vec3>& positions)
{
  for (std::size_t leg = 0; leg < positions.size(); ++leg)
  {
    const auto key = static_cast<std::uint64_t>(seed);
    const auto xy = NormalPair(key, RandomStream::LegOffset, leg, 0);
    const auto z = NormalPair(key, RandomStream::LegOffset, leg, 1);
    const Vec3 chance(xy[0], xy[1], z[0]);
    positions[leg] += Vec3(offset.Mean, offset.Mean, offset.Mean) + offset.Deviation * chance;
  }
}

/// Places legs on the ground if requested; false after an error.
bool PlaceOnGround(
  const SurveyData& survey, vtkPolyData* scene, Messages& log, std::vector<Vec3>& positions)
{
  const auto isOnGround = [](const LegData& leg) { return leg.OnGround; };
  if (std::none_of(survey.Legs.begin(), survey.Legs.end(), isOnGround))
  {
    return true;
  }
  const auto legs = MakeWaypoints(survey, positions, 0, positions.size());
  auto* onGround = AddPointArray<vtkIntArray>(legs, names::OnGround);
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

} // namespace

//------------------------------------------------------------------------------
bool FindPositions(const SurveyData& survey, vtkPolyData* scene, const LegOffsetNoise& offsets,
  Messages& log, std::vector<Vec3>& positions)
{
  if (!TransformPositions(survey, scene, log, positions))
  {
    return false;
  }
  if (offsets.IsOn && survey.LegOffset.IsOn)
  {
    MoveByChance(survey.LegOffset, offsets.Seed, positions);
  }
  return PlaceOnGround(survey, scene, log, positions);
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkPolyData> MakeWaypoints(
  const SurveyData& survey, const std::vector<Vec3>& positions, std::size_t first, std::size_t last)
{
  auto waypoints = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->SetNumberOfPoints(static_cast<vtkIdType>(last - first));
  waypoints->SetPoints(points);
  auto* speed = AddPointArray<vtkDoubleArray>(waypoints, names::Speed);
  auto* stops = AddPointArray<vtkIntArray>(waypoints, names::StopAndTurn);
  auto* smooths = AddPointArray<vtkIntArray>(waypoints, names::SmoothTurn);
  auto* yaws = AddPointArray<vtkDoubleArray>(waypoints, names::YawAtDeparture);
  auto* ids = AddPointArray<vtkIntArray>(waypoints, names::LegIds);
  for (std::size_t leg = first; leg < last; ++leg)
  {
    const auto i = static_cast<vtkIdType>(leg - first);
    points->SetPoint(i, positions[leg].GetData());
    const LegData& data = survey.Legs[leg];
    speed->SetValue(i, data.Speed);
    stops->SetValue(i, data.StopAndTurn ? 1 : 0);
    smooths->SetValue(i, data.SmoothTurn ? 1 : 0);
    yaws->SetValue(i, -data.YawAtDeparture); // counterclockwise in files
    ids->SetValue(i, static_cast<int>(leg));
  }
  return waypoints;
}

} // namespace helios
