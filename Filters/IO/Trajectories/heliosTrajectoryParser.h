// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Reads the rows of a trajectory file in order of time.

#ifndef heliosTrajectoryParser_h
#define heliosTrajectoryParser_h

#include "heliosLineFile.h"
#include "heliosRecordTimes.h"
#include "heliosTextFile.h"
#include "heliosTextRow.h"
#include "heliosTrajectoryRow.h"

#include <array>
#include <string>
#include <string_view>
#include <vector>

namespace helios
{

/// Content of a column of a trajectory file, in the default order.
enum TrajectoryColumn : int
{
  TimeOf,
  RollOf,
  PitchOf,
  YawOf,
  XOf,
  YOf,
  ZOf
};

using TrajectoryColumns = std::array<int, 7>;

struct TrajectoryFormat
{
  std::string Separators = ",";
  TrajectoryColumns Columns{ { -1, -1, -1, -1, -1, -1, -1 } }; // -1: not set
  bool HasAttitude = true;
};

/// Reads rows of numbers and the comments that name their columns; every number is checked.
class TrajectoryParser
{
public:
  TrajectoryParser(const TrajectoryFormat& format, TextReport& report)
    : Format(format)
    , Report(report)
    , Row(format.Separators)
  {
  }

  /// Reads all rows of a file, sorted by time; false after an error.
  bool Read(LineFile& file, std::vector<TrajectoryRow>& rows);

private:
  bool ReadComment(std::string_view line);
  bool ReadTimeColumn(std::string_view text);
  bool ReadHeader(std::string_view text);
  bool FindColumns(TrajectoryColumns& columns);
  bool SetColumns();
  bool ReadRow(std::string_view line, std::vector<TrajectoryRow>& rows);
  double ReadTime(double time);
  void Sort(std::vector<TrajectoryRow>& rows);
  bool CheckTimes(const std::vector<TrajectoryRow>& rows);
  bool HasGivenColumns() const;
  bool IsNeeded(int column) const;
  std::string GetPlaceOf(const TrajectoryRow& row);
  bool Fail(const std::string& message);
  bool FailShort();

  const TrajectoryFormat& Format;
  TextReport& Report;
  TextRow Row;
  LineFile* File = nullptr;
  int TimeColumn = -1;      // from the comment
  TrajectoryColumns Header; // from the comment, -1: not named
  bool HasHeader = false;
  bool KnowsColumns = false;
  TrajectoryColumns Columns{};
  RecordClock Clock;
};

} // namespace helios

#endif
