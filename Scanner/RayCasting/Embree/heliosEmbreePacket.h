// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Eight rays at a time, as the double-precision test and as Embree's float traversal want them.

#ifndef heliosEmbreePacket_h
#define heliosEmbreePacket_h

#include "heliosTriangleTest.h"

#include <limits>

namespace helios
{

constexpr int Lanes = 8; // as Embree traces them
constexpr int Half = 4;  // as AVX2 tests them
typedef double Doubles __attribute__((vector_size(8 * Half)));
typedef long long Masks __attribute__((vector_size(8 * Half))); // -1 or 0
typedef float Floats __attribute__((vector_size(4 * Half)));
typedef int ShortMasks __attribute__((vector_size(4 * Half)));

/**
 * The frame of the float boxes: the scene's box, centred and scaled by a power of two into
 * [-1, 1]^3. Boxes are padded by Pad = 8 u32, u32 = 2^-24: a float ray is off its double by u32 for
 * the rounding of its origin and 2 u32 for that of its direction, a box by u32. The other half of
 * the pad is for what the double test allows (BoxSlack) and for the start of the float ray, which
 * suffices for origins up to 1e7 scene sizes away.
 */
struct LocalFrame
{
  static constexpr double Pad = 0x1p-21;

  double Centre[3] = { 0, 0, 0 };
  double Scale = 0.0;          ///< zero without a box
  double Low[3] = { 0, 0, 0 }; ///< the padded box, relative to the centre
  double High[3] = { 0, 0, 0 };

  /// Takes the box of what is in the tree; an empty one where low is above high.
  void Set(const double low[3], const double high[3]);

  /// Makes a float box large enough for a triangle.
  void AddBox(const double* const points[3], float low[3], float high[3]) const;
};

/// Half a packet: four rays and their best hits so far.
struct HalfPacket : RayTerms<Doubles>
{
  Doubles Range;   ///< of the best hit; the ray's maximum as long as there is none
  Masks Triangle;  ///< of the best hit; NoTriangle as long as there is none
  Doubles Start;   ///< where the float ray starts, on the scene's box
  Doubles Stretch; ///< float length for a unit of range
  RayAxes Axes[Half];
  bool HaveSameAxes;

  static constexpr long long NoTriangle = std::numeric_limits<long long>::max();

  vtkHeliosHit GetHit(int lane) const
  {
    const vtkIdType triangle = this->Triangle[lane];
    return triangle == NoTriangle ? vtkHeliosHit{ NoHit, -1 }
                                  : vtkHeliosHit{ this->Range[lane], triangle };
  }

  /// Tests one ray against a triangle; keeps a better hit and says how far its float ray may go.
  bool TestLane(int lane, const double* const points[3], vtkTypeInt32 triangle, float& far);
};

/// The float side of a packet, laid out as RTCRay8.
struct alignas(64) FloatRays
{
  float Origin[3][Lanes];
  float Near[Lanes];
  float Direction[3][Lanes];
  float Time[Lanes];
  float Far[Lanes];
  unsigned int Mask[Lanes];
  unsigned int Id[Lanes];
  unsigned int Flags[Lanes];
};

/// Eight rays.
struct Packet
{
  HalfPacket Halves[2];

  HalfPacket& GetHalf(int lane) { return this->Halves[lane / Half]; }

  /**
   * Takes up to eight rays. Valid lanes are those that may hit the scene; returns how many.
   */
  int Set(const LocalFrame& frame,
    const vtkHeliosRay* rays,
    int count,
    FloatRays& floats,
    int valid[Lanes]);

  /// Tests all valid rays against a triangle, as TestLane does.
  void TestLanes(const int valid[Lanes],
    const double* const points[3],
    vtkTypeInt32 triangle,
    float far[Lanes]);
};

} // namespace helios

#endif
