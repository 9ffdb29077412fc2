// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// The vertices of a PLY file, in double precision. VTK's reader uses floats, and ends the process
// if a header is wrong.

#ifndef heliosPlyPoints_h
#define heliosPlyPoints_h

#include "heliosStatus.h"

#include <string>

class vtkPolyData;

namespace helios::viewer
{

/// Reads vertices as points, and their other properties as arrays. Returns an error or empty
/// string.
Status ReadPlyPoints(const std::string& path, vtkPolyData* cloud);

} // namespace helios::viewer

#endif
