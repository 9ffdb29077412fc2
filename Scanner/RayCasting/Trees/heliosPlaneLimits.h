// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// When a cone that several triangles fill meets one plane.

#ifndef heliosPlaneLimits_h
#define heliosPlaneLimits_h

#include <vtkType.h>

#include <functional>
#include <utility>

namespace helios
{

/// What surfaces have in common that count as one plane.
struct PlaneLimits
{
  /// The maximum distance from one plane, along the axis, inside the cone [m].
  double Distance = 0.0;

  /// Whether two triangles respond alike; without it, all do.
  std::function<bool(vtkIdType, vtkIdType)> AreAlike;

  PlaneLimits(double distance, std::function<bool(vtkIdType, vtkIdType)> areAlike = {})
    : Distance(distance)
    , AreAlike(std::move(areAlike))
  {
  }
};

} // namespace helios

#endif
