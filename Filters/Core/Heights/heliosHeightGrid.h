// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// The pixels of a raster of heights and their places.

#ifndef heliosHeightGrid_h
#define heliosHeightGrid_h

#include <cstdint>

namespace helios
{

/// Heights, row by row, float or double; a pixel without height is NaN. They belong to an image.
struct HeightGrid
{
  std::int64_t Columns = 0; ///< in pixels
  std::int64_t Rows = 0;
  const float* Floats = nullptr;
  const double* Doubles = nullptr; ///< if they are not floats
  double Transform[6] = {};        ///< see RasterFile

  double GetHeight(std::int64_t row, std::int64_t column) const
  {
    const std::int64_t i = row * this->Columns + column;
    return this->Floats ? static_cast<double>(this->Floats[i]) : this->Doubles[i];
  }

  /// Computes the centre of a pixel, with its height, by the same operations as RasterMesh.
  void GetPoint(std::int64_t row, std::int64_t column, double point[3]) const
  {
    const double* t = this->Transform;
    const double x = static_cast<double>(column) + 0.5;
    const double y = static_cast<double>(row) + 0.5;
    point[0] = t[0] + (t[1] * x + t[2] * y);
    point[1] = t[3] + (t[4] * x + t[5] * y);
    point[2] = this->GetHeight(row, column);
  }

  bool IsMirrored() const
  {
    const double* t = this->Transform;
    return t[1] * t[5] > t[2] * t[4];
  }
};

} // namespace helios

#endif
