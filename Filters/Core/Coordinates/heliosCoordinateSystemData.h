// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Properties of a coordinate system. Internal to this folder.

#ifndef heliosCoordinateSystemData_h
#define heliosCoordinateSystemData_h

#include "heliosMapProjection.h"

#include <string>

namespace helios
{

/// Mapping from PROJ coordinates to east, north, up.
struct AxisOrder
{
  int From[3] = { 0, 1, 2 };
  double Factor[3] = { 1.0, 1.0, 1.0 }; // sign; degrees per unit of an angle

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
  std::string Code;
  std::string UnitName;
  std::string HeightUnitName;           // empty: not stated
  double Unit = 1.0;                    // [m]; 0: degrees
  double HeightUnit = 1.0;              // [m]
  bool IsCompound = false;              // with a vertical part
  bool IsPlane = false;                 // no vertical part, or one that only states the unit
  bool IsCut = false;                   // PROJ gets the horizontal part
  bool IsLocal = false;                 // unknown to PROJ
  double Origin[3] = { 0.0, 0.0, 0.0 }; // local system only: latitude, longitude [deg], height [m]
  AxisOrder Axes;
  MapProjectionPointer Projection; // null: not computed by GeographicLib
};

} // namespace helios

#endif
