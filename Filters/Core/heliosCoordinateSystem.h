// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// A coordinate system, by any of its names.

#ifndef heliosCoordinateSystem_h
#define heliosCoordinateSystem_h

#include "vtkHeliosFiltersCoreModule.h"

#include <memory>
#include <string>

namespace helios
{

struct CoordinateSystemData;

/**
 * Made from a text:
 * - "EPSG:25832", or another authority's code; "EPSG:25832+7837", with a system of heights;
 * - WKT (1 or 2, ESRI's too), PROJJSON, a PROJ string, the full name of an EPSG system;
 * - "ENU 49.4 8.7 110": local east, north, up about a latitude [deg], longitude [deg] and height
 *   above the ellipsoid [m] of WGS 84.
 *
 * Coordinates are always in the order east, north, up (geocentric: X, Y, Z), whatever order and
 * signs the system's definition has; angles are degrees, lengths in the units of the system. A
 * system that says nothing of heights has them in metres.
 *
 * Immutable and cheap to copy; safe for many threads.
 */
class VTKHELIOSFILTERSCORE_EXPORT CoordinateSystem
{
public:
  /// Reads a text; says in words what is wrong with it, or returns an empty text.
  std::string Set(const std::string& text);

  bool IsSet() const { return this->Data != nullptr; }

  ///@{
  /// The text it was made from; a short one for it ("EPSG:32632" for its WKT); and how messages call
  /// it: "EPSG:32632 (WGS 84 / UTM zone 32N)".
  const std::string& GetText() const;
  const std::string& GetLabel() const;
  const std::string& GetName() const;
  ///@}

  /// Its WKT: of 2001 (WKT 1) as LAS files have it, of 2019 where that cannot say it; empty for a
  /// local system, which has none.
  std::string GetWkt() const;

  /// Whether x and y are longitude and latitude [deg].
  bool IsGeographic() const;

  /// Metres a unit of x and y; 0 for degrees.
  double GetUnit() const;

  /// Metres a unit of z; 1 where the system says nothing of heights.
  double GetHeightUnit() const;

  /// Whether distances in it are metres: projected, geocentric or local, and no feet.
  bool IsMetric() const;

  /// The units in words: "degrees", "US survey foot", "metre, with heights in foot".
  std::string GetUnitName() const;

  ///@{
  /// Whether both mean the same coordinates, however they are spelled.
  bool operator==(const CoordinateSystem& other) const;
  bool operator!=(const CoordinateSystem& other) const { return !(*this == other); }
  ///@}

private:
  friend class CoordinateTransform;
  std::shared_ptr<const CoordinateSystemData> Data;
};

} // namespace helios

#endif
