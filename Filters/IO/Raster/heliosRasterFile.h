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

/// Settings that override the settings of the file.
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
class RasterFile
{
public:
  virtual ~RasterFile() = default;
  RasterFile(const RasterFile&) = delete;
  void operator=(const RasterFile&) = delete;

  /// Opens a file.
  virtual Status Open(const std::string& path, const RasterOptions& options) = 0;

  virtual const std::string& GetPath() const = 0;

  virtual std::int64_t GetNumberOfColumns() const = 0;
  virtual std::int64_t GetNumberOfRows() const = 0;

  /// Returns t with x = t0 + t1 column + t2 row, y = t3 + t4 column + t5 row; the first pixel
  /// centre is at 0.5.
  virtual const double* GetTransform() const = 0;

  /// Returns WKT with heights in metres; empty if the file has none.
  virtual const std::string& GetCrs() const = 0;

  /// Returns the number of pixels outside missing blocks; some of them may also lack a height.
  virtual double CountPixels() const = 0;

  /// Returns the number of rows to read at a time: whole blocks of the file, some megabytes.
  virtual std::int64_t GetRowsPerBlock() const = 0;

  /// Reads heights [m] of rows, NaN if missing.
  virtual Status Read(std::int64_t firstRow, std::int64_t count, double* heights) = 0;

  /// Warns of heights that no place on Earth has: of an undeclared no-data value.
  virtual void CheckHeights(double lowest, double highest) = 0;

  /// Warnings of GDAL and of the validation.
  virtual std::vector<std::string> GetWarnings() const = 0;

protected:
  RasterFile() = default;
};

/**
 * Makes a raster file. The first call loads GDAL, which needs 85 libraries and 30 MB: what reads no
 * raster runs without them. Library is the file name of the part of vtkHelios that is linked to
 * GDAL.
 */
VTKHELIOSFILTERSIO_EXPORT Status MakeRasterFile(std::unique_ptr<RasterFile>& file);
VTKHELIOSFILTERSIO_EXPORT Status MakeRasterFile(
  const std::string& library, std::unique_ptr<RasterFile>& file);

} // namespace helios

#endif
