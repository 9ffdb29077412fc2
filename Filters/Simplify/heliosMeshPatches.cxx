// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosMeshPatches.h"

#include "heliosMeshRecords.h"

#include <algorithm>
#include <numeric>
#include <unordered_map>

namespace helios
{

namespace
{

/// Union-find: disjoint sets of numbers, each identified by its lowest one.
vtkTypeInt32 Find(std::vector<vtkTypeInt32>& sets, vtkTypeInt32 i)
{
  while (sets[i] != i)
  {
    sets[i] = sets[sets[i]];
    i = sets[i];
  }
  return i;
}

void Unite(std::vector<vtkTypeInt32>& sets, vtkTypeInt32 a, vtkTypeInt32 b)
{
  a = Find(sets, a);
  b = Find(sets, b);
  sets[std::max(a, b)] = std::min(a, b);
}

void Flatten(std::vector<vtkTypeInt32>& sets)
{
  for (std::size_t i = 0; i < sets.size(); ++i)
  {
    sets[i] = sets[sets[i]]; // the lower ones are already flat
  }
}

vtkTypeInt32 GetNextCorner(vtkIdType corner)
{
  return static_cast<vtkTypeInt32>(corner % 3 == 2 ? corner - 2 : corner + 1);
}

} // namespace

MeshPatches::MeshPatches(const PatchSource& source, StopCheck& check)
  : Source(source)
  , Fans(source.Corners.size())
  , Components(source.Parts.size())
  , IsLocked(static_cast<std::size_t>(source.NumberOfPoints), false)
{
  std::iota(this->Fans.begin(), this->Fans.end(), 0);
  std::iota(this->Components.begin(), this->Components.end(), 0);
  this->Join(check);
  check.Poll();
  this->Lock();
  check.Poll();
  this->Sort();
}

/// Joins triangles and their corners across edges, and locks the points of all other edges.
void MeshPatches::Join(StopCheck& check)
{
  const vtkTypeInt32* corners = this->Source.Corners.data();
  const Triangles triangles = { corners, this->Source.Parts.data(),
    static_cast<vtkIdType>(this->Source.Parts.size()), this->Source.NumberOfPoints };
  std::vector<bool> isNonManifold(this->Source.Parts.size(), false);
  ForEachEdge(SortSides(triangles),
    [&](const SideRecord* first, const SideRecord* last)
    {
      check.Count();
      const bool isPair = last - first == 2 &&
        IsAscending(first[0], corners) != IsAscending(first[1], corners) &&
        this->Source.Materials[first[0].Use / 3] == this->Source.Materials[first[1].Use / 3];
      if (isPair)
      {
        const auto a = static_cast<vtkTypeInt32>(first[0].Use);
        const auto b = static_cast<vtkTypeInt32>(first[1].Use);
        Unite(this->Components, a / 3, b / 3);
        Unite(this->Fans, a, GetNextCorner(b));
        Unite(this->Fans, GetNextCorner(a), b);
        return;
      }
      this->IsLocked[first->Low] = true;
      this->IsLocked[first->High] = true;
      for (const SideRecord* side = first; last - first > 2 && side != last; ++side)
      {
        isNonManifold[side->Use / 3] = true;
      }
    });
  for (std::size_t i = 0; i < isNonManifold.size(); ++i)
  {
    for (std::size_t k = 3 * i; isNonManifold[i] && k < 3 * i + 3; ++k)
    {
      this->IsLocked[corners[k]] = true;
    }
  }
  this->NonManifold = std::count(isNonManifold.begin(), isNonManifold.end(), true);
  Flatten(this->Components);
  Flatten(this->Fans);
}

/// Locks points where fans meet.
void MeshPatches::Lock()
{
  std::vector<vtkTypeInt32> fanOfPoint(this->IsLocked.size(), -1);
  for (std::size_t i = 0; i < this->Fans.size(); ++i)
  {
    const vtkTypeInt32 point = this->Source.Corners[i];
    if (fanOfPoint[point] < 0)
    {
      fanOfPoint[point] = this->Fans[i];
    }
    else if (fanOfPoint[point] != this->Fans[i])
    {
      this->IsLocked[point] = true;
    }
  }
}

/// Sorts the triangles by patch.
void MeshPatches::Sort()
{
  const std::size_t count = this->Components.size();
  std::vector<vtkIdType> sizes(count, 0);
  std::vector<bool> isFree(count, false);
  for (std::size_t i = 0; i < count; ++i)
  {
    const vtkTypeInt32 patch = this->Components[i];
    ++sizes[patch];
    for (std::size_t k = 3 * i; k < 3 * i + 3; ++k)
    {
      isFree[patch] = isFree[patch] || !this->IsLocked[this->Source.Corners[k]];
    }
  }
  std::vector<vtkTypeInt32> patches;
  for (std::size_t i = 0; i < count; ++i)
  {
    if (!isFree[this->Components[i]])
    {
      this->Fixed.push_back(static_cast<vtkIdType>(i));
    }
    else if (sizes[i] > 0)
    {
      patches.push_back(static_cast<vtkTypeInt32>(i));
    }
  }
  std::stable_sort(patches.begin(), patches.end(),
    [&sizes](vtkTypeInt32 a, vtkTypeInt32 b) { return sizes[a] > sizes[b]; });

  std::vector<std::size_t> next(count, 0);
  this->Begins.assign(1, 0);
  for (const vtkTypeInt32 patch : patches)
  {
    next[patch] = this->Begins.back();
    this->Begins.push_back(next[patch] + static_cast<std::size_t>(sizes[patch]));
  }
  this->Sorted.resize(this->Begins.back());
  for (std::size_t i = 0; i < count; ++i)
  {
    if (isFree[this->Components[i]])
    {
      this->Sorted[next[this->Components[i]]++] = static_cast<vtkIdType>(i);
    }
  }
}

Patch MeshPatches::MakePatch(std::size_t patch, StopCheck& check) const
{
  Patch result;
  result.Cells.assign(
    this->Sorted.data() + this->Begins[patch], this->Sorted.data() + this->Begins[patch + 1]);
  const vtkTypeInt32 first = this->Source.Corners[3 * result.Cells[0]];
  const Vec3 origin(this->Source.Points + 3 * static_cast<vtkIdType>(first));
  std::unordered_map<vtkTypeInt32, vtkTypeInt32> copies; // copies for further fans
  copies.reserve(result.Cells.size());
  for (const vtkIdType cell : result.Cells)
  {
    check.Count();
    for (vtkIdType k = 3 * cell; k < 3 * cell + 3; ++k)
    {
      const auto next = static_cast<vtkTypeInt32>(result.Points.size());
      const auto [copy, isNew] = copies.emplace(this->Fans[k], next);
      if (isNew)
      {
        const vtkTypeInt32 point = this->Source.Corners[k];
        result.Points.push_back(
          Vec3(this->Source.Points + 3 * static_cast<vtkIdType>(point)) - origin);
        result.PointIds.push_back(point);
        result.IsLocked.push_back(this->IsLocked[point]);
      }
      result.Corners.push_back(copy->second);
    }
  }
  return result;
}

} // namespace helios
