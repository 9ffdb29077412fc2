// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosStrip.h"

#include "vtkHeliosSwath.h"

#include <algorithm>
#include <cmath>

namespace helios
{

//------------------------------------------------------------------------------
Strip::Strip(std::vector<Vec3> waypoints, double speed)
  : Speed(speed)
  , Begin(waypoints.front())
{
  const Vec3 all = waypoints.back() - waypoints.front();
  const double length = std::hypot(all[0], all[1]);
  this->Forward = length > 0.0 ? Vec3(all[0] / length, all[1] / length, 0.0) : Vec3(0, 1, 0);
  this->Right = Vec3(this->Forward[1], -this->Forward[0], 0.0);
  for (const Vec3& waypoint : waypoints)
  {
    this->Distances.push_back((waypoint - this->Begin).Dot(this->Forward));
    this->Heights.push_back(waypoint[2]);
  }
}

//------------------------------------------------------------------------------
Strip::Level Strip::GetLevel(double along) const
{
  const auto next = std::upper_bound(this->Distances.begin(), this->Distances.end(), along);
  const auto last = static_cast<std::ptrdiff_t>(this->Distances.size()) - 1;
  const std::ptrdiff_t index = next - this->Distances.begin() - 1;
  const auto i = static_cast<std::size_t>(std::clamp<std::ptrdiff_t>(index, 0, last - 1));
  const double run = this->Distances[i + 1] - this->Distances[i];
  const double climb = this->Heights[i + 1] - this->Heights[i];
  const double share = run > 0.0 ? std::clamp((along - this->Distances[i]) / run, 0.0, 1.0) : 0.0;
  const double distance = std::hypot(run, climb);
  return { this->Heights[i] + share * climb,
    distance > 0.0 ? this->Speed * run / distance : this->Speed };
}

//------------------------------------------------------------------------------
PlaceInStrip Strip::Find(const Vec3& place) const
{
  const Vec3 from = place - this->Begin;
  const double along = from.Dot(this->Forward);
  return { along, from.Dot(this->Right), this->GetLevel(along).Z - place[2] };
}

//------------------------------------------------------------------------------
double Strip::ComputeDensity(const GroundPlace& place, const vtkHeliosSwath& swath) const
{
  const PlaceInStrip at = this->Find(place.Position);
  if (!(at.Height > 0.0))
  {
    return 0.0;
  }
  const double nearly = at.Across / at.Height;
  const double slopeAlong = place.SlopeX * this->Forward[0] + place.SlopeY * this->Forward[1];
  const double slopeAcross = place.SlopeX * this->Right[0] + place.SlopeY * this->Right[1];
  double density = 0.0;
  for (const double sign : { -1.0, 1.0 })
  {
    const double b = swath.GetAlongMean(nearly) + sign * swath.GetAlongDeviation(nearly);
    const double from = at.Along - b * at.Height;
    if (from < 0.0 || from > this->GetLength())
    {
      continue;
    }
    const Level level = this->GetLevel(from);
    const double height = level.Z - place.Position[2];
    const double a = at.Across / height;
    const double range = height * std::sqrt(1.0 + a * a + b * b);
    if (height > 0.0 && range >= swath.GetRangeMin() && range <= swath.GetRangeMax())
    {
      density += 0.5 * swath.GetRate(a) / (level.GroundSpeed * height) *
        std::max(0.0, 1.0 + a * slopeAcross + b * slopeAlong);
    }
  }
  return density;
}

} // namespace helios
