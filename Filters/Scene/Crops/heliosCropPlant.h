// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// One plant of a crop: stems as closed tubes, leaves as curved strips.

#ifndef heliosCropPlant_h
#define heliosCropPlant_h

#include "heliosCropGround.h"
#include "heliosPose.h"

#include <array>
#include <cstdint>

namespace helios
{

class MeshBuilder;

/// Parameters shared by all plants of a field: the properties of vtkHeliosCropFieldSource.
struct CropShape
{
  double Height;
  double StemRadius;
  int Stems; // tillers
  int StemSides;
  double Lean;      // offset of a stem's top, as a share of its height
  double EarLength; // [m]; 0: none
  int Leaves;       // on all stems together
  double LeafLength;
  double LeafWidth;
  double LeafAngle; // [rad] from the vertical, at the base
  double LeafDroop; // [rad] from base to tip
  double LeafVariation;
  int LeafSegments;
  double WidestAt;     // share of a leaf's length
  double PetioleShare; // share of a leaf's length
  double LeavesFrom;   // share of the stem's height of the lowest leaf
  double LeavesTo;
  bool IsAlternate; // leaves in one plane, else at the golden angle
};

struct CropPlant
{
  Vec3 Position;
  double Height;
  std::uint64_t Seed;
  std::uint64_t Site; // key of the random numbers
};

/// Returns the relative width of a leaf at a share of its length, 1 at the widest point, 0 at the
/// tip: a parabola.
double GetLeafWidth(double share, double widestAt);

/// Returns the number of triangles of one plant, and an upper bound on its points.
vtkIdType CountTriangles(const CropShape& shape);
vtkIdType CountPoints(const CropShape& shape);

/// Adds a plant; leaves and stems scale with its height. Returns its leaf area [m2], one side.
double AddCropPlant(
  MeshBuilder& mesh, const CropShape& shape, const CropPlant& plant, const CropGround& ground);

} // namespace helios

#endif
