// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// The turbid voxels of a scene: what they take out of a beam before it comes to a surface.

#ifndef heliosTurbidMedium_h
#define heliosTurbidMedium_h

#include "heliosTurbidGrid.h"
#include "vtkHeliosRayCaster.h"

#include <cstdint>
#include <string>
#include <vector>

class vtkImageData;

namespace helios
{

/**
 * Each sub-ray is a photon's way: it is stopped by a leaf, as one of Beer and Lambert's free paths says,
 * or comes to the surface that it would meet without. The path is a function of seed, pulse, sub-ray and
 * grid alone. Grids may overlap: their densities add up, since of independent exponential paths the
 * shortest is exponential.
 */
class TurbidMedium
{
public:
  /// Adds a grid, whose first cell is to have an id. Says in words what is wrong, or returns an empty text.
  std::string Add(vtkImageData* image, vtkIdType firstCell);

  bool IsEmpty() const { return this->Grids.empty(); }

  /// False if nothing within (t + setback) tangent of a ray at its range t can meet a grid.
  bool MayMeet(const Vec3& origin, const Vec3& direction, double tangent, double setback) const;

  /// Replaces the hits of the sub-rays of a pulse where a leaf comes first.
  void Intercept(std::uint64_t seed, vtkIdType pulseId, const vtkHeliosRay* rays, std::size_t count,
    vtkHeliosHit* hits) const;

private:
  struct Entry
  {
    TurbidGrid Grid;
    vtkIdType FirstCell;
  };

  std::vector<Entry> Grids;
};

} // namespace helios

#endif
