// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// A row of a trajectory file, and checks of the times of all.

#ifndef heliosTrajectoryRow_h
#define heliosTrajectoryRow_h

#include "heliosPose.h"
#include "heliosTextFile.h"

#include <cstdint>
#include <functional>
#include <sstream>
#include <string>
#include <vector>

namespace helios
{

struct TrajectoryRow
{
  double Time;
  Vec3 Position;
  Vec3 Angles; // roll, pitch, yaw as in the file
  std::int64_t LineStart;
};

/// Checks the times of rows; getPlace returns the place of a row: "file:line: ".
bool CheckRowTimes(const std::vector<TrajectoryRow>& rows,
  const std::function<std::string(std::size_t)>& getPlace, TextReport& report);

/// Returns a number with all its digits, for messages.
inline std::string PrintExactly(double number)
{
  std::ostringstream text;
  text.precision(17);
  text << number;
  return text.str();
}

} // namespace helios

#endif
