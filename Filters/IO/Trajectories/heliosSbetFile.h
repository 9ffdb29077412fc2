// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Reads SBET files: smoothed best estimates of a trajectory.

#ifndef heliosSbetFile_h
#define heliosSbetFile_h

#include "heliosCoordinateSystem.h"
#include "heliosCoordinateTransform.h"
#include "heliosRecordTimes.h"
#include "heliosRecordedPath.h"
#include "heliosStatus.h"

#include <array>
#include <cstddef>
#include <functional>
#include <string>
#include <string_view>

namespace helios
{

/// The numbers of a record, all double, little-endian. Velocities are in the wander-azimuth frame
/// (north, west, up at wander angle 0).
enum SbetField : std::size_t
{
  SbetTime,      // [s]
  SbetLatitude,  // [rad]
  SbetLongitude, // [rad]
  SbetAltitude,  // [m] above the ellipsoid
  SbetVelocityX, // [m/s]
  SbetVelocityY,
  SbetVelocityZ,
  SbetRoll,    // [rad] right side down
  SbetPitch,   // [rad] nose up
  SbetHeading, // [rad] clockwise from the x axis of the wander-azimuth frame
  SbetWander,  // [rad] true heading = heading - wander angle
  SbetAccelerationX,
  SbetAccelerationY,
  SbetAccelerationZ,
  SbetRateX,
  SbetRateY,
  SbetRateZ,
  SbetFieldCount
};

using SbetRecord = std::array<double, SbetFieldCount>;
constexpr std::int64_t SbetRecordSize = sizeof(SbetRecord);

/// Reads the records of a file, checks them, and projects positions and attitudes.
class SbetReader
{
public:
  explicit SbetReader(std::string path)
    : Path(std::move(path))
  {
  }

  /// Runs after every block with the fraction of the file read; false stops reading.
  std::function<bool(double)> OnBlock;

  /**
   * Reads all records. The file's positions are in the system named by fileCrs; the rows are in
   * that named by targetCrs (empty: the UTM zone, on WGS 84, of the first record).
   */
  Status Read(const std::string& fileCrs, const std::string& targetCrs, RecordedPath& path,
    TextReport& report);

private:
  void WarnOfEpoch(const SbetRecord& record, TextReport& report);
  Status SetSystems(const std::string& fileCrs, const std::string& targetCrs, const SbetRecord& r);
  Status Check(const SbetRecord& record) const;
  std::string MakePlace(std::int64_t record) const;
  Status Add(const SbetRecord& record, RecordedPath& path);
  Status Fail(const std::string& message) const;

  std::string Path;
  std::int64_t Index = 0; // index of the record
  double LastTime = 0.0;  // time of the previous record
  RecordClock Clock;
  CoordinateSystem Target; // set with the first record
  CoordinateTransform Transform;
};

} // namespace helios

#endif
