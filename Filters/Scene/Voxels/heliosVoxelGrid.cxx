// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosVoxelGrid.h"

#include <algorithm>

namespace helios
{

void VoxelMap::Clear()
{
  constexpr int bits = 10;
  if (this->Size < this->Entries.size() / 8 || this->Entries.empty())
  {
    this->Entries.assign(std::size_t(1) << bits, Entry());
    this->Shift = 64 - bits;
  }
  else
  {
    std::fill(this->Entries.begin(), this->Entries.end(), Entry());
  }
  this->Mask = this->Entries.size() - 1;
  this->Size = 0;
}

std::uint32_t VoxelMap::Add(std::size_t slot, VoxelKey key)
{
  const std::uint32_t id = this->Size++;
  this->Entries[slot] = { key, id };
  if (this->Size > this->Entries.size() / 10 * 7)
  {
    this->Grow();
  }
  return id;
}

void VoxelMap::Grow()
{
  std::vector<Entry> entries(2 * this->Entries.size());
  entries.swap(this->Entries);
  this->Mask = this->Entries.size() - 1;
  --this->Shift;
  for (const Entry& entry : entries)
  {
    if (entry.Key != 0)
    {
      std::size_t slot = this->GetSlot(entry.Key);
      while (this->Entries[slot].Key != 0)
      {
        slot = (slot + 1) & this->Mask;
      }
      this->Entries[slot] = entry;
    }
  }
}

std::vector<VoxelMap::Entry> VoxelMap::ReleaseSorted()
{
  std::vector<Entry> entries;
  entries.swap(this->Entries);
  this->Clear();
  const auto isEmpty = [](const Entry& entry) { return entry.Key == 0; };
  entries.erase(std::remove_if(entries.begin(), entries.end(), isEmpty), entries.end());
  const auto isBefore = [](const Entry& a, const Entry& b) { return a.Key < b.Key; };
  std::sort(entries.begin(), entries.end(), isBefore);
  return entries;
}

struct VoxelGrid::Block
{
  static constexpr int Size = 256;
  VoxelKey Keys[Size];
  std::uint32_t Ids[Size];
  double Local[Size][3]; ///< from the centre of the cell, in cells
};

VoxelGrid::VoxelGrid(const double origin[3], double size, double epsilon, const Contents& contents)
  : Size(size)
  , Epsilon(epsilon)
  , Wanted(contents)
{
  std::copy_n(origin, 3, this->Origin);
}

std::uint32_t VoxelGrid::Find(VoxelKey key)
{
  if (key == this->LastKey)
  {
    return this->LastId;
  }
  const std::uint32_t known = this->Map.GetSize();
  const std::uint32_t id = this->Map.Insert(key);
  if (id == known)
  {
    const std::size_t size = known + std::size_t(1);
    this->Counts.resize(this->Wanted.Counts ? size : 0);
    this->Normals.resize(this->Wanted.Normals ? size : 0);
    this->Nearest.resize(this->Wanted.Nearest ? size : 0);
    this->Planes.resize(this->Wanted.Planes ? size : 0);
    this->Colors.resize(this->Wanted.Colors ? size : 0);
  }
  this->LastKey = key;
  this->LastId = id;
  return id;
}

bool VoxelGrid::Add(const VoxelPoints& points, vtkIdType maximumNumberOfCells)
{
  Block block;
  for (vtkIdType first = 0; first < points.Count; first += Block::Size)
  {
    const int count = static_cast<int>(std::min<vtkIdType>(Block::Size, points.Count - first));
    this->Place(points.Points + 3 * first, count, block);
    for (int i = 0; i < count; ++i)
    {
      block.Ids[i] = this->Find(block.Keys[i]);
    }
    this->Gather(block, count, points, first);
    if (this->Map.GetSize() > maximumNumberOfCells)
    {
      return false;
    }
  }
  return true;
}

void VoxelGrid::Place(const double* points, int count, Block& block) const
{
  for (int i = 0; i < count; ++i)
  {
    std::int64_t cell[3];
    for (int axis = 0; axis < 3; ++axis)
    {
      const double x = points[3 * i + axis];
      const double index = GetVoxelIndex(x, this->Origin[axis], this->Size, this->Epsilon);
      cell[axis] = static_cast<std::int64_t>(index);
      block.Local[i][axis] = (x - this->Origin[axis]) / this->Size - (index + 0.5);
    }
    block.Keys[i] = MakeVoxelKey(cell);
    this->Map.Prefetch(block.Keys[i]);
  }
}

void VoxelGrid::Gather(const Block& block, int count, const VoxelPoints& points, vtkIdType first)
{
  for (int i = 0; this->Wanted.Counts && i < count; ++i)
  {
    std::uint32_t& number = this->Counts[block.Ids[i]];
    number += number < std::numeric_limits<std::uint32_t>::max();
  }
  for (int i = 0; this->Wanted.Planes && i < count; ++i)
  {
    __builtin_prefetch(&this->Planes[block.Ids[std::min(i + 8, count - 1)]], 1);
    this->Planes[block.Ids[i]].Add(block.Local[i]);
  }
  for (int i = 0; this->Wanted.Colors && i < count; ++i)
  {
    this->Colors[block.Ids[i]].Add(points.Colors + 3 * (first + i));
  }
  for (int i = 0; (this->Wanted.Normals || this->Wanted.Nearest) && i < count; ++i)
  {
    const Vec3 normal = GetUnit(Vec3(points.Normals + 3 * (first + i)));
    const Vec3 local(block.Local[i]);
    if (normal == Vec3(0.0, 0.0, 0.0))
    {
      continue; // none
    }
    if (this->Wanted.Normals)
    {
      this->Normals[block.Ids[i]].Add(normal);
    }
    if (this->Wanted.Nearest)
    {
      this->Nearest[block.Ids[i]].Add(local.Dot(local), normal);
    }
  }
}

std::vector<VoxelMap::Entry> VoxelGrid::ReleaseCells(vtkIdType minimumNumberOfPoints)
{
  std::vector<VoxelMap::Entry> cells = this->Map.ReleaseSorted();
  if (this->Wanted.Counts)
  {
    const auto hasFew = [this, minimumNumberOfPoints](const VoxelMap::Entry& cell)
    { return this->Counts[cell.Id] < minimumNumberOfPoints; };
    cells.erase(std::remove_if(cells.begin(), cells.end(), hasFew), cells.end());
  }
  return cells;
}

Vec3 VoxelGrid::GetNormal(std::uint32_t id) const
{
  return this->Wanted.Planes ? this->Planes[id].GetNormal()
    : this->Wanted.Nearest   ? Vec3(this->Nearest[id].Normal)
                             : this->Normals[id].GetNormal();
}

Vec3 VoxelGrid::GetColor(std::uint32_t id) const
{
  return this->Colors[id].GetColor();
}

} // namespace helios
