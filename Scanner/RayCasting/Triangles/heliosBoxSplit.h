// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Divides boxes by the surface area heuristic. For sources only, as heliosRayVectors.h.

#ifndef heliosBoxSplit_h
#define heliosBoxSplit_h

#include "heliosRayVectors.h"

#include <algorithm>
#include <limits>

namespace helios
{

/// A box that grows; the fourth lane is to be ignored.
struct Extent
{
  Floats Low = Floats() + std::numeric_limits<float>::max();
  Floats High = Floats() - std::numeric_limits<float>::max();

  HELIOS_INLINE void Add(const Floats& low, const Floats& high)
  {
    this->Low = Min<Floats>(this->Low, low);
    this->High = Max<Floats>(this->High, high);
  }
  HELIOS_INLINE void Add(const Extent& other) { this->Add(other.Low, other.High); }
};

/// A node of a binary tree: child i covers Low[i] to High[i], and is the node First[i], or with a
/// Count that is not zero a leaf.
struct SplitNode
{
  float Low[2][3];
  float High[2][3];
  vtkTypeInt32 First[2];
  vtkTypeInt32 Count[2];
};

/**
 * Sixteen bins of centres along each axis. A box B has GetLow() and GetHigh(); its centre counts
 * twice, as their sum. Costs count leaves that are full: four triangles take the time of one.
 */
class BoxBins
{
public:
  static constexpr int Size = 16;
  static constexpr int MaximumDepth = 56; ///< halves below: at most 56 + 31 levels

  /// Sets the bins of centres within an extent; sides: the factors of sides along the axes.
  HELIOS_INLINE BoxBins(const Extent& centres, const Floats& sides)
    : Start(centres.Low)
    , Sides(sides)
  {
    const Floats width = centres.High - centres.Low;
    const Floats scale = Floats() + static_cast<float>(Size);
    this->Scale = width > 0.0f ? scale / width : Floats();
    for (int axis = 0; axis < 3; ++axis)
    {
      // No bin holds a number whose inverse is beyond floats.
      this->IsUsed[axis] = this->Scale[axis] > 0.0f && this->Scale[axis] < 1e30f;
      this->Scale[axis] = this->IsUsed[axis] ? this->Scale[axis] : 0.0f;
    }
  }

  /// Returns the bins of a centre.
  HELIOS_INLINE ShortMasks GetBins(const Floats& centre) const
  {
    const Floats bin = (centre - this->Start) * this->Scale;
    constexpr float last = Size - 1;
    return __builtin_convertvector(
      Min<Floats>(Max<Floats>(bin, Floats()), Floats() + last), ShortMasks);
  }

  template <typename BoxT>
  HELIOS_INLINE void Add(const BoxT& box)
  {
    const Floats low = box.GetLow();
    const Floats high = box.GetHigh();
    const ShortMasks bins = this->GetBins(low + high);
    for (int axis = 0; axis < 3; ++axis)
    {
      this->Bounds[axis][bins[axis]].Add(low, high);
      ++this->Counts[axis][bins[axis]];
    }
  }

  /// Adds the counts and boxes of the same bins.
  void Add(const BoxBins& other)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      for (int i = 0; i < Size; ++i)
      {
        this->Bounds[axis][i].Add(other.Bounds[axis][i]);
        this->Counts[axis][i] += other.Counts[axis][i];
      }
    }
  }

  /// Finds the axis and the first bin of the second half; false if no axis divides them.
  HELIOS_INLINE bool FindSplit()
  {
    float best = std::numeric_limits<float>::max();
    this->Axis = -1;
    for (int axis = 0; axis < 3; ++axis)
    {
      if (this->IsUsed[axis])
      {
        this->TrySplits(axis, best);
      }
    }
    return this->Axis >= 0;
  }

  HELIOS_INLINE bool IsFirst(const Floats& centre) const
  {
    return this->GetBins(centre)[this->Axis] < this->First;
  }

  /// Returns the boxes of the halves.
  HELIOS_INLINE void GetHalves(Extent halves[2]) const
  {
    for (int i = 0; i < Size; ++i)
    {
      halves[i < this->First ? 0 : 1].Add(this->Bounds[this->Axis][i]);
    }
  }

private:
  HELIOS_INLINE float GetCost(const Extent& e, vtkTypeInt32 count) const
  {
    const Floats d = (e.High - e.Low) * this->Sides;
    return (d[0] * d[1] + d[1] * d[2] + d[2] * d[0]) * static_cast<float>((count + 3) / 4);
  }

  HELIOS_INLINE void TrySplits(int axis, float& best)
  {
    float costs[Size];
    Extent below;
    vtkTypeInt32 count = 0;
    for (int i = 1; i < Size; ++i)
    {
      below.Add(this->Bounds[axis][i - 1]);
      count += this->Counts[axis][i - 1];
      costs[i] = count == 0 ? std::numeric_limits<float>::max() : this->GetCost(below, count);
    }
    Extent above;
    count = 0;
    for (int i = Size - 1; i > 0; --i)
    {
      above.Add(this->Bounds[axis][i]);
      count += this->Counts[axis][i];
      const float cost =
        count == 0 ? std::numeric_limits<float>::max() : costs[i] + this->GetCost(above, count);
      if (cost < best)
      {
        best = cost;
        this->Axis = axis;
        this->First = i;
      }
    }
  }

  Floats Start;
  Floats Scale;
  Floats Sides;
  bool IsUsed[3];
  int Axis = -1;
  int First = 0;
  Extent Bounds[3][Size];
  vtkTypeInt32 Counts[3][Size] = {};
};

/// Moves the boxes of the first half to the front, and finds the extents of the centres of both;
/// returns where the second half starts.
template <typename BoxT>
HELIOS_INLINE vtkTypeInt32 Partition(
  BoxT* boxes, vtkTypeInt32 first, vtkTypeInt32 last, const BoxBins& bins, Extent centres[2])
{
  while (first < last)
  {
    const Floats centre = boxes[first].GetLow() + boxes[first].GetHigh();
    const bool isFirst = bins.IsFirst(centre);
    centres[isFirst ? 0 : 1].Add(centre, centre);
    if (isFirst)
    {
      ++first;
    }
    else
    {
      std::swap(boxes[first], boxes[--last]);
    }
  }
  return first;
}

/// Halves boxes along the longest side of the extent of their centres.
template <typename BoxT>
vtkTypeInt32 Halve(
  BoxT* boxes, vtkTypeInt32 first, vtkTypeInt32 last, const Extent& extent, Extent centres[2])
{
  const Floats width = extent.High - extent.Low;
  const int axis =
    width[0] >= width[1] ? (width[0] >= width[2] ? 0 : 2) : (width[1] >= width[2] ? 1 : 2);
  const vtkTypeInt32 middle = first + (last - first) / 2;
  std::nth_element(boxes + first, boxes + middle, boxes + last,
    [axis](const BoxT& a, const BoxT& b)
    { return a.GetLow()[axis] + a.GetHigh()[axis] < b.GetLow()[axis] + b.GetHigh()[axis]; });
  for (vtkTypeInt32 i = first; i < last; ++i)
  {
    const Floats centre = boxes[i].GetLow() + boxes[i].GetHigh();
    centres[i < middle ? 0 : 1].Add(centre, centre);
  }
  return middle;
}

} // namespace helios

#endif
