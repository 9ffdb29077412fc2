// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// The formats and the cache of GDAL.

#ifndef heliosGdalDrivers_h
#define heliosGdalDrivers_h

#include "heliosGdal.h"

#include <mutex>

namespace helios
{

/// Rows are read once, in order: they need no cache of the default size, 5 % of the memory.
inline void LimitGdalCache()
{
  constexpr GIntBig size = 64 << 20;
  if (!CPLGetConfigOption("GDAL_CACHEMAX", nullptr))
  {
    GDALSetCacheMax64(size);
  }
}

/// Registers the formats that are read: GeoTIFF, and VRT of these.
inline void RegisterGdalDrivers()
{
  static std::once_flag once;
  const auto prepare = []
  {
    GDALRegister_GTiff();
    GDALRegister_VRT();
    LimitGdalCache();
  };
  std::call_once(once, prepare);
}

} // namespace helios

#endif
