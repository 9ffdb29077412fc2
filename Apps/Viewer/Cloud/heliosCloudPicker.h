// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Finds the cloud point drawn at a pixel, among all points.

#ifndef heliosCloudPicker_h
#define heliosCloudPicker_h

#include "heliosCloud.h"
#include "heliosSlab.h"

#include <cstdint>
#include <limits>
#include <vector>

class vtkRenderer;

namespace helios::viewer
{

class PixelMap;

/// The visible part of a cloud: up to a time, inside a box and a slab.
struct CloudWindow
{
  double TimeLimit = std::numeric_limits<double>::infinity(); ///< [s]
  bool HasBox = false;
  double Box[6] = { 0.0, 0.0, 0.0, 0.0, 0.0, 0.0 }; ///< x0 x1 y0 y1 z0 z1 [m], less the origin

  bool HasSlab = false;
  Slab Section; ///< less the origin

  bool IsClipped() const { return this->HasBox || this->HasSlab; }

  /// Returns whether no point of a chunk is visible, judging by its bounds.
  bool IsOutside(const CloudChunk& chunk) const;
  bool Contains(const CloudChunk& chunk, vtkIdType i) const;
};

/// Search position, in pixels of the window from its lower left corner.
struct PickSpot
{
  double X = 0.0;
  double Y = 0.0;
  double Radius = 5.0;
  double PointSize = 1.0; ///< side of the squares drawn for points
};

/**
 * Returns the row of the point shown at a spot; -1: none. The renderer draws the cloud in
 * coordinates relative to its origin. Of points whose square covers the spot, the one closest to
 * the camera; otherwise the nearest in pixels within the radius.
 */
vtkIdType PickPoint(
  const Cloud& cloud, const CloudWindow& window, vtkRenderer* renderer, const PickSpot& spot);

/**
 * Returns the rows of the visible points: at each pixel the one closest to the camera, among all.
 * So the cost of drawing many points depends on the number of pixels.
 */
std::vector<std::uint32_t> FindVisiblePoints(
  const Cloud& cloud, const CloudWindow& window, const PixelMap& pixels);

} // namespace helios::viewer

#endif
