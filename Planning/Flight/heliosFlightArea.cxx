// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosFlightArea.h"

#include <vtkCellArray.h>
#include <vtkIdList.h>
#include <vtkMath.h>
#include <vtkNew.h>
#include <vtkPolyData.h>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace helios
{

namespace
{

/// Adds the part of an edge in a band across, as the interval along.
void AddEdge(const vtkVector2d& a, const vtkVector2d& b, const Interval& band, Interval& along)
{
  const double across = b[1] - a[1];
  double first = 0.0;
  double last = 1.0;
  if (across == 0.0)
  {
    if (a[1] < band.Low || a[1] > band.High)
    {
      return;
    }
  }
  else
  {
    const double low = (band.Low - a[1]) / across;
    const double high = (band.High - a[1]) / across;
    first = std::max(first, std::min(low, high));
    last = std::min(last, std::max(low, high));
  }
  if (first <= last)
  {
    along.Add(a[0] + first * (b[0] - a[0]));
    along.Add(a[0] + last * (b[0] - a[0]));
  }
}

double Cross(const vtkVector2d& o, const vtkVector2d& a, const vtkVector2d& b)
{
  return (a[0] - o[0]) * (b[1] - o[1]) - (a[1] - o[1]) * (b[0] - o[0]);
}

} // namespace

//------------------------------------------------------------------------------
void Interval::Add(double value)
{
  const bool isEmpty = this->IsEmpty();
  this->Low = isEmpty ? value : std::min(this->Low, value);
  this->High = isEmpty ? value : std::max(this->High, value);
}

//------------------------------------------------------------------------------
Status FlightArea::Read(vtkPolyData* polygons)
{
  this->Rings.clear();
  for (vtkCellArray* cells : { polygons->GetPolys(), polygons->GetLines() })
  {
    vtkNew<vtkIdList> ids;
    for (vtkIdType cell = 0; cell < cells->GetNumberOfCells(); ++cell)
    {
      cells->GetCellAtId(cell, ids);
      Ring ring;
      for (vtkIdType i = 0; i < ids->GetNumberOfIds(); ++i)
      {
        double p[3];
        polygons->GetPoint(ids->GetId(i), p);
        if (!std::isfinite(p[0]) || !std::isfinite(p[1]))
        {
          std::ostringstream text;
          text << "Vertex " << ids->GetId(i) << " of the area is (" << p[0] << ", " << p[1]
               << "); give finite coordinates";
          return Status::Error(text.str());
        }
        ring.emplace_back(p[0], p[1]);
      }
      if (ring.size() >= 3)
      {
        this->Rings.push_back(std::move(ring));
      }
    }
  }
  if (this->GetHull().size() < 3)
  {
    return Status::Error(
      "the area has no polygon with a surface; give one of three or more vertices");
  }
  return {};
}

//------------------------------------------------------------------------------
FlightArea FlightArea::Turn(double heading) const
{
  const double angle = vtkMath::RadiansFromDegrees(heading);
  const double s = std::sin(angle);
  const double c = std::cos(angle);
  FlightArea turned = *this;
  for (Ring& ring : turned.Rings)
  {
    for (vtkVector2d& p : ring)
    {
      p = { s * p[0] + c * p[1], c * p[0] - s * p[1] };
    }
  }
  return turned;
}

//------------------------------------------------------------------------------
vtkVector2d FlightArea::TurnBack(const vtkVector2d& place, double heading)
{
  const double angle = vtkMath::RadiansFromDegrees(heading);
  const double s = std::sin(angle);
  const double c = std::cos(angle);
  return { s * place[0] + c * place[1], c * place[0] - s * place[1] };
}

//------------------------------------------------------------------------------
Interval FlightArea::GetWidth() const
{
  Interval width;
  for (const Ring& ring : this->Rings)
  {
    for (const vtkVector2d& p : ring)
    {
      width.Add(p[1]);
    }
  }
  return width;
}

//------------------------------------------------------------------------------
Interval FlightArea::GetLength(const Interval& band) const
{
  Interval along;
  for (const Ring& ring : this->Rings)
  {
    for (std::size_t i = 0; i < ring.size(); ++i)
    {
      AddEdge(ring[i], ring[(i + 1) % ring.size()], band, along);
    }
  }
  return along;
}

//------------------------------------------------------------------------------
// The convex hull by Andrew's monotone chain.
std::vector<vtkVector2d> FlightArea::GetHull() const
{
  std::vector<vtkVector2d> all;
  for (const Ring& ring : this->Rings)
  {
    all.insert(all.end(), ring.begin(), ring.end());
  }
  std::sort(all.begin(), all.end(),
    [](const vtkVector2d& a, const vtkVector2d& b)
    { return a[0] != b[0] ? a[0] < b[0] : a[1] < b[1]; });
  std::vector<vtkVector2d> hull;
  for (int side = 0; side < 2; ++side)
  {
    const std::size_t first = hull.size();
    for (const vtkVector2d& p : all)
    {
      while (hull.size() >= first + 2 && Cross(hull[hull.size() - 2], hull.back(), p) <= 0.0)
      {
        hull.pop_back();
      }
      hull.push_back(p);
    }
    if (!hull.empty())
    {
      hull.pop_back(); // the first of the other side
    }
    std::reverse(all.begin(), all.end());
  }
  return hull;
}

//------------------------------------------------------------------------------
std::vector<double> FlightArea::GetHullHeadings() const
{
  const std::vector<vtkVector2d> hull = this->GetHull();
  std::vector<double> headings;
  for (std::size_t i = 0; i < hull.size(); ++i)
  {
    const vtkVector2d& a = hull[i];
    const vtkVector2d& b = hull[(i + 1) % hull.size()];
    const double heading = vtkMath::DegreesFromRadians(std::atan2(b[0] - a[0], b[1] - a[1]));
    headings.push_back(std::fmod(heading + 360.0, 180.0));
  }
  return headings;
}

} // namespace helios
