// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosPartSpeeds.h"

#include "heliosPartMotions.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace helios
{

namespace
{

constexpr int MaximumMoments = 256; // moments of a leg
constexpr int MinimumMoments = 3;
constexpr double TotalMoments = 200000.0; // about, for all parts and legs

/// Widens the speeds of a part by those in a leg, at evenly spaced moments.
void AddLeg(
  const SceneMotions& motions, std::size_t part, const LegClock& leg, int moments, PartSpeeds& sums)
{
  const Vec3 centroid = motions.GetContent().Parts[part].Centroid;
  const auto path = motions.MakePath(part);
  if (!path) // it deforms where it stands
  {
    sums.Minimum = 0.0;
    return;
  }
  MotionMap map;
  for (int i = 0; i < moments; ++i)
  {
    const double share = static_cast<double>(i) / static_cast<double>(moments - 1);
    const double since = share * (leg.End - leg.Clock.StartTime);
    const SceneMoment moment = { static_cast<vtkIdType>(std::floor(since * leg.Clock.Rate)),
      leg.Clock.StartTime + since };
    path->Move(moment, map);
    const double speed = path->GetRates(moment).GetVelocity(map * centroid).Norm();
    sums.Minimum = std::min(sums.Minimum, speed);
    sums.Maximum = std::max(sums.Maximum, speed);
  }
}

} // namespace

//------------------------------------------------------------------------------
std::vector<PartSpeeds> ComputeSpeeds(
  const std::shared_ptr<const SceneMotions::Content>& content, const std::vector<LegClock>& legs)
{
  std::vector<PartSpeeds> all;
  const double pairs =
    static_cast<double>(content->Parts.size() * std::max<std::size_t>(1, legs.size()));
  const int moments =
    std::clamp(static_cast<int>(TotalMoments / pairs), MinimumMoments, MaximumMoments);
  for (std::size_t i = 0; i < content->Parts.size(); ++i)
  {
    const MovingPartData& part = content->Parts[i];
    PartSpeeds speeds = { part.Name, DescribeMotion(part.Data, part.Frames != nullptr),
      legs.empty() ? 0.0 : std::numeric_limits<double>::infinity(), 0.0 };
    for (const LegClock& leg : legs)
    {
      AddLeg(SceneMotions(content, leg.Clock), i, leg, moments, speeds);
    }
    all.push_back(speeds);
  }
  return all;
}

} // namespace helios
