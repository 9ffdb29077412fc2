// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosTrajectoryShape.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace helios
{

namespace
{

using Slopes = std::array<double, 6>; // velocity [m/s], turning rate about the body axes [deg/s]

Quaternion Turn(int axis, double angle)
{
  Quaternion q(std::cos(0.5 * angle), 0.0, 0.0, 0.0);
  q[1 + axis] = std::sin(0.5 * angle);
  return q;
}

Slopes GetSlopes(
  const TrajectoryRow& a, const TrajectoryRow& b, const Quaternion& from, const Quaternion& to)
{
  const double dt = b.Time - a.Time;
  const Quaternion turn = from.Conjugated() * to;
  const double sine = std::hypot(turn.GetX(), turn.GetY(), turn.GetZ());
  const double angle = 2.0 * std::atan2(turn.GetW() < 0.0 ? -sine : sine, std::abs(turn.GetW()));
  const double rate = sine > 0.0 ? vtkMath::DegreesFromRadians(angle) / sine / dt : 0.0;
  const Vec3 velocity = (1.0 / dt) * (b.Position - a.Position);
  return { { velocity[0], velocity[1], velocity[2], rate * turn.GetX(), rate * turn.GetY(),
    rate * turn.GetZ() } };
}

} // namespace

Quaternion FromArinc705(const Vec3& rollPitchYaw)
{
  return Turn(2, -rollPitchYaw[2]) * Turn(1, rollPitchYaw[0]) * Turn(0, rollPitchYaw[1]);
}

Quaternion FromNavigation(const Vec3& rollPitchYaw)
{
  return Turn(2, -rollPitchYaw[2]) * Turn(0, rollPitchYaw[1]) * Turn(1, rollPitchYaw[0]);
}

Quaternion FromCanonical(const Vec3& rollPitchYaw)
{
  return Turn(0, rollPitchYaw[0]) * Turn(1, rollPitchYaw[1]) * Turn(2, rollPitchYaw[2]);
}

Quaternion ToBodyAxes(BodyAxes axes)
{
  const double half = std::sqrt(0.5);
  switch (axes)
  {
    case BodyAxes::ForwardLeftUp: // x to -y, y to x
      return Quaternion(half, 0.0, 0.0, -half);
    case BodyAxes::ForwardRightDown: // x to y, y to x, z to -z
      return Quaternion(0.0, half, half, 0.0);
    default:
      return Quaternion(1.0, 0.0, 0.0, 0.0);
  }
}

//------------------------------------------------------------------------------
std::vector<Quaternion> HeadingsOfFlight(
  const std::vector<TrajectoryRow>& rows, double minimumSpeed)
{
  std::vector<Quaternion> headings(rows.size(), Quaternion(1.0, 0.0, 0.0, 0.0));
  std::size_t first = rows.size(); // first row with a heading
  for (std::size_t i = 0; i < rows.size(); ++i)
  {
    const double before = i > 0 ? rows[i].Time - rows[i - 1].Time : 0.0;
    const double after = i + 1 < rows.size() ? rows[i + 1].Time - rows[i].Time : 0.0;
    Vec3 velocity(0.0, 0.0, 0.0); // parabola weights
    if (before > 0.0)
    {
      const double weight = (after > 0.0 ? after : before) / (before * (before + after));
      velocity = velocity + weight * (rows[i].Position - rows[i - 1].Position);
    }
    if (after > 0.0)
    {
      const double weight = (before > 0.0 ? before : after) / (after * (before + after));
      velocity = velocity + weight * (rows[i + 1].Position - rows[i].Position);
    }
    const double speed = std::hypot(velocity[0], velocity[1]);
    if (speed > 0.0 && speed >= minimumSpeed)
    {
      headings[i] = Turn(2, std::atan2(-velocity[0], velocity[1]));
      first = std::min(first, i);
    }
    else if (i > 0)
    {
      headings[i] = headings[i - 1];
    }
  }
  if (first < rows.size())
  {
    std::fill_n(headings.begin(), first, headings[first]);
  }
  return headings;
}

//------------------------------------------------------------------------------
std::vector<std::size_t> FilterSlopes(const std::vector<TrajectoryRow>& rows,
  const std::vector<Quaternion>& orientations, double threshold)
{
  std::vector<std::size_t> kept;
  Slopes known{};
  bool isKnown = false;
  for (std::size_t i = 0; i < rows.size(); ++i)
  {
    const bool isLast = i + 1 == rows.size();
    const bool jumps = !isLast && rows[i + 1].Time == rows[i].Time;
    bool isKept = isLast || jumps || !isKnown;
    if (!isLast && !jumps)
    {
      const Slopes slopes = GetSlopes(rows[i], rows[i + 1], orientations[i], orientations[i + 1]);
      for (std::size_t k = 0; k < slopes.size(); ++k)
      {
        isKept = isKept || std::abs(slopes[k] - known[k]) > threshold;
      }
      known = isKept ? slopes : known;
    }
    isKnown = !jumps; // slopes restart after a jump
    if (isKept)
    {
      kept.push_back(i);
    }
  }
  return kept;
}

} // namespace helios
