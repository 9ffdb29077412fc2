// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Eight rays at a time, as the double-precision test and as Embree's float traversal want them.

#ifndef heliosEmbreePacket_h
#define heliosEmbreePacket_h

#include "heliosTriangleTest.h"

namespace helios
{

class TriangleMesh;

constexpr int Lanes = 8; // as Embree traces them
constexpr int Half = 4;  // as AVX2 tests them
typedef double Doubles __attribute__((vector_size(8 * Half)));
typedef long long Masks __attribute__((vector_size(8 * Half))); // -1 or 0
typedef float Floats __attribute__((vector_size(4 * Half)));
typedef int ShortMasks __attribute__((vector_size(4 * Half)));

/**
 * The frame of the float boxes: the scene's box, centred and scaled by a power of two into
 * [-1, 1]^3. Boxes are padded by Pad. In units of u32 = 2^-24, a float ray is off its double by 1
 * for the rounding of its origin and 2 for that of its direction, a box by 1: 4 in all, half of
 * the pad. The other half is left for what the double test allows (BoxSlack), which suffices for
 * origins up to 1e7 scene sizes away.
 */
struct LocalFrame
{
  static constexpr double Pad = 0x1p-21;

  double Centre[3] = { 0, 0, 0 };
  double Scale = 1.0;
  double Low[3] = { 0, 0, 0 }; ///< the padded box, relative to the centre
  double High[3] = { 0, 0, 0 };

  void Set(const double bounds[6]);

  /// The box of a triangle.
  void GetBox(const double* const points[3], float low[3], float high[3]) const;
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

  static constexpr long long NoTriangle = 0x7fffffffffff;

  /// Tests one ray against a triangle; keeps a better hit and says how far its float ray may go.
  bool TestLane(int lane, const double* const points[3], unsigned int triangle, float& far);
};

/// The float side of a packet, laid out as RTCRay8.
struct alignas(64) FloatRays
{
  float Origin[3][Lanes];
  float Near[Lanes];
  float Direction[3][Lanes];
  float Time[Lanes];
  float Far[Lanes];
  int Mask[Lanes];
  int Id[Lanes];
  int Flags[Lanes];
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
    unsigned int triangle,
    float far[Lanes]);
};

} // namespace helios

#endif
