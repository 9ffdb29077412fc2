// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosOctreeNodes.h"

#include <numeric>
#include <utility>

namespace helios
{

namespace
{

/// A step of spreading: where bits are moved, and those that stay.
struct Step
{
  int Shift;
  std::uint64_t Mask;
};

constexpr std::uint64_t AxisMask = 0x1249249249249249;
constexpr Step Steps[] = { { 32, 0x1F00000000FFFF }, { 16, 0x1F0000FF0000FF },
  { 8, 0x100F00F00F00F00F }, { 4, 0x10C30C30C30C30C3 }, { 2, AxisMask } };

/// Returns the part of a code that is common to a cell of a number of bits per axis.
std::uint64_t GetCell(std::uint64_t code, int bits)
{
  return code >> 3 * (MortonBits - bits);
}

} // namespace

std::uint64_t SpreadMorton(std::uint64_t value)
{
  for (const Step& step : Steps)
  {
    value = (value | (value << step.Shift)) & step.Mask;
  }
  return value;
}

std::uint64_t GatherMorton(std::uint64_t code)
{
  constexpr std::uint64_t mask = (std::uint64_t(1) << MortonBits) - 1;
  code &= AxisMask;
  for (int i = 4; i >= 0; --i)
  {
    code = (code | (code >> Steps[i].Shift)) & (i > 0 ? Steps[i - 1].Mask : mask);
  }
  return code;
}

OctreeNodes::OctreeNodes(std::size_t length, UseNode use)
  : Length(length)
  , Use(std::move(use))
{
}

Status OctreeNodes::Add(const SortedPoint& point)
{
  int level = 0;
  while (level <= Deepest && this->Levels[level].IsOpen &&
    this->Levels[level].Node.Code == GetCell(point.Code, level))
  {
    ++level;
  }
  const Status status = this->CloseFrom(level);
  for (level = 0; level <= Deepest; ++level)
  {
    Open& open = this->Levels[level];
    const std::uint64_t cell = GetCell(point.Code, level + OctreeGridBits);
    if (open.IsOpen && open.Cell == cell && level < Deepest)
    {
      continue;
    }
    open.IsOpen = true;
    open.Cell = cell;
    open.Node.Level = level;
    open.Node.Code = GetCell(point.Code, level);
    open.Node.Indices.push_back(point.Index);
    open.Node.Records.insert(open.Node.Records.end(), point.Record, point.Record + this->Length);
    break;
  }
  return status;
}

/// Ends the open nodes of a level and below.
Status OctreeNodes::CloseFrom(int level)
{
  Status status;
  for (int i = Deepest; i >= level && status.IsOk(); --i)
  {
    status = this->Levels[i].IsOpen ? this->Close(i) : status;
  }
  return status;
}

/// Ends a node. Few points of it and its children become one node, which its parent may take, too.
Status OctreeNodes::Close(int level)
{
  Open closed = std::exchange(this->Levels[level], Open());
  OctreeNode& node = closed.Node;
  const std::uint64_t total =
    std::accumulate(closed.Children.begin(), closed.Children.end(), node.Indices.size(),
      [](std::size_t sum, const OctreeNode& child) { return sum + child.Indices.size(); });
  if (!closed.IsDivided && total <= Few)
  {
    for (const OctreeNode& child : closed.Children)
    {
      node.Indices.insert(node.Indices.end(), child.Indices.begin(), child.Indices.end());
      node.Records.insert(node.Records.end(), child.Records.begin(), child.Records.end());
    }
    if (level == 0)
    {
      return this->Use(std::move(node));
    }
    this->Levels[level - 1].Children.push_back(std::move(node));
    return {};
  }
  Status status;
  for (OctreeNode& child : closed.Children)
  {
    status = status.IsOk() ? this->Use(std::move(child)) : status;
  }
  if (level > 0)
  {
    this->Levels[level - 1].IsDivided = true;
  }
  return status.IsOk() ? this->Use(std::move(node)) : status;
}

} // namespace helios
