// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Rays in packets, for the double-precision test and for Embree's float traversal.

#ifndef heliosEmbreePacket_h
#define heliosEmbreePacket_h

#include "heliosRayLanes.h"

namespace helios
{

constexpr int MaximumWidth = 16; // rays that Embree traces at a time

/**
 * The frame of the float boxes: the scene's box, centred and scaled by a power of two into [-1,
 * 1]^3. Boxes are padded by Pad = 8 u32, u32 = 2^-24: a float ray differs from its double by u32
 * for the rounding of its origin and by 2 u32 for its direction, a box by u32. The other half of
 * the pad covers the tolerance of the double test (BoxSlack) and the start of the float ray, for
 * origins up to 1e7 scene sizes away.
 */
struct LocalFrame
{
  static constexpr double Pad = 0x1p-21;

  double Centre[3] = { 0, 0, 0 };
  double Scale = 0.0;          ///< zero without a box
  double Low[3] = { 0, 0, 0 }; ///< the padded box, relative to the centre
  double High[3] = { 0, 0, 0 };

  /// Sets the box of the tree's content; empty if low is above high.
  void Set(const double low[3], const double high[3]);

  /// Builds a float box that contains a triangle.
  void AddBox(const double* const points[3], float low[3], float high[3]) const;
};

/// One triangle, or two with a common edge.
struct TrianglePair
{
  vtkTypeInt32 First;
  int Count;
  const double* Points[2][3];
};

/// Four rays, their best hits so far, and their float rays.
struct RayQuad : RayLanes
{
  Doubles Start;   ///< where the float ray starts, on the scene's box
  Doubles Stretch; ///< float length for a unit of range
  RayAxes Axes[QuadWidth];
  bool HaveSameAxes;

  /**
   * Tests one ray against triangles; keeps a better hit and updates the range of its float
   * ray. Returns whether there is a better hit.
   */
  bool TestLane(int lane, const TrianglePair& pair, float& far);
};

/// The fields of Embree's packets of rays (RTCRay4, 8, 16), in order.
enum class RayField
{
  Origin = 0,
  Near = 3,
  Direction = 4,
  Time = 7,
  Far = 8,
  Mask = 9,
  Id = 10,
  Flags = 11
};

/// A packet of Embree's width: 4, 8 or 16 rays.
struct Packet
{
  int Width = 0;
  RayQuad Quads[MaximumWidth / QuadWidth];
  alignas(64) int Valid[MaximumWidth];         ///< -1: this ray is to be traced
  alignas(64) float Floats[21 * MaximumWidth]; ///< a RTCRayHit4, 8 or 16; a ray's id is its lane

  float* GetField(RayField field) { return this->Floats + static_cast<int>(field) * this->Width; }

  /// Sets the fields common to all rays.
  void SetWidth(int width);

  /// Adds up to Width rays; returns the number of them that may hit the scene and are valid.
  int Set(const LocalFrame& frame, const vtkHeliosRay* rays, int count);

  vtkHeliosHit GetHit(int lane) const
  {
    return this->Quads[lane / QuadWidth].GetHit(lane % QuadWidth);
  }
  bool TestLane(int lane, const TrianglePair& pair, float& far)
  {
    return this->Quads[lane / QuadWidth].TestLane(lane % QuadWidth, pair, far);
  }

  /// Calls RayQuad::TestLane for all valid lanes.
  void TestLanes(const int* valid, const TrianglePair& pair, float* far);
};

} // namespace helios

#endif
