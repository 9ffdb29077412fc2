// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosCutoutClipper.h"

#include <algorithm>
#include <cmath>

namespace helios
{

namespace
{

using Point = std::array<double, 2>;

constexpr double MaximumTiles = 4096.0; // over a triangle
constexpr double SmallestPiece = 1e-4;  // share of a pixel
constexpr double ClampMargin = 1e-2;    // beyond the border, of the texture

/// Returns twice the area of a triangle, positive if it is counterclockwise.
double ComputeTwiceArea(const Point& a, const Point& b, const Point& c)
{
  return (b[0] - a[0]) * (c[1] - a[1]) - (c[0] - a[0]) * (b[1] - a[1]);
}

} // namespace

//------------------------------------------------------------------------------
Point CutoutClipper::Tile::Place(const Point& point) const
{
  Point place = this->Origin;
  for (std::size_t axis = 0; axis < 2; ++axis)
  {
    place[axis] += this->IsMirrored[axis] ? 1.0 - point[axis] : point[axis];
  }
  return place;
}

//------------------------------------------------------------------------------
CutoutClipper::CutoutClipper(const CutoutBand& band, std::array<TextureWrap, 2> wrap)
  : Band(band)
  , Grid(band)
  , Wrap(wrap)
  , Ids(band.Points.size(), -1)
{
}

//------------------------------------------------------------------------------
bool CutoutClipper::Clip(const std::array<Point, 3>& corners, CutoutPieces& pieces)
{
  pieces.Clear();
  this->Corners = corners;
  this->Area = ComputeTwiceArea(corners[0], corners[1], corners[2]);
  Point low = corners[0];
  Point high = corners[0];
  for (const Point& corner : corners)
  {
    for (std::size_t axis = 0; axis < 2; ++axis)
    {
      low[axis] = std::min(low[axis], corner[axis]);
      high[axis] = std::max(high[axis], corner[axis]);
    }
  }
  if (!this->HasTiles(low, high))
  {
    return false;
  }
  for (double row = std::floor(low[1]); this->Area != 0.0 && row < high[1]; ++row)
  {
    for (double column = std::floor(low[0]); column < high[0]; ++column)
    {
      this->ClipTile(this->MakeTile(column, row), low, high, pieces);
    }
  }
  return true;
}

//------------------------------------------------------------------------------
/// Returns whether the texture is known within a rectangle, and repeated over it not too often.
bool CutoutClipper::HasTiles(const Point& low, const Point& high) const
{
  double count = 1.0;
  for (std::size_t axis = 0; axis < 2; ++axis)
  {
    count *= std::ceil(high[axis]) - std::floor(low[axis]);
    if (this->Wrap[axis] == TextureWrap::Clamp &&
      (low[axis] < -ClampMargin || high[axis] > 1.0 + ClampMargin))
    {
      return false;
    }
  }
  return count <= MaximumTiles; // false: also of infinite coordinates
}

//------------------------------------------------------------------------------
CutoutClipper::Tile CutoutClipper::MakeTile(double column, double row) const
{
  const auto isMirrored = [this](std::size_t axis, double number)
  { return this->Wrap[axis] == TextureWrap::Mirror && std::fmod(number, 2.0) != 0.0; };
  return { { column, row }, { isMirrored(0, column), isMirrored(1, row) } };
}

//------------------------------------------------------------------------------
void CutoutClipper::ClipTile(
  const Tile& tile, const Point& low, const Point& high, CutoutPieces& pieces)
{
  for (std::size_t axis = 0; axis < 2; ++axis)
  {
    if (this->Wrap[axis] == TextureWrap::Clamp && tile.Origin[axis] != 0.0)
    {
      return; // within ClampMargin
    }
  }
  const Point first = Tile{ { 0.0, 0.0 }, tile.IsMirrored }.Place(
    { low[0] - tile.Origin[0], low[1] - tile.Origin[1] });
  const Point second = Tile{ { 0.0, 0.0 }, tile.IsMirrored }.Place(
    { high[0] - tile.Origin[0], high[1] - tile.Origin[1] });
  this->Grid.Find({ std::min(first[0], second[0]), std::min(first[1], second[1]) },
    { std::max(first[0], second[0]), std::max(first[1], second[1]) }, this->Found);
  for (const int triangle : this->Found)
  {
    this->ClipBandTriangle(tile, triangle, pieces);
  }
  for (const int point : this->Used)
  {
    this->Ids[static_cast<std::size_t>(point)] = -1;
  }
  this->Used.clear();
}

//------------------------------------------------------------------------------
/// Adds the part of a triangle of the band that is within the corners. Whole ones share points.
void CutoutClipper::ClipBandTriangle(const Tile& tile, int triangle, CutoutPieces& pieces)
{
  const int* ids = this->Band.Corners.data() + 3 * static_cast<std::size_t>(triangle);
  this->Polygon.clear();
  for (int i = 0; i < 3; ++i)
  {
    this->Polygon.push_back(tile.Place(this->Band.Points[static_cast<std::size_t>(ids[i])]));
  }
  const bool isWhole = !this->CutSides(this->Polygon);
  std::vector<int> points(this->Polygon.size(), -1);
  const auto getId = [&](std::size_t corner)
  {
    int& id = isWhole ? this->Ids[static_cast<std::size_t>(ids[corner])] : points[corner];
    if (id < 0)
    {
      id = this->AddPoint(this->Polygon[corner], pieces);
      if (isWhole)
      {
        this->Used.push_back(ids[corner]);
      }
    }
    return id;
  };
  for (std::size_t i = 2; i < this->Polygon.size(); ++i)
  {
    const double twice = ComputeTwiceArea(this->Polygon[0], this->Polygon[i - 1], this->Polygon[i]);
    if (std::abs(twice) > SmallestPiece * this->Band.PixelArea)
    {
      const bool isTurned = (twice > 0.0) != (this->Area > 0.0);
      pieces.Corners.insert(pieces.Corners.end(),
        { getId(0), getId(isTurned ? i : i - 1), getId(isTurned ? i - 1 : i) });
    }
  }
}

//------------------------------------------------------------------------------
/// Leaves the part of a polygon that is within the corners (Sutherland and Hodgman 1974); returns
/// whether it is smaller.
bool CutoutClipper::CutSides(std::vector<Point>& polygon) const
{
  const double sign = this->Area > 0.0 ? 1.0 : -1.0;
  bool isCut = false;
  for (std::size_t side = 0; side < 3 && !polygon.empty(); ++side)
  {
    const Point& from = this->Corners[side];
    const Point& to = this->Corners[(side + 1) % 3];
    const auto getDepth = [&](const Point& p) { return sign * ComputeTwiceArea(from, to, p); };
    if (std::all_of(
          polygon.begin(), polygon.end(), [&](const Point& p) { return getDepth(p) >= 0.0; }))
    {
      continue;
    }
    isCut = true;
    std::vector<Point> kept;
    for (std::size_t i = 0; i < polygon.size(); ++i)
    {
      const Point& a = polygon[i];
      const Point& b = polygon[(i + 1) % polygon.size()];
      const double depthOfA = getDepth(a);
      const double depthOfB = getDepth(b);
      if (depthOfA >= 0.0)
      {
        kept.push_back(a);
      }
      if ((depthOfA >= 0.0) != (depthOfB >= 0.0))
      {
        const double share = depthOfA / (depthOfA - depthOfB);
        kept.push_back({ a[0] + share * (b[0] - a[0]), a[1] + share * (b[1] - a[1]) });
      }
    }
    polygon = std::move(kept);
  }
  return isCut;
}

//------------------------------------------------------------------------------
int CutoutClipper::AddPoint(const Point& point, CutoutPieces& pieces) const
{
  const Point& origin = this->Corners[0];
  pieces.Points.push_back({ ComputeTwiceArea(origin, point, this->Corners[2]) / this->Area,
    ComputeTwiceArea(origin, this->Corners[1], point) / this->Area });
  return static_cast<int>(pieces.Points.size()) - 1;
}

} // namespace helios
