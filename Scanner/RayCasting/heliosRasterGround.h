// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// The triangles of a raster of heights near positions.

#ifndef heliosRasterGround_h
#define heliosRasterGround_h

#include <vtkSmartPointer.h>

#include <array>
#include <vector>

class vtkPolyData;

namespace helios
{

class HeightField;
class Status;
struct Similarity;

/**
 * Makes a mesh, in the frame of the raster, of the triangles whose bounding box at a place in the
 * scene has one of some positions (x, y) in it, and perhaps of more; of all of them if the raster
 * is tilted there. Errors: as MakeRasterMesh().
 */
Status ExtractRasterGround(const HeightField& field, const Similarity& place,
  const std::vector<std::array<double, 2>>& positions, vtkPolyData* mesh);

} // namespace helios

#endif
