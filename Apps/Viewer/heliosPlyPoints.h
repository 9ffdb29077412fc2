// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// The vertices of a PLY file, in double precision. VTK's reader has floats, and ends the process where
// a header is wrong.

#ifndef heliosPlyPoints_h
#define heliosPlyPoints_h

#include <string>

class vtkPolyData;

namespace helios
{

/// Reads vertices as points, and their other properties as arrays. What is wrong, or an empty text.
std::string ReadPlyPoints(const std::string& path, vtkPolyData* cloud);

} // namespace helios

#endif
