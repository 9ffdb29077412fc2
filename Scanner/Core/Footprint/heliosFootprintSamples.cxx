// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// The parts of a crowded beam that the cells of a grid see.

#include "heliosFootprint.h"

#include <algorithm>
#include <cmath>

namespace helios
{

/// Finds the cuts of all faces.
void Footprint::SetStrips()
{
  this->AllCuts.clear();
  std::size_t strips = 0;
  for (std::size_t i = 0; i < this->GetNumberOfFaces(); ++i)
  {
    const VisibleSurfaces::Face& face = this->Surfaces.GetFace(i);
    this->SetCuts(face, this->GetSpread(face));
    this->AllStrips.push_back({ this->AllCuts.size(), strips, this->Cuts.size() });
    this->AllCuts.insert(this->AllCuts.end(), this->Cuts.begin(), this->Cuts.end());
    strips += this->Cuts.size() + 1;
  }
  this->Sampled.resize(strips);
}

//------------------------------------------------------------------------------
/// Returns the strip of a face at a point of the cross-section.
std::size_t Footprint::FindStrip(std::size_t face, double x, double y) const
{
  const Strips& strips = this->AllStrips[face];
  if (strips.Count == 0)
  {
    return strips.FirstStrip;
  }
  const double depth = 1.0 / this->Surfaces.GetFace(face).Inverse(x, y);
  const auto first = this->AllCuts.begin() + static_cast<std::ptrdiff_t>(strips.FirstCut);
  const auto cut =
    std::upper_bound(first, first + static_cast<std::ptrdiff_t>(strips.Count), depth);
  return strips.FirstStrip + static_cast<std::size_t>(cut - first);
}

//------------------------------------------------------------------------------
/// Computes the intensity at the columns of a row through the axis.
void Footprint::SetProfile()
{
  const auto across = static_cast<std::size_t>(this->Raster.GetAcross());
  if (this->Profile.size() != across)
  {
    this->Profile.resize(across);
    for (std::size_t i = 0; i < across; ++i)
    {
      this->Profile[i] = this->Beam.GetIntensity(this->Raster.GetCentre(static_cast<int>(i)), 0.0);
    }
  }
}

/// Returns the intensity in a cell, relative to the axis and, unless the beam is wide, relative to
/// the row.
double Footprint::GetIntensity(int column, int row) const
{
  return this->Beam.IsProduct()
    ? this->Profile[static_cast<std::size_t>(column)]
    : this->Beam.GetIntensity(this->Raster.GetCentre(column), this->Raster.GetCentre(row));
}

//------------------------------------------------------------------------------
/// Adds the cells of a row to the strips; returns their energy.
double Footprint::SampleRow(int row, int step)
{
  const int* faces = this->Raster.GetFaces(row);
  const double y = this->Raster.GetCentre(row);
  const double scale = this->Beam.IsProduct() ? this->Profile[static_cast<std::size_t>(row)] : 1.0;
  const int first = this->Raster.GetFirst(row);
  const int last = this->Raster.GetAcross() - first;
  double total = 0.0;
  int column = first + (step + step / 2 - first % step) % step;
  while (column < last)
  {
    const int face = faces[column];
    const bool hasCuts = face >= 0 && this->AllStrips[static_cast<std::size_t>(face)].Count > 0;
    const double start = this->Raster.GetCentre(column);
    double energy = 0.0, sumX = 0.0, sumXX = 0.0; // sums over cells of one strip
    do
    {
      const double x = this->Raster.GetCentre(column);
      const double intensity = this->GetIntensity(column, row);
      energy += intensity;
      sumX += intensity * x;
      sumXX += intensity * x * x;
      column += step;
    } while (column < last && faces[column] == face && !hasCuts);
    total += scale * energy;
    if (face >= 0)
    {
      EnergyMoments& m = this->Sampled[this->FindStrip(static_cast<std::size_t>(face), start, y)];
      m.Energy += scale * energy;
      m.X += scale * sumX;
      m.Y += scale * energy * y;
      m.XX += scale * sumXX;
      m.XY += scale * sumX * y;
      m.YY += scale * energy * y * y;
    }
  }
  return total;
}

//------------------------------------------------------------------------------
void Footprint::Sample(int step, std::vector<FootprintPart>& parts)
{
  parts.clear();
  if (this->AllStrips.empty())
  {
    this->SetStrips();
  }
  std::fill(this->Sampled.begin(), this->Sampled.end(), EnergyMoments());
  this->SetProfile();
  double total = 0.0;
  for (int row = step / 2; row < this->Raster.GetAcross(); row += step)
  {
    total += this->SampleRow(row, step);
  }
  for (std::size_t i = 0; i < this->AllStrips.size(); ++i)
  {
    const Strips& strips = this->AllStrips[i];
    for (std::size_t k = 0; k <= strips.Count; ++k)
    {
      EnergyMoments moments;
      moments.AddTimes(1.0 / total, this->Sampled[strips.FirstStrip + k]);
      this->AddPart(this->Surfaces.GetFace(i), moments, parts);
    }
  }
}

} // namespace helios
