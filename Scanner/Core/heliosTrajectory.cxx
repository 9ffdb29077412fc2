// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosTrajectory.h"

#include "vtkHeliosArrayNames.h"

#include <vtkDataArray.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>

#include <algorithm>
#include <cmath>

namespace helios
{
namespace names = vtkHeliosArrayNames;

std::string Trajectory::Set(vtkPolyData* trajectory)
{
  *this = Trajectory();
  const vtkIdType count = trajectory ? trajectory->GetNumberOfPoints() : 0;
  if (count == 0)
  {
    return "the trajectory has no points; a platform filter makes one from waypoints";
  }
  vtkPointData* data = trajectory->GetPointData();
  vtkDataArray* times = data->GetArray(names::GpsTime);
  vtkDataArray* orientations = data->GetArray(names::Orientation);
  if (count > 1 && !times)
  {
    return std::string("the trajectory has no point array ") + names::GpsTime;
  }
  if (orientations && orientations->GetNumberOfComponents() != 4)
  {
    return std::string("the array ") + names::Orientation +
      " of the trajectory needs 4 components: w, x, y, z";
  }
  for (vtkIdType i = 0; i < count; ++i)
  {
    double p[3];
    double q[4] = { 1.0, 0.0, 0.0, 0.0 };
    trajectory->GetPoint(i, p);
    if (orientations)
    {
      orientations->GetTuple(i, q);
    }
    const double time = times ? times->GetComponent(i, 0) : 0.0;
    const double norm = std::sqrt(q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3]);
    if (!std::isfinite(time + p[0] + p[1] + p[2]) || !(std::abs(norm - 1.0) < 1e-6))
    {
      return "sample " + std::to_string(i) +
        " of the trajectory is not finite, or its orientation no unit quaternion";
    }
    if (i > 0 && time < this->Times.back())
    {
      return "the times of the trajectory go back at sample " + std::to_string(i);
    }
    this->Times.push_back(time);
    this->Positions.emplace_back(p);
    this->Orientations.emplace_back(q[0] / norm, q[1] / norm, q[2] / norm, q[3] / norm);
  }
  return {};
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
  const bool holds = i + 1 == this->Times.size() || time <= this->Times[i];
  if (holds)
  {
    return this->Positions[i];
  }
  const double s = (time - this->Times[i]) / (this->Times[i + 1] - this->Times[i]);
  if (this->Orientations[i] != this->Orientations[i + 1])
  {
    attitude = Rotation(this->Orientations[i].Slerp(s, this->Orientations[i + 1]));
  }
  return this->Positions[i] + s * (this->Positions[i + 1] - this->Positions[i]);
}

} // namespace helios
