// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// The content of a trajectory file, whatever its format.

#ifndef heliosRecordedPath_h
#define heliosRecordedPath_h

#include "heliosPose.h"
#include "heliosTrajectoryRow.h"

#include <string>
#include <vector>

namespace helios
{

struct RecordedPath
{
  std::vector<TrajectoryRow> Rows;   // in order of time
  std::vector<Quaternion> Attitudes; // body to world, one per row; empty: rows have angles
  std::vector<Vec3> Velocities;      // [m/s], one per row; empty: none in the file
  std::string Crs;                   // system of the positions; empty: unknown
};

} // namespace helios

#endif
