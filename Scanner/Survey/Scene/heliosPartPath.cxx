// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosPartPath.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace helios
{

namespace
{

/// Returns where the point is that a map turns about.
Vec3 GetImage(const MotionMap& map)
{
  return map.Center + map.Shift;
}

/// Returns a then b, which turns about the point that a turns about.
MotionMap Join(const MotionMap& a, const MotionMap& b)
{
  if (!b.Turns)
  {
    MotionMap map = a;
    map.Shift = a.Shift + b.Shift;
    return map;
  }
  MotionMap map;
  map.Turns = true;
  map.Linear = b.Linear * a.Linear;
  map.Center = a.Center;
  map.Shift = b * GetImage(a) - a.Center;
  return map;
}

SceneMoment GetMiddle(const MomentSpan& span)
{
  return { span.First + (span.Last - span.First) / 2, 0.5 * span.Start + 0.5 * span.End };
}

} // namespace

//------------------------------------------------------------------------------
double PathBound::GetReach(double distance) const
{
  return this->Shift + std::min(this->Angle, 2.0) * distance;
}

//------------------------------------------------------------------------------
StepPath::StepPath(
  const MotionData& data, std::shared_ptr<const PartMotion> motion, const PulseClock& clock)
  : Data(data)
  , Motion(std::move(motion))
  , Clock(clock)
{
}

//------------------------------------------------------------------------------
bool StepPath::Move(const SceneMoment& moment, MotionMap& map)
{
  const vtkIdType step = FindSeenStep(this->Data, this->Clock, moment.Pulse);
  if (step == this->Step)
  {
    return false;
  }
  this->Step = step;
  map = this->Motion->GetMap(this->Motion->FindLastMove(step));
  return true;
}

//------------------------------------------------------------------------------
const MotionSection& StepPath::FindSection(vtkIdType step)
{
  if (!this->HasSection || step < this->Section.GetBegin() || step >= this->Section.GetEnd())
  {
    this->Section = this->Motion->GetSection(step);
    this->HasSection = true;
  }
  return this->Section;
}

//------------------------------------------------------------------------------
/// Bounds steps by those of their sections: all steps of a section are equally long.
PathBound StepPath::GetBound(const MomentSpan& span)
{
  const vtkIdType first = FindSeenStep(this->Data, this->Clock, span.First);
  const vtkIdType last = FindSeenStep(this->Data, this->Clock, span.Last);
  const vtkIdType middle =
    FindSeenStep(this->Data, this->Clock, span.First + (span.Last - span.First) / 2);
  PathBound bound;
  double chord = 0.0;
  double angle = 0.0;
  for (vtkIdType step = first; step < last; step = this->FindSection(step).GetEnd())
  {
    const MotionSection& section = this->FindSection(step);
    chord = std::max(chord, section.GetChord());
    angle = section.IsMirror() ? std::numeric_limits<double>::infinity()
                               : std::max(angle, section.GetAngle());
  }
  const MotionSection& section = this->FindSection(middle);
  bound.Map =
    section.IsMirror() ? this->Motion->GetMap(middle) : section.GetMap(static_cast<double>(middle));
  const auto steps = static_cast<double>(std::max(middle - first, last - middle));
  bound.Shift = steps * chord;
  bound.Angle = angle > 0.0 ? steps * angle : 0.0;
  return bound;
}

//------------------------------------------------------------------------------
PathRates StepPath::GetRatesAt(double step)
{
  const double perSecond = this->Data.Seconds > 0.0
    ? 1.0 / this->Data.Seconds
    : this->Clock.Rate / static_cast<double>(this->Data.Pulses);
  const MotionSection& section = this->FindSection(static_cast<vtkIdType>(std::floor(step)));
  PathRates rates;
  if (!section.IsMirror())
  {
    section.GetRates(step, rates.Velocity, rates.Rotation);
    rates.Velocity = perSecond * rates.Velocity;
    rates.Rotation = perSecond * rates.Rotation;
  }
  rates.Point = GetImage(section.GetMap(step));
  return rates;
}

//------------------------------------------------------------------------------
PathRates StepPath::GetRates(const SceneMoment& moment)
{
  const vtkIdType step = FindSeenStep(this->Data, this->Clock, moment.Pulse);
  return this->GetRatesAt(static_cast<double>(step));
}

//------------------------------------------------------------------------------
/// Returns the steps made at a moment, with a fraction.
double ContinuousPath::GetStep(const SceneMoment& moment) const
{
  const double shots = static_cast<double>(this->Clock.FirstShot) +
    (moment.Time - this->Clock.StartTime) * this->Clock.Rate;
  return std::max(0.0,
    this->Data.Seconds > 0.0 ? moment.Time / this->Data.Seconds
                             : shots / static_cast<double>(this->Data.Pulses));
}

//------------------------------------------------------------------------------
bool ContinuousPath::Move(const SceneMoment& moment, MotionMap& map)
{
  const double step = this->GetStep(moment);
  map = this->FindSection(static_cast<vtkIdType>(std::floor(step))).GetMap(step);
  return true;
}

//------------------------------------------------------------------------------
PathBound ContinuousPath::GetBound(const MomentSpan& span)
{
  const double first = this->GetStep({ span.First, span.Start });
  const double last = this->GetStep({ span.Last, span.End });
  const double middle = this->GetStep(GetMiddle(span));
  PathBound bound;
  double arc = 0.0;
  double angle = 0.0;
  const auto end = static_cast<vtkIdType>(std::floor(last));
  for (auto step = static_cast<vtkIdType>(std::floor(first)); step <= end;
       step = this->FindSection(step).GetEnd())
  {
    const MotionSection& section = this->FindSection(step);
    arc = std::max(arc, section.GetArc());
    angle = std::max(angle, section.GetAngle());
  }
  const double steps = std::max(middle - first, last - middle);
  bound.Map = this->FindSection(static_cast<vtkIdType>(std::floor(middle))).GetMap(middle);
  bound.Shift = steps * arc;
  bound.Angle = steps * angle;
  return bound;
}

//------------------------------------------------------------------------------
PathRates ContinuousPath::GetRates(const SceneMoment& moment)
{
  return this->GetRatesAt(this->GetStep(moment));
}

//------------------------------------------------------------------------------
TrajectoryPath::TrajectoryPath(std::shared_ptr<const Trajectory> trajectory)
  : Track(std::move(trajectory))
{
}

//------------------------------------------------------------------------------
bool TrajectoryPath::Move(const SceneMoment& moment, MotionMap& map)
{
  map.Turns = true;
  map.Shift = this->Track->GetPosition(moment.Time, this->Cursor, map.Linear);
  return true;
}

//------------------------------------------------------------------------------
PathBound TrajectoryPath::GetBound(const MomentSpan& span)
{
  PathBound bound;
  this->Move(GetMiddle(span), bound.Map);
  double speed = 0.0;
  double rotation = 0.0;
  this->Track->GetBounds(span.Start, span.End, speed, rotation);
  const double half = 0.5 * (span.End - span.Start);
  bound.Shift = half * speed;
  bound.Angle = half * rotation;
  return bound;
}

//------------------------------------------------------------------------------
PathRates TrajectoryPath::GetRates(const SceneMoment& moment)
{
  const Trajectory::Rates rates = this->Track->GetRates(moment.Time);
  MotionMap map;
  this->Move(moment, map);
  return { map.Shift, rates.Velocity, rates.Rotation };
}

//------------------------------------------------------------------------------
MountedPath::MountedPath(std::unique_ptr<PartPath> carrier, std::unique_ptr<PartPath> own)
  : Carrier(std::move(carrier))
  , Own(std::move(own))
{
}

//------------------------------------------------------------------------------
bool MountedPath::Move(const SceneMoment& moment, MotionMap& map)
{
  const bool hasMoved = this->Own && this->Own->Move(moment, this->OfOwn);
  if (!this->Carrier->Move(moment, this->OfCarrier) && !hasMoved)
  {
    return false;
  }
  map = this->Own ? Join(this->OfOwn, this->OfCarrier) : this->OfCarrier;
  return true;
}

//------------------------------------------------------------------------------
PathBound MountedPath::GetBound(const MomentSpan& span)
{
  const PathBound carrier = this->Carrier->GetBound(span);
  if (!this->Own)
  {
    return carrier;
  }
  const PathBound own = this->Own->GetBound(span);
  const double arm = (GetImage(own.Map) - carrier.Map.Center).Norm();
  PathBound bound;
  bound.Map = Join(own.Map, carrier.Map);
  bound.Shift = carrier.GetReach(arm) + own.Shift;
  bound.Angle = carrier.Angle + own.Angle;
  return bound;
}

//------------------------------------------------------------------------------
PathRates MountedPath::GetRates(const SceneMoment& moment)
{
  PathRates rates = this->Carrier->GetRates(moment);
  if (this->Own)
  {
    MotionMap map;
    this->Move(moment, map);
    const PathRates own = this->Own->GetRates(moment);
    const Vec3 point = this->OfCarrier * own.Point;
    const Rotation& turn = this->OfCarrier.Linear;
    rates = { point, rates.GetVelocity(point) + turn * own.Velocity,
      rates.Rotation + turn * own.Rotation };
  }
  return rates;
}

} // namespace helios
