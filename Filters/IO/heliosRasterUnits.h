// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// The units of heights in rasters.

#ifndef heliosRasterUnits_h
#define heliosRasterUnits_h

#include "vtkHeliosFiltersIOModule.h"

#include <ogr_srs_api.h>

#include <string>

namespace helios
{

/// The metres of a unit as GeoTIFF files spell it ("m", "us-ft", "Foot_US", ...); 0: not known.
VTKHELIOSFILTERSIO_EXPORT double GetUnitInMetres(const std::string& name);

/// WKT 2 of a system.
std::string ToWkt(OGRSpatialReferenceH system);

/**
 * The same system (WKT) with heights in metres, where it has any. The vertical part then says so
 * in its name and has no code. Empty if that cannot be done.
 */
VTKHELIOSFILTERSIO_EXPORT std::string MakeHeightsMetric(const std::string& wkt);

} // namespace helios

#endif
