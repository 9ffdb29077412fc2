// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// When a cone that several triangles fill meets one plane, or one surface.

#ifndef heliosPlaneLimits_h
#define heliosPlaneLimits_h

#include <vtkType.h>

#include <functional>
#include <utility>

namespace helios
{

/// What triangles have in common that count as one plane, or as one layer (ConeLayer).
struct PlaneLimits
{
  using Relation = std::function<bool(vtkIdType, vtkIdType)>;

  /// The maximum distance from one plane, along the axis, inside the cone [m].
  double Distance = 0.0;

  /// Whether two triangles respond alike; without it, all do.
  Relation AreAlike;

  ///@{
  /// The same of a layer; 0: no layer is sought.
  double LayerDistance = 0.0;
  Relation AreSimilar;
  ///@}

  PlaneLimits(double distance, Relation areAlike = {}) // NOLINT(google-explicit-constructor)
    : Distance(distance)
    , AreAlike(std::move(areAlike))
  {
  }
};

} // namespace helios

#endif
