// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosBeamFan.h"

#include "heliosCloud.h"

#include <algorithm>

namespace helios::viewer
{

namespace
{

/// Returns the number of points up to a time, in a cloud in time order.
vtkIdType CountUntil(const Cloud& cloud, double time)
{
  const auto& chunks = cloud.GetChunks();
  const auto after = std::partition_point(
    chunks.begin(), chunks.end(), [time](const auto& chunk) { return chunk->FirstTime <= time; });
  if (after == chunks.begin())
  {
    return 0;
  }
  const CloudChunk& chunk = **std::prev(after);
  const auto late = std::upper_bound(chunk.Times.begin(), chunk.Times.end(), time - chunk.TimeBase,
    [](double limit, float own) { return limit < static_cast<double>(own); });
  return chunk.FirstRow + static_cast<vtkIdType>(late - chunk.Times.begin());
}

} // namespace

//------------------------------------------------------------------------------
std::vector<Vec3> FindNewestPoints(
  const Cloud& cloud, double time, double duration, std::size_t count)
{
  double range[2];
  if (!cloud.GetTimeRange(range) || count == 0)
  {
    return {};
  }
  const double end = std::min(time, range[1]);
  const vtkIdType last = CountUntil(cloud, end);
  const vtkIdType first = std::min(last, CountUntil(cloud, end - duration));
  const auto points = static_cast<std::size_t>(last - first);
  std::vector<Vec3> found;
  const std::size_t step = std::max<std::size_t>(1, (points + count - 1) / count);
  for (std::size_t i = 0; i < points; i += step)
  {
    found.push_back(cloud.GetEcho(last - 1 - static_cast<vtkIdType>(i)).Position);
  }
  return found;
}

} // namespace helios::viewer
