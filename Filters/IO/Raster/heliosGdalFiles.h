// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Opens rasters with GDAL, and finds the files that GDAL opens for them.

#ifndef heliosGdalFiles_h
#define heliosGdalFiles_h

#include "heliosGdal.h"
#include "heliosStatus.h"

#include <memory>
#include <string>

namespace helios
{

struct GdalCloser
{
  void operator()(GDALDatasetH dataset) const { GDALClose(dataset); }
};
using GdalDataset = std::unique_ptr<void, GdalCloser>;

/// Opens a GeoTIFF or VRT; null for a file of another format. GDALOpenEx defines the flags.
GdalDataset OpenGdalDataset(const std::string& path, unsigned int flags);

/// Checks, as CheckInputFile() does, all other files of a raster: the tiles of a VRT, the tiles of
/// these, and what is beside them (.aux.xml, .tfw, .msk, .ovr). Of archives, the archive.
Status CheckGdalFiles(const std::string& path, GDALDatasetH raster);

} // namespace helios

#endif
