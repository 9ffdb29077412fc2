// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Reads the rows of a raster in blocks.

#ifndef heliosRasterRows_h
#define heliosRasterRows_h

#include "heliosRasterFile.h"
#include "heliosStatus.h"

#include <algorithm>
#include <cstdint>
#include <memory>
#include <string>

namespace helios
{

/// Passes the rows of heights in order to add(), until that returns false; goOn() receives the part
/// that is read, and returns false to stop with an error.
template <typename AddT, typename GoOnT>
Status ReadRows(RasterFile& file, AddT add, GoOnT goOn)
{
  const std::int64_t columns = file.GetNumberOfColumns();
  const std::int64_t rows = file.GetNumberOfRows();
  const std::int64_t step = file.GetRowsPerBlock();
  const std::unique_ptr<double[]> heights(new double[static_cast<std::size_t>(columns * step)]);
  for (std::int64_t row = 0; row < rows; row += step)
  {
    const std::int64_t count = std::min(step, rows - row);
    const Status status = file.Read(row, count, heights.get());
    if (!status.IsOk())
    {
      return status;
    }
    for (std::int64_t i = 0; i < count; ++i)
    {
      if (!add(heights.get() + i * columns))
      {
        return {};
      }
    }
    if (!goOn(static_cast<double>(row + count) / static_cast<double>(rows)))
    {
      return Status::Error(file.GetPath() + ": reading was aborted at row " +
        std::to_string(row + count) + "; update again to read it");
    }
  }
  return {};
}

} // namespace helios

#endif
