// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// The times of a recorded trajectory: continued over the end of a week or day, and checked.

#ifndef heliosRecordTimes_h
#define heliosRecordTimes_h

#include "heliosPose.h"
#include "vtkHeliosFiltersCoreModule.h" // For export macro

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

namespace helios
{

/// Returns the period [s], of a GPS week or a day, that ends between two consecutive times; 0:
/// none.
VTKHELIOSFILTERSCORE_EXPORT double FindEndedPeriod(double before, double time);

/// Returns "a GPS week" or "a day".
VTKHELIOSFILTERSCORE_EXPORT std::string NamePeriod(double period);

/// Continues the times of the rows of a file, in their order there, over ends of weeks or days.
class VTKHELIOSFILTERSCORE_EXPORT RecordClock
{
public:
  /// Returns the time of the next row [s], continued.
  double Continue(double time);

  /// Returns whether the last row is the first one that was continued: it needs a warning.
  bool IsFirstContinued() const { return this->NumberOfEnds == 1 && this->IsEnd; }

  /// Returns the warning about the last row.
  std::string DescribeEnd() const;

private:
  double Last = 0.0; // last time in the file
  double Before = 0.0;
  double Offset = 0.0;
  double Period = 0.0; // the last one that ended
  bool HasLast = false;
  bool IsEnd = false;
  std::size_t NumberOfEnds = 0;
};

/// Finding about the times of rows.
struct TimeFinding
{
  std::size_t Row = 0; ///< counted from 0
  std::string Message; ///< empty: nothing
  bool IsError = false;
};

/// The rows of a trajectory in order of time.
struct TimedRows
{
  std::size_t Count = 0;
  std::function<double(std::size_t)> GetTime;   ///< [s]
  std::function<Vec3(std::size_t)> GetPosition; ///< [m]
};

/**
 * Finds, in times that do not decrease, times that cannot be seconds or are of two clocks (errors),
 * steps that look like milliseconds, and missing rows (warnings).
 */
VTKHELIOSFILTERSCORE_EXPORT TimeFinding CheckRecordTimes(const TimedRows& rows);

} // namespace helios

#endif
