// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosFootprintRaster.h"

#include "heliosVectorLoops.h"

#include <algorithm>
#include <cmath>

namespace helios
{
namespace
{

constexpr float Nothing = -1.0F; // before everything: scaled inverse depths are not negative

} // namespace

//------------------------------------------------------------------------------
void FootprintRaster::SetGrid(int across)
{
  const auto count = static_cast<std::size_t>(across);
  if (this->Across != across)
  {
    this->Across = across;
    this->Centres.resize(count);
    this->Columns.resize(count);
    this->Firsts.resize(count);
    for (std::size_t i = 0; i < count; ++i)
    {
      this->Centres[i] = (2.0 * static_cast<double>(i) + 1.0) / across - 1.0;
      this->Columns[i] = static_cast<float>(this->Centres[i]);
      const double y = this->Centres[i];
      this->Firsts[i] = this->GetLine(-std::sqrt(1.0 - y * y));
    }
  }
  this->Nearest.assign(count * count, Nothing);
  this->Owners.assign(count * count, -1);
}

//------------------------------------------------------------------------------
/// Returns the first row or column whose centre is not below a place.
int FootprintRaster::GetLine(double place) const
{
  const double line = std::clamp(0.5 * this->Across * (place + 1.0) - 0.5, 0.0, 1.0 * this->Across);
  const int below = static_cast<int>(line);
  return below + (below < line ? 1 : 0); // std::ceil() is a call without SSE 4.1
}

//------------------------------------------------------------------------------
void FootprintRaster::Draw(const VisibleSurfaces& surfaces, int across)
{
  this->SetGrid(across);
  this->Spans.resize(static_cast<std::size_t>(across));
  const std::size_t count = surfaces.GetNumberOfFaces();
  this->Minimum = HUGE_VAL;
  double maximum = 0.0;
  for (std::size_t i = 0; i < count; ++i)
  {
    this->Minimum = std::min(this->Minimum, surfaces.GetFace(i).Minimum);
    maximum = std::max(maximum, surfaces.GetFace(i).Maximum);
  }
  this->Scale = maximum > this->Minimum ? 1.0 / (maximum - this->Minimum) : 0.0;
  for (std::size_t i = 0; i < count; ++i)
  {
    this->DrawFace(surfaces.GetFace(i), static_cast<int>(i));
  }
}

//------------------------------------------------------------------------------
void FootprintRaster::DrawFace(const VisibleSurfaces::Face& face, int index)
{
  const Polygon& outline = face.Outline;
  const auto [low, high] = std::minmax_element(outline.Y, outline.Y + outline.Size);
  const int first = this->GetLine(*low);
  const int last = this->GetLine(*high);
  if (first == last)
  {
    return;
  }
  for (int edge = 0; edge < outline.Size; ++edge)
  {
    this->AddEdge(outline, edge);
  }
  for (int row = first; row < last; ++row)
  {
    this->DrawRow(face, row, index);
  }
}

//------------------------------------------------------------------------------
/// Sets a limit of the rows that an edge crosses. It does not depend on the direction of the edge,
/// so that the face on its other side has the same one.
void FootprintRaster::AddEdge(const Polygon& outline, int edge)
{
  const int next = outline.GetNext(edge);
  const bool isUp = outline.Y[edge] < outline.Y[next];
  const int low = isUp ? edge : next;
  const int high = isUp ? next : edge;
  const int first = this->GetLine(outline.Y[low]);
  const int last = this->GetLine(outline.Y[high]);
  if (first >= last)
  {
    return;
  }
  const double slope = (outline.X[high] - outline.X[low]) / (outline.Y[high] - outline.Y[low]);
  for (int row = first; row < last; ++row)
  {
    const double x = outline.X[low] + slope * (this->GetCentre(row) - outline.Y[low]);
    Span& span = this->Spans[static_cast<std::size_t>(row)];
    (isUp ? span.Last : span.First) = this->GetLine(x); // counterclockwise: up on the right
  }
}

//------------------------------------------------------------------------------
void FootprintRaster::DrawRow(const VisibleSurfaces::Face& face, int row, int index)
{
  Span span = this->Spans[static_cast<std::size_t>(row)];
  span.First = std::max(span.First, this->GetFirst(row));
  span.Last = std::min(span.Last, this->Across - this->GetFirst(row));
  if (span.First < span.Last)
  {
    const auto start = static_cast<std::size_t>(row) * static_cast<std::size_t>(this->Across);
    const auto scale = [this](double inverse) { return static_cast<float>(this->Scale * inverse); };
    const Slope slope{ scale(face.Inverse(0.0, this->GetCentre(row)) - this->Minimum),
      scale(face.Inverse.X), scale(face.Minimum - this->Minimum),
      scale(face.Maximum - this->Minimum) };
    DrawSpan(this->Columns.data(), &this->Nearest[start], &this->Owners[start], span, slope, index);
  }
}

//------------------------------------------------------------------------------
HELIOS_CLONES
void FootprintRaster::DrawSpan(
  const float* columns, float* depths, int* owners, const Span& span, const Slope& slope, int index)
{
  for (int i = span.First; i < span.Last; ++i)
  {
    const float there = slope.Start + slope.Slope * columns[i];
    const float depth = std::min(slope.Maximum, std::max(slope.Minimum, there));
    const bool isNearer = depth > depths[i];
    depths[i] = isNearer ? depth : depths[i];
    owners[i] = isNearer ? index : owners[i];
  }
}

} // namespace helios
