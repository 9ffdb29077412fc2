// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Reads the error report of a GNSS/IMU solution.

#ifndef heliosErrorReport_h
#define heliosErrorReport_h

#include "heliosStatus.h"

#include <array>
#include <cstdint>
#include <string>

namespace helios
{

/// Quadratic means of the rows: east, north, up [m], pitch, roll, heading [deg].
struct ErrorReport
{
  std::int64_t Rows = 0;
  std::array<double, 6> Squares{}; // sums of squares, in the units of the file

  Status ReadText(const std::string& path);
  Status ReadBinary(const std::string& path);
  double GetRMS(std::size_t component) const;
};

} // namespace helios

#endif
