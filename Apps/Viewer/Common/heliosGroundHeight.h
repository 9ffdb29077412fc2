// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// The ground below a place, estimated from some points of a scene or a cloud.

#ifndef heliosGroundHeight_h
#define heliosGroundHeight_h

#include "heliosPose.h"

#include <vector>

class vtkPolyData;

namespace helios::viewer
{

/// Returns some evenly chosen points of the mesh of a scene [m].
std::vector<Vec3> SampleMesh(vtkPolyData* scene);

/// Returns the height of the lowest of the points that are closest in the plan [m]; NaN: no points.
double FindGround(const std::vector<Vec3>& points, const Vec3& place);

} // namespace helios::viewer

#endif
