// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosSbetFile.h"

#include "heliosLineFile.h"
#include "heliosMapProjection.h"
#include "heliosTrajectoryShape.h"

#include <vtkMath.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <vector>

#if defined(__BYTE_ORDER__) && __BYTE_ORDER__ != __ORDER_LITTLE_ENDIAN__
#error "SBET files are little-endian"
#endif

namespace helios
{

namespace
{

constexpr std::size_t RecordsPerBlock = 8192;

struct FieldName
{
  SbetField Field;
  const char* Name;
};
/// The fields that are read.
constexpr FieldName ReadFields[] = { { SbetTime, "time" }, { SbetLatitude, "latitude" },
  { SbetLongitude, "longitude" }, { SbetAltitude, "altitude" }, { SbetVelocityX, "velocity x" },
  { SbetVelocityY, "velocity y" }, { SbetVelocityZ, "velocity z" }, { SbetRoll, "roll" },
  { SbetPitch, "pitch" }, { SbetHeading, "platform heading" }, { SbetWander, "wander angle" } };

Quaternion FromMatrix(const double m[3][3])
{
  Quaternion q;
  q.FromMatrix3x3(m);
  return q;
}

/// Returns the velocity in east, north, up of a record, whose x and y are turned by the wander
/// angle, y to the left.
Vec3 GetVelocity(const SbetRecord& record)
{
  const double c = std::cos(record[SbetWander]);
  const double s = std::sin(record[SbetWander]);
  const double x = record[SbetVelocityX];
  const double right = -record[SbetVelocityY];
  return { c * right - s * x, c * x + s * right, record[SbetVelocityZ] };
}

Vec3 ToTarget(const double m[3][3], const Vec3& v)
{
  const auto row = [&](int i) { return m[i][0] * v[0] + m[i][1] * v[1] + m[i][2] * v[2]; };
  return { row(0), row(1), row(2) };
}

/// Checks that the size is a positive number of whole records.
Status CheckSize(const std::string& path, std::int64_t size)
{
  const std::int64_t rest = size % SbetRecordSize;
  if (size == 0)
  {
    return Status::Error(path + ": is empty; give an SBET file with records of 136 bytes");
  }
  if (rest != 0)
  {
    const std::int64_t whole = size - rest;
    return Status::Error(path + ": has " + std::to_string(size) +
      " bytes, no whole number of SBET records of 136 bytes; it ends within record " +
      std::to_string(size / SbetRecordSize) + ", which starts at byte " + std::to_string(whole) +
      "; copy the complete file again, or truncate it to " + std::to_string(whole) + " bytes");
  }
  return {};
}

} // namespace

//------------------------------------------------------------------------------
Status SbetReader::Fail(const std::string& message) const
{
  return Status::Error(this->MakePlace(this->Index) + message);
}

//------------------------------------------------------------------------------
std::string SbetReader::MakePlace(std::int64_t record) const
{
  return this->Path + ", record " + std::to_string(record) + " (byte " +
    std::to_string(record * SbetRecordSize) + "): ";
}

//------------------------------------------------------------------------------
Status SbetReader::Check(const SbetRecord& record) const
{
  for (const FieldName& field : ReadFields)
  {
    if (!std::isfinite(record[field.Field]))
    {
      return this->Fail(std::string(field.Name) + " is " + PrintExactly(record[field.Field]) +
        "; give finite numbers, or remove the record");
    }
  }
  const double pi = vtkMath::Pi();
  const double latitude = record[SbetLatitude];
  const double longitude = record[SbetLongitude];
  if (std::abs(latitude) > 0.5 * pi)
  {
    return this->Fail("latitude is " + PrintExactly(latitude) +
      ", outside [-pi/2, pi/2]; SBET has angles in radians, little-endian");
  }
  if (std::abs(longitude) > 2.0 * pi)
  {
    return this->Fail("longitude is " + PrintExactly(longitude) +
      ", outside [-2 pi, 2 pi]; SBET has angles in radians, little-endian");
  }
  if (this->Index > 0 && !(record[SbetTime] > this->LastTime))
  {
    return this->Fail("time is " + PrintExactly(record[SbetTime]) +
      " s, not after that of the record "
      "before, " +
      PrintExactly(this->LastTime) + " s; split the file there, or remove the record");
  }
  return {};
}

//------------------------------------------------------------------------------
Status SbetReader::SetSystems(
  const std::string& fileCrs, const std::string& targetCrs, const SbetRecord& record)
{
  const double first[3] = { vtkMath::DegreesFromRadians(record[SbetLongitude]),
    vtkMath::DegreesFromRadians(record[SbetLatitude]), record[SbetAltitude] };
  CoordinateSystem source;
  if (const Status status = source.Set(fileCrs); !status.IsOk())
  {
    return Status::Error("FileCRS " + status.Message());
  }
  if (!source.IsGeographic())
  {
    return Status::Error("FileCRS is " + source.GetName() +
      "; give a geographic system, since SBET has latitudes and longitudes");
  }
  const std::string utm = "EPSG:" + std::to_string(GetUTMCode(first[1], first[0]));
  if (const Status status = this->Target.Set(targetCrs.empty() ? utm : targetCrs); !status.IsOk())
  {
    return Status::Error("TargetCRS " + status.Message());
  }
  double point[3];
  std::copy_n(first, 3, point);
  if (const Status status = CheckMetric(this->Target, point); !status.IsOk())
  {
    return Status::Error("TargetCRS " + status.Message());
  }
  return this->Transform.Set(source, this->Target);
}

//------------------------------------------------------------------------------
/// Warns that positions which move with the epoch have an unknown one: records have seconds of a
/// week.
void SbetReader::WarnOfEpoch(const SbetRecord& record, TextReport& report)
{
  const double first[3] = { vtkMath::DegreesFromRadians(record[SbetLongitude]),
    vtkMath::DegreesFromRadians(record[SbetLatitude]), record[SbetAltitude] };
  const std::string warning = this->Transform.GetEpochWarning(first);
  if (!warning.empty())
  {
    report.Warn(this->Path + ": " + warning +
      ": convert the trajectory before, or name the datum of the scene as its system (FileCRS)");
  }
}

//------------------------------------------------------------------------------
/// Appends a record in the target system; the rotation contains the meridian convergence.
Status SbetReader::Add(const SbetRecord& record, RecordedPath& path)
{
  const double geographic[3] = { vtkMath::DegreesFromRadians(record[SbetLongitude]),
    vtkMath::DegreesFromRadians(record[SbetLatitude]), record[SbetAltitude] };
  TrajectoryRow row{};
  row.Time = record[SbetTime];
  double rotation[3][3];
  if (this->Transform.Forward(geographic, row.Position.GetData(), 1) >= 0 ||
    !this->Transform.GetRotation(geographic, rotation))
  {
    return this->Fail(this->Transform.DescribeFailure(this->Index, geographic));
  }
  path.Rows.push_back(row);
  path.Velocities.push_back(ToTarget(rotation, GetVelocity(record)));
  path.Attitudes.push_back(FromMatrix(rotation) *
    FromNavigation(
      { record[SbetRoll], record[SbetPitch], record[SbetHeading] - record[SbetWander] }));
  return {};
}

//------------------------------------------------------------------------------
Status SbetReader::Read(
  const std::string& fileCrs, const std::string& targetCrs, RecordedPath& path, TextReport& report)
{
  InputFile file;
  std::int64_t size = 0;
  Status status = OpenInput(this->Path, file, size);
  status = status.IsOk() ? CheckSize(this->Path, size) : status;
  std::vector<SbetRecord> block(RecordsPerBlock);
  const std::int64_t count = size / SbetRecordSize;
  for (this->Index = 0; status.IsOk() && this->Index < count;)
  {
    const std::size_t read = std::fread(block.data(), SbetRecordSize, block.size(), file.get());
    if (read == 0)
    {
      return this->Fail("cannot be read: the file became shorter; read it again when complete");
    }
    for (std::size_t k = 0; status.IsOk() && k < read && this->Index < count; ++k)
    {
      SbetRecord& record = block[k];
      record[SbetTime] = this->Clock.Continue(record[SbetTime]);
      if (this->Clock.IsFirstContinued())
      {
        report.Warn(this->MakePlace(this->Index) + this->Clock.DescribeEnd());
      }
      status = this->Check(record);
      if (status.IsOk() && this->Index == 0)
      {
        status = this->SetSystems(fileCrs, targetCrs, record);
        status = status.IsOk() ? status : Status::Error(this->Path + ": " + status.Message());
        this->WarnOfEpoch(record, report);
        path.Rows.reserve(static_cast<std::size_t>(count));
        path.Attitudes.reserve(static_cast<std::size_t>(count));
        path.Velocities.reserve(static_cast<std::size_t>(count));
      }
      status = status.IsOk() ? this->Add(record, path) : status;
      this->LastTime = record[SbetTime];
      this->Index += status.IsOk();
    }
    const double fraction = static_cast<double>(this->Index) / static_cast<double>(count);
    if (status.IsOk() && this->OnBlock && !this->OnBlock(fraction))
    {
      return this->Fail("reading was aborted here; update again to read it");
    }
  }
  const auto isZero = [](const Vec3& v) { return v.SquaredNorm() == 0.0; };
  if (std::all_of(path.Velocities.begin(), path.Velocities.end(), isZero))
  {
    path.Velocities.clear(); // programs without velocities write zeros
  }
  path.Crs = this->Target.IsSet() ? this->Target.GetText() : std::string();
  const auto getPlace = [this](std::size_t i)
  { return this->MakePlace(static_cast<std::int64_t>(i)); };
  return status.IsOk() && !CheckRowTimes(path.Rows, getPlace, report) ? Status::Error(report.Error)
                                                                      : status;
}

} // namespace helios
