// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// The coordinate system in the GeoTIFF keys of a LAS file.

#ifndef heliosLasGeoKeys_h
#define heliosLasGeoKeys_h

#include <string>

namespace helios
{

/**
 * Returns "EPSG:n" or "EPSG:n+m" of a GeoKeyDirectoryTag record; WKT if key 4099 gives heights a
 * unit that no vertical system states. Empty if the map is defined by parameters, or by no key.
 *
 * Vertical codes of GeoTIFF 1.0 (5101 to 5106) are replaced by codes of EPSG; codes of ellipsoids
 * (5001 to 5033) state no surface.
 */
std::string GetGeoKeysCrs(const std::string& keys);

} // namespace helios

#endif
