// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosSbetEncoder.h"

#include "heliosPose.h"
#include "vtkHeliosArrayNames.h"

#include <algorithm>
#include <cmath>

namespace helios
{

namespace
{

constexpr double LockedCosine = 1e-9; // cosine of the pitch at gimbal lock

Vec3 GetVector(const Column& column, vtkIdType row)
{
  return { column.GetNumber(row, 0), column.GetNumber(row, 1), column.GetNumber(row, 2) };
}

/// Returns the velocity of a row: of the array, else of the neighbours in the block.
Vec3 FindVelocity(const SbetSamples& samples, vtkIdType row)
{
  if (samples.Velocities.IsSet())
  {
    return GetVector(samples.Velocities, row);
  }
  const vtkIdType a = std::max<vtkIdType>(row - 1, 0);
  const vtkIdType b = std::min<vtkIdType>(row + 1, samples.Count - 1);
  const double dt = samples.Times.GetNumber(b) - samples.Times.GetNumber(a);
  const Vec3 way = GetVector(samples.Points, b) - GetVector(samples.Points, a);
  return dt > 0.0 ? (1.0 / dt) * way : Vec3(0.0, 0.0, 0.0);
}

/// Sets roll, pitch, true heading of an attitude relative to east, north, up; see FromNavigation().
void SetAngles(const Rotation& attitude, SbetRecord& record)
{
  const auto& m = attitude.M;
  const double cosPitch = std::hypot(m[0][1], m[1][1]);
  const bool isLocked = cosPitch < LockedCosine;
  const double heading = isLocked ? std::atan2(-m[1][0], m[0][0]) : std::atan2(m[0][1], m[1][1]);
  record[SbetRoll] = isLocked ? 0.0 : std::atan2(-m[2][0], m[2][2]);
  record[SbetPitch] = std::atan2(m[2][1], cosPitch);
  record[SbetHeading] = heading < 0.0 ? heading + 2.0 * vtkMath::Pi() : heading;
}

Rotation Transpose(const double m[3][3])
{
  Rotation r;
  for (int i = 0; i < 3; ++i)
  {
    for (int j = 0; j < 3; ++j)
    {
      r.M[i][j] = m[j][i];
    }
  }
  return r;
}

} // namespace

//------------------------------------------------------------------------------
Status SbetEncoder::SetSystems(const std::string& crs, const std::string& fileCrs)
{
  if (crs == this->Crs && !crs.empty())
  {
    return {};
  }
  if (crs.empty())
  {
    return Status::Error("the block has no field data CRS, and CRS is not set; give the system of "
                         "its points, such as CRS EPSG:32632");
  }
  CoordinateSystem from, to;
  if (const Status status = from.Set(crs); !status.IsOk())
  {
    return Status::Error("CRS " + status.Message());
  }
  if (const Status status = to.Set(fileCrs); !status.IsOk())
  {
    return Status::Error("FileCRS " + status.Message());
  }
  if (!to.IsGeographic())
  {
    return Status::Error("FileCRS is " + to.GetName() +
      "; give a geographic system, since SBET has latitudes and longitudes");
  }
  Status status = this->Transform.Set(from, to);
  status = status.IsOk() ? this->Inverse.Set(to, from) : status;
  this->Crs = status.IsOk() ? crs : std::string();
  return status;
}

//------------------------------------------------------------------------------
Status SbetEncoder::EncodeRow(const SbetSamples& samples, vtkIdType row, SbetRecord& record)
{
  const Vec3 point = GetVector(samples.Points, row);
  double q[4];
  for (int i = 0; i < 4; ++i)
  {
    q[i] = samples.Orientations.GetNumber(row, i);
  }
  const double length = Quaternion(q).Norm();
  const double time = samples.Times.GetNumber(row);
  if (!std::isfinite(time) || !std::isfinite(length) || !(length > 0.0))
  {
    return Status::Error("its time or orientation is not finite, or the orientation is 0; give "
                         "finite times and unit quaternions");
  }
  if (this->HasTime && !(time > this->LastTime))
  {
    return Status::Error(std::string(vtkHeliosArrayNames::GpsTime) + " is " + PrintExactly(time) +
      " s, not after that of the sample before, " + PrintExactly(this->LastTime) +
      " s; SBET times increase: write the samples in order, and legs that jump to files of their "
      "own");
  }
  double geographic[3];
  double toMap[3][3];
  if (this->Transform.Forward(point.GetData(), geographic, 1) >= 0 ||
    !this->Inverse.GetRotation(geographic, toMap))
  {
    return Status::Error(this->Transform.DescribeFailure(row, point.GetData()));
  }
  const Rotation fromMap = Transpose(toMap);
  const Vec3 velocity = fromMap * FindVelocity(samples, row);
  record.fill(0.0);
  record[SbetTime] = time;
  record[SbetLatitude] = vtkMath::RadiansFromDegrees(geographic[1]);
  record[SbetLongitude] = vtkMath::RadiansFromDegrees(geographic[0]);
  record[SbetAltitude] = geographic[2];
  record[SbetVelocityX] = velocity[1];
  record[SbetVelocityY] = -velocity[0];
  record[SbetVelocityZ] = velocity[2];
  SetAngles(fromMap * Rotation(Quaternion(q) * (1.0 / length)), record);
  this->HasTime = true;
  this->LastTime = time;
  return {};
}

//------------------------------------------------------------------------------
Status SbetEncoder::Encode(const SbetSamples& samples, std::vector<SbetRecord>& records)
{
  const bool hadTime = this->HasTime;
  const double before = this->LastTime;
  records.resize(static_cast<std::size_t>(samples.Count));
  for (vtkIdType row = 0; row < samples.Count; ++row)
  {
    const Status status = this->EncodeRow(samples, row, records[static_cast<std::size_t>(row)]);
    if (!status.IsOk())
    {
      this->HasTime = hadTime; // nothing of the block is written
      this->LastTime = before;
      return Status::Error("row " + std::to_string(row) + " of a block: " + status.Message());
    }
  }
  return {};
}

} // namespace helios
