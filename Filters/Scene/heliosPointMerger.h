// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Finds points at the same place.

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
 * A hash table of points by place: one probe a point at tolerance 0, eight at any other, whatever
 * the spread of the points (the buckets of a regular grid overflow where a tree stands on 20 km of
 * terrain).
 */
class VTKHELIOSFILTERSSCENE_EXPORT PointMerger
{
public:
  /// Over that many points x, y, z; they must outlive this. Tolerance 0: equal coordinates only.
  PointMerger(const double* points, vtkIdType count, double tolerance);

  /**
   * The lowest point so far, of those that stand for themselves, of the same group and no further
   * away than the tolerance; the point itself if there is none. Add points in ascending order.
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
  std::vector<vtkTypeInt32> Heads; ///< of the chain of a slot; -1: none
  std::vector<vtkTypeInt32> Next;  ///< of a point in its chain
  std::vector<int> Groups;
};

} // namespace helios

#endif
