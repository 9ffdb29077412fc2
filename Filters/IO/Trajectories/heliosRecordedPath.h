// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// The content of a trajectory file, whatever its format.

#ifndef heliosRecordedPath_h
#define heliosRecordedPath_h

#include "heliosPose.h"
#include "heliosTrajectoryParser.h"

#include <functional>
#include <sstream>
#include <string>
#include <vector>

namespace helios
{

struct RecordedPath
{
  std::vector<TrajectoryRow> Rows;   // in order of time
  std::vector<Quaternion> Attitudes; // body to world, one per row; empty: rows have angles
  std::vector<Vec3> Velocities;      // [m/s], one per row; empty: none in the file
  std::string Crs;                   // of the positions; empty: unknown
};

/// Checks the times of rows; getPlace gives that of a row, as "file:line: ".
bool CheckRowTimes(const std::vector<TrajectoryRow>& rows,
  const std::function<std::string(std::size_t)>& getPlace, TextReport& report);

/// A number with all its digits, for messages.
inline std::string PrintExactly(double number)
{
  std::ostringstream text;
  text.precision(17);
  text << number;
  return text.str();
}

} // namespace helios

#endif
