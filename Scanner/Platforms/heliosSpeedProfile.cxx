// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosSpeedProfile.h"

#include <algorithm>
#include <limits>

namespace helios
{
namespace
{

/// Returns the braking distance from one speed to another with full brake.
double GetBrakeDistance(const LinearDrag& brake, double from, double to)
{
  return from > to ? brake.At(from, brake.FindTime(from, to)).Distance : 0.0;
}

/// Returns the maximum speed at the start of a stretch from which the brake reaches a speed at its
/// end.
double GetEntrySpeed(const Stretch& stretch, double rate, double exit)
{
  const LinearDrag brake{ stretch.Brake, rate };
  if (exit >= stretch.Cap || GetBrakeDistance(brake, stretch.Cap, exit) <= stretch.Length)
  {
    return stretch.Cap;
  }
  return FindRoot(
    [&](double v) { return GetBrakeDistance(brake, v, exit) - stretch.Length; }, exit, stretch.Cap);
}

/// Returns the maximum speed at the end of every stretch.
std::vector<double> GetExitSpeeds(const std::vector<Stretch>& stretches, double rate)
{
  std::vector<double> exits(stretches.size());
  double next = std::numeric_limits<double>::infinity();
  for (std::size_t i = stretches.size(); i-- > 0;)
  {
    exits[i] = stretches[i].StopsAtEnd ? 0.0 : std::min(next, stretches[i].Cap);
    next = GetEntrySpeed(stretches[i], rate, exits[i]);
  }
  return exits;
}

/// Drives one stretch.
class Driver
{
public:
  Driver(const Stretch& way, std::size_t index, double rate, double exit)
    : Way(way)
    , Index(index)
    , Exit(exit)
    , Rate(rate)
    , Force{ way.Thrust, rate }
    , Brake{ way.Brake, rate }
  {
  }

  /// Appends its phases; returns the speed at the end.
  double Drive(double speed, std::vector<SpeedPhase>& phases)
  {
    this->Entry = speed;
    const double toCap = speed < this->Way.Cap ? this->Force.FindTime(speed, this->Way.Cap) : 0.0;
    const double toEnd = this->Force.FindTimeTo(speed, this->Way.Length);
    double push = std::min(toCap, toEnd);
    double hold = 0.0;
    const double left = this->GetRemainingDistance(push);
    if (left < 0.0)
    {
      push = FindRoot([&](double t) { return this->GetRemainingDistance(t); }, 0.0, push);
    }
    else if (toCap < toEnd)
    {
      hold = left;
    }
    return this->Append(push, hold, phases);
  }

private:
  /// Returns the distance left after full force for a time and full brake after that.
  double GetRemainingDistance(double time) const
  {
    const Travel travel = this->Force.At(this->Entry, time);
    return this->Way.Length - travel.Distance -
      GetBrakeDistance(this->Brake, travel.Speed, this->Exit);
  }

  /// Appends full force for a time, constant speed over a distance, and the brake over the rest.
  double Append(double push, double hold, std::vector<SpeedPhase>& phases) const
  {
    Travel at{ 0.0, this->Entry };
    const auto add = [&](double duration, const LinearDrag& force)
    {
      if (duration > 0.0)
      {
        phases.push_back({ this->Index, at.Distance, at.Speed, duration, force });
        at = phases.back().At(duration);
      }
    };
    add(push, this->Force);
    add(at.Speed > 0.0 ? hold / at.Speed : 0.0, { this->Rate * at.Speed, this->Rate });
    if (at.Speed > this->Exit)
    {
      // The remaining distance may be only rounding.
      add(
        at.Speed - this->Exit > 1e-12 * at.Speed ? this->Brake.FindTime(at.Speed, this->Exit) : 0.0,
        this->Brake);
      return this->Exit;
    }
    return at.Speed;
  }

  const Stretch& Way;
  std::size_t Index;
  double Exit;
  double Rate;
  double Entry = 0.0;
  LinearDrag Force;
  LinearDrag Brake;
};

} // namespace

//------------------------------------------------------------------------------
std::vector<SpeedPhase> DriveStretches(const std::vector<Stretch>& stretches, double rate)
{
  const std::vector<double> exits = GetExitSpeeds(stretches, rate);
  std::vector<SpeedPhase> phases;
  double speed = 0.0;
  for (std::size_t i = 0; i < stretches.size(); ++i)
  {
    speed = Driver(stretches[i], i, rate, exits[i]).Drive(speed, phases);
  }
  return phases;
}

} // namespace helios
