// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// A raster of heights as triangles that are computed on demand.

#ifndef heliosHeightField_h
#define heliosHeightField_h

#include "heliosHeightGrid.h"
#include "heliosHeightPyramid.h"
#include "heliosPose.h"
#include "heliosStatus.h"
#include "vtkHeliosFiltersCoreModule.h" // For export macro

#include <vtkImageData.h>
#include <vtkSmartPointer.h>
#include <vtkType.h>

#include <cstddef>
#include <cstdint>
#include <vector>

class vtkDataArray;

namespace helios
{

/**
 * Triangle i has the corners, and their order, of cell i of the mesh that vtkHeliosGeoTiffSceneReader
 * makes of the raster, bit for bit. Triangles with a corner without height are missing there, and
 * have no number; slot 2 ((columns - 1) row + column) + k counts them all, k = 0 for the triangle
 * with the upper left pixel of the cell at row and column, 1 for the other:
 *
 *      UL ---- UR
 *       |  0  / |
 *       |   /   |
 *       | /  1  |
 *      LL ---- LR
 *
 * Slots have the order of the triangles. Without missing triangles they are the same.
 */
class VTKHELIOSFILTERSCORE_EXPORT HeightField
{
public:
  /**
   * Sets an image with the point data Heights, float or double, NaN for none, and the field data
   * GeoTransform, and keeps a reference. Errors: no triangles; missing arrays; infinite heights, or
   * heights that differ by more than 10,000 times the width of the raster; more than 2^30 cells;
   * pixels too small to be apart in double precision.
   */
  Status Set(vtkImageData* raster);

  /// Releases the raster, which must then outlive this object.
  void ReleaseRaster() { this->Raster = nullptr; }

  vtkIdType GetNumberOfTriangles() const { return this->NumberOfTriangles; }

  void GetCorners(vtkIdType triangle, double corners[3][3]) const
  {
    this->GetSlotCorners(this->GetSlot(triangle), corners);
  }

  /// Returns the unit normal by the right-hand rule: up.
  Vec3 GetNormal(vtkIdType triangle) const;

  /// Computes the smallest and largest coordinates of the corners of the triangles: x0 x1 y0 y1 z0
  /// z1.
  void GetBounds(double bounds[6]) const;

  /// Bytes held by this object in addition to the image.
  std::size_t GetMemorySize() const;

  const HeightGrid& GetGrid() const { return this->Grid; }
  const HeightPyramid& GetPyramid() const { return this->Pyramid; }

  /// Returns the triangle of a slot that is not missing, and the slot of a triangle.
  vtkIdType GetTriangle(std::int64_t slot) const;
  std::int64_t GetSlot(vtkIdType triangle) const;

  bool HasTriangle(std::int64_t slot) const;

  void GetSlotCorners(std::int64_t slot, double corners[3][3]) const;

private:
  static constexpr int BlockSize = 32; ///< cells of a row, two slots each

  struct PixelRow;

  Status SetTriangles(vtkImageData* raster);
  Status SetGrid(vtkImageData* raster);
  Status SetHeights(vtkDataArray* heights, std::int64_t count);
  Status CheckTransform() const;
  Status FindTriangles();
  void AddRow(std::int64_t row, PixelRow& above, PixelRow& below);
  void AddBounds(std::int64_t row, const PixelRow& pixels);
  Status CheckHeights() const;

  vtkSmartPointer<vtkImageData> Raster;
  HeightGrid Grid;
  HeightPyramid Pyramid;
  double Bounds[6] = {};
  vtkIdType NumberOfTriangles = 0;

  // Blocks, row by row; none if no triangle is missing.
  std::int64_t BlocksPerRow = 0;
  std::vector<std::uint64_t> Masks;   ///< a bit per slot: whether it has a triangle
  std::vector<std::uint32_t> Numbers; ///< number of triangles before the block
};

} // namespace helios

#endif
