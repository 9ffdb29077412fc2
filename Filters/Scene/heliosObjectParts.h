// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Objects of a file, such as the houses of a city, as parts of a scene.

#ifndef heliosObjectParts_h
#define heliosObjectParts_h

#include "heliosSceneJoin.h"

#include <vector>

class vtkPolyData;

namespace helios
{

/**
 * Numbers the objects of connections that are split after all other parts: their PartIds, with their
 * Part.Name. The scene has the triangles of the connections in their order, with PartIds, and
 * Part.Name in its field data.
 */
void SplitParts(const PartList& parts, const std::vector<bool>& areSplit, vtkPolyData* scene);

} // namespace helios

#endif
