// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Finds points at the same position.

#ifndef heliosPointMerger_h
#define heliosPointMerger_h

#include "vtkHeliosFiltersSceneModule.h" // For export macro

#include <vtkType.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace helios
{

/**
 * A hash table of points by position: one probe per point at tolerance 0, eight at any other, for
 * any extent of the points (the buckets of a regular grid overflow for a tree on 20 km of terrain).
 */
class VTKHELIOSFILTERSSCENE_EXPORT PointMerger
{
public:
  /// Refers to count points x, y, z, which must outlive this. Tolerance 0: equal coordinates only.
  PointMerger(const double* points, vtkIdType count, double tolerance);

  /**
   * The lowest earlier point that represents itself, in the same group and within the tolerance;
   * else the point itself. Add points in ascending order.
   */
  vtkTypeInt32 Add(vtkTypeInt32 point, int group);

private:
  struct Place
  {
    double X[3];
  };
  std::size_t GetSlot(const Place& cell) const;
  Place GetCell(const double* p) const;
  bool AreNear(const double* p, const double* q) const;
  vtkTypeInt32 Find(std::size_t slot, vtkTypeInt32 point, int group) const;

  const double* Points;
  double Tolerance;
  std::vector<vtkTypeInt32> Heads; ///< first point of the chain of a slot; -1: none
  std::vector<vtkTypeInt32> Next;  ///< next point in the chain
  std::vector<int> Groups;
};

} // namespace helios

#endif
