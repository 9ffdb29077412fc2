// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// When a cone that several triangles fill meets one plane, or one surface.

#ifndef heliosPlaneLimits_h
#define heliosPlaneLimits_h

#include <vtkType.h>

#include <functional>

namespace helios
{

/// Limits within which triangles count as one plane, or as one layer (ConeLayer).
struct PlaneLimits
{
  /// Largest difference of two triangles.
  struct Difference
  {
    double Distance = 0.0; ///< from the plane of the first, along the axis, inside the cone [m]
    double Contrast = 0.0; ///< contrast of the energies that they return, relative to the larger
  };

  /// The energy that a triangle returns, in any unit; without it, all return the same.
  using Response = std::function<double(vtkIdType)>;

  Difference OfPlane;
  Difference OfLayer; ///< distance 0: no layer is sought
  /// How far a triangle that ends inside the cone may be before one that covers it [m].
  double Overlap = 0.0;
  Response GetResponse;

  PlaneLimits(double distance) // NOLINT(google-explicit-constructor)
    : OfPlane{ distance, 0.0 }
  {
  }
};

} // namespace helios

#endif
