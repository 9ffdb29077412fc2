// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// The parts of a crowded beam that the cells of a grid see.

#include "heliosFootprint.h"

#include <algorithm>
#include <cmath>

namespace helios
{
namespace
{

constexpr double LargestReach = Crowd::Reach * (1 - 1e-6);
constexpr std::size_t SmallestCrowd = 12; // surfaces
constexpr std::size_t LargestShare = 2; // triangles of a crowd, in its surfaces: others are joined

} // namespace

/// Projects the triangles of a view as they are, if they are a crowd. What decides on that is the same
/// whether or not the view has triangles that do not touch the beam.
bool Footprint::CollectCrowd()
{
  if (!this->Settings.IsCrowd || this->Settings.ApexOffset > 0.0 ||
    this->View.Triangles.size() < SmallestCrowd)
  {
    return false;
  }
  const double tangent = this->Projection.Tangent;
  this->Faces.Clear();
  const Crowd crowd = this->Faces.AddTriangles(
    this->View, this->Ellipse, tangent, { this->Maker, this->Settings.PairTilt }, this->Facets);
  const double* gate = this->Settings.Gate;
  const bool meetsGate = std::any_of(gate, gate + 2,
    [&crowd](double limit) { return limit > crowd.Nearest && limit < crowd.Farthest; });
  const bool isWorthJoining = crowd.Triangles > LargestShare * crowd.Surfaces;
  if (meetsGate || isWorthJoining || crowd.Surfaces < SmallestCrowd ||
    this->GetNumberOfTiles(crowd.Farthest) > 1 ||
    !this->Settings.IsCrowd(crowd.Surfaces, crowd.Layers))
  {
    return false;
  }
  this->Crowded = crowd;
  this->TilesAcross = 1;
  this->Surfaces.Project(this->Facets, this->Projection);
  for (std::size_t i = 0; i < this->Surfaces.GetNumberOfFaces(); ++i)
  {
    VisibleSurfaces::Face face = this->Surfaces.GetFace(i);
    face.Facet = FacePlane::None;
    this->Faces.Add(face);
  }
  return true;
}

//------------------------------------------------------------------------------
bool Footprint::IsMixed(double tangent, double distance) const
{
  const Crowd& c = this->Crowded;
  return this->IsCrowd() && this->Ellipse.IsCircle() &&
    tangent <= LargestReach * this->Projection.Tangent && c.NearestPlane > c.Nearest + distance;
}

//------------------------------------------------------------------------------
/// Returns whether the corners of a face are within one step of depth, and not across the gate.
bool Footprint::HasNoCuts(const FacePlane& face) const
{
  const double near = 1.0 / face.Maximum;
  const double far = 1.0 / face.Minimum;
  const double* gate = this->Settings.Gate;
  return far - near < std::min(this->Settings.Depth, LargestRatio * near) &&
    std::all_of(gate, gate + 2, [&](double limit) { return !(limit > near && limit < far); });
}

//------------------------------------------------------------------------------
/// Finds the cuts of the faces that are sampled.
void Footprint::SetStrips()
{
  this->AllCuts.clear();
  this->AllStrips.clear();
  std::size_t strips = 0;
  for (std::size_t i = 0; i < this->Faces.GetNumberOfFaces(); ++i)
  {
    const FacePlane& face = this->Faces.GetFace(i);
    if (this->HasNoCuts(face))
    {
      this->AllStrips.push_back({ this->AllCuts.size(), strips++, 0 });
      continue;
    }
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
  const double depth = 1.0 / this->Faces.GetFace(face).Inverse(x, y);
  const auto first = this->AllCuts.begin() + static_cast<std::ptrdiff_t>(strips.FirstCut);
  const auto cut =
    std::upper_bound(first, first + static_cast<std::ptrdiff_t>(strips.Count), depth);
  return strips.FirstStrip + static_cast<std::size_t>(cut - first);
}

//------------------------------------------------------------------------------
void Footprint::Sample(int across, std::vector<FootprintPart>& parts)
{
  parts.clear();
  if (!this->IsCrowd())
  {
    this->Faces.Clear();
    for (std::size_t i = 0; i < this->Surfaces.GetNumberOfFaces(); ++i)
    {
      this->Faces.Add(this->Surfaces.GetFace(i));
    }
  }
  this->Faces.Sort();
  this->SetStrips();
  std::fill(this->Sampled.begin(), this->Sampled.end(), EnergyMoments());
  this->Targets.clear();
  for (const Strips& strips : this->AllStrips)
  {
    this->Targets.push_back(strips.Count == 0 ? static_cast<int>(strips.FirstStrip) : -1);
  }
  static_assert(MaximumTriangles <= FootprintRaster::MaximumFaces, "a face has a number");
  FootprintRaster& raster = this->Rasters[across];
  raster.Draw(this->Faces, this->Beam, across, this->Targets, this->Sampled);
  for (const FootprintRaster::Spot& spot : raster.GetSpots())
  {
    spot.AddTo(this->Sampled[this->FindStrip(static_cast<std::size_t>(spot.Face), spot.X, spot.Y)]);
  }
  for (std::size_t i = 0; i < this->AllStrips.size(); ++i)
  {
    const Strips& strips = this->AllStrips[i];
    for (std::size_t k = 0; k <= strips.Count; ++k)
    {
      this->AddPart(this->Faces.GetFace(i), this->Sampled[strips.FirstStrip + k], parts);
    }
  }
}

} // namespace helios
