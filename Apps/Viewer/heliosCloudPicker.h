// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Finds the point of a cloud that is drawn at a pixel, among all there are.

#ifndef heliosCloudPicker_h
#define heliosCloudPicker_h

#include "heliosCloud.h"

#include <cstdint>
#include <limits>
#include <vector>

class vtkRenderer;

namespace helios
{

class PixelMap;

/// The part of a cloud that is shown: up to a time, and inside a box.
struct CloudWindow
{
  double TimeLimit = std::numeric_limits<double>::infinity(); ///< [s]
  bool HasBox = false;
  double Box[6] = { 0.0, 0.0, 0.0, 0.0, 0.0, 0.0 }; ///< x0 x1 y0 y1 z0 z1 [m], less the origin

  /// Whether no point of a chunk is shown, as far as its bounds tell.
  bool IsOutside(const CloudChunk& chunk) const;
  bool Contains(const CloudChunk& chunk, vtkIdType i) const;
};

/// Where to look for a point, in pixels of the window from its lower left corner.
struct PickSpot
{
  double X = 0.0;
  double Y = 0.0;
  double Radius = 5.0;
  double PointSize = 1.0; ///< points are drawn as squares of this side
};

/**
 * The row of the point that a spot shows; -1: none. The renderer draws the cloud in coordinates
 * less its origin. Of points whose square covers the spot, the one closest to the camera; where
 * there is none, the nearest in pixels within the radius.
 */
vtkIdType PickPoint(
  const Cloud& cloud, const CloudWindow& window, vtkRenderer* renderer, const PickSpot& spot);

/**
 * The rows of the points that are seen: of those at one pixel the closest to the camera, of all
 * there are. So a picture of many points costs what its pixels cost.
 */
std::vector<std::uint32_t> FindVisiblePoints(
  const Cloud& cloud, const CloudWindow& window, const PixelMap& pixels);

} // namespace helios

#endif
