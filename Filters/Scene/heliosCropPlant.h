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

/// What all plants of a field have in common: the properties of vtkHeliosCropFieldSource.
struct CropShape
{
  double Height;
  double StemRadius;
  int Stems; // tillers
  int StemSides;
  double Lean;      // of a stem's top, of its height
  double EarLength; // [m]; 0: none
  int Leaves;       // on all stems together
  double LeafLength;
  double LeafWidth;
  double LeafAngle; // [rad] from the vertical, at its base
  double LeafDroop; // [rad] from base to tip
  double LeafVariation;
  int LeafSegments;
  double WidestAt;     // share of a leaf's length
  double PetioleShare; // of a leaf's length
  double LeavesFrom;   // share of the stem's height
  double LeavesTo;
  bool IsAlternate; // leaves in one plane, else by the golden angle
};

struct CropPlant
{
  Vec3 Position;
  double Height;
  std::uint64_t Seed;
  std::uint64_t Site; // the key of its random numbers
};

/// The width of a leaf at a share of its length, 1 where it is widest, 0 at its tip: a parabola.
double GetLeafWidth(double share, double widestAt);

/// Triangles of one plant, points a little more than they can be.
vtkIdType CountTriangles(const CropShape& shape);
vtkIdType CountPoints(const CropShape& shape);

/// Adds a plant; leaves and stems scale with its height. Returns the area of its leaves [m2], one side.
double AddCropPlant(
  MeshBuilder& mesh, const CropShape& shape, const CropPlant& plant, const CropGround& ground);

} // namespace helios

#endif
