// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Triangles between the heights of a raster, which come row by row.

#ifndef heliosRasterMesh_h
#define heliosRasterMesh_h

#include "heliosGrowingArray.h"

#include <vtkDoubleArray.h>

#include <array>
#include <cstdint>
#include <string>
#include <vector>

class vtkPolyData;

namespace helios
{

/**
 * A vertex lies at the centre of every pixel. Four neighbours make the triangles (UL, LL, UR) and
 * (LL, LR, UR), turned round where the raster is mirrored, so that normals point up. A triangle
 * with a corner without height (NaN) is left out, and so is a vertex of no triangle. IndexArrayT
 * is vtkTypeInt32Array or vtkTypeInt64Array.
 */
template <typename IndexArrayT>
class RasterMesh
{
public:
  /// The transform is that of RasterFile.
  RasterMesh(std::int64_t columns, const double transform[6]);

  /// The next row of heights. False if there are more points than a scene can hold.
  bool AddRow(const double* heights);

  /// After the last row. False as AddRow.
  bool Finish();

  /// Lowest and highest vertex.
  const std::array<double, 2>& GetHeights() const { return this->Heights; }

  /// Hands points, triangles and zero MaterialIds over.
  void MoveTo(vtkPolyData* scene);

  std::int64_t MaximumNumberOfPoints = 0x7fffffff; // corners of a scene are 32-bit

private:
  using T = typename IndexArrayT::ValueType;

  struct Row
  {
    std::vector<double> Heights;
    std::vector<unsigned char> HasHeight;
    std::vector<unsigned char> IsUsed; // by a triangle
    std::vector<unsigned char> Upper;  // triangles towards the next row: (UL, LL, UR)
    std::vector<unsigned char> Lower;  // (LL, LR, UR)
    std::vector<T> Ids;
  };

  Row& GetRow(std::int64_t r) { return this->Rows[r % 3]; }
  void FindTriangles(std::int64_t r); // between a row and the next
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

} // namespace helios

#endif
