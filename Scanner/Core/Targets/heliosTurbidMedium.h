// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// The turbid voxels of a scene: the attenuation of a beam before it hits a surface.

#ifndef heliosTurbidMedium_h
#define heliosTurbidMedium_h

#include "heliosStatus.h"
#include "heliosTurbidGrid.h"
#include "vtkHeliosRay.h"
#include "vtkHeliosScannerCoreModule.h" // For export macro

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

class vtkImageData;

namespace helios
{

/**
 * Each sub-ray is a photon path: it is stopped by a leaf, after a random Beer-Lambert free path, or
 * hits the surface behind. The path is a function of seed, pulse, sub-ray and grid only. Grids may
 * overlap: their densities add up, since the shortest of independent exponential paths is
 * exponential.
 */
class TurbidMedium
{
public:
  /// Adds a grid with the id of its first cell.
  VTKHELIOSSCANNERCORE_EXPORT Status Add(vtkImageData* image, vtkIdType firstCell);

  bool IsEmpty() const { return this->Grids.empty(); }

  /// Returns false if nothing within (t + apexOffset) tangent of a ray at its range t can hit a
  /// grid.
  bool MayMeet(const Vec3& origin, const Vec3& direction, double tangent, double apexOffset) const;

  /// Replaces the hits of the sub-rays of a pulse if a leaf is nearer.
  void Intercept(std::uint64_t seed, vtkIdType pulseId, const vtkHeliosRay* rays, std::size_t count,
    vtkHeliosHit* hits) const;

  /// Replaces the hit of a ray if a leaf is nearer; draw(grid) returns random numbers in (0, 1).
  template <typename DrawT>
  void Stop(
    const Vec3& origin, const Vec3& direction, double range, DrawT draw, vtkHeliosHit& hit) const
  {
    double end = hit.CellId < 0 ? range : hit.Range;
    for (std::size_t g = 0; g < this->Grids.size(); ++g)
    {
      const Entry& entry = this->Grids[g];
      if (!entry.Grid.MayMeet(origin, direction, 0.0, 0.0))
      {
        continue;
      }
      const TurbidHit stop = entry.Grid.FindDepth(origin, direction, end, -std::log(draw(g)));
      if (stop.Cell >= 0)
      {
        hit = { stop.Range, entry.FirstCell + stop.Cell };
        end = stop.Range;
      }
    }
  }

  /// Returns the optical depth of a ray up to a range.
  double GetDepth(const Vec3& origin, const Vec3& direction, double range) const;

  /// Returns the projection of a unit of leaf area in a cell onto a plane across a direction.
  double GetProjection(vtkIdType cell, const Vec3& direction) const;

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
