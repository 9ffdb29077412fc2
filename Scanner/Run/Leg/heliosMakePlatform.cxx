// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosMakePlatform.h"

#include "heliosConstants.h"
#include "heliosMessages.h"
#include "heliosTrajectoryFile.h"
#include "heliosWaypoints.h"
#include "vtkHeliosGroundVehiclePlatform.h"
#include "vtkHeliosInterpolatedPlatform.h"
#include "vtkHeliosLinearPathPlatform.h"
#include "vtkHeliosMulticopterPlatform.h"
#include "vtkHeliosPlatformNoise.h"
#include "vtkHeliosStaticPlatform.h"
#include "vtkHeliosTrajectoryReader.h"

#include <vtkMath.h>
#include <vtkPolyData.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace helios
{

namespace
{

/// Returns the speed of the fastest leg of a trajectory, at least 1 m/s: drag is negligible below.
double FindFastest(const SurveyData& survey, std::size_t first, std::size_t last)
{
  double speed = 1.0;
  for (std::size_t leg = first; leg + 1 < last; ++leg)
  {
    speed = std::max(speed, survey.Legs[leg].Speed);
  }
  return speed;
}

/// Files do not give mass and drag in physical units: the drag is that at which the copter cruises
/// at its base pitch, m g tan(pitch) = c v^2 (Docs/platforms.md).
vtkSmartPointer<vtkHeliosPlatform> MakeMulticopter(
  const SurveyData& survey, std::size_t first, std::size_t last)
{
  const VehicleData& data = survey.GetPlatform(first).Vehicle;
  const double fastest = FindFastest(survey, first, last);
  const double pitch = vtkMath::RadiansFromDegrees(std::abs(data.BasePitch));
  auto copter = vtkSmartPointer<vtkHeliosMulticopterPlatform>::New();
  copter->SetMaximumPitch(std::max(data.PitchOffset, std::abs(data.BasePitch)));
  copter->SetMaximumRoll(data.RollOffset);
  copter->SetPitchRate(data.PitchSpeed);
  copter->SetRollRate(data.RollSpeed);
  copter->SetYawRate(data.YawSpeed);
  copter->SetDragCoefficient(
    copter->GetMass() * StandardGravity * std::tan(pitch) / (fastest * fastest));
  const auto slowsDown = [](const LegData& leg) { return leg.SlowsDown; };
  copter->SetSlowdownEnabled(std::all_of(survey.Legs.begin() + static_cast<std::ptrdiff_t>(first),
    survey.Legs.begin() + static_cast<std::ptrdiff_t>(last), slowsDown));
  return copter;
}

/// Returns the inputs, or the files of all legs, each once, with the settings of the first leg that
/// names it.
vtkSmartPointer<vtkHeliosPlatform> MakeInterpolated(
  const SurveyData& survey, const LegPath& path, std::size_t first, std::size_t last, Messages& log)
{
  const TrajectoryInputs& inputs = path.Inputs;
  auto platform = vtkSmartPointer<vtkHeliosInterpolatedPlatform>::New();
  platform->SetFirstLegId(static_cast<int>(first));
  std::set<std::string> files = { "" };
  bool keepsTime = false;
  for (vtkPolyData* input : inputs)
  {
    platform->AddInputData(input);
  }
  for (std::size_t leg = first; leg < last; ++leg)
  {
    const TrajectoryFileData& file = survey.Legs[leg].Trajectory;
    if (inputs.empty() && files.insert(file.File).second)
    {
      const auto reader = MakeTrajectoryReader(file, survey.Convention, path.Crs);
      log.Listen(reader);
      if (reader->IsSbet() && path.Crs.empty())
      {
        log.WarnOnce("trajectory " + file.File,
          file.Where + ": the scene has no coordinate system; " + file.File +
            " is in the UTM zone of its first record; give <scene> one, crs=\"EPSG:...\"");
      }
      platform->AddInputConnection(reader->GetOutputPort());
    }
    platform->AddLeg(file.StartTime, file.EndTime, file.TeleportsToStart);
    keepsTime = keepsTime || file.KeepsTime;
  }
  platform->SetKeepFileTimes(keepsTime);
  return platform;
}

vtkSmartPointer<vtkHeliosPlatform> MakeVehicle(
  const SurveyData& survey, std::size_t first, std::size_t last)
{
  switch (survey.GetPlatform(first).Type)
  {
    case PlatformType::GroundVehicle:
      return vtkSmartPointer<vtkHeliosGroundVehiclePlatform>::New();
    case PlatformType::Multicopter:
      return MakeMulticopter(survey, first, last);
    case PlatformType::LinearPath:
      return vtkSmartPointer<vtkHeliosLinearPathPlatform>::New();
    case PlatformType::Interpolated:
    case PlatformType::Static:
      break;
  }
  return vtkSmartPointer<vtkHeliosStaticPlatform>::New();
}

/// Attitudes in files are in radians.
void SetComponent(
  int component, const NoiseData& data, std::size_t channels, vtkHeliosPlatformNoise* noise)
{
  const double unit =
    component >= vtkHeliosPlatformNoise::ATTITUDE_X ? vtkMath::DegreesFromRadians(1.0) : 1.0;
  if (data.IsUniform)
  {
    noise->SetUniform(component, unit * data.Low, unit * data.High);
  }
  else
  {
    noise->SetNormal(component, unit * data.Mean, unit * data.Deviation);
  }
  if (data.IsClipped)
  {
    noise->SetClip(component, unit * data.ClipLow, unit * data.ClipHigh);
  }
  noise->SetLifespan(component, static_cast<vtkIdType>(channels) * data.Lifespan);
}

bool HasErrors(const NavigationErrorData& data)
{
  const auto isSet = [](const double(&values)[3])
  { return values[0] != 0.0 || values[1] != 0.0 || values[2] != 0.0; };
  const auto isPositive = [](const double(&values)[3])
  { return values[0] > 0.0 || values[1] > 0.0 || values[2] > 0.0; };
  return !data.Grade.empty() || isPositive(data.PositionRMS) || isPositive(data.AttitudeRMS) ||
    isSet(data.Boresight) || isSet(data.LeverArm) || data.ClockOffset != 0.0;
}

void SetErrors(const NavigationErrorData& data, vtkHeliosPlatformNoise* noise)
{
  if (!data.Grade.empty())
  {
    noise->SetGrade(data.Grade);
  }
  for (int k = 0; k < 6; ++k)
  {
    const double given = k < 3 ? data.PositionRMS[k] : data.AttitudeRMS[k - 3];
    noise->SetSlowError(k, given >= 0.0 ? given : noise->GetSlowErrorRMS(k),
      k < 3 ? data.PositionTime : data.AttitudeTime);
  }
  noise->SetBoresight(data.Boresight[0], data.Boresight[1], data.Boresight[2]);
  noise->SetLeverArmError(data.LeverArm[0], data.LeverArm[1], data.LeverArm[2]);
  noise->SetClockOffset(data.ClockOffset);
}

} // namespace

//------------------------------------------------------------------------------
vtkSmartPointer<vtkHeliosPlatform> MakePlatform(
  const SurveyData& survey, const LegPath& path, std::size_t first, std::size_t last, Messages& log)
{
  if (survey.GetPlatform(first).Type == PlatformType::Interpolated)
  {
    return MakeInterpolated(survey, path, first, last, log);
  }
  const auto platform = MakeVehicle(survey, first, last);
  platform->SetInputData(MakeWaypoints(survey, path.Positions, first, last));
  return platform;
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkHeliosPlatformNoise> MakePlatformNoise(
  const PlatformData& platform, std::size_t channels)
{
  vtkSmartPointer<vtkHeliosPlatformNoise> noise;
  for (int component = 0; component < 6; ++component)
  {
    if (platform.Noise[component].IsOn)
    {
      noise = noise ? noise : vtkSmartPointer<vtkHeliosPlatformNoise>::New();
      SetComponent(component, platform.Noise[component], channels, noise);
    }
  }
  if (HasErrors(platform.Errors))
  {
    noise = noise ? noise : vtkSmartPointer<vtkHeliosPlatformNoise>::New();
    SetErrors(platform.Errors, noise);
  }
  return noise;
}

} // namespace helios
