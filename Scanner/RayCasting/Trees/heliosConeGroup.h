// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// The few triangles that the cones of consecutive pulses may touch, found by one walk of the trees.

#ifndef heliosConeGroup_h
#define heliosConeGroup_h

#include "heliosPlacedTree.h"
#include "heliosTriangleTest.h"
#include "vtkHeliosRay.h"
#include "vtkHeliosScannerRayCastingModule.h" // For export macro

#include <cstddef>
#include <cstdint>

namespace helios
{

class SceneTree;
struct MomentSpan;

/// A cone by its apex and unit axis.
struct ConeAxis
{
  double Origin[3];
  double Axis[3];
};

/// The triangles in a cone, as bits: those that it may touch, and among them those that cover it,
/// beyond doubt.
struct ConeTriangles
{
  std::uint32_t Touched;
  std::uint32_t Covering;

  bool AreNone() const { return this->Touched == 0; }

  /// Returns whether one triangle covers the cone and no other one touches it.
  bool IsOne() const
  {
    return !this->AreNone() && this->Touched == this->Covering &&
      (this->Touched & (this->Touched - 1)) == 0;
  }
};

class VTKHELIOSSCANNERRAYCASTING_EXPORT ConeGroup
{
public:
  static constexpr int Capacity = 16;

  /// Finds the triangles of a scene that cones of one half angle may touch at any moment of a span; false if they
  /// are more than the capacity, if the cones are too wide or point to different sides, or if they may touch an
  /// instance that moves within the span.
  bool Find(const SceneTree& scene, const ConeAxis* cones, std::size_t count, double tangent,
    const MomentSpan& span);

  int GetNumberOfTriangles() const { return this->Count; }

  /// Selects the triangles in one of the cones, but for those that are hidden: farther than one that covers it
  /// by more than a distance.
  ConeTriangles Select(
    const double origin[3], const double axis[3], double tangent, double distance = 0.0) const;

  /// Calls add() with the tree and number of the triangles of some bits, until it returns false; returns what the
  /// last one has returned.
  template <typename AddT>
  bool Visit(std::uint32_t bits, AddT add) const
  {
    bool isGoing = true;
    for (; bits != 0 && isGoing; bits &= bits - 1)
    {
      const Entry& entry = this->Entries[__builtin_ctz(bits)];
      isGoing = add(entry.Placed, entry.Triangle);
    }
    return isGoing;
  }

  /// Computes the hits of rays inside a cone that one triangle, given by its bit, covers and no other one
  /// touches. The rays have the same origin. Byte-identical to vtkHeliosRayCaster::Intersect().
  void Meet(
    std::uint32_t bit, const vtkHeliosRay* rays, std::size_t count, vtkHeliosHit* hits) const;

private:
  struct Entry
  {
    PlacedTree Placed;
    vtkTypeInt32 Triangle;
  };

  bool Add(const PlacedTree& placed, vtkTypeInt32 triangle);

  int Count = 0;
  Entry Entries[Capacity];
  alignas(32) double Points[3][3][Capacity] = {}; ///< corner, axis, triangle; in the scene
};

} // namespace helios

#endif
