// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Reads text files of poses with quaternions: TUM and EuRoC.

#ifndef heliosPoseText_h
#define heliosPoseText_h

#include "heliosLineFile.h"
#include "heliosRecordTimes.h"
#include "heliosRecordedPath.h"
#include "heliosTextFile.h"
#include "heliosTextRow.h"

#include <string_view>

namespace helios
{

/// The columns of a format.
struct PoseColumns
{
  const char* Name;
  const char* Separators;
  const char* Order;
  double TimeUnit; // [s]
  int W;           // the column of w; x, y, z are in FirstOfVector to FirstOfVector + 2
  int FirstOfVector;
};

/// "t x y z qx qy qz qw", t in seconds.
inline constexpr PoseColumns TumColumns = { "TUM", " ", "t x y z qx qy qz qw", 1.0, 7, 4 };
/// "t,x,y,z,qw,qx,qy,qz ...", t in nanoseconds; further columns are not read.
inline constexpr PoseColumns EurocColumns = { "EuRoC", ",", "t,x,y,z,qw,qx,qy,qz", 1e-9, 4, 5 };

class PoseTextParser
{
public:
  PoseTextParser(const PoseColumns& columns, TextReport& report);

  /// Reads all rows of a file, times increasing; false after an error.
  bool Read(LineFile& file, RecordedPath& path);

private:
  bool ReadRow(std::string_view line, RecordedPath& path);
  bool AddPose(RecordedPath& path);
  bool Fail(const std::string& message);

  const PoseColumns& Columns;
  TextReport& Report;
  TextRow Row;
  RecordClock Clock;
  LineFile* File = nullptr;
};

} // namespace helios

#endif
