// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosMeshRecords.h"

#include <algorithm>
#include <tuple>

namespace helios
{

namespace
{

bool IsProper(const vtkTypeInt32* c)
{
  return c[0] != c[1] && c[1] != c[2] && c[2] != c[0];
}

FaceRecord MakeFace(const Triangles& triangles, vtkIdType cell)
{
  const vtkTypeInt32* c = triangles.Corners + 3 * cell;
  const auto [low, high] = std::minmax({ c[0], c[1], c[2] });
  const vtkTypeInt32 middle = std::max(std::min(c[0], c[1]), std::min(std::max(c[0], c[1]), c[2]));
  return { low, middle, high, triangles.Groups[cell], cell };
}

SideRecord MakeSide(const Triangles& triangles, vtkIdType cell, int side)
{
  const vtkTypeInt32* c = triangles.Corners + 3 * cell;
  const auto [low, high] = std::minmax({ c[side], c[(side + 1) % 3] });
  return { low, high, triangles.Groups[cell], 3 * cell + side };
}

auto GetOrder(const FaceRecord& face)
{
  return std::tie(face.Middle, face.High, face.Group, face.Cell);
}

auto GetOrder(const SideRecord& side)
{
  return std::tie(side.High, side.Group, side.Use);
}

/// Sorts the output of generate(receiver): into buckets of the lowest point, then within.
template <typename RecordT, typename GenerateT>
std::vector<RecordT> Sort(vtkIdType numberOfPoints, GenerateT generate)
{
  std::vector<std::size_t> ends(static_cast<std::size_t>(numberOfPoints) + 2, 0);
  generate([&ends](const RecordT& record) { ++ends[static_cast<std::size_t>(record.Low) + 2]; });
  for (std::size_t i = 1; i < ends.size(); ++i)
  {
    ends[i] += ends[i - 1];
  }
  std::vector<RecordT> records(ends.back());
  // ends[point + 1]: the beginning of its bucket, and the end once it is full.
  generate([&ends, &records](const RecordT& record)
    { records[ends[static_cast<std::size_t>(record.Low) + 1]++] = record; });
  const auto isLess = [](const RecordT& a, const RecordT& b) { return GetOrder(a) < GetOrder(b); };
  for (std::size_t i = 1; i < ends.size(); ++i)
  {
    std::sort(records.data() + ends[i - 1], records.data() + ends[i], isLess);
  }
  return records;
}

} // namespace

std::vector<SideRecord> SortSides(const Triangles& triangles)
{
  return Sort<SideRecord>(triangles.NumberOfPoints,
    [&triangles](auto receive)
    {
      for (vtkIdType i = 0; i < triangles.Count; ++i)
      {
        for (int side = 0; side < 3 && IsProper(triangles.Corners + 3 * i); ++side)
        {
          receive(MakeSide(triangles, i, side));
        }
      }
    });
}

std::vector<FaceRecord> SortFaces(const Triangles& triangles)
{
  return Sort<FaceRecord>(triangles.NumberOfPoints,
    [&triangles](auto receive)
    {
      for (vtkIdType i = 0; i < triangles.Count; ++i)
      {
        if (IsProper(triangles.Corners + 3 * i))
        {
          receive(MakeFace(triangles, i));
        }
      }
    });
}

} // namespace helios
