// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// A coordinate reference system.

#ifndef heliosCoordinateSystem_h
#define heliosCoordinateSystem_h

#include "heliosStatus.h"
#include "vtkHeliosFiltersCoreModule.h"

#include <memory>
#include <string>

namespace helios
{

struct CoordinateSystemData;

/**
 * Defined by a text:
 * - "EPSG:25832", or a code of another authority; "EPSG:25832+7837", with a vertical system;
 * - WKT (1 or 2, also ESRI), PROJJSON, a PROJ string, the full name of an EPSG system;
 * - "ENU 49.4 8.7 110": local east, north, up at a latitude [deg], longitude [deg] and height above
 *   the ellipsoid [m] of WGS 84.
 *
 * Coordinates are always in the order east, north, up (geocentric: X, Y, Z), whatever the axis
 * order and signs of the definition; angles are degrees, lengths in the units of the system. A
 * system without a vertical part has heights in metres.
 *
 * Immutable, cheap to copy, thread-safe.
 */
class VTKHELIOSFILTERSCORE_EXPORT CoordinateSystem
{
public:
  /// Parses a text.
  Status Set(const std::string& text);

  bool IsSet() const { return this->Data != nullptr; }

  ///@{
  /// The source text; a short form of it ("EPSG:32632" for its WKT); and the label in messages:
  /// "EPSG:32632 (WGS 84 / UTM zone 32N)".
  const std::string& GetText() const;
  const std::string& GetLabel() const;
  const std::string& GetName() const;
  ///@}

  /// WKT of 2001 (WKT 1) as in LAS files, or of 2019 if WKT 1 cannot express the system; empty for
  /// a local system.
  std::string GetWkt() const;

  /// Whether x and y are longitude and latitude [deg].
  bool IsGeographic() const;

  /// Metres per unit of x and y; 0 for degrees.
  double GetUnit() const;

  /// Metres per unit of z; 1 if the system has no vertical part.
  double GetHeightUnit() const;

  /// Whether distances are in metres: projected, geocentric or local, and not in feet.
  bool IsMetric() const;

  /// The units as text: "degrees", "US survey foot", "metre, with heights in foot".
  std::string GetUnitName() const;

  ///@{
  /// Whether both define the same coordinates, regardless of spelling.
  bool operator==(const CoordinateSystem& other) const;
  bool operator!=(const CoordinateSystem& other) const { return !(*this == other); }
  ///@}

private:
  friend class CoordinateTransform;
  std::shared_ptr<const CoordinateSystemData> Data;
};

} // namespace helios

#endif
