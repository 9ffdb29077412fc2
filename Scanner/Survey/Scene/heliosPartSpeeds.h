// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// How fast the parts of a scene move during legs.

#ifndef heliosPartSpeeds_h
#define heliosPartSpeeds_h

#include "heliosPulseClock.h"
#include "heliosSceneMotions.h"

#include <memory>
#include <string>
#include <vector>

namespace helios
{

/// The pulses of a leg, and its end [s].
struct LegClock
{
  PulseClock Clock;
  double End = 0.0;
};

/// A part that moves, and the speeds of the centroid of its area [m/s].
struct PartSpeeds
{
  std::string Name;
  std::string Motion; ///< in words
  double Minimum = 0.0;
  double Maximum = 0.0;
};

/// Returns the speeds of all parts at moments of legs: up to 256 in each, fewer of many parts and
/// legs.
std::vector<PartSpeeds> ComputeSpeeds(
  const std::shared_ptr<const SceneMotions::Content>& motions, const std::vector<LegClock>& legs);

} // namespace helios

#endif
