// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosMapProjection.h"

#include <GeographicLib/Geocentric.hpp>
#include <GeographicLib/LocalCartesian.hpp>
#include <GeographicLib/PolarStereographic.hpp>
#include <GeographicLib/TransverseMercator.hpp>
#include <GeographicLib/TransverseMercatorExact.hpp>
#include <GeographicLib/UTMUPS.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace helios
{

namespace
{

constexpr double NaN = std::numeric_limits<double>::quiet_NaN();
const double Radius = GeographicLib::Constants::WGS84_a<double>();
const double Flattening = GeographicLib::Constants::WGS84_f<double>();

void SetInvalid(double p[3])
{
  std::fill_n(p, 3, NaN);
}

bool IsPlace(const double geographic[3])
{
  return std::abs(geographic[1]) <= 90.0 && std::isfinite(geographic[0]);
}

class Geographic : public MapProjection
{
public:
  void ToGeographic(const double xyz[3], double geographic[3]) const override
  {
    IsPlace(xyz) ? void(std::copy_n(xyz, 3, geographic)) : SetInvalid(geographic);
  }
  void FromGeographic(const double geographic[3], double xyz[3]) const override
  {
    this->ToGeographic(geographic, xyz);
  }
};

class Geocentric : public MapProjection
{
public:
  void ToGeographic(const double xyz[3], double geographic[3]) const override
  {
    this->Earth.Reverse(xyz[0], xyz[1], xyz[2], geographic[1], geographic[0], geographic[2]);
  }
  void FromGeographic(const double g[3], double xyz[3]) const override
  {
    IsPlace(g) ? this->Earth.Forward(g[1], g[0], g[2], xyz[0], xyz[1], xyz[2]) : SetInvalid(xyz);
  }

private:
  GeographicLib::Geocentric Earth = GeographicLib::Geocentric::WGS84();
};

class Local : public MapProjection
{
public:
  Local(double latitude, double longitude, double height)
    : Frame(latitude, longitude, height)
  {
  }
  void ToGeographic(const double xyz[3], double geographic[3]) const override
  {
    this->Frame.Reverse(xyz[0], xyz[1], xyz[2], geographic[1], geographic[0], geographic[2]);
  }
  void FromGeographic(const double g[3], double xyz[3]) const override
  {
    IsPlace(g) ? this->Frame.Forward(g[1], g[0], g[2], xyz[0], xyz[1], xyz[2]) : SetInvalid(xyz);
  }

private:
  GeographicLib::LocalCartesian Frame;
};

/// Krueger series near the central meridian, where it is exact to rounding; elliptic functions
/// elsewhere (Karney 2011, Journal of Geodesy 85, 475).
class TransverseMercator : public MapProjection
{
public:
  explicit TransverseMercator(const MapOrigin& origin)
    : Origin(origin)
    , Series(Radius, Flattening, origin.Scale)
    , Exact(Radius, Flattening, origin.Scale)
  {
  }
  void ToGeographic(const double xyz[3], double geographic[3]) const override
  {
    const double x = xyz[0] - this->Origin.FalseEasting;
    const double y = xyz[1] - this->Origin.FalseNorthing;
    const double meridian = this->Origin.Longitude;
    std::abs(x) < SeriesWidth ? this->Series.Reverse(meridian, x, y, geographic[1], geographic[0])
                              : this->Exact.Reverse(meridian, x, y, geographic[1], geographic[0]);
    geographic[2] = xyz[2];
    if (!this->IsInside(geographic))
    {
      SetInvalid(geographic);
    }
  }
  void FromGeographic(const double g[3], double xyz[3]) const override
  {
    if (!this->IsInside(g))
    {
      return SetInvalid(xyz);
    }
    this->Series.Forward(this->Origin.Longitude, g[1], g[0], xyz[0], xyz[1]);
    if (!(std::abs(xyz[0]) < SeriesWidth))
    {
      this->Exact.Forward(this->Origin.Longitude, g[1], g[0], xyz[0], xyz[1]);
    }
    xyz[0] += this->Origin.FalseEasting;
    xyz[1] += this->Origin.FalseNorthing;
    xyz[2] = g[2];
  }

private:
  static constexpr double SeriesWidth = 2.5e6; // [m]

  bool IsInside(const double geographic[3]) const
  {
    const double away = std::remainder(geographic[0] - this->Origin.Longitude, 360.0);
    return IsPlace(geographic) && std::abs(away) <= 80.0;
  }

  MapOrigin Origin;
  GeographicLib::TransverseMercator Series;
  GeographicLib::TransverseMercatorExact Exact;
};

class PolarStereographic : public MapProjection
{
public:
  PolarStereographic(bool isNorth, const MapOrigin& origin)
    : IsNorth(isNorth)
    , Origin(origin)
    , Plane(Radius, Flattening, origin.Scale)
  {
  }
  void ToGeographic(const double xyz[3], double geographic[3]) const override
  {
    const double x = xyz[0] - this->Origin.FalseEasting;
    const double y = xyz[1] - this->Origin.FalseNorthing;
    this->Plane.Reverse(this->IsNorth, x, y, geographic[1], geographic[0]);
    geographic[0] = std::remainder(geographic[0] + this->Origin.Longitude, 360.0);
    geographic[2] = xyz[2];
    if (!this->IsInside(geographic))
    {
      SetInvalid(geographic);
    }
  }
  void FromGeographic(const double g[3], double xyz[3]) const override
  {
    if (!this->IsInside(g))
    {
      return SetInvalid(xyz);
    }
    const double longitude = g[0] - this->Origin.Longitude;
    this->Plane.Forward(this->IsNorth, g[1], longitude, xyz[0], xyz[1]);
    xyz[0] += this->Origin.FalseEasting;
    xyz[1] += this->Origin.FalseNorthing;
    xyz[2] = g[2];
  }

private:
  bool IsInside(const double geographic[3]) const
  {
    return IsPlace(geographic) && (geographic[1] >= 0.0) == this->IsNorth;
  }

  bool IsNorth;
  MapOrigin Origin;
  GeographicLib::PolarStereographic Plane;
};

} // namespace

//------------------------------------------------------------------------------
MapProjectionPointer MakeGeographic()
{
  return std::make_shared<Geographic>();
}

//------------------------------------------------------------------------------
MapProjectionPointer MakeGeocentric()
{
  return std::make_shared<Geocentric>();
}

//------------------------------------------------------------------------------
MapProjectionPointer MakeLocal(double latitude, double longitude, double height)
{
  return std::make_shared<Local>(latitude, longitude, height);
}

//------------------------------------------------------------------------------
MapProjectionPointer MakeTransverseMercator(const MapOrigin& origin)
{
  return std::make_shared<TransverseMercator>(origin);
}

//------------------------------------------------------------------------------
MapProjectionPointer MakePolarStereographic(bool isNorth, const MapOrigin& origin)
{
  return std::make_shared<PolarStereographic>(isNorth, origin);
}

//------------------------------------------------------------------------------
int GetUTMCode(double latitude, double longitude)
{
  const int zone = GeographicLib::UTMUPS::StandardZone(latitude, longitude);
  const bool isNorth = latitude >= 0.0;
  if (zone == GeographicLib::UTMUPS::UPS)
  {
    return isNorth ? 5041 : 5042;
  }
  return (isNorth ? 32600 : 32700) + zone;
}

} // namespace helios
