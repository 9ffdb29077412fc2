// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// The space between two parallel planes.

#ifndef heliosSlab_h
#define heliosSlab_h

#include "heliosPose.h"

#include <vtkNew.h>
#include <vtkPlane.h>
#include <vtkPlaneCollection.h>

namespace helios::viewer
{

/// Points p with Low <= Normal p <= High [m].
struct Slab
{
  Vec3 Normal{ 0.0, 1.0, 0.0 }; ///< unit vector
  double Low = 0.0;
  double High = 0.0;

  bool Contains(const Vec3& p) const
  {
    const double at = this->Normal.Dot(p);
    return at >= this->Low && at <= this->High;
  }

  /// Returns the same slab in coordinates relative to an origin.
  Slab RelativeTo(const Vec3& origin) const
  {
    const double shift = this->Normal.Dot(origin);
    return { this->Normal, this->Low - shift, this->High - shift };
  }

  /// Adds its planes to those that a mapper clips with.
  void AddPlanes(vtkPlaneCollection* planes) const
  {
    for (const double side : { 1.0, -1.0 })
    {
      vtkNew<vtkPlane> plane;
      const Vec3 origin = (side > 0.0 ? this->Low : this->High) * this->Normal;
      const Vec3 inwards = side * this->Normal;
      plane->SetOrigin(origin.GetData());
      plane->SetNormal(inwards.GetData());
      planes->AddItem(plane);
    }
  }
};

} // namespace helios::viewer

#endif
