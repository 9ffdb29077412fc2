// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosSampledPath.h"

#include "heliosStatus.h"
#include "vtkHeliosArrayNames.h"

#include <vtkDataArray.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>

#include <algorithm>
#include <cmath>

namespace names = vtkHeliosArrayNames;

namespace helios
{

namespace
{

bool IsFinite(const Vec3& v)
{
  return std::isfinite(v[0]) && std::isfinite(v[1]) && std::isfinite(v[2]);
}

/// Returns a point array with n components, null if missing.
vtkDataArray* FindArray(vtkPolyData* path, const char* name, int components)
{
  vtkDataArray* array = path->GetPointData()->GetArray(name);
  const bool fits = array && array->GetNumberOfComponents() == components &&
    array->GetNumberOfTuples() == path->GetNumberOfPoints();
  return fits ? array : nullptr;
}

} // namespace

Status SampledPath::Set(vtkPolyData* trajectory, bool isCubic)
{
  this->Path = trajectory;
  this->Count = trajectory ? trajectory->GetNumberOfPoints() : 0;
  this->IsCubic = isCubic;
  const Status status = this->CheckArrays(trajectory);
  return status.IsOk() ? this->CheckSamples() : status;
}

Status SampledPath::CheckArrays(vtkPolyData* trajectory)
{
  if (this->Count == 0)
  {
    return Status::Error("has no samples; connect a vtkHeliosTrajectoryReader");
  }
  this->Times = FindArray(trajectory, names::GpsTime, 1);
  this->Orientations = FindArray(trajectory, names::Orientation, 4);
  this->Velocities = this->IsCubic ? FindArray(trajectory, names::Velocity, 3) : nullptr;
  if (!this->Times || !this->Orientations)
  {
    return Status::Error(std::string("needs the point arrays ") + names::GpsTime +
      " (1 component) and " + names::Orientation + " (4), as vtkHeliosTrajectoryReader gives them");
  }
  return {};
}

Status SampledPath::CheckSamples() const
{
  for (vtkIdType i = 0; i < this->Count; ++i)
  {
    const State state = this->GetSample(i);
    const Quaternion& q = state.Orientation;
    const std::string sample = "sample " + std::to_string(i);
    if (!std::isfinite(state.Time) || !IsFinite(state.Position))
    {
      return Status::Error(sample + " is not finite; correct or remove it");
    }
    if (!(std::abs(q.SquaredNorm() - 1.0) < 1e-6))
    {
      return Status::Error(
        sample + " has an " + names::Orientation + " that is not a unit quaternion; normalize it");
    }
    if (i > 0 && state.Time < this->GetTime(i - 1))
    {
      return Status::Error(
        sample + " is earlier than the previous one; sort the samples by " + names::GpsTime);
    }
    if (this->IsCubic && !IsFinite(state.Velocity))
    {
      return Status::Error(
        sample + " has a " + names::Velocity + " that is not finite; correct or remove it");
    }
  }
  return {};
}

double SampledPath::GetTime(vtkIdType sample) const
{
  return this->Times->GetComponent(sample, 0);
}

SampledPath::State SampledPath::GetSample(vtkIdType sample) const
{
  State state{ this->GetTime(sample), {}, {}, { 0.0, 0.0, 0.0 } };
  this->Path->GetPoint(sample, state.Position.GetData());
  this->Orientations->GetTuple(sample, state.Orientation.GetData());
  if (this->IsCubic)
  {
    state.Velocity = this->GetVelocity(sample);
  }
  return state;
}

// Returns the velocity along the parabola through the sample and its neighbours; beside an end or a
// jump, along the parabola through the sample and the next two.
Vec3 SampledPath::GetVelocity(vtkIdType sample) const
{
  if (this->Velocities)
  {
    Vec3 velocity;
    this->Velocities->GetTuple(sample, velocity.GetData());
    return velocity;
  }
  const auto step = [this](vtkIdType i) // the time from i to i + 1, 0 if there is no motion
  { return i >= 0 && i + 1 < this->Count ? this->GetTime(i + 1) - this->GetTime(i) : 0.0; };
  const auto chord = [this, &step](vtkIdType i)
  {
    Vec3 a, b;
    this->Path->GetPoint(i, a.GetData());
    this->Path->GetPoint(i + 1, b.GetData());
    return (1.0 / step(i)) * (b - a);
  };
  const auto middle = [&step, &chord](vtkIdType i)
  {
    const double before = step(i - 1);
    const double after = step(i);
    return (1.0 / (before + after)) * (after * chord(i - 1) + before * chord(i));
  };
  const bool hasBefore = step(sample - 1) > 0.0;
  const bool hasAfter = step(sample) > 0.0;
  if (hasBefore && hasAfter)
  {
    return middle(sample);
  }
  if (hasAfter)
  {
    return step(sample + 1) > 0.0 ? 2.0 * chord(sample) - middle(sample + 1) : chord(sample);
  }
  if (hasBefore)
  {
    return step(sample - 2) > 0.0 ? 2.0 * chord(sample - 1) - middle(sample - 1)
                                  : chord(sample - 1);
  }
  return { 0.0, 0.0, 0.0 };
}

vtkIdType SampledPath::CountBefore(double time) const
{
  vtkIdType low = 0;
  for (vtkIdType high = this->Count; low < high;)
  {
    const vtkIdType middle = low + (high - low) / 2;
    this->GetTime(middle) < time ? low = middle + 1 : high = middle;
  }
  return low;
}

vtkIdType SampledPath::CountUntil(double time) const
{
  return this->CountBefore(std::nextafter(time, INFINITY));
}

SampledPath::State SampledPath::GetArrival(double time) const
{
  const vtkIdType sample = std::min(this->CountBefore(time), this->Count - 1);
  return this->GetTime(sample) > time && sample > 0 ? this->Interpolate(sample - 1, time)
                                                    : this->GetSample(sample);
}

SampledPath::State SampledPath::GetDeparture(double time) const
{
  const vtkIdType sample = std::max<vtkIdType>(this->CountUntil(time) - 1, 0);
  return this->GetTime(sample) < time && sample + 1 < this->Count ? this->Interpolate(sample, time)
                                                                  : this->GetSample(sample);
}

// Interpolates between a sample and the next, later one.
SampledPath::State SampledPath::Interpolate(vtkIdType sample, double time) const
{
  const State a = this->GetSample(sample);
  const State b = this->GetSample(sample + 1);
  const double step = b.Time - a.Time;
  const double s = (time - a.Time) / step;
  State state{ time, a.Position + s * (b.Position - a.Position),
    a.Orientation.Slerp(s, b.Orientation).Normalized(), { 0.0, 0.0, 0.0 } };
  if (this->IsCubic)
  {
    const Vec3 way = b.Position - a.Position;
    const Vec3 from = step * a.Velocity - way; // deviation of the ends from the straight line
    const Vec3 to = step * b.Velocity - way;
    state.Position = state.Position + s * (1.0 - s) * ((1.0 - s) * from - s * to);
    state.Velocity =
      (1.0 / step) * (way + (1.0 - s) * (1.0 - 3.0 * s) * from - s * (2.0 - 3.0 * s) * to);
  }
  return state;
}

} // namespace helios
