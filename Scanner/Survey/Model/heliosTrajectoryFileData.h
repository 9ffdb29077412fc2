// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// A trajectory in a file, of a platform or of a part of the scene.

#ifndef heliosTrajectoryFileData_h
#define heliosTrajectoryFileData_h

#include <limits>
#include <string>

namespace helios
{

/// The format of a trajectory file, as in vtkHeliosTrajectoryReader.
enum class TrajectoryFileFormat
{
  Automatic, ///< by the ending of its name
  Columns,
  Sbet,
  Tum,
  Euroc
};

/// The axes x, y, z of a body in a trajectory file, as in vtkHeliosTrajectoryReader.
enum class BodyFrame
{
  RightForwardUp,
  ForwardLeftUp,
  ForwardRightDown
};

/// The order and signs of roll, pitch and yaw, as in vtkHeliosTrajectoryReader.
enum class AngleConvention
{
  Arinc705,
  Canonical,
  Navigation
};

/// A trajectory in a file, and the section used by a leg.
struct TrajectoryFileData
{
  static constexpr double NotGiven = std::numeric_limits<double>::quiet_NaN();

  std::string Where;
  std::string File;
  TrajectoryFileFormat Format = TrajectoryFileFormat::Automatic;
  std::string Crs;                            ///< system of SBET positions; empty: WGS 84
  BodyFrame Body = BodyFrame::RightForwardUp; ///< frame of TUM and EuRoC
  std::string Separator = ",";
  int Columns[7] = { -1, -1, -1, -1, -1, -1, -1 }; ///< t, roll, pitch, yaw, x, y, z; -1: not given
  bool IsInRadians = false;
  bool HasAttitude = true;
  bool KeepsTime = false;      ///< else time starts at 0
  double SlopeThreshold = 0.0; ///< 0: every sample is kept
  double StartTime = NotGiven; ///< [s]
  double EndTime = NotGiven;   ///< [s]
  bool TeleportsToStart = false;
};

} // namespace helios

#endif
