// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosCutoutShape.h"

#include "heliosPlanarTriangulation.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace helios
{

namespace
{

using Point = std::array<double, 2>;

constexpr double FullValue = 255.0;
constexpr double NearlyOpaque = 0.998; // is opaque: half of an 8-bit step
constexpr int NumberOfBands = 8;
constexpr int Halvings = 3;     // smaller tolerances, before outlines are not simplified
constexpr int LargestGrid = 64; // cells in a row
constexpr int TrianglesPerCell = 4;

double ComputeArea(const Point& a, const Point& b, const Point& c)
{
  return 0.5 * ((b[0] - a[0]) * (c[1] - a[1]) - (c[0] - a[0]) * (b[1] - a[1]));
}

/// Triangulates what is within an odd number of rings.
void FillRings(const std::vector<ContourRing>& rings, CutoutBand& band)
{
  std::map<Point, int> ids;
  std::vector<std::pair<int, int>> sides;
  band.Points.clear();
  const auto add = [&](const Point& point)
  {
    const auto [place, isNew] = ids.emplace(point, static_cast<int>(band.Points.size()));
    if (isNew)
    {
      band.Points.push_back(point);
    }
    return place->second;
  };
  for (const ContourRing& ring : rings)
  {
    int last = add(ring.back());
    for (const Point& point : ring)
    {
      const int id = add(point);
      if (id != last)
      {
        sides.emplace_back(last, id);
      }
      last = id;
    }
  }
  PlanarTriangulation plane;
  plane.Build(band.Points);
  for (const auto& [from, to] : sides)
  {
    plane.AddSide(from, to);
  }
  band.Corners = plane.FindInside();
  band.Area = 0.0;
  for (std::size_t i = 0; i < band.Corners.size(); i += 3)
  {
    const auto get = [&](std::size_t corner)
    { return band.Points[static_cast<std::size_t>(band.Corners[i + corner])]; };
    band.Area += ComputeArea(get(0), get(1), get(2));
  }
}

double ComputeAreaOf(const std::vector<ContourRing>& rings)
{
  double area = 0.0;
  for (const ContourRing& ring : rings)
  {
    area += ComputeRingArea(ring);
  }
  return area;
}

/// Fills the rings as simple as their area permits: rings that cross have another one.
void FillSimplified(
  const MaskImage& mask, const std::vector<ContourRing>& rings, double area, CutoutBand& band)
{
  double tolerance = OutlineTolerance;
  for (int i = 0; i < Halvings; ++i, tolerance *= 0.5)
  {
    std::vector<ContourRing> simple;
    simple.reserve(rings.size());
    for (const ContourRing& ring : rings)
    {
      simple.push_back(SimplifyRing(ring, tolerance, mask));
    }
    FillRings(simple, band);
    if (std::abs(band.Area - area) <= OutlineAreaError * area)
    {
      return;
    }
  }
  FillRings(rings, band);
}

/// Returns the mean opacity of the pixels between two levels; their number may be zero.
double ComputeOpacity(const MaskImage& mask, double low, double high)
{
  double sum = 0.0;
  double count = 0.0;
  for (const unsigned char value : mask.Values)
  {
    const bool isWithin = value > low && value <= high;
    sum += isWithin ? value : 0.0;
    count += isWithin ? 1.0 : 0.0;
  }
  const double opacity = count > 0.0 ? sum / count : 0.5 * (low + std::min(high, FullValue));
  return opacity / FullValue >= NearlyOpaque ? 1.0 : opacity / FullValue;
}

} // namespace

//------------------------------------------------------------------------------
CutoutShape CutoutShape::Cut(const MaskImage& mask, double threshold)
{
  return { mask, { std::ceil(threshold * FullValue) - 0.5 }, false };
}

//------------------------------------------------------------------------------
CutoutShape CutoutShape::Blend(const MaskImage& mask)
{
  std::vector<double> levels{ 0.5 };
  for (int i = 1; i < NumberOfBands; ++i)
  {
    levels.push_back(std::ceil((i + 0.5) / NumberOfBands * FullValue) - 0.5);
  }
  return { mask, std::move(levels), true };
}

//------------------------------------------------------------------------------
/// Makes a band above each level and up to the next one.
CutoutShape::CutoutShape(const MaskImage& mask, std::vector<double> levels, bool isBlended)
{
  levels.push_back(FullValue + 1.0);
  const auto [least, most] = std::minmax_element(mask.Values.begin(), mask.Values.end());
  std::vector<ContourRing> outer = FindRings(mask, levels[0]);
  for (std::size_t i = 0; i + 1 < levels.size(); ++i)
  {
    std::vector<ContourRing> inner = FindRings(mask, levels[i + 1]);
    const double area = ComputeAreaOf(outer) - ComputeAreaOf(inner);
    CutoutBand band;
    band.Opacity = isBlended ? ComputeOpacity(mask, levels[i], levels[i + 1]) : 1.0;
    this->Whole = *least > levels[i] && *most <= levels[i + 1];
    if (this->Whole)
    {
      band.Area = 1.0;
      this->Bands.assign(1, band);
      return;
    }
    if (area > 0.0)
    {
      std::vector<ContourRing> rings = outer;
      rings.insert(rings.end(), inner.begin(), inner.end());
      FillSimplified(mask, rings, area, band);
      band.PixelArea = 1.0 / (static_cast<double>(mask.Width) * mask.Height);
      band.Area *= band.PixelArea;
      for (Point& point : band.Points)
      {
        point = { point[0] / mask.Width, point[1] / mask.Height };
      }
      this->Bands.push_back(std::move(band));
    }
    outer = std::move(inner);
  }
}

//------------------------------------------------------------------------------
CutoutGrid::CutoutGrid(const CutoutBand& band)
{
  const auto cells = static_cast<double>(band.GetNumberOfTriangles()) / TrianglesPerCell;
  this->Size = std::clamp(static_cast<int>(std::sqrt(cells)), 1, LargestGrid);
  this->Cells.resize(static_cast<std::size_t>(this->Size) * static_cast<std::size_t>(this->Size));
  for (std::size_t i = 0; i < band.GetNumberOfTriangles(); ++i)
  {
    Point low{ 1.0, 1.0 };
    Point high{ 0.0, 0.0 };
    for (std::size_t corner = 0; corner < 3; ++corner)
    {
      const Point& point = band.Points[static_cast<std::size_t>(band.Corners[3 * i + corner])];
      for (std::size_t axis = 0; axis < 2; ++axis)
      {
        low[axis] = std::min(low[axis], point[axis]);
        high[axis] = std::max(high[axis], point[axis]);
      }
    }
    this->VisitCells(
      low, high, [&](std::size_t cell) { this->Cells[cell].push_back(static_cast<int>(i)); });
  }
}

//------------------------------------------------------------------------------
int CutoutGrid::GetCell(double coordinate) const
{
  return static_cast<int>(std::clamp(coordinate * this->Size, 0.0, this->Size - 1.0));
}

//------------------------------------------------------------------------------
template <typename Visitor>
void CutoutGrid::VisitCells(const Point& low, const Point& high, Visitor visit) const
{
  for (int row = this->GetCell(low[1]); row <= this->GetCell(high[1]); ++row)
  {
    for (int column = this->GetCell(low[0]); column <= this->GetCell(high[0]); ++column)
    {
      visit(static_cast<std::size_t>(row) * static_cast<std::size_t>(this->Size) +
        static_cast<std::size_t>(column));
    }
  }
}

//------------------------------------------------------------------------------
void CutoutGrid::Find(const Point& low, const Point& high, std::vector<int>& found) const
{
  found.clear();
  this->VisitCells(low, high,
    [&](std::size_t cell)
    { found.insert(found.end(), this->Cells[cell].begin(), this->Cells[cell].end()); });
  std::sort(found.begin(), found.end());
  found.erase(std::unique(found.begin(), found.end()), found.end());
}

} // namespace helios
