// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosFlightSpeed.h"

#include "heliosRoot.h"

#include <algorithm>
#include <cmath>

namespace helios
{
namespace
{

/// Steps of a ramp that takes minutes.
constexpr int MaximumSteps = 4000;

/// A change of speed: the drive goes to a peak, is constant, and goes to the drive of the final
/// speed.
struct Maneuver
{
  double Peak;
  double Wait;
};

SpeedChange Fly(const DriveLimits& limits, double from, double to, const Maneuver& maneuver)
{
  SpeedChange change;
  double speed = from;
  const auto add = [&](const DrivePhase& phase)
  {
    const DrivePhase::State end = phase.GetEnd();
    change.Phases.push_back(phase);
    change.Distance += end.Distance;
    speed = end.Speed;
  };
  add(DrivePhase::Ramp(limits, speed, limits.GetDrive(from), maneuver.Peak));
  if (maneuver.Wait > 0.0)
  {
    add(DrivePhase::Hold(limits, speed, maneuver.Peak, maneuver.Wait));
  }
  add(DrivePhase::Ramp(limits, speed, maneuver.Peak, limits.GetDrive(to)));
  return change;
}

/// Returns the excess over the requested final speed of a manoeuvre.
double GetExcess(const DriveLimits& limits, double from, double to, const Maneuver& maneuver)
{
  return Fly(limits, from, to, maneuver).Phases.back().GetEnd().Speed - to;
}

/// Returns an upper bound of the time at the peak.
double GetLongestWait(const DriveLimits& limits, double from, double to, double peak)
{
  if (to > from)
  {
    double wait = 1.0;
    while (GetExcess(limits, from, to, { peak, wait }) < 0.0 && wait < 1e9)
    {
      wait *= 2.0;
    }
    return wait;
  }
  // Until it is at rest.
  const double speed = DrivePhase::Ramp(limits, from, limits.GetDrive(from), peak).GetEnd().Speed;
  const double w = std::sqrt(limits.Drag * std::abs(peak));
  return w > 0.0 ? std::atan(speed * w / std::abs(peak)) / w : speed / std::abs(peak);
}

SpeedChange ChangeWithin(const DriveLimits& limits, double from, double to, double extreme)
{
  if (from == to)
  {
    return {};
  }
  const double base = limits.GetDrive(to);
  const auto gentle = [&](double effort) {
    return Maneuver{ base + effort * (extreme - base), 0.0 };
  };
  const auto excess = [&](const Maneuver& m) { return GetExcess(limits, from, to, m); };
  const double hard = excess(gentle(1.0));
  if (to > from ? hard >= 0.0 : hard <= 0.0)
  {
    const double effort = FindRoot([&](double e) { return excess(gentle(e)); }, 0.0, 1.0);
    return Fly(limits, from, to, gentle(effort));
  }
  const double longest = GetLongestWait(limits, from, to, extreme);
  const double wait = FindRoot([&](double t) { return excess({ extreme, t }); }, 0.0, longest);
  return Fly(limits, from, to, { extreme, wait });
}

/// Slows down over a distance, or over the minimum of the limits.
SpeedChange Brake(const DriveLimits& limits, double from, double to, double distance)
{
  SpeedChange change = ChangeSpeed(limits, from, to);
  if (from <= to || change.Distance >= distance)
  {
    return change;
  }
  // Down to almost no braking: the effect of drag must not be too large either.
  const auto at = [&](double share)
  { return ChangeWithin(limits, from, to, share * limits.Minimum); };
  double low = 0.5;
  while (at(low).Distance < distance && low > 1e-6)
  {
    low *= 0.5;
  }
  const double share =
    FindRoot([&](double s) { return at(s).Distance - distance; }, low, std::min(1.0, 2.0 * low));
  return at(share);
}

void Append(const SpeedChange& change, std::vector<DrivePhase>& phases)
{
  phases.insert(phases.end(), change.Phases.begin(), change.Phases.end());
}

} // namespace

//------------------------------------------------------------------------------
DrivePhase DrivePhase::Ramp(const DriveLimits& limits, double speed, double from, double to)
{
  DrivePhase phase;
  phase.Duration = std::abs(to - from) / limits.Rate;
  phase.Speed = speed;
  phase.Drive = from;
  phase.Rate = to > from ? limits.Rate : -limits.Rate;
  phase.Drag = limits.Drag;
  const double steps = phase.Duration / limits.Step;
  const int count = 4 + (steps < MaximumSteps ? static_cast<int>(steps) : MaximumSteps);
  phase.Steps.reserve(static_cast<std::size_t>(count) + 1);
  phase.Steps.push_back({ 0.0, speed });
  for (int i = 0; i < count; ++i)
  {
    const double t = phase.Duration * i / count;
    phase.Steps.push_back(phase.Advance(phase.Steps.back(), t, phase.Duration / count));
  }
  return phase;
}

//------------------------------------------------------------------------------
DrivePhase DrivePhase::Hold(const DriveLimits& limits, double speed, double drive, double duration)
{
  DrivePhase phase;
  phase.Duration = duration;
  phase.Speed = speed;
  phase.Drive = drive;
  phase.Drag = limits.Drag;
  return phase;
}

//------------------------------------------------------------------------------
DrivePhase DrivePhase::Cruise(const DriveLimits& limits, double speed, double duration)
{
  DrivePhase phase = Hold(limits, speed, limits.GetDrive(speed), duration);
  phase.Cruises = true;
  return phase;
}

//------------------------------------------------------------------------------
DrivePhase::State DrivePhase::At(double t) const
{
  const double drive = this->Drive + this->Rate * t;
  if (this->Cruises)
  {
    return { this->Speed * t, this->Speed, drive };
  }
  if (this->Steps.empty())
  {
    const Travel travel = QuadraticDrag{ this->Drive, this->Drag }.At(this->Speed, t);
    return { travel.Distance, travel.Speed, drive };
  }
  const std::size_t last = this->Steps.size() - 1;
  const double step = this->Duration / static_cast<double>(last);
  const std::size_t i =
    step > 0.0 ? std::min(last, static_cast<std::size_t>(std::max(0.0, t / step))) : last;
  const double before = static_cast<double>(i) * step;
  const Travel travel = this->Advance(this->Steps[i], before, t - before);
  return { travel.Distance, travel.Speed, drive };
}

//------------------------------------------------------------------------------
Travel DrivePhase::Advance(const Travel& from, double time, double step) const
{
  const auto pull = [&](double t, double v)
  { return this->Drive + this->Rate * t - this->Drag * v * std::abs(v); };
  const double h = 0.5 * step;
  const double v1 = from.Speed;
  const double a1 = pull(time, v1);
  const double v2 = from.Speed + h * a1;
  const double a2 = pull(time + h, v2);
  const double v3 = from.Speed + h * a2;
  const double a3 = pull(time + h, v3);
  const double v4 = from.Speed + step * a3;
  const double a4 = pull(time + step, v4);
  return { from.Distance + step / 6.0 * (v1 + 2.0 * (v2 + v3) + v4),
    from.Speed + step / 6.0 * (a1 + 2.0 * (a2 + a3) + a4) };
}

//------------------------------------------------------------------------------
SpeedChange ChangeSpeed(const DriveLimits& limits, double from, double to)
{
  return ChangeWithin(limits, from, to, to > from ? limits.Maximum : limits.Minimum);
}

//------------------------------------------------------------------------------
std::vector<DrivePhase> FlyLine(const DriveLimits& limits, const LineFlight& line)
{
  const double brakeDistance = std::min(line.BrakeDistance, 0.5 * line.Length);
  const auto up = [&](double top) { return ChangeSpeed(limits, line.Entry, top); };
  const auto down = [&](double top) { return Brake(limits, top, line.Exit, brakeDistance); };
  const auto getRest = [&](double top)
  { return line.Length - up(top).Distance - down(top).Distance; };
  double top = line.Cruise;
  double rest = getRest(top);
  if (rest < 0.0)
  {
    top = FindRoot(getRest, std::max(line.Entry, line.Exit), top);
    rest = 0.0;
  }
  std::vector<DrivePhase> phases;
  Append(up(top), phases);
  if (rest > 0.0 && top > 0.0)
  {
    phases.push_back(DrivePhase::Cruise(limits, top, rest / top));
  }
  Append(down(top), phases);
  return phases;
}

} // namespace helios
