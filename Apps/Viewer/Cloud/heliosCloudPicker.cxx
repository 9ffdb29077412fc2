// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosCloudPicker.h"

#include "heliosPixelMap.h"

#include <vtkSMPThreadLocal.h>
#include <vtkSMPTools.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <tuple>

namespace helios::viewer
{

namespace
{

/// The best first: covers the spot, then nearest, then closest to the camera.
struct Candidate
{
  double Distance = HUGE_VAL; ///< [pixels], 0: covers the spot
  double Depth = HUGE_VAL;
  vtkIdType Row = -1;

  bool operator<(const Candidate& b) const
  {
    return std::tie(this->Distance, this->Depth, this->Row) < std::tie(b.Distance, b.Depth, b.Row);
  }
};

struct Search
{
  const Cloud& Points;
  const CloudWindow& Window;
  const PixelMap Pixels;
  const PickSpot Spot;
  const double Reach; ///< [pixels]
  vtkSMPThreadLocal<Candidate> Best;

  void operator()(vtkIdType begin, vtkIdType end)
  {
    Candidate& best = this->Best.Local();
    for (vtkIdType c = begin; c < end; ++c)
    {
      const CloudChunk& chunk = *this->Points.GetChunks()[static_cast<std::size_t>(c)];
      if (!this->Window.IsOutside(chunk) &&
        this->Pixels.MayShow(chunk.Bounds, this->Spot.X, this->Spot.Y, this->Reach))
      {
        this->Scan(chunk, best);
      }
    }
  }

  void Scan(const CloudChunk& chunk, Candidate& best) const
  {
    const float* xyz = chunk.GetXyz();
    for (vtkIdType i = 0; i < chunk.GetSize(); ++i, xyz += 3)
    {
      double pixel[3];
      if (!this->Pixels.Map(xyz[0], xyz[1], xyz[2], pixel))
      {
        continue;
      }
      const double dx = std::abs(pixel[0] - this->Spot.X), dy = std::abs(pixel[1] - this->Spot.Y);
      const double distance = std::hypot(dx, dy);
      const bool covers = std::max(dx, dy) <= 0.5 * this->Spot.PointSize;
      if (!covers && distance > this->Spot.Radius)
      {
        continue;
      }
      const Candidate candidate{ covers ? 0.0 : distance, pixel[2], chunk.FirstRow + i };
      if (candidate < best && this->Window.Contains(chunk, i))
      {
        best = candidate;
      }
    }
  }
};

/// The closest point of every pixel, packed as depth bits and row in one number.
struct VisibleSearch
{
  static constexpr std::uint64_t Nothing = ~std::uint64_t(0);

  const Cloud& Points;
  const CloudWindow& Window;
  const PixelMap& Pixels;
  vtkSMPThreadLocal<std::vector<std::uint64_t>> Closest;

  std::size_t GetSize() const
  {
    return static_cast<std::size_t>(this->Pixels.GetWidth()) *
      static_cast<std::size_t>(this->Pixels.GetHeight());
  }

  void operator()(vtkIdType begin, vtkIdType end)
  {
    std::vector<std::uint64_t>& closest = this->Closest.Local();
    closest.resize(this->GetSize(), Nothing);
    for (vtkIdType c = begin; c < end; ++c)
    {
      const CloudChunk& chunk = *this->Points.GetChunks()[static_cast<std::size_t>(c)];
      if (!this->Window.IsOutside(chunk))
      {
        this->Scan(chunk, closest);
      }
    }
  }

  void Scan(const CloudChunk& chunk, std::vector<std::uint64_t>& closest) const
  {
    const bool isWhole = !this->Window.IsClipped() && !(chunk.LastTime > this->Window.TimeLimit);
    const float* xyz = chunk.GetXyz();
    for (vtkIdType i = 0; i < chunk.GetSize(); ++i, xyz += 3)
    {
      double pixel[3];
      if (!this->Pixels.Map(xyz[0], xyz[1], xyz[2], pixel) ||
        !(isWhole || this->Window.Contains(chunk, i)))
      {
        continue;
      }
      const vtkIdType index = this->Pixels.GetIndex(pixel);
      if (index >= 0)
      {
        const auto depth =
          static_cast<float>(1.0 + pixel[2]); // not negative: its bits sort in order
        std::uint32_t bits;
        std::memcpy(&bits, &depth, sizeof(bits));
        const std::uint64_t key =
          (std::uint64_t(bits) << 32) | static_cast<std::uint32_t>(chunk.FirstRow + i);
        std::uint64_t& best = closest[static_cast<std::size_t>(index)];
        best = std::min(best, key);
      }
    }
  }
};

/// Returns whether a box x0 x1 y0 y1 z0 z1 lies on one side of a slab.
bool IsOutsideSlab(const Slab& slab, const double bounds[6])
{
  double low = 0.0, high = 0.0;
  for (int axis = 0; axis < 3; ++axis)
  {
    const double a = slab.Normal[axis] * bounds[2 * axis];
    const double b = slab.Normal[axis] * bounds[2 * axis + 1];
    low += std::min(a, b);
    high += std::max(a, b);
  }
  return high < slab.Low || low > slab.High;
}

} // namespace

//------------------------------------------------------------------------------
bool CloudWindow::IsOutside(const CloudChunk& chunk) const
{
  if (chunk.FirstTime > this->TimeLimit)
  {
    return true;
  }
  for (int axis = 0; this->HasBox && axis < 3; ++axis)
  {
    if (chunk.Bounds[2 * axis] > this->Box[2 * axis + 1] ||
      chunk.Bounds[2 * axis + 1] < this->Box[2 * axis])
    {
      return true;
    }
  }
  return this->HasSlab && IsOutsideSlab(this->Section, chunk.Bounds);
}

//------------------------------------------------------------------------------
bool CloudWindow::Contains(const CloudChunk& chunk, vtkIdType i) const
{
  if (chunk.GetTime(i) > this->TimeLimit) // false for NaN times
  {
    return false;
  }
  const float* p = chunk.GetXyz() + 3 * i;
  for (int axis = 0; this->HasBox && axis < 3; ++axis)
  {
    const auto at = static_cast<double>(p[axis]);
    if (at < this->Box[2 * axis] || at > this->Box[2 * axis + 1])
    {
      return false;
    }
  }
  return !this->HasSlab || this->Section.Contains(Vec3(p[0], p[1], p[2]));
}

//------------------------------------------------------------------------------
vtkIdType PickPoint(
  const Cloud& cloud, const CloudWindow& window, vtkRenderer* renderer, const PickSpot& spot)
{
  Search search{ cloud, window, PixelMap(renderer), spot, spot.Radius + spot.PointSize, {} };
  vtkSMPTools::For(0, static_cast<vtkIdType>(cloud.GetChunks().size()), 1, search);
  Candidate best;
  for (const Candidate& candidate : search.Best)
  {
    best = std::min(best, candidate);
  }
  return best.Row;
}

//------------------------------------------------------------------------------
std::vector<std::uint32_t> FindVisiblePoints(
  const Cloud& cloud, const CloudWindow& window, const PixelMap& pixels)
{
  VisibleSearch search{ cloud, window, pixels, {} };
  vtkSMPTools::For(0, static_cast<vtkIdType>(cloud.GetChunks().size()), 1, search);
  std::vector<std::uint64_t> all(search.GetSize(), VisibleSearch::Nothing);
  for (const std::vector<std::uint64_t>& closest : search.Closest)
  {
    std::transform(closest.begin(), closest.end(), all.begin(), all.begin(),
      [](std::uint64_t a, std::uint64_t b) { return std::min(a, b); });
  }
  std::vector<std::uint32_t> rows;
  for (const std::uint64_t key : all)
  {
    if (key != VisibleSearch::Nothing)
    {
      rows.push_back(static_cast<std::uint32_t>(key));
    }
  }
  return rows;
}

} // namespace helios::viewer
