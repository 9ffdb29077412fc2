// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Triangulates the heights of a raster, row by row.

#ifndef heliosRasterMesh_h
#define heliosRasterMesh_h

#include "heliosGrowingArray.h"
#include "heliosStatus.h"
#include "vtkHeliosFiltersCoreModule.h" // For export macro

#include <vtkDoubleArray.h>

#include <array>
#include <cstdint>
#include <string>
#include <vector>

class vtkPolyData;

namespace helios
{

/**
 * Vertices are at pixel centres. Each 2 x 2 pixels form the triangles (UL, LL, UR) and (LL, LR,
 * UR), reversed for mirrored rasters, so that normals point up. Triangles with a corner without
 * height (NaN) and unused vertices are dropped. IndexArrayT is vtkTypeInt32Array or
 * vtkTypeInt64Array.
 */
template <typename IndexArrayT>
class RasterMesh
{
public:
  /// Sets the number of columns and the geotransform (see RasterFile).
  RasterMesh(std::int64_t columns, const double transform[6]);

  /// Adds the next row of heights. False if there are more points than a scene can hold.
  bool AddRow(const double* heights);

  /// Ends the mesh after the last row. False under the conditions of AddRow.
  bool Finish();

  /// Returns the minimum and maximum height of the vertices.
  const std::array<double, 2>& GetHeights() const { return this->Heights; }

  /// Moves points, triangles and zero MaterialIds to a scene.
  void MoveTo(vtkPolyData* scene);

  std::int64_t MaximumNumberOfPoints = 0x7fffffff; // corners of a scene are 32-bit

private:
  using T = typename IndexArrayT::ValueType;

  struct Row
  {
    std::vector<double> Heights;
    std::vector<unsigned char> HasHeight;
    std::vector<unsigned char> IsUsed; // by a triangle
    std::vector<unsigned char> Upper;  // triangles with the next row: (UL, LL, UR)
    std::vector<unsigned char> Lower;  // (LL, LR, UR)
    std::vector<T> Ids;
  };

  Row& GetRow(std::int64_t r) { return this->Rows[r % 3]; }
  void FindTriangles(std::int64_t r); // between row r and the next
  bool Complete(std::int64_t r);
  bool AddPoints(std::int64_t r);
  void AddTriangles(std::int64_t r);

  std::int64_t Columns;
  std::array<double, 6> Transform;
  bool IsMirrored;
  std::int64_t NumberOfRows = 0;
  std::array<double, 2> Heights;
  std::array<Row, 3> Rows; // the last three
  GrowingArray<vtkDoubleArray> Points;
  GrowingArray<IndexArrayT> Corners;
};

struct HeightGrid;

/// Makes the mesh of a raster in 32-bit cells. Error: more points than a scene can hold.
VTKHELIOSFILTERSCORE_EXPORT Status MakeRasterMesh(const HeightGrid& grid, vtkPolyData* mesh);

} // namespace helios

#endif
