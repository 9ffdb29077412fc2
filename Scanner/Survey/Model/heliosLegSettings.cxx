// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosLegSettings.h"

#include "heliosMessages.h"
#include "heliosScanResolver.h"

#include <algorithm>
#include <cmath>

namespace helios
{

namespace
{

/// The minimum speed of a moving platform [m/s]: a slower flight practically never ends.
constexpr double SlowestSpeed = 1e-6;

void CheckSpeed(const SurveyData& survey, std::size_t leg, Messages& log)
{
  const LegData& data = survey.Legs[leg];
  const bool flies = survey.IsMoving(leg) && !survey.EndsTrajectory(leg) &&
    survey.GetPlatform(leg).Type != PlatformType::Interpolated;
  if (flies && !(data.Speed > SlowestSpeed))
  {
    MessageBuilder text;
    text << data.Where << ": movePerSec_m=\"" << data.Speed
         << "\": the platform never reaches the next leg; give a speed above 0 [m/s]";
    log.Error(text.str());
  }
}

/// Limits the samples of a trajectory to the number of pulses.
void LimitTrajectory(LegData& leg, bool fires, Messages& log)
{
  const double asked = leg.TrajectoryTimeInterval;
  const double minimum = 1.0 / leg.Scans.front().PulseFrequency;
  if (asked > 0.0 && asked < minimum && fires)
  {
    leg.TrajectoryTimeInterval = minimum;
    MessageBuilder text;
    text << "trajectoryTimeInterval_s=\"" << asked << "\" is shorter than the time between pulses; "
         << minimum << " s is used";
    log.WarnOnce(text.str(), leg.Where + ": " + text.str());
  }
}

/// Returns a scanner that supports all settings of a leg.
ScannerData MakeAbleScanner(const LegSettings& leg, Optics type)
{
  constexpr double unlimited = std::numeric_limits<double>::infinity();
  ScannerData scanner;
  scanner.Type = type;
  scanner.PulseFrequencies = { std::isnan(leg.PulseFrequency) ? 1.0 : leg.PulseFrequency };
  scanner.ScanAngleMax = 360.0;
  scanner.ScanAngleEffectiveMax = 360.0;
  scanner.HeadRotateSpeedMax = unlimited; // resolutions require any speed
  scanner.ScanProduct = unlimited;
  return scanner;
}

} // namespace

//------------------------------------------------------------------------------
void StartLegs(SurveyData& survey)
{
  survey.Legs.clear();
  for (const LegSettings& settings : survey.Settings)
  {
    const bool isOther =
      survey.Legs.empty() || survey.Legs.back().Platform != settings.Leg.Platform;
    survey.Legs.push_back(settings.Leg);
    survey.Legs.back().StartsTrajectory = isOther || settings.Leg.StartsTrajectory;
  }
}

//------------------------------------------------------------------------------
void CheckPath(const SurveyData& survey, std::size_t leg, Messages& log)
{
  const LegData& data = survey.Legs[leg];
  const bool isAlone = data.StartsTrajectory && survey.EndsTrajectory(leg);
  const bool isFlown = survey.GetPlatform(leg).Type == PlatformType::Interpolated;
  if (isAlone && survey.IsMoving(leg) && !isFlown)
  {
    log.Error(data.Where + ": platform " + survey.GetPlatform(leg).Id +
      " has 1 <leg>; a moving platform needs two, a start and an end");
  }
}

//------------------------------------------------------------------------------
bool NeedsTrajectory(const SurveyData& survey, std::size_t leg)
{
  const LegData& data = survey.Legs[leg];
  return survey.GetPlatform(leg).Type == PlatformType::Interpolated && data.StartsTrajectory &&
    data.Trajectory.File.empty();
}

//------------------------------------------------------------------------------
void CheckLegAlone(
  const LegSettings& settings, std::size_t leg, const SurveyData& survey, Messages& log)
{
  SurveyData able = survey;
  able.Scanners[survey.Legs[leg].Scanner] = MakeAbleScanner(settings, survey.GetScanner(leg).Type);
  ResolveLeg(settings, leg, able, log);
}

//------------------------------------------------------------------------------
void ResolveLeg(const LegSettings& settings, std::size_t leg, SurveyData& survey, Messages& log)
{
  const ScannerData& scanner = survey.GetScanner(leg);
  for (std::size_t k = 0; k < scanner.GetNumberOfChannels(); ++k)
  {
    ScanResolver resolver(settings, scanner.GetChannel(k), survey, leg, log);
    survey.Legs[leg].Scans.push_back(resolver.Resolve());
  }
  LimitTrajectory(survey.Legs[leg], survey.Fires(leg), log);
  CheckSpeed(survey, leg, log);
}

} // namespace helios
