// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Selects the triangles of a leaf that adjacent rays may hit, in floats. For sources only, which
// must first ignore -Wpsabi: vectors are passed to functions that are inlined.

#ifndef heliosLeafFilter_h
#define heliosLeafFilter_h

#include "heliosBeamTree.h"
#include "heliosRayVectors.h"

namespace helios
{

/**
 * A line through the middle of the rays (drawn at Frustum) is the axis of a plane (x, y) across Z;
 * relative to it, a ray is at slope z, z being the distance along Z from the rays' origins. With corners q = (x, y,
 * z) the edge function of a ray at the edge q r is (slope, 1) . (q x r), linear in the slope: its
 * sign is used where it is beyond a bound of its error, which covers float rounding and the
 * tolerance of the double test.
 */
class LeafFilter
{
public:
  /// The edge functions of four triangles, and their error bounds.
  struct Edges
  {
    float Terms[3][3][BeamTree::LeafSize]; ///< edge, factor of the slopes along X and Y, and of 1
    float Error[BeamTree::LeafSize];
    int IsAlive[BeamTree::LeafSize]; ///< whether any ray may hit it; -1 or 0
  };

  /// Sets the axis for rays within intervals, from which BeamTree::SetFrustum made a frustum.
  void SetAxis(const BeamTree& tree, const Frustum& hull, const double low[3], const double high[3],
    const double slopeLow[2], const double slopeHigh[2]);

  /**
   * Sets the maximum offset of rays from their position in the filter, in the frame of the tree.
   * False if the origins are too far for floats: then all hits are possible, with slopes of zero.
   */
  bool SetError(double rest);

  /// Returns the slope of the axis along X or Y, and z where the frustum starts, in the frame of
  /// the tree.
  double GetSlope(int axis) const { return this->Slope[axis]; }
  double GetDepth() const { return this->Depth; }

  HELIOS_INLINE void SetEdges(const BeamTree::Leaf& leaf, float limit, Edges& edges) const;

  /// Finds IsAlive of the edges within a limit.
  void FindAlive(const BeamTree::Leaf& leaf, float limit, int isAlive[BeamTree::LeafSize]) const;

private:
  HELIOS_INLINE void SetPlaces(
    const BeamTree::Leaf& leaf, Floats x[3], Floats y[3], Floats s[3]) const;
  HELIOS_INLINE void SetPackedPlaces(
    const BeamTree::Leaf& leaf, const float steps[3], Floats x[3], Floats y[3], Floats s[3]) const;

  RayAxes Axes;
  bool IsForward = true;
  double Depth = 0.0;
  double Largest = 0.0; ///< largest coordinate of the frustum's start
  double Slack = 0.0;
  float Place[3] = {};  ///< place of the axis at the frustum's start, along X, Y, Z
  float Slope[2] = {};  ///< slope of the axis, per unit along Z
  float Spread[2] = {}; ///< the largest slope of a ray relative to it
  float Tilt[2] = {};   ///< half of the largest slope of a ray
  float Base = 0.0f;    ///< Depth
  float Error = 0.0f;   ///< error of the position of a ray
  float Length = 0.0f;  ///< length of the ray origins, along Z
};

HELIOS_INLINE void LeafFilter::SetPlaces(
  const BeamTree::Leaf& leaf, Floats x[3], Floats y[3], Floats s[3]) const
{
  for (int k = 0; k < 3; ++k)
  {
    x[k] = Load<Floats>(leaf.GetCorners(k, this->Axes.X)) - this->Place[0];
    y[k] = Load<Floats>(leaf.GetCorners(k, this->Axes.Y)) - this->Place[1];
    s[k] = Load<Floats>(leaf.GetCorners(k, this->Axes.Z)) - this->Place[2];
  }
}

HELIOS_INLINE void LeafFilter::SetPackedPlaces(
  const BeamTree::Leaf& leaf, const float steps[3], Floats x[3], Floats y[3], Floats s[3]) const
{
  const int axes[3] = { this->Axes.X, this->Axes.Y, this->Axes.Z };
  Floats* places[3] = { x, y, s };
  for (int i = 0; i < 3; ++i)
  {
    const float start = leaf.Frame->Origin[axes[i]] - this->Place[i];
    const int mask = PackedWord::Masks[axes[i]];
    const float factor = steps[i] * PackedWord::Units[axes[i]];
    for (int k = 0; k < 3; ++k)
    {
      const ShortMasks numbers = Load<ShortMasks>(leaf.GetWords(k)) & mask;
      places[i][k] = start + factor * __builtin_convertvector(numbers, Floats);
    }
  }
}

void LeafFilter::SetEdges(const BeamTree::Leaf& leaf, float limit, Edges& edges) const
{
  Floats x[3], y[3], z[3];
  float error[3] = { this->Error, this->Error, this->Error }; // along X, Y, Z
  if (leaf.Frame)
  {
    const float steps[3] = { leaf.Frame->GetStep(this->Axes.X), leaf.Frame->GetStep(this->Axes.Y),
      leaf.Frame->GetStep(this->Axes.Z) };
    this->SetPackedPlaces(leaf, steps, x, y, z);
    error[0] += 0.5f * steps[0] + this->Tilt[0] * steps[2];
    error[1] += 0.5f * steps[1] + this->Tilt[1] * steps[2];
    error[2] += 0.5f * steps[2];
  }
  else
  {
    this->SetPlaces(leaf, x, y, z);
  }
  Floats sizeX = Floats(), sizeY = Floats(), far = Floats(), minimum = Floats() + 1e30f;
  for (int k = 0; k < 3; ++k)
  {
    const Floats s = this->IsForward ? z[k] : -z[k];
    x[k] = x[k] - this->Slope[0] * s;
    y[k] = y[k] - this->Slope[1] * s;
    z[k] = s + this->Base;
    sizeX = Max<Floats>(sizeX, Max<Floats>(x[k], -x[k]));
    sizeY = Max<Floats>(sizeY, Max<Floats>(y[k], -y[k]));
    far = Max<Floats>(far, Max<Floats>(z[k], -z[k]));
    minimum = Min(minimum, s);
  }
  // The edge function is a x b, a and b being the positions of two corners relative to the ray
  // where it passes them: with errors da and db, its error is da x b + a x db + da x db.
  constexpr float edgeError = 0x1p-19f; // float rounding of an edge function, relative to its terms
  const Floats reachX = sizeX + far * this->Spread[0]; // largest coordinates of a and b
  const Floats reachY = sizeY + far * this->Spread[1];
  const Floats reach = reachX + reachY;
  const Floats doubt = 2.0f * (error[0] * reachY + error[1] * reachX + error[0] * error[1]) +
    edgeError * reach * reach;
  const float uncertain = error[2] + this->Length;
  ShortMasks positive = (minimum - uncertain <= limit) & (ShortMasks{ 0, 1, 2, 3 } < leaf.Count);
  ShortMasks negative = positive;
  for (int k = 0; k < 3; ++k)
  {
    const int i = (k + 1) % 3;
    const int j = (k + 2) % 3;
    const Floats a = y[i] * z[j] - z[i] * y[j];
    const Floats b = z[i] * x[j] - x[i] * z[j];
    const Floats c = x[i] * y[j] - y[i] * x[j];
    const Floats spread =
      Max<Floats>(a, -a) * this->Spread[0] + Max<Floats>(b, -b) * this->Spread[1] + doubt;
    positive = positive & (c + spread >= 0.0f);
    negative = negative & (c - spread <= 0.0f);
    Store(edges.Terms[k][0], a);
    Store(edges.Terms[k][1], b);
    Store(edges.Terms[k][2], c);
  }
  Store(edges.Error, doubt);
  Store(edges.IsAlive, positive | negative);
}

} // namespace helios

#endif
