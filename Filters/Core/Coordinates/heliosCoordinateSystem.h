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
 * order and signs of the definition; angles are degrees, lengths in the units of the system.
 * Without a vertical part, heights have the unit of x and y, or are metres if these are degrees.
 *
 * Immutable, cheap to copy, thread-safe. The owner of what a system is: readers, writers, filters
 * and measures ask here whether two systems are the same, and for units and resolutions.
 */
class VTKHELIOSFILTERSCORE_EXPORT CoordinateSystem
{
public:
  /// Parses a text.
  Status Set(const std::string& text);

  bool IsSet() const { return this->Data != nullptr; }

  /// @{
  /// Returns the source text; its short form ("EPSG:32632" for its WKT); and the label in messages:
  /// "EPSG:32632 (WGS 84 / UTM zone 32N)".
  const std::string& GetText() const;
  const std::string& GetLabel() const;
  const std::string& GetName() const;
  ///@}

  /// Returns "EPSG:25832", or "EPSG:25832+7837" with a vertical part; empty if a part has no code.
  const std::string& GetCode() const;

  /// Returns WKT of 2001 (WKT 1), which LAS files hold, or of 2019 if WKT 1 cannot express the
  /// system; empty for a local system.
  std::string GetWkt() const;

  /// Returns whether x and y are longitude and latitude [deg].
  bool IsGeographic() const;

  /// Metres per unit of x and y; 0 for degrees.
  double GetUnit() const;

  /// Metres per unit of z.
  double GetHeightUnit() const;

  /// Returns whether the system states the unit of z: by a vertical part, or as a system of three
  /// axes.
  bool HasHeightUnit() const;

  /// Returns the horizontal part, with heights above an unknown surface in a unit [m], as WKT; not
  /// set if PROJ cannot make it.
  CoordinateSystem WithHeightUnit(double metres) const;

  /// Returns whether distances are in metres: projected, geocentric or local, and not in feet.
  bool IsMetric() const;

  /// Returns the units as text: "degrees", "US survey foot", "metre, with heights in foot".
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

/// Returns the largest step for stored coordinates of an axis, in its unit: 1e-9 degrees (0.1 mm),
/// or the power of ten next to 0.1 mm or below. A system that is not set has metres.
VTKHELIOSFILTERSCORE_EXPORT double GetResolution(const CoordinateSystem& system, int axis);

} // namespace helios

#endif
