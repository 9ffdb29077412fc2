// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHeliosNavigationReport
 * @brief   the errors that navigation software estimates for a trajectory
 *
 * Reads the error report of a GNSS/IMU solution (Applanix smrmsg): a row per second with the RMS
 * errors of position, velocity and attitude. A text file has a header with the names of its columns,
 * with or without quotes, between commas, in any order: NorthPositionRMS, EastPositionRMS,
 * DownPositionRMS [m], RollRMS, PitchRMS, HeadingRMS [arc minutes]; further columns are not read. A
 * file whose name ends in .out is binary: records of 10 little-endian doubles, time, north, east,
 * down position, north, east, down velocity, roll, pitch, heading.
 *
 * The RMS of the whole trajectory is the quadratic mean of its rows. It is what
 * vtkHeliosPlatformNoise::SetSlowError() takes; reports have no correlation times.
 *
 * Errors: with file:line a row that is too short, numbers that are not finite or negative, a missing
 * column; a file without rows, or cut within a record.
 *
 * @sa
 * vtkHeliosPlatformNoise vtkHeliosTrajectoryReader
 */

#ifndef vtkHeliosNavigationReport_h
#define vtkHeliosNavigationReport_h

#include "vtkHeliosFiltersIOModule.h" // For export macro
#include "vtkObject.h"

#include <string> // For the file

class VTKHELIOSFILTERSIO_EXPORT vtkHeliosNavigationReport : public vtkObject
{
public:
  static vtkHeliosNavigationReport* New();
  vtkTypeMacro(vtkHeliosNavigationReport, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * Reads a file. Returns false after an error; the RMS are then 0.
   */
  bool Read(const std::string& fileName);

  /**
   * Get the number of rows of the file.
   */
  vtkGetMacro(NumberOfRows, vtkIdType);

  /**
   * Returns the RMS of a component, numbered as in vtkHeliosPlatformNoise: 0 to 2 east, north, up
   * [m]; 3 to 5 pitch, roll, heading [deg]. NaN for other numbers.
   */
  double GetRMS(int component) const;

protected:
  vtkHeliosNavigationReport() = default;
  ~vtkHeliosNavigationReport() override = default;

private:
  vtkHeliosNavigationReport(const vtkHeliosNavigationReport&) = delete;
  void operator=(const vtkHeliosNavigationReport&) = delete;

  vtkIdType NumberOfRows = 0;
  double RMS[6] = { 0.0, 0.0, 0.0, 0.0, 0.0, 0.0 };
};

#endif
