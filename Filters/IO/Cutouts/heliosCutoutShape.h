// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Triangles of a unit square that the transparency of a texture leaves.

#ifndef heliosCutoutShape_h
#define heliosCutoutShape_h

#include "heliosContourRings.h"
#include "vtkHeliosFiltersIOModule.h" // For export macro

#include <array>
#include <cstddef>
#include <vector>

namespace helios
{

/// Farthest that outlines are from the smoothed ones of the texture [pixels].
constexpr double OutlineTolerance = 0.5;

/// Largest error of the area of triangles, of the area.
constexpr double OutlineAreaError = 1e-3;

/// The triangles of one opacity.
struct CutoutBand
{
  double Opacity = 1.0;                      ///< mean of the pixels, (0..1]
  std::vector<std::array<double, 2>> Points; ///< u v, from 0 to 1, v upward
  std::vector<int> Corners;                  ///< three points per triangle, counterclockwise
  double Area = 0.0;                         ///< [0..1]
  double PixelArea = 1.0;                    ///< area of a pixel, [0..1]

  std::size_t GetNumberOfTriangles() const { return this->Corners.size() / 3; }
};

/**
 * Bands of a mask. Where a mask is cut at a threshold, there is one of opacity 1: what is at least as
 * opaque. A mask of opacities has a band for each eighth of them. Outlines are within
 * a pixel of the texture's and have its area.
 */
class VTKHELIOSFILTERSIO_EXPORT CutoutShape
{
public:
  /// Makes the shape where a mask is at least a threshold, (0..1].
  static CutoutShape Cut(const MaskImage& mask, double threshold);

  /// Makes the shape of a mask of opacities.
  static CutoutShape Blend(const MaskImage& mask);

  /// Returns the bands: none where nothing is left.
  const std::vector<CutoutBand>& GetBands() const { return this->Bands; }

  /// Returns whether the first band covers all: it has no triangles then.
  bool IsWhole() const { return this->Whole; }

private:
  CutoutShape(const MaskImage& mask, std::vector<double> levels, bool isBlended);

  std::vector<CutoutBand> Bands;
  bool Whole = false;
};

/// The triangles of a band by cells of a grid.
class VTKHELIOSFILTERSIO_EXPORT CutoutGrid
{
public:
  explicit CutoutGrid(const CutoutBand& band);

  /// Replaces found by the triangles whose bounds may meet a rectangle, in their order.
  void Find(const std::array<double, 2>& low, const std::array<double, 2>& high,
    std::vector<int>& found) const;

private:
  int GetCell(double coordinate) const;

  template <typename Visitor>
  void VisitCells(
    const std::array<double, 2>& low, const std::array<double, 2>& high, Visitor visit) const;

  int Size = 1; // cells in a row
  std::vector<std::vector<int>> Cells;
};

} // namespace helios

#endif
