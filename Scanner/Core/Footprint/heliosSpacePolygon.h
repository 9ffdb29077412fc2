// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// The part of a facet about a beam.

#ifndef heliosSpacePolygon_h
#define heliosSpacePolygon_h

#include "heliosBeamProjection.h"
#include "heliosFacets.h"

#include <algorithm>
#include <cmath>

namespace helios
{

/// A polygon in space, with corners of which depth z is the third coordinate.
struct SpacePolygon
{
  static constexpr int Capacity = Facet::Capacity + 5;
  int Size = 0;
  double Corners[Capacity][3];
};

/// Returns the part where a x + b y + c z is at least d.
inline SpacePolygon Clip(const SpacePolygon& p, double a, double b, double c, double d)
{
  SpacePolygon part;
  for (int i = 0; i < p.Size; ++i)
  {
    const double* from = p.Corners[i];
    const double* to = p.Corners[(i + 1) % p.Size];
    const double atFrom = a * from[0] + b * from[1] + c * from[2] - d;
    const double atTo = a * to[0] + b * to[1] + c * to[2] - d;
    if (atFrom >= 0.0 && part.Size < SpacePolygon::Capacity)
    {
      std::copy_n(from, 3, part.Corners[part.Size++]);
    }
    if (((atFrom > 0.0 && atTo < 0.0) || (atFrom < 0.0 && atTo > 0.0)) &&
      part.Size < SpacePolygon::Capacity)
    {
      const double t = atFrom / (atFrom - atTo);
      for (int axis = 0; axis < 3; ++axis)
      {
        part.Corners[part.Size][axis] = from[axis] + t * (to[axis] - from[axis]);
      }
      ++part.Size;
    }
  }
  return part;
}

/// Returns the part of a facet in a frustum about the beam; the whole facet if it is not much
/// larger.
inline SpacePolygon CutToBeam(const Facet& facet, const BeamProjection& beam)
{
  constexpr double frame = 2.0;   // half side of the square that large facets are cut to
  constexpr double large = 100.0; // coordinates from which they are, without a waist
  SpacePolygon space;
  space.Size = facet.Size;
  std::copy_n(&facet.Corners[0][0], 3 * facet.Size, &space.Corners[0][0]);
  const double largest = beam.ApexOffset > 0.0 ? frame : large;
  const bool isLarge = std::any_of(facet.Corners, facet.Corners + facet.Size,
    [&beam, largest](const double* corner)
    {
      const double reach = std::max(std::abs(corner[0]), std::abs(corner[1]));
      return !(corner[2] > beam.ApexOffset) || reach > largest * beam.Tangent * corner[2];
    });
  if (isLarge)
  {
    const double slope = frame * beam.Tangent;
    space = Clip(space, 0.0, 0.0, 1.0, beam.ApexOffset);
    space = Clip(space, 1.0, 0.0, slope, 0.0);
    space = Clip(space, -1.0, 0.0, slope, 0.0);
    space = Clip(space, 0.0, 1.0, slope, 0.0);
    space = Clip(space, 0.0, -1.0, slope, 0.0);
  }
  return space;
}

} // namespace helios

#endif
