// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Heights in a GeoTIFF file, read with GDAL.

#ifndef heliosRasterFile_h
#define heliosRasterFile_h

#include "heliosStatus.h"
#include "vtkHeliosFiltersIOModule.h"

#include <cstdint>
#include <limits>
#include <memory>
#include <string>
#include <vector>

namespace helios
{

/// Settings that override those of the file.
struct RasterOptions
{
  int Band = 1;                                             ///< from 1
  double HeightUnit = 0.0;                                  ///< [m]; 0: from the file
  double NoData = std::numeric_limits<double>::quiet_NaN(); ///< NaN: from the file
};

/**
 * A band of heights. GDAL messages do not go to the console: errors are returned, warnings
 * collected.
 */
class VTKHELIOSFILTERSIO_EXPORT RasterFile
{
public:
  RasterFile();
  ~RasterFile();

  /// Opens a file.
  Status Open(const std::string& path, const RasterOptions& options);

  const std::string& GetPath() const;

  std::int64_t GetNumberOfColumns() const;
  std::int64_t GetNumberOfRows() const;

  /// x = t0 + t1 column + t2 row, y = t3 + t4 column + t5 row; the first pixel centre is at 0.5.
  const double* GetTransform() const;

  /// WKT with heights in metres; empty if the file has none.
  const std::string& GetCrs() const;

  /// Number of pixels except those of missing blocks; other pixels may also lack a height.
  double CountPixels() const;

  /// Number of rows to read at a time: whole blocks of the file, some megabytes.
  std::int64_t GetRowsPerBlock() const;

  /// Reads heights [m] of rows, NaN if missing.
  Status Read(std::int64_t firstRow, std::int64_t count, double* heights);

  /// Warns of heights that no place on Earth has: of an undeclared no-data value.
  void CheckHeights(double lowest, double highest);

  /// Warnings of GDAL and of the validation.
  std::vector<std::string> GetWarnings() const;

private:
  struct Internals;
  std::unique_ptr<Internals> State;
};

} // namespace helios

#endif
