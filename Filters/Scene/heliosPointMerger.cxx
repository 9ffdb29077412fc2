// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosPointMerger.h"

#include <cmath>
#include <cstring>

namespace helios
{

PointMerger::PointMerger(const double* points, vtkIdType count, double tolerance)
  : Points(points)
  , Tolerance(tolerance)
{
  std::size_t size = 16;
  while (size < 2 * static_cast<std::size_t>(count))
  {
    size *= 2;
  }
  this->Heads.assign(size, -1);
  this->Next.assign(static_cast<std::size_t>(count), -1);
  this->Groups.assign(static_cast<std::size_t>(count), 0);
}

std::size_t PointMerger::GetSlot(const Place& cell) const
{
  std::uint64_t hash = 0;
  for (const double x : cell.X)
  {
    const double positive = x + 0.0; // maps -0 to 0
    std::uint64_t bits;
    std::memcpy(&bits, &positive, sizeof(bits));
    hash = (hash ^ bits) * 0x9e3779b97f4a7c15u;
    hash ^= hash >> 32;
  }
  return static_cast<std::size_t>(hash) & (this->Heads.size() - 1);
}

PointMerger::Place PointMerger::GetCell(const double* p) const
{
  const double width = 2.0 * this->Tolerance;
  return { { std::floor(p[0] / width), std::floor(p[1] / width), std::floor(p[2] / width) } };
}

bool PointMerger::AreNear(const double* p, const double* q) const
{
  const double d[3] = { p[0] - q[0], p[1] - q[1], p[2] - q[2] };
  return this->Tolerance > 0.0
    ? d[0] * d[0] + d[1] * d[1] + d[2] * d[2] <= this->Tolerance * this->Tolerance
    : d[0] == 0.0 && d[1] == 0.0 && d[2] == 0.0; // squares may underflow
}

vtkTypeInt32 PointMerger::Find(std::size_t slot, vtkTypeInt32 point, int group) const
{
  const double* p = this->Points + 3 * static_cast<std::ptrdiff_t>(point);
  vtkTypeInt32 found = point;
  for (vtkTypeInt32 other = this->Heads[slot]; other >= 0; other = this->Next[other])
  {
    const double* q = this->Points + 3 * static_cast<std::ptrdiff_t>(other);
    if (other < found && this->Groups[other] == group && this->AreNear(p, q))
    {
      found = other;
    }
  }
  return found;
}

vtkTypeInt32 PointMerger::Add(vtkTypeInt32 point, int group)
{
  const double* p = this->Points + 3 * static_cast<std::ptrdiff_t>(point);
  Place home = { { p[0], p[1], p[2] } };
  vtkTypeInt32 found = point;
  if (this->Tolerance > 0.0)
  {
    // Cells are twice the tolerance wide: near points are in this one or its nearer neighbours.
    home = this->GetCell(p);
    for (int corner = 0; corner < 8; ++corner)
    {
      Place cell = home;
      for (int axis = 0; axis < 3; ++axis)
      {
        const bool isInLowHalf = p[axis] / (2.0 * this->Tolerance) - home.X[axis] < 0.5;
        cell.X[axis] += (corner >> axis & 1) == 0 ? 0.0 : isInLowHalf ? -1.0 : 1.0;
      }
      const vtkTypeInt32 near = this->Find(this->GetSlot(cell), point, group);
      found = near < found ? near : found;
    }
  }
  else
  {
    found = this->Find(this->GetSlot(home), point, group);
  }
  if (found == point)
  {
    const std::size_t slot = this->GetSlot(home);
    this->Next[point] = this->Heads[slot];
    this->Heads[slot] = point;
    this->Groups[point] = group;
  }
  return found;
}

} // namespace helios
