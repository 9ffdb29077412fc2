// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosTrajectory.h"

#include "heliosFloatCoordinates.h"
#include "heliosStatus.h"
#include "vtkHeliosArrayNames.h"

#include <vtkDataArray.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>

#include <algorithm>
#include <cmath>

namespace helios
{
namespace names = vtkHeliosArrayNames;

namespace
{

/// Checks the arrays of a trajectory.
Status CheckArrays(vtkPolyData* trajectory)
{
  const vtkIdType count = trajectory ? trajectory->GetNumberOfPoints() : 0;
  if (count == 0)
  {
    return Status::Error(
      "the trajectory has no points; a platform filter makes one from waypoints");
  }
  vtkPointData* data = trajectory->GetPointData();
  if (count > 1 && !data->GetArray(names::GpsTime))
  {
    return Status::Error(std::string("the trajectory has no point array ") + names::GpsTime);
  }
  vtkDataArray* orientations = data->GetArray(names::Orientation);
  if (orientations && orientations->GetNumberOfComponents() != 4)
  {
    return Status::Error(std::string("the array ") + names::Orientation +
      " of the trajectory needs 4 components: w, x, y, z");
  }
  vtkDataArray* velocities = data->GetArray(names::Velocity);
  if (velocities && velocities->GetNumberOfComponents() != 3)
  {
    return Status::Error(std::string("the array ") + names::Velocity +
      " of the trajectory needs 3 components: x, y, z");
  }
  return CheckFloatCoordinates(trajectory->GetPoints()->GetData(), "the trajectory");
}

} // namespace

Status Trajectory::Set(vtkPolyData* trajectory)
{
  *this = Trajectory();
  Status status = CheckArrays(trajectory);
  const vtkIdType count = status.IsOk() ? trajectory->GetNumberOfPoints() : 0;
  for (vtkIdType i = 0; i < count && status.IsOk(); ++i)
  {
    status = this->Append(trajectory, i);
  }
  this->Connect();
  return status;
}

Status Trajectory::SetLeg(vtkPolyData* trajectory, int leg)
{
  *this = Trajectory();
  Status status = CheckArrays(trajectory);
  const vtkIdType count = status.IsOk() ? trajectory->GetNumberOfPoints() : 0;
  vtkDataArray* legs = count > 0 ? trajectory->GetPointData()->GetArray(names::LegIds) : nullptr;
  for (vtkIdType i = 0; i < count && status.IsOk(); ++i)
  {
    if (legs && legs->GetTuple1(i) == static_cast<double>(leg))
    {
      status = this->Append(trajectory, i);
    }
  }
  if (status.IsOk() && this->Times.empty())
  {
    return Status::Error("the trajectory has no samples of leg " + std::to_string(leg));
  }
  this->Connect();
  return status;
}

Status Trajectory::Append(vtkPolyData* trajectory, vtkIdType sample)
{
  vtkPointData* data = trajectory->GetPointData();
  vtkDataArray* times = data->GetArray(names::GpsTime);
  double p[3];
  double q[4] = { 1.0, 0.0, 0.0, 0.0 };
  double v[3] = { 0.0, 0.0, 0.0 };
  trajectory->GetPoint(sample, p);
  if (vtkDataArray* orientations = data->GetArray(names::Orientation))
  {
    orientations->GetTuple(sample, q);
  }
  if (vtkDataArray* velocities = data->GetArray(names::Velocity))
  {
    velocities->GetTuple(sample, v);
    this->Velocities.emplace_back(v);
  }
  const double time = times ? times->GetComponent(sample, 0) : 0.0;
  const double norm = std::sqrt(q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3]);
  if (!std::isfinite(time + p[0] + p[1] + p[2] + v[0] + v[1] + v[2]) ||
    !(std::abs(norm - 1.0) < 1e-6))
  {
    return Status::Error("sample " + std::to_string(sample) +
      " of the trajectory is not finite, or its orientation is not a unit quaternion");
  }
  if (!this->Times.empty() && time < this->Times.back())
  {
    return Status::Error(
      "the times of the trajectory decrease at sample " + std::to_string(sample));
  }
  this->Times.push_back(time);
  this->Positions.emplace_back(p);
  this->Orientations.emplace_back(q[0] / norm, q[1] / norm, q[2] / norm, q[3] / norm);
  return {};
}

void Trajectory::Connect()
{
  for (std::size_t i = 0; i + 1 < this->Times.size(); ++i)
  {
    const Vec3& p0 = this->Positions[i];
    const Vec3& p1 = this->Positions[i + 1];
    this->Segments.push_back(this->Velocities.empty()
        ? HermiteSegment(p0, p1)
        : HermiteSegment(this->Times[i], p0, this->Velocities[i], this->Times[i + 1], p1,
            this->Velocities[i + 1]));
  }
  this->Velocities = {};
}

std::size_t Trajectory::FindSample(double time, std::size_t hint) const
{
  const std::size_t last = this->Times.size() - 1;
  if (hint < last && this->Times[hint] <= time && time < this->Times[hint + 1])
  {
    return hint;
  }
  const auto after = std::upper_bound(this->Times.begin(), this->Times.end(), time);
  return after == this->Times.begin() ? 0
                                      : static_cast<std::size_t>(after - this->Times.begin()) - 1;
}

Vec3 Trajectory::GetPosition(double time, Cursor& cursor, Rotation& attitude) const
{
  const std::size_t i = this->FindSample(time, cursor.Sample);
  if (!cursor.Valid || cursor.Sample != i)
  {
    cursor.Sample = i;
    cursor.Valid = true;
    cursor.Attitude = Rotation(this->Orientations[i]);
  }
  attitude = cursor.Attitude;
  if (this->HoldsAt(i, time))
  {
    return this->Positions[i];
  }
  const double s = this->GetFraction(i, time);
  if (this->RotatesAfter(i))
  {
    attitude = Rotation(this->Orientations[i].Slerp(s, this->Orientations[i + 1]));
  }
  return this->Segments[i](s);
}

Pose Trajectory::GetPose(double time) const
{
  const std::size_t i = this->FindSample(time, 0);
  if (this->HoldsAt(i, time))
  {
    return { this->Positions[i], this->Orientations[i] };
  }
  const double s = this->GetFraction(i, time);
  return { this->Segments[i](s),
    this->RotatesAfter(i) ? this->Orientations[i].Slerp(s, this->Orientations[i + 1])
                          : this->Orientations[i] };
}

Trajectory::Rates Trajectory::GetRatesAfter(std::size_t sample, double s) const
{
  const double step = this->Times[sample + 1] - this->Times[sample];
  Rates rates{ (1.0 / step) * this->Segments[sample].GetSlope(s), { 0.0, 0.0, 0.0 } };
  if (this->RotatesAfter(sample))
  {
    Quaternion turn = this->Orientations[sample + 1] * this->Orientations[sample].Conjugated();
    const Vec3 axis(turn.GetX(), turn.GetY(), turn.GetZ());
    const double sine = axis.Norm();
    const double sign = turn.GetW() < 0.0 ? -1.0 : 1.0; // the shorter way
    const double angle = 2.0 * std::atan2(sine, sign * turn.GetW());
    rates.Rotation = sine > 0.0 ? sign * angle / (sine * step) * axis : rates.Rotation;
  }
  return rates;
}

Trajectory::Rates Trajectory::GetRates(double time) const
{
  const std::size_t i = this->FindSample(time, 0);
  const bool isOutside = i + 1 == this->Times.size() || time < this->Times[i];
  return isOutside ? Rates() : this->GetRatesAfter(i, this->GetFraction(i, time));
}

void Trajectory::GetBounds(double start, double end, double& speed, double& rotation) const
{
  speed = 0.0;
  rotation = 0.0;
  for (std::size_t i = this->FindSample(start, 0); i + 1 < this->Times.size(); ++i)
  {
    if (this->Times[i] > end)
    {
      break;
    }
    const double step = this->Times[i + 1] - this->Times[i];
    if (step > 0.0)
    {
      speed = std::max(speed, this->Segments[i].GetSteepest() / step);
      rotation = std::max(rotation, this->GetRatesAfter(i, 0.0).Rotation.Norm());
    }
  }
}

bool Trajectory::RotatesAfter(std::size_t sample) const
{
  return this->Interpolates && this->Orientations[sample] != this->Orientations[sample + 1];
}

bool Trajectory::HoldsAt(std::size_t sample, double time) const
{
  return sample + 1 == this->Times.size() || time <= this->Times[sample];
}

double Trajectory::GetFraction(std::size_t sample, double time) const
{
  return (time - this->Times[sample]) / (this->Times[sample + 1] - this->Times[sample]);
}

} // namespace helios
