// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHeliosGpsTime
 * @brief   GPS time, UTC and Unix time
 *
 * GPS time counts seconds since 6 January 1980 00:00 UTC, leap seconds included; Unix time counts
 * seconds since 1970 without them (a leap second itself has the Unix time of the second after it).
 * GPS time is 18 s ahead of UTC since 2017. The field array GpsEpoch is the GPS time of GpsTime 0.
 */

#ifndef vtkHeliosGpsTime_h
#define vtkHeliosGpsTime_h

#include "vtkHeliosFiltersCoreModule.h" // For export macro
#include "vtkObject.h"

#include <string> // For texts

class VTKHELIOSFILTERSCORE_EXPORT vtkHeliosGpsTime : public vtkObject
{
public:
  static vtkHeliosGpsTime* New();
  vtkTypeMacro(vtkHeliosGpsTime, vtkObject);

  ///@{
  /**
   * Returns the GPS time of a Unix time, and the reverse [s].
   */
  static double FromUnixTime(double unixTime);
  static double ToUnixTime(double gpsTime);
  ///@}

  /**
   * Returns the GPS time [s] of a text: YYYY-MM-DD hh:mm:ss of UTC, with T or a blank between,
   * decimals of the second, and Z or a zone such as +02:00; Unix seconds; or GPS seconds as
   * gps:1467000000. NaN for another text; GetFault() tells why.
   */
  static double Parse(const std::string& text);
  static std::string GetFault(const std::string& text);

protected:
  vtkHeliosGpsTime() = default;
  ~vtkHeliosGpsTime() override = default;

private:
  vtkHeliosGpsTime(const vtkHeliosGpsTime&) = delete;
  void operator=(const vtkHeliosGpsTime&) = delete;
};

#endif
