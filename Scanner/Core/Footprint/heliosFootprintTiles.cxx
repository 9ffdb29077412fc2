// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// The tiles of a wide beam, within which ranges at one depth are equal.

#include "heliosFootprint.h"

#include <algorithm>
#include <cmath>

namespace helios
{
namespace
{

constexpr double Curvature = 0.1; // largest spread of ranges at one depth, in the depth of a part
constexpr double MaximumTiles = 128.0; // across the beam

} // namespace

/// Returns the number of tiles across the beam. The ranges at one depth spread over depth T^2 r^2 / 2:
/// tiles are so small that they do so over a fraction of the depth of a part.
int Footprint::GetNumberOfTiles(double farthest) const
{
  const double tangent = this->Projection.Tangent;
  const double spread = 0.5 * tangent * tangent * farthest;
  const double limit = Curvature * this->Settings.Depth;
  // A tile at the rim is 2 / count of the radius, and twice as much of its square.
  const double count = std::clamp(std::ceil(4.0 * spread / limit), 2.0, MaximumTiles);
  return spread > limit ? static_cast<int>(count) : 1;
}

//------------------------------------------------------------------------------
void Footprint::SetTiles()
{
  double minimum = HUGE_VAL; // inverse depth
  for (std::size_t i = 0; i < this->GetNumberOfFaces(); ++i)
  {
    minimum = std::min(minimum, this->Surfaces.GetFace(i).Minimum);
  }
  this->TilesAcross = this->GetNumberOfTiles(1.0 / minimum);
}

//------------------------------------------------------------------------------
/// Adds a polygon of a face of a wide beam, in tiles.
void Footprint::AddTiles(
  const FacePlane& face, const Polygon& polygon, std::vector<FootprintPart>& parts)
{
  const double size = 2.0 / this->TilesAcross;
  Polygon restX = polygon;
  for (int i = 1; i <= this->TilesAcross && !restX.IsEmpty(); ++i)
  {
    const HalfPlane left{ -1.0, 0.0, i * size - 1.0 };
    Polygon restY = i < this->TilesAcross ? Clip(restX, left) : restX;
    restX = Clip(restX, left.GetOpposite());
    for (int k = 1; k <= this->TilesAcross && !restY.IsEmpty(); ++k)
    {
      const HalfPlane below{ 0.0, -1.0, k * size - 1.0 };
      const Polygon tile = k < this->TilesAcross ? Clip(restY, below) : restY;
      restY = Clip(restY, below.GetOpposite());
      if (!tile.IsEmpty() && PolygonBounds(tile).MayTouchUnitCircle())
      {
        this->AddPart(face, this->Beam.Integrate(tile), parts);
      }
    }
  }
}

} // namespace helios
