// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// The outlines of what an image covers.

#ifndef heliosContourRings_h
#define heliosContourRings_h

#include "vtkHeliosFiltersIOModule.h" // For export macro

#include <array>
#include <vector>

namespace helios
{

/// One value from 0 to 255 per pixel, row by row from the lowest.
struct VTKHELIOSFILTERSIO_EXPORT MaskImage
{
  int Width = 0;
  int Height = 0;
  std::vector<unsigned char> Values;

  /// Returns a value; pixels outside have the value of the nearest.
  double Get(int column, int row) const;
};

/// A closed line [pixels]: x right, y up from the lower left corner of the image; what it encloses
/// is on its left. The first point is not repeated.
using ContourRing = std::vector<std::array<double, 2>>;

/// Returns the area on the left of a ring [pixels]; holes have a negative one.
VTKHELIOSFILTERSIO_EXPORT double ComputeRingArea(const ContourRing& ring);

/**
 * Returns the rings around all places whose value is above a level, where values are interpolated
 * bilinearly between the centres of pixels (marching squares; where two corners that are opposite
 * are above, the value at the saddle decides). Rings end at the border of the image. The level may
 * not be a whole number, so no pixel is on a ring.
 */
VTKHELIOSFILTERSIO_EXPORT std::vector<ContourRing> FindRings(const MaskImage& image, double level);

/**
 * Returns a ring with fewer points (Douglas and Peucker 1973), after the stairs of pixels are
 * smoothed: no side is farther than a tolerance from the points that it replaces [pixels]. Its sides
 * are then moved to the outside or inside by the same distance, within the image, so that it has the
 * area of the ring.
 */
VTKHELIOSFILTERSIO_EXPORT ContourRing SimplifyRing(
  const ContourRing& ring, double tolerance, const MaskImage& image);

} // namespace helios

#endif
