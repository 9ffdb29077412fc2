// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosLasGeoKeys.h"

#include "heliosCoordinateSystem.h"
#include "heliosLasFormat.h"

#include <cmath>
#include <cstdint>

namespace helios
{

namespace
{

///@{
/// GeoTIFF keys; values below Undefined are EPSG codes.
constexpr int ModelKey = 1024;
constexpr int GeographicKey = 2048;
constexpr int ProjectedKey = 3072;
constexpr int VerticalKey = 4096;
constexpr int HeightUnitKey = 4099;
constexpr int UndefinedCode = 32767;
constexpr int ProjectedModel = 1;
///@}

/// Returns the value of a key; 0: missing.
int GetGeoKey(const std::string& keys, int key)
{
  constexpr std::size_t entry = 8;
  for (std::size_t at = entry; at + entry <= keys.size(); at += entry)
  {
    const char* bytes = keys.data() + at;
    if (LoadLas<std::uint16_t>(bytes) == key && LoadLas<std::uint16_t>(bytes + 2) == 0)
    {
      return LoadLas<std::uint16_t>(bytes + 6);
    }
  }
  return 0;
}

/// Returns the EPSG code of a key; 0: missing or defined otherwise.
int GetCode(const std::string& keys, int key)
{
  const int code = GetGeoKey(keys, key);
  return code < UndefinedCode ? code : 0;
}

/// Returns the EPSG code of the map; 0: unknown.
int GetMapCode(const std::string& keys)
{
  const bool isMap =
    GetGeoKey(keys, ProjectedKey) != 0 || GetGeoKey(keys, ModelKey) == ProjectedModel;
  return GetCode(keys, isMap ? ProjectedKey : GeographicKey);
}

/// Returns the EPSG code of the heights; 0: unknown.
int GetVerticalCode(const std::string& keys)
{
  const int code = GetCode(keys, VerticalKey);
  const bool isEllipsoid = code >= 5001 && code <= 5033;
  const bool isOld = code >= 5101 && code <= 5106;
  constexpr int fromOld = 600;
  return isEllipsoid ? 0 : isOld ? code + fromOld : code;
}

/// Metres per unit of heights; 0: not stated.
double GetHeightUnit(const std::string& keys)
{
  switch (GetGeoKey(keys, HeightUnitKey))
  {
    case 9001:
      return 1.0;
    case 9002:
      return 0.3048;
    case 9003:
      return 1200.0 / 3937.0;
    default:
      return 0.0;
  }
}

/// Finds the system of the same surface in another unit, of those in use; 0: none.
int FindInUnit(int vertical, double unit)
{
  constexpr int navd88 = 5703;
  constexpr int navd88Foot = 8228;
  constexpr int navd88SurveyFoot = 6360;
  return vertical != navd88 ? 0 : unit == 0.3048 ? navd88Foot : navd88SurveyFoot;
}

} // namespace

std::string GetGeoKeysCrs(const std::string& keys)
{
  const int code = GetMapCode(keys);
  if (code == 0)
  {
    return {};
  }
  const std::string map = "EPSG:" + std::to_string(code);
  const int vertical = GetVerticalCode(keys);
  const std::string both = map + (vertical ? "+" + std::to_string(vertical) : std::string());
  const double unit = GetHeightUnit(keys);
  CoordinateSystem system;
  if (!system.Set(both).IsOk() && !system.Set(map).IsOk())
  {
    return both;
  }
  const bool isStated = unit == 0.0 || std::abs(system.GetHeightUnit() / unit - 1.0) < 1e-9;
  if (isStated && (vertical || unit == 0.0 || system.HasHeightUnit()))
  {
    return system.GetText();
  }
  const int other = FindInUnit(vertical, unit);
  if (other && system.Set(map + "+" + std::to_string(other)).IsOk())
  {
    return system.GetText();
  }
  const CoordinateSystem stated = system.WithHeightUnit(unit);
  return stated.IsSet() ? stated.GetText() : system.GetText();
}

} // namespace helios
