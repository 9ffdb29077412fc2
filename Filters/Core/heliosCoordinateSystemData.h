// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// What is known of a coordinate system. Only for the sources of this folder.

#ifndef heliosCoordinateSystemData_h
#define heliosCoordinateSystemData_h

#include "heliosMapProjection.h"

#include <string>

namespace helios
{

/// How east, north, up follow from the coordinates as PROJ gives them.
struct AxisOrder
{
  int From[3] = { 0, 1, 2 };
  double Factor[3] = { 1.0, 1.0, 1.0 }; // a sign; degrees per unit of an angle

  bool IsIdentity() const
  {
    return this->From[0] == 0 && this->Factor[0] == 1.0 && this->Factor[1] == 1.0 &&
      this->Factor[2] == 1.0;
  }
};

struct CoordinateSystemData
{
  std::string Text;
  std::string Label;
  std::string Name;
  std::string UnitName;
  std::string HeightUnitName;           // empty: nothing said of heights
  double Unit = 1.0;                    // [m]; 0: degrees
  double HeightUnit = 1.0;              // [m]
  bool IsCompound = false;              // with a system of heights
  bool IsPlane = false;                 // nothing said of heights
  bool IsLocal = false;                 // unknown to PROJ
  double Origin[3] = { 0.0, 0.0, 0.0 }; // of a local one: latitude, longitude [deg], height [m]
  AxisOrder Axes;
  MapProjectionPointer Projection; // where GeographicLib computes it; else null
};

} // namespace helios

#endif
