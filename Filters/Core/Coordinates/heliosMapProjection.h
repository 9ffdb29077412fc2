// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Coordinate systems on WGS 84 computed by GeographicLib, to nanometres.

#ifndef heliosMapProjection_h
#define heliosMapProjection_h

#include "vtkHeliosFiltersCoreModule.h" // For export macro

#include <memory>

namespace helios
{

/// Converts between a system on WGS 84 and longitude [deg], latitude [deg], height above the
/// ellipsoid [m]. Points without an image become NaN. Const and thread-safe.
class MapProjection
{
public:
  virtual ~MapProjection() = default;
  virtual void ToGeographic(const double xyz[3], double geographic[3]) const = 0;
  virtual void FromGeographic(const double geographic[3], double xyz[3]) const = 0;
};

/// Origin of a map: central meridian [deg], scale, and false easting and northing [m].
struct MapOrigin
{
  double Longitude = 0.0;
  double Scale = 1.0;
  double FalseEasting = 0.0;
  double FalseNorthing = 0.0;
};

using MapProjectionPointer = std::shared_ptr<const MapProjection>;

MapProjectionPointer MakeGeographic();
MapProjectionPointer MakeGeocentric();

/// Returns a local east, north, up system at a latitude [deg], longitude [deg] and height [m].
MapProjectionPointer MakeLocal(double latitude, double longitude, double height);

/// Returns a projection with its origin at the equator, valid within 80 degrees of the central
/// meridian.
MapProjectionPointer MakeTransverseMercator(const MapOrigin& origin);

/// Returns a projection about the north or south pole, valid up to the equator; the origin's scale
/// is the scale at the pole.
MapProjectionPointer MakePolarStereographic(bool isNorth, const MapOrigin& origin);

/// Returns the EPSG code of the UTM or UPS system on WGS 84 at a position [deg].
VTKHELIOSFILTERSCORE_EXPORT int GetUTMCode(double latitude, double longitude);

} // namespace helios

#endif
