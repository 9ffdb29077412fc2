// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Accumulates points in cubic cells; only cells with points use memory. Sums are integers, so they
// do not depend on the order of the points.

#ifndef heliosVoxelGrid_h
#define heliosVoxelGrid_h

#include "heliosVoxelSums.h"

#include <cstdint>
#include <cstring>
#include <vector>

namespace helios
{

/**
 * Returns the index of the half-open cell [i s, (i + 1) s) from x0 that contains x, for x >= x0. A
 * quotient that rounding may have put below an integer counts as that integer: decimal lattice
 * points, in double or (epsilon = 2^-23) in float, are in the cell of their decimal value.
 */
inline double GetVoxelIndex(double x, double x0, double s, double epsilon = 0x1p-52)
{
  const double q = (x - x0) / s;
  const double below = static_cast<double>(static_cast<std::int64_t>(q));
  const double magnitude = std::max(std::abs(x), std::abs(x0));
  std::uint64_t bits = 0;
  std::memcpy(&bits, &magnitude, sizeof bits);
  bits &= 0x7ff0000000000000; // the power of two of its binade
  double power = 0.0;
  std::memcpy(&power, &bits, sizeof power);
  const double tolerance = 2.0 * power * epsilon / s + 4.0 * 0x1p-52 * std::max(1.0, q);
  return below + (below + 1.0 - q <= tolerance ? 1.0 : 0.0);
}

/// A cell, or a cell corner, as one number; sorted along x first, then y, then z.
using VoxelKey = std::uint64_t;

constexpr int VoxelKeyBits = 21;
constexpr VoxelKey VoxelKeyMask = (VoxelKey(1) << VoxelKeyBits) - 1;
/// Key increments along x, y and z.
constexpr VoxelKey VoxelStep[3] = { 1, VoxelKey(1) << VoxelKeyBits,
  VoxelKey(1) << (2 * VoxelKeyBits) };
/// Cells per axis: keys count from 1, so that both ends have valid neighbours.
constexpr std::int64_t MaximumVoxelsAlongAxis = static_cast<std::int64_t>(VoxelKeyMask) - 2;

inline VoxelKey MakeVoxelKey(const std::int64_t index[3])
{
  return static_cast<VoxelKey>(index[0] + 1) * VoxelStep[0] +
    static_cast<VoxelKey>(index[1] + 1) * VoxelStep[1] +
    static_cast<VoxelKey>(index[2] + 1) * VoxelStep[2];
}

inline std::int64_t GetVoxelIndexAlong(VoxelKey key, int axis)
{
  return static_cast<std::int64_t>((key >> (VoxelKeyBits * axis)) & VoxelKeyMask) - 1;
}

/// Numbers keys from 0 in order of insertion.
class VoxelMap
{
public:
  struct Entry
  {
    VoxelKey Key = 0; // 0: none
    std::uint32_t Id = 0;
  };

  VoxelMap() { this->Clear(); }

  void Clear();
  std::uint32_t GetSize() const { return this->Size; }

  /// Returns the number of a key: GetSize() before the call if the key is new.
  std::uint32_t Insert(VoxelKey key)
  {
    std::size_t slot = this->GetSlot(key);
    for (; this->Entries[slot].Key != key; slot = (slot + 1) & this->Mask)
    {
      if (this->Entries[slot].Key == 0)
      {
        return this->Add(slot, key);
      }
    }
    return this->Entries[slot].Id;
  }

  /// Prefetches the memory that Insert will read.
  void Prefetch(VoxelKey key) const { __builtin_prefetch(&this->Entries[this->GetSlot(key)], 1); }

  /// Returns the entries by key; the map is empty afterwards.
  std::vector<Entry> ReleaseSorted();

private:
  std::size_t GetSlot(VoxelKey key) const
  {
    return static_cast<std::size_t>((key * 0x9E3779B97F4A7C15u) >> this->Shift);
  }
  std::uint32_t Add(std::size_t slot, VoxelKey key);
  void Grow();

  std::vector<Entry> Entries;
  std::size_t Mask = 0;
  int Shift = 64;
  std::uint32_t Size = 0;
};

/// Points and their attributes, one value each; null: missing.
struct VoxelPoints
{
  const double* Points = nullptr;
  const double* Normals = nullptr;
  const std::uint16_t* Colors = nullptr; ///< full scale: 65535
  vtkIdType Count = 0;
};

/// The cells with points, and the sums of each.
class VoxelGrid
{
public:
  /// The attributes to accumulate.
  struct Contents
  {
    bool Counts = false;
    bool Normals = false; ///< the sum of normals
    bool Nearest = false; ///< the normal of the point nearest to the centre
    bool Planes = false;  ///< the plane fitted to the points
    bool Colors = false;
  };

  /// The origin is the minimum of the points; epsilon is the precision of the coordinates (2^-52,
  /// or 2^-23).
  VoxelGrid(const double origin[3], double size, double epsilon, const Contents& contents);

  /// Adds points. False if there are more than the maximum number of cells.
  bool Add(const VoxelPoints& points, vtkIdType maximumNumberOfCells);

  vtkIdType GetNumberOfCells() const { return this->Map.GetSize(); }
  /// Cells with at least this many points, by key; to be called once, at the end.
  std::vector<VoxelMap::Entry> ReleaseCells(vtkIdType minimumNumberOfPoints);

  /// @{
  /// Returns the result for the cell of an entry. A normal of 0 0 0 means no normal.
  Vec3 GetNormal(std::uint32_t id) const;
  Vec3 GetColor(std::uint32_t id) const;
  ///@}

  const double* GetOrigin() const { return this->Origin; }
  double GetVoxelSize() const { return this->Size; }

private:
  /// Points in order of processing: later ones are prefetched while earlier ones are processed.
  struct Block;

  void Place(const double* points, int count, Block& block) const;
  std::uint32_t Find(VoxelKey key);
  void Gather(const Block& block, int count, const VoxelPoints& points, vtkIdType first);

  double Origin[3];
  double Size;
  double Epsilon;
  Contents Wanted;
  VoxelMap Map;
  VoxelKey LastKey = 0; // consecutive points are often in one cell
  std::uint32_t LastId = 0;
  std::vector<std::uint32_t> Counts;
  std::vector<NormalSum> Normals;
  std::vector<NearestNormal> Nearest;
  std::vector<PlaneSum> Planes;
  std::vector<ColorSum> Colors;
};

} // namespace helios

#endif
