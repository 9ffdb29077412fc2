// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Units of raster heights.

#ifndef heliosRasterUnits_h
#define heliosRasterUnits_h

#include "heliosGdal.h"
#include "heliosGdalExport.h"

#include <string>

namespace helios
{

/// Metres per unit for a GeoTIFF unit name ("m", "us-ft", "Foot_US", ...); 0: unknown.
HELIOSGDAL_EXPORT double GetUnitInMetres(const std::string& name);

/// Returns WKT 2 of a coordinate system.
std::string ToWkt(OGRSpatialReferenceH system);

/**
 * Returns the same system (WKT) with heights in metres. The vertical part of a system in feet then
 * says so in its name and has no code. Empty on failure.
 */
HELIOSGDAL_EXPORT std::string MakeHeightsMetric(const std::string& wkt);

} // namespace helios

#endif
