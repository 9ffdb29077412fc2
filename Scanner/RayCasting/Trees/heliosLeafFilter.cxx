// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma GCC diagnostic ignored "-Wpsabi" // vectors are passed to inlined functions only
#include "heliosLeafFilter.h"

#include <algorithm>

namespace helios
{

void LeafFilter::SetAxis(const BeamTree& tree, const Frustum& hull, const double low[3],
  const double high[3], const double slopeLow[2], const double slopeHigh[2])
{
  this->Axes = hull.Axes;
  this->IsForward = hull.IsForward;
  const int axes[3] = { hull.Axes.X, hull.Axes.Y, hull.Axes.Z };
  const double sign = hull.IsForward ? 1.0 : -1.0;
  const double width = std::max(slopeHigh[0] - slopeLow[0], slopeHigh[1] - slopeLow[1]);
  const int widest = slopeHigh[0] - slopeLow[0] == width ? 0 : 1;
  const double apart = high[widest] - low[widest];
  // Computes the distance to the crossing of the rays.
  const double before = width * 1e6 > apart * hull.Scale ? apart / width : 0.0;
  this->Depth = (hull.Start + before) * hull.Scale;
  const double start = tree.GetLocal(low[2], axes[2]) + sign * hull.Start * hull.Scale;
  this->Largest = std::abs(start);
  this->Place[2] = static_cast<float>(start);
  for (int i = 0; i < 2; ++i)
  {
    this->Slope[i] = static_cast<float>(0.5 * (slopeLow[i] + slopeHigh[i]));
    const double slope = this->Slope[i];
    const double middle = tree.GetLocal(0.5 * low[i] + 0.5 * high[i], axes[i]);
    const double place = middle + slope * hull.Start * hull.Scale;
    this->Spread[i] =
      static_cast<float>(std::max(slopeHigh[i] - slope, slope - slopeLow[i]) * (1 + 0x1p-20));
    this->Tilt[i] = 0.5f * (std::abs(this->Slope[i]) + this->Spread[i]) * (1 + 0x1p-20f);
    this->Place[i] = static_cast<float>(place);
    this->Largest = std::max(this->Largest, std::abs(place));
  }
  this->Base = static_cast<float>(this->Depth);
  this->Slack = hull.Slack * hull.Scale;
  this->Length = hull.High[2] - hull.Low[2];
}

bool LeafFilter::SetError(double rest)
{
  // Float rounding of a corner's position relative to the axis: up to 5 + 7 Largest units of 2^-24.
  constexpr double placeError = 0x1p-21;
  this->Error =
    static_cast<float>(placeError * (1.0 + this->Largest) + 2 * (rest + 4 * this->Slack));
  if (this->Largest + this->Depth < 1e6)
  {
    return true;
  }
  std::fill_n(this->Place, 3, 0.0f);
  std::fill_n(this->Slope, 2, 0.0f);
  std::fill_n(this->Spread, 2, 0.0f);
  std::fill_n(this->Tilt, 2, 0.0f);
  this->Base = 0.0f;
  this->Error = 1e6f;
  return false;
}

HELIOS_CLONES
void LeafFilter::FindAlive(
  const BeamTree::Leaf& leaf, float limit, int isAlive[BeamTree::LeafSize]) const
{
  Edges edges;
  this->SetEdges(leaf, limit, edges);
  std::copy_n(edges.IsAlive, BeamTree::LeafSize, isAlive);
}

} // namespace helios
