// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// The heights in a GeoTIFF file, read by GDAL.

#ifndef heliosRasterFile_h
#define heliosRasterFile_h

#include "vtkHeliosFiltersIOModule.h"

#include <cstdint>
#include <limits>
#include <memory>
#include <string>
#include <vector>

namespace helios
{

/// What to read, beyond what the file says.
struct RasterOptions
{
  int Band = 1;                                             ///< from 1
  double HeightUnit = 0.0;                                  ///< [m]; 0: as the file says
  double NoData = std::numeric_limits<double>::quiet_NaN(); ///< NaN: as the file says
};

/**
 * A band of heights. GDAL's messages are kept from the console: errors are returned, warnings
 * gathered.
 */
class VTKHELIOSFILTERSIO_EXPORT RasterFile
{
public:
  RasterFile();
  ~RasterFile();

  /// Says in words why a file cannot be read, or returns an empty text.
  std::string Open(const std::string& path, const RasterOptions& options);

  std::int64_t GetNumberOfColumns() const;
  std::int64_t GetNumberOfRows() const;

  /// x = t0 + t1 column + t2 row, y = t3 + t4 column + t5 row; the first pixel's centre is at 0.5.
  const double* GetTransform() const;

  /// WKT with heights in metres; empty: the file has none.
  const std::string& GetCrs() const;

  /// The pixels, those of blocks left out; pixels of other blocks may lack a height, too.
  double CountPixels() const;

  /// How many rows to read at a time: whole blocks of the file, some megabytes.
  std::int64_t GetRowsPerBlock() const;

  /// Heights [m] of some rows, NaN where there are none. Returns an error in words, or nothing.
  std::string Read(std::int64_t firstRow, std::int64_t count, double* heights);

  /// What GDAL warned of, and what is doubtful.
  std::vector<std::string> GetWarnings() const;

private:
  struct Internals;
  std::unique_ptr<Internals> State;
};

} // namespace helios

#endif
