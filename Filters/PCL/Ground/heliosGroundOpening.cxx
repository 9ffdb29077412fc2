// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosGroundOpening.h"

#include <vtkSMPTools.h>
#include <vtkType.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <vector>

namespace helios
{

namespace
{

using Cloud = pcl::PointCloud<pcl::PointXYZ>;

/// Bins across a window.
constexpr double BinsOfWindow = 8.0;

/// Bins per point.
constexpr double BinsOfPoint = 2.0;

struct Rectangle
{
  float Low[2] = { HUGE_VALF, HUGE_VALF };
  float High[2] = { -HUGE_VALF, -HUGE_VALF };

  void Add(const pcl::PointXYZ& p)
  {
    for (int axis = 0; axis < 2; ++axis)
    {
      this->Low[axis] = std::min(this->Low[axis], p.data[axis]);
      this->High[axis] = std::max(this->High[axis], p.data[axis]);
    }
  }
  bool Holds(const pcl::PointXYZ& p) const
  {
    return this->Low[0] <= p.x && p.x <= this->High[0] && this->Low[1] <= p.y &&
      p.y <= this->High[1];
  }
  bool Holds(const Rectangle& other) const
  {
    return this->Low[0] <= other.Low[0] && other.High[0] <= this->High[0] &&
      this->Low[1] <= other.Low[1] && other.High[1] <= this->High[1];
  }
};

/// The minimum, or maximum, values of points within windows: by bins that are entirely inside a
/// window, point by point in the others.
class Windows
{
public:
  Windows(const Cloud& points, float size)
    : Points(points)
    , Half(size / 2.0F)
    , BinOf(points.size())
  {
    Rectangle bounds;
    std::for_each(points.begin(), points.end(), [&](const pcl::PointXYZ& p) { bounds.Add(p); });
    this->SetBins(bounds, static_cast<double>(size) / BinsOfWindow);
    const auto count = static_cast<std::size_t>(this->Across[0]) * this->Across[1];
    this->Begin.resize(count + 1);
    this->Bounds.resize(count);
    this->Extremes.resize(count);
    for (std::size_t i = 0; i < points.size(); ++i)
    {
      this->BinOf[i] =
        this->GetBin(0, points[i].x) * this->Across[1] + this->GetBin(1, points[i].y);
      this->Bounds[this->BinOf[i]].Add(points[i]);
      ++this->Begin[this->BinOf[i] + 1];
    }
    std::partial_sum(this->Begin.begin(), this->Begin.end(), this->Begin.begin());
    std::vector<std::size_t> next(this->Begin.begin(), this->Begin.end() - 1);
    this->Order.resize(points.size());
    for (std::size_t i = 0; i < points.size(); ++i)
    {
      this->Order[next[this->BinOf[i]]++] = i;
    }
  }

  /// Replaces the value of each point by the minimum within its window, times a sign: -1 makes it
  /// the maximum. False: stopped.
  bool Reduce(float sign, const GoOn& goOn, std::vector<float>& values)
  {
    std::vector<float> from(values.size());
    std::transform(
      values.begin(), values.end(), from.begin(), [sign](float value) { return sign * value; });
    std::fill(this->Extremes.begin(), this->Extremes.end(), HUGE_VALF);
    for (std::size_t i = 0; i < from.size(); ++i)
    {
      float& minimum = this->Extremes[this->BinOf[i]];
      minimum = std::min(minimum, from[i]);
    }
    return ForChunks(values.size(), goOn,
      [&](std::size_t begin, std::size_t end)
      {
        vtkSMPTools::For(static_cast<vtkIdType>(begin), static_cast<vtkIdType>(end),
          [&](vtkIdType first, vtkIdType last)
          {
            for (auto i = static_cast<std::size_t>(first); i < static_cast<std::size_t>(last); ++i)
            {
              values[i] = sign * this->GetMinimum(this->Points[i], from);
            }
          });
      });
  }

private:
  void SetBins(const Rectangle& bounds, double side)
  {
    double extent[2];
    for (int axis = 0; axis < 2; ++axis)
    {
      this->Low[axis] = bounds.Low[axis];
      extent[axis] = static_cast<double>(bounds.High[axis]) - static_cast<double>(bounds.Low[axis]);
    }
    const double maximum = BinsOfPoint * static_cast<double>(this->Points.size()) + 4.0;
    this->Side = std::max({ side, extent[0] / maximum, extent[1] / maximum });
    while ((extent[0] / this->Side + 1.0) * (extent[1] / this->Side + 1.0) > 2.0 * maximum)
    {
      this->Side *= 1.5;
    }
    for (int axis = 0; axis < 2; ++axis)
    {
      this->Across[axis] = static_cast<std::size_t>(extent[axis] / this->Side) + 1;
    }
  }

  /// Returns the bin of a place. It is monotonic: points of a window are in the bins from its low
  /// end to its high end.
  std::size_t GetBin(int axis, float place) const
  {
    const double distance =
      (static_cast<double>(place) - static_cast<double>(this->Low[axis])) / this->Side;
    const auto last = static_cast<double>(this->Across[axis] - 1);
    return static_cast<std::size_t>(std::clamp(distance, 0.0, last));
  }

  float GetMinimum(const pcl::PointXYZ& p, const std::vector<float>& from) const
  {
    const Rectangle window = { { p.x - this->Half, p.y - this->Half },
      { p.x + this->Half, p.y + this->Half } };
    const std::size_t columns[] = { this->GetBin(1, window.Low[1]),
      this->GetBin(1, window.High[1]) };
    float minimum = HUGE_VALF;
    const std::size_t last = this->GetBin(0, window.High[0]);
    for (std::size_t row = this->GetBin(0, window.Low[0]); row <= last; ++row)
    {
      for (std::size_t column = columns[0]; column <= columns[1]; ++column)
      {
        const std::size_t bin = row * this->Across[1] + column;
        if (this->Extremes[bin] < minimum)
        {
          const bool isInside = window.Holds(this->Bounds[bin]);
          minimum = isInside ? this->Extremes[bin] : this->GetMinimum(bin, window, from, minimum);
        }
      }
    }
    return minimum;
  }

  float GetMinimum(
    std::size_t bin, const Rectangle& window, const std::vector<float>& from, float minimum) const
  {
    for (std::size_t k = this->Begin[bin]; k < this->Begin[bin + 1]; ++k)
    {
      const std::size_t i = this->Order[k];
      minimum = from[i] < minimum && window.Holds(this->Points[i]) ? from[i] : minimum;
    }
    return minimum;
  }

  const Cloud& Points;
  float Half;
  float Low[2];
  double Side = 1.0;
  std::size_t Across[2]; // bins
  std::vector<std::size_t> BinOf;
  std::vector<std::size_t> Begin; // begin of each bin in Order; one more at the end
  std::vector<std::size_t> Order; // points by bins
  std::vector<Rectangle> Bounds;  // bounds of the points of a bin
  std::vector<float> Extremes;    // extreme value of a bin
};

/// Removes the ground points that are too far above its opening; false: stopped.
bool Open(
  const Cloud& points, float window, float threshold, const GoOn& goOn, pcl::Indices& ground)
{
  const Cloud chosen(points, ground);
  std::vector<float> heights;
  heights.reserve(chosen.size());
  std::transform(chosen.begin(), chosen.end(), std::back_inserter(heights),
    [](const pcl::PointXYZ& p) { return p.z; });
  Windows windows(chosen, window);
  if (!windows.Reduce(1.0F, Within(goOn, 0.0, 0.5), heights) ||
    !windows.Reduce(-1.0F, Within(goOn, 0.5, 1.0), heights))
  {
    return false;
  }
  pcl::Indices near;
  for (std::size_t i = 0; i < heights.size(); ++i)
  {
    if (chosen[i].z - heights[i] < threshold)
    {
      near.push_back(ground[i]);
    }
  }
  ground.swap(near);
  return true;
}

} // namespace

bool FindGround(
  const Cloud& points, const GroundWindows& settings, const GoOn& goOn, pcl::Indices& ground)
{
  std::vector<float> windows;
  while (windows.empty() || windows.back() < settings.MaximumWindowSize)
  {
    const auto power = std::pow(2.0F, static_cast<float>(windows.size()));
    windows.push_back(settings.CellSize * (2.0F * power + 1.0F));
  }
  ground.resize(points.size());
  std::iota(ground.begin(), ground.end(), 0);
  for (std::size_t i = 0; i < windows.size() && !ground.empty(); ++i)
  {
    const float growth = i == 0 ? 0.0F : windows[i] - windows[i - 1];
    const float threshold = settings.Slope * growth * settings.CellSize + settings.InitialDistance;
    const auto count = static_cast<double>(windows.size());
    const auto done = static_cast<double>(i);
    if (!Open(points, windows[i], std::min(threshold, settings.MaximumDistance),
          Within(goOn, done / count, (done + 1.0) / count), ground))
    {
      return false;
    }
  }
  return true;
}

} // namespace helios
