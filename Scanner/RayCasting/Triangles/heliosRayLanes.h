// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Rays in the lanes of vectors, and their best hits.

#ifndef heliosRayLanes_h
#define heliosRayLanes_h

#include "heliosTriangleTest.h"

#include <limits>

namespace helios
{

constexpr int QuadWidth = 4; // doubles in an AVX2 register
typedef double Doubles __attribute__((vector_size(8 * QuadWidth)));
typedef long long Masks __attribute__((vector_size(8 * QuadWidth))); // -1 or 0
typedef float Floats __attribute__((vector_size(4 * QuadWidth)));
typedef int ShortMasks __attribute__((vector_size(4 * QuadWidth)));

/// Four rays and their best hits so far.
struct RayLanes : RayTerms<Doubles>
{
  Doubles Range;  ///< range of the best hit; initially the ray's maximum
  Masks Triangle; ///< triangle of the best hit; initially NoTriangle

  static constexpr long long NoTriangle = std::numeric_limits<long long>::max();

  vtkHeliosHit GetHit(int lane) const
  {
    const vtkIdType triangle = this->Triangle[lane];
    return triangle == NoTriangle ? vtkHeliosHit{ NoHit, -1 }
                                  : vtkHeliosHit{ this->Range[lane], triangle };
  }

  /// Returns the hits of the first lanes.
  HELIOS_INLINE void GetHits(vtkHeliosHit* hits, int count) const
  {
    const Masks isNone = this->Triangle == NoTriangle;
    const Doubles ranges = isNone ? Doubles() + NoHit : this->Range;
    const Masks cells = this->Triangle | isNone; // -1: none
    for (int lane = 0; lane < count; ++lane)
    {
      hits[lane] = { ranges[lane], cells[lane] };
    }
  }
};

} // namespace helios

#endif
