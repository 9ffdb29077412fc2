// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosContourRings.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <unordered_map>
#include <utility>

namespace helios
{

namespace
{

using Point = std::array<double, 2>;

constexpr int Border = 2;            // rows of nodes around the centres of pixels: edge, outside
constexpr double LongestMiter = 2.0; // move of a corner, in moves of its sides
constexpr int SmoothingPasses = 2;
constexpr std::size_t SmallestSmoothed = 16; // points: smaller rings keep their shape
constexpr int AreaSteps = 8;                 // steps that correct the area
constexpr double AreaError = 1e-9;           // relative

/**
 * Marching squares over nodes: the centres of pixels, the border of the image with the values of its
 * pixels, and once more the border, with nothing in it.
 */
class RingTracer
{
public:
  RingTracer(const MaskImage& image, double level)
    : Image(image)
    , Level(level)
    , Columns(image.Width + 2 * Border)
    , Rows(image.Height + 2 * Border)
  {
  }

  std::vector<ContourRing> Trace()
  {
    for (int row = 0; row + 1 < this->Rows; ++row)
    {
      for (int column = 0; column + 1 < this->Columns; ++column)
      {
        this->AddCell(column, row);
      }
    }
    return this->Join();
  }

private:
  /// A side of a cell: from a node to the next one in its row or column.
  using Side = std::int64_t;

  double GetValue(int column, int row) const
  {
    const bool isOutside =
      column == 0 || row == 0 || column == this->Columns - 1 || row == this->Rows - 1;
    return isOutside ? -1.0 : this->Image.Get(column - Border, row - Border);
  }

  static double GetPlace(int node, int size)
  {
    return std::clamp(node - Border + 0.5, 0.0, static_cast<double>(size));
  }

  Point GetPoint(int column, int row) const
  {
    return { GetPlace(column, this->Image.Width), GetPlace(row, this->Image.Height) };
  }

  Side MakeSide(int column, int row, bool isUpward) const
  {
    return 2 * (static_cast<std::int64_t>(row) * this->Columns + column) + (isUpward ? 1 : 0);
  }

  /// Returns where the level is between the two nodes of a side.
  Point GetCrossing(Side side) const
  {
    const auto node = side / 2;
    const auto column = static_cast<int>(node % this->Columns);
    const auto row = static_cast<int>(node / this->Columns);
    const int right = side % 2 == 0 ? 1 : 0;
    const double first = this->GetValue(column, row);
    const double second = this->GetValue(column + right, row + 1 - right);
    const double share = (this->Level - first) / (second - first);
    const Point from = this->GetPoint(column, row);
    const Point to = this->GetPoint(column + right, row + 1 - right);
    return { from[0] + share * (to[0] - from[0]), from[1] + share * (to[1] - from[1]) };
  }

  /// Adds the pieces of a cell: from each side where the cell's boundary, counterclockwise, leaves
  /// what is above the level, to a side where it enters.
  void AddCell(int column, int row)
  {
    const std::array<double, 4> values{ this->GetValue(column, row),
      this->GetValue(column + 1, row), this->GetValue(column + 1, row + 1),
      this->GetValue(column, row + 1) };
    const auto isAbove = [&](std::size_t corner) { return values[corner % 4] > this->Level; };
    const std::array<Side, 4> sides{ this->MakeSide(column, row, false),
      this->MakeSide(column + 1, row, true), this->MakeSide(column, row + 1, false),
      this->MakeSide(column, row, true) };
    const bool isJoined = this->IsSaddleAbove(values);
    for (std::size_t i = 0; i < 4; ++i)
    {
      if (!isAbove(i) || isAbove(i + 1))
      {
        continue;
      }
      // From a side that leaves, the next one that enters; around the same corner at a saddle whose
      // middle is below.
      std::size_t next = i + 1;
      while (isAbove(next) || !isAbove(next + 1))
      {
        ++next;
      }
      const bool isSaddle = isAbove(i + 2) && !isAbove(i + 3);
      next = isSaddle && !isJoined ? i + 3 : next;
      this->Next.emplace(sides[i], this->Pieces.size());
      this->Pieces.emplace_back(sides[i], sides[next % 4]);
    }
  }

  /// Returns whether the bilinear value at the saddle of a cell is above the level.
  bool IsSaddleAbove(const std::array<double, 4>& v) const
  {
    const double bend = v[0] + v[2] - v[1] - v[3];
    return bend != 0.0 && (v[0] * v[2] - v[1] * v[3]) / bend > this->Level;
  }

  std::vector<ContourRing> Join() const
  {
    std::vector<ContourRing> rings;
    std::vector<bool> isUsed(this->Pieces.size());
    for (std::size_t first = 0; first < this->Pieces.size(); ++first)
    {
      ContourRing ring;
      for (std::size_t piece = first; !isUsed[piece];
           piece = this->Next.at(this->Pieces[piece].second))
      {
        isUsed[piece] = true;
        ring.push_back(this->GetCrossing(this->Pieces[piece].first));
      }
      ring.erase(std::unique(ring.begin(), ring.end()), ring.end());
      if (ring.size() > 2)
      {
        rings.push_back(std::move(ring));
      }
    }
    return rings;
  }

  const MaskImage& Image;
  const double Level;
  const int Columns; // numbers of nodes
  const int Rows;
  std::vector<std::pair<Side, Side>> Pieces;
  std::unordered_map<Side, std::size_t> Next; // piece that begins at a side
};

double ComputeSquaredDistance(const Point& p, const Point& from, const Point& to)
{
  const double dx = to[0] - from[0];
  const double dy = to[1] - from[1];
  const double length = dx * dx + dy * dy;
  const double along =
    length > 0.0 ? ((p[0] - from[0]) * dx + (p[1] - from[1]) * dy) / length : 0.0;
  const double share = std::clamp(along, 0.0, 1.0);
  const double x = p[0] - from[0] - share * dx;
  const double y = p[1] - from[1] - share * dy;
  return x * x + y * y;
}

/// Marks the points of a ring that are kept between two kept ones; from > to goes around.
void MarkKept(const ContourRing& ring, double tolerance, std::vector<bool>& isKept)
{
  const std::size_t count = ring.size();
  std::size_t farthest = 0;
  for (std::size_t i = 1; i < count; ++i)
  {
    const auto away = [&](std::size_t j)
    { return std::hypot(ring[j][0] - ring[0][0], ring[j][1] - ring[0][1]); };
    farthest = away(i) > away(farthest) ? i : farthest;
  }
  isKept[0] = isKept[farthest] = true;
  std::vector<std::pair<std::size_t, std::size_t>> open{ { 0, farthest }, { farthest, count } };
  while (!open.empty())
  {
    const auto [from, to] = open.back();
    open.pop_back();
    double largest = tolerance * tolerance;
    std::size_t middle = from;
    for (std::size_t i = from + 1; i < to; ++i)
    {
      const double away = ComputeSquaredDistance(ring[i], ring[from], ring[to % count]);
      middle = away > largest ? i : middle;
      largest = std::max(largest, away);
    }
    if (middle != from)
    {
      isKept[middle] = true;
      open.emplace_back(from, middle);
      open.emplace_back(middle, to);
    }
  }
}

bool IsAtBorder(double coordinate, int size)
{
  return coordinate == 0.0 || coordinate == static_cast<double>(size);
}

bool IsAtBorder(const Point& point, const MaskImage& image)
{
  return IsAtBorder(point[0], image.Width) || IsAtBorder(point[1], image.Height);
}

/// Returns a ring without the stairs of pixels: each point within the image is moved towards its
/// neighbours.
ContourRing SmoothRing(const ContourRing& ring, const MaskImage& image)
{
  ContourRing smooth = ring;
  const std::size_t count = ring.size();
  for (int pass = 0; pass < SmoothingPasses && count > SmallestSmoothed; ++pass)
  {
    const ContourRing old = smooth;
    for (std::size_t i = 0; i < count; ++i)
    {
      const Point& before = old[(i + count - 1) % count];
      const Point& after = old[(i + 1) % count];
      for (std::size_t axis = 0; axis < 2 && !IsAtBorder(ring[i], image); ++axis)
      {
        smooth[i][axis] = 0.25 * before[axis] + 0.5 * old[i][axis] + 0.25 * after[axis];
      }
    }
  }
  return smooth;
}

/// Returns the unit vector to the right of a side.
Point GetOutward(const Point& from, const Point& to)
{
  const double x = to[0] - from[0];
  const double y = to[1] - from[1];
  const double length = std::hypot(x, y);
  return length > 0.0 ? Point{ y / length, -x / length } : Point{ 0.0, 0.0 };
}

double ComputeLength(const ContourRing& ring)
{
  double length = 0.0;
  for (std::size_t i = 0; i < ring.size(); ++i)
  {
    const Point& next = ring[(i + 1) % ring.size()];
    length += std::hypot(next[0] - ring[i][0], next[1] - ring[i][1]);
  }
  return length;
}

/// Moves the sides of a ring to their right by a distance, but those at the border of the image.
void MoveOutward(ContourRing& ring, double distance, const MaskImage& image)
{
  const ContourRing old = ring;
  const std::size_t count = old.size();
  const std::array<int, 2> sizes{ image.Width, image.Height };
  for (std::size_t i = 0; i < count; ++i)
  {
    const Point before = GetOutward(old[(i + count - 1) % count], old[i]);
    const Point after = GetOutward(old[i], old[(i + 1) % count]);
    const double cosine = before[0] * after[0] + before[1] * after[1];
    const double scale = distance / std::max(1.0 + cosine, 1.0 / (LongestMiter * LongestMiter));
    for (std::size_t axis = 0; axis < 2; ++axis)
    {
      const double moved = old[i][axis] + scale * (before[axis] + after[axis]);
      ring[i][axis] = IsAtBorder(old[i][axis], sizes[axis])
        ? old[i][axis]
        : std::clamp(moved, 0.0, static_cast<double>(sizes[axis]));
    }
  }
}

} // namespace

//------------------------------------------------------------------------------
double MaskImage::Get(int column, int row) const
{
  const auto x = static_cast<std::size_t>(std::clamp(column, 0, this->Width - 1));
  const auto y = static_cast<std::size_t>(std::clamp(row, 0, this->Height - 1));
  return this->Values[y * static_cast<std::size_t>(this->Width) + x];
}

//------------------------------------------------------------------------------
double ComputeRingArea(const ContourRing& ring)
{
  double twice = 0.0;
  for (std::size_t i = 0; i < ring.size(); ++i)
  {
    const Point& next = ring[(i + 1) % ring.size()];
    twice += ring[i][0] * next[1] - next[0] * ring[i][1];
  }
  return 0.5 * twice;
}

//------------------------------------------------------------------------------
std::vector<ContourRing> FindRings(const MaskImage& image, double level)
{
  return RingTracer(image, level).Trace();
}

//------------------------------------------------------------------------------
ContourRing SimplifyRing(const ContourRing& ring, double tolerance, const MaskImage& image)
{
  std::vector<bool> isKept(ring.size());
  const ContourRing smooth = SmoothRing(ring, image);
  MarkKept(smooth, tolerance, isKept);
  ContourRing simple;
  for (std::size_t i = 0; i < ring.size(); ++i)
  {
    if (isKept[i])
    {
      simple.push_back(smooth[i]);
    }
  }
  const double area = ComputeRingArea(ring);
  if (simple.size() < 3 || ComputeRingArea(simple) * area <= 0.0)
  {
    return ring; // it is as narrow as the tolerance
  }
  for (int i = 0; i < AreaSteps; ++i)
  {
    const double missing = area - ComputeRingArea(simple);
    const double length = ComputeLength(simple);
    if (std::abs(missing) <= AreaError * std::abs(area) || length == 0.0)
    {
      break;
    }
    MoveOutward(simple, missing / length, image);
  }
  return simple;
}

} // namespace helios
