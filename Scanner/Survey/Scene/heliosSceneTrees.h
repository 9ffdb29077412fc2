// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// The trees among the parts of a scene.

#ifndef heliosSceneTrees_h
#define heliosSceneTrees_h

#include "heliosStatus.h"

#include <vector>

class vtkPolyData;

namespace helios
{

struct PartData;

/**
 * Adds the number and the species of the tree that each part is to the field data of a scene: Part.Tree
 * and Part.Species, by part id. Null: no part of a file. Without trees nothing is added. An error:
 * objects of a file as one tree, or trees of which only some have numbers.
 */
Status AddTrees(const std::vector<const PartData*>& parts, vtkPolyData* scene);

} // namespace helios

#endif
