// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Trees and shrubs with individual leaves.

#ifndef heliosSyntheticTree_h
#define heliosSyntheticTree_h

#include "heliosPose.h"

#include <vtkType.h>

#include <vector>

namespace helios
{

class MeshBuilder;
class Terrain;

enum class Species
{
  Broadleaf,
  Conifer,
  Shrub
};

struct TreeShape
{
  Species Kind = Species::Broadleaf;
  double Height = 12.0;       // [m]
  double CrownDiameter = 7.2; // [m]
  int NumberOfLeaves = 5000;
};

/// Adds a closed tube along a path, from a cap to a point; radii of all points but the last.
void AddTube(
  MeshBuilder& mesh, const std::vector<Vec3>& path, const std::vector<double>& radii, int sides);

/**
 * Adds a tree about the z axis on z = 0: stem and branches as closed tapered tubes, leaves as
 * diamonds of two triangles with random normals, sized such that their area is 3 times (conifers: 4
 * times) the ground below the crown. Trees with different numbers differ.
 */
void AddTree(MeshBuilder& mesh, const TreeShape& shape, vtkIdType seed, vtkIdType number);

/**
 * Trees on the terrain, one in each of a number of squares of the side: 70 % broadleaf, 30 %
 * conifer, 70 to 100 % of the height of the shape.
 */
void AddForest(MeshBuilder& mesh, const Terrain& terrain, double side, const TreeShape& shape,
  int numberOfTrees, vtkIdType seed);

} // namespace helios

#endif
