// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// The coordinate systems on WGS 84 that GeographicLib computes, to nanometres.

#ifndef heliosMapProjection_h
#define heliosMapProjection_h

#include <memory>

namespace helios
{

/// A system on WGS 84 against longitude [deg], latitude [deg] and height above the ellipsoid [m].
/// What has no image becomes NaN. Const and safe for many threads.
class MapProjection
{
public:
  virtual ~MapProjection() = default;
  virtual void ToGeographic(const double xyz[3], double geographic[3]) const = 0;
  virtual void FromGeographic(const double geographic[3], double xyz[3]) const = 0;
};

/// Where a map has its origin: central meridian [deg], its scale, and what is added [m].
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

/// East, north, up at a latitude [deg], longitude [deg] and height [m].
MapProjectionPointer MakeLocal(double latitude, double longitude, double height);

/// From the equator; within 80 degrees of the central meridian.
MapProjectionPointer MakeTransverseMercator(const MapOrigin& origin);

/// About the north or the south pole, up to the equator; the scale of the origin is that at the pole.
MapProjectionPointer MakePolarStereographic(bool isNorth, const MapOrigin& origin);

/// The EPSG code of the UTM or UPS system on WGS 84 for a place [deg].
int GetUTMCode(double latitude, double longitude);

} // namespace helios

#endif
