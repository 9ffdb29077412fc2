// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Parts of a scene at other places.

#ifndef heliosPlacedParts_h
#define heliosPlacedParts_h

#include "heliosPartMotion.h"
#include "heliosStatus.h"

#include <map>

class vtkPolyData;

namespace helios
{

/// Places parts of a scene, by their ids: points, normals and instances are replaced. Maps are
/// rotations and shifts; meshes of parts have points of their own.
Status PlaceParts(const std::map<int, MotionMap>& maps, vtkPolyData* scene);

} // namespace helios

#endif
