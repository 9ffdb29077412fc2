// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosTrajectoryRow.h"

#include "heliosRecordTimes.h"

namespace helios
{

bool CheckRowTimes(const std::vector<TrajectoryRow>& rows,
  const std::function<std::string(std::size_t)>& getPlace, TextReport& report)
{
  const TimeFinding finding =
    CheckRecordTimes({ rows.size(), [&rows](std::size_t i) { return rows[i].Time; },
      [&rows](std::size_t i) { return rows[i].Position; } });
  if (!finding.Message.empty() && !finding.IsError)
  {
    report.Warn(getPlace(finding.Row) + finding.Message);
  }
  return !finding.IsError || report.Fail(getPlace(finding.Row) + finding.Message);
}

} // namespace helios
