// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosRasterMesh.h"

#include "heliosHeightField.h"
#include "heliosRasterScenes.h"
#include "heliosTriangleMesh.h"

#include <catch2/catch.hpp>

#include <cstring>

namespace
{

/// The number of triangles that are not the same bytes in the height field and in the mesh.
vtkIdType CountDifferences(const helios::HeightField& field, const helios::TriangleMesh& mesh)
{
  vtkIdType differences = 0;
  for (vtkIdType i = 0; i < mesh.GetNumberOfTriangles(); ++i)
  {
    double p[3][3];
    field.GetCorners(i, p);
    bool isSame = field.GetNormal(i) == mesh.GetNormal(i);
    for (int corner = 0; corner < 3; ++corner)
    {
      isSame = isSame && std::memcmp(p[corner], mesh.GetCorner(i, corner), sizeof(p[corner])) == 0;
    }
    differences += !isSame;
  }
  return differences;
}

void CheckRaster(const helios::HeightRaster& raster, vtkImageData* image)
{
  helios::HeightField field;
  REQUIRE(field.Set(image).IsOk());
  helios::TriangleMesh mesh;
  REQUIRE(mesh.Set(helios::MakeMesh(raster)).IsOk());
  REQUIRE(field.GetNumberOfTriangles() == mesh.GetNumberOfTriangles());
  CHECK(CountDifferences(field, mesh) == 0);
  double bounds[6], expected[6];
  field.GetBounds(bounds);
  mesh.GetBounds(expected);
  CHECK(std::memcmp(bounds, expected, sizeof(bounds)) == 0);
}

} // namespace

TEST_CASE("RasterMesh: its triangles are those of a height field, bit for bit", "[RasterMesh]")
{
  for (const auto& transform : helios::TestTransforms)
  {
    for (const auto& [columns, rows] : { std::pair(3, 3), { 2, 40 }, { 67, 2 }, { 100, 50 } })
    {
      helios::HeightRaster raster(columns, rows, transform);
      raster.AddHills(20.0, 3.0);
      CheckRaster(raster, raster.MakeImage<vtkFloatArray>());
      for (double& value : raster.Values)
      {
        value += 1e-9; // not a float
      }
      CheckRaster(raster, raster.MakeImage<vtkDoubleArray>());
      if (columns * rows > 1000)
      {
        raster.AddHoles();
        CheckRaster(raster, raster.MakeImage<vtkDoubleArray>());
      }
    }
  }
}
