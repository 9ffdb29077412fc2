// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosShapePath.h"

#include "heliosMessages.h"

#include <algorithm>
#include <cmath>

namespace helios
{

//------------------------------------------------------------------------------
std::string PartFrames::Describe() const
{
  const std::size_t count = this->Frames->GetCount();
  MessageBuilder text;
  text << "deforms: " << count << " frames of " << this->Frames->GetFrame(0)->GetNumberOfPoints()
       << " vertices, from " << this->First
       << (this->First == this->Last ? "" : " to " + this->Last) << ", at " << this->Rate
       << " a second";
  return text.str();
}

//------------------------------------------------------------------------------
Status PartFrames::CheckSpan(const std::string& part, double start, double end) const
{
  constexpr double rounding = 1e-6;            // [s]
  const double first = 0.0 - this->Data.Start; // not -0
  const double last = (static_cast<double>(this->Frames->GetCount()) - 1.0) / this->Rate + first;
  if (this->Data.End != FramesEnd::Error || (first <= start + rounding && last >= end - rounding))
  {
    return {};
  }
  MessageBuilder text;
  text << this->Data.Where << ": part " << part << ": "
       << (this->IsClosed ? "frames " + this->First + " to " + this->Last
                          : "the keys of the animation of " + this->First)
       << " have times of the survey from " << first << " s to " << last
       << " s, but a leg lasts from " << start << " s to " << end
       << " s; set atEnd to loop or hold, or give more frames, or another tStart";
  return Status::Error(text.str());
}

//------------------------------------------------------------------------------
double PartFrames::GetPeriod() const
{
  const auto count = static_cast<double>(this->Frames->GetCount());
  return this->Data.End == FramesEnd::Loop ? std::max(1.0, this->IsClosed ? count : count - 1.0)
                                           : 0.0;
}

//------------------------------------------------------------------------------
std::pair<std::size_t, std::size_t> PartFrames::FindEnds(double interval) const
{
  const std::size_t count = this->Frames->GetCount();
  const double period = this->GetPeriod();
  const double from = period > 0.0 ? interval - period * std::floor(interval / period)
                                   : std::clamp(interval, -1.0, static_cast<double>(count) - 1.0);
  if (from < 0.0)
  {
    return { 0, 0 };
  }
  const auto first = static_cast<std::size_t>(from);
  const std::size_t last = period > 0.0 && first + 1 == count ? 0 : std::min(first + 1, count - 1);
  return { first, last };
}

//------------------------------------------------------------------------------
ShapePath::ShapePath(
  const MotionData& motion, std::shared_ptr<const PartFrames> frames, const PulseClock& clock)
  : Motion(motion)
  , Frames(std::move(frames))
  , Clock(clock)
{
}

//------------------------------------------------------------------------------
double ShapePath::GetSeenPlace(const SceneMoment& moment) const
{
  if (this->Motion.IsContinuous)
  {
    return this->Frames->GetPlace(moment.Time);
  }
  const vtkIdType step = FindSeenStep(this->Motion, this->Clock, moment.Pulse);
  if (this->Motion.Seconds > 0.0)
  {
    return this->Frames->GetPlace(static_cast<double>(step) * this->Motion.Seconds);
  }
  const vtkIdType pulse = step * this->Motion.Pulses - this->Clock.FirstShot;
  const double after = static_cast<double>(std::max<vtkIdType>(0, pulse)) / this->Clock.Rate;
  return this->Frames->GetPlace(this->Clock.StartTime + after);
}

//------------------------------------------------------------------------------
void ShapePath::Find(const SceneMoment& moment, MeshShape& shape) const
{
  const double place = this->GetSeenPlace(moment);
  const double interval = std::floor(place);
  const auto [from, to] = this->Frames->FindEnds(interval);
  const double step = this->Motion.Seconds > 0.0
    ? this->Motion.Seconds
    : static_cast<double>(this->Motion.Pulses) / this->Clock.Rate;
  shape.From = this->GetFrames().GetPoints(from);
  shape.To = this->GetFrames().GetPoints(to);
  shape.Fraction = from == to ? 0.0 : place - interval;
  shape.Rate = from == to ? 0.0 : this->Frames->Rate;
  shape.Hold = this->Motion.IsContinuous ? 0.0 : step * this->Motion.Every * this->Frames->Rate;
}

//------------------------------------------------------------------------------
std::array<double, 6> ShapePath::GetBounds(const MomentSpan& span) const
{
  const double first = std::floor(this->GetSeenPlace({ span.First, span.Start }));
  const double last = std::floor(this->GetSeenPlace({ span.Last, span.End }));
  if (last - first >= static_cast<double>(this->GetFrames().GetCount()))
  {
    return this->GetFrames().GetBounds();
  }
  std::array<double, 6> box = this->GetFrames().GetBounds(this->Frames->FindEnds(first).first);
  for (double interval = first; interval <= last; ++interval)
  {
    const auto [from, to] = this->Frames->FindEnds(interval);
    for (const std::size_t frame : { from, to })
    {
      const std::array<double, 6>& each = this->GetFrames().GetBounds(frame);
      for (std::size_t i = 0; i < 6; i += 2)
      {
        box[i] = std::min(box[i], each[i]);
        box[i + 1] = std::max(box[i + 1], each[i + 1]);
      }
    }
  }
  return box;
}

} // namespace helios
