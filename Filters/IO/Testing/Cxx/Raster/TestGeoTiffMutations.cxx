// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Damaged GeoTIFF files give an error or a complete scene.
#include "heliosGeoTiffTesting.h"
#include "heliosMaterialTable.h"
#include "heliosMutation.h"
#include "vtkHeliosArrayNames.h"

#include <vtkCellData.h>
#include <vtkDataArray.h>

#include <catch2/catch.hpp>

#include <iterator>

using helios::GeoTiffReading;
using helios::TempFolder;
using helios::TestRaster;

namespace
{

/// Valid files of all kinds: without GDAL, in strips, in tiles, compressed, masked, rotated.
std::vector<std::string> MakeGoodFiles(const TempFolder& folder)
{
  std::vector<TestRaster> rasters(5, TestRaster(20, 18));
  rasters[0].Type = GDT_Float32;
  rasters[0].HasNoData = true;
  rasters[0].NoData = -9999.0;
  rasters[0].Values[77] = -9999.0;
  rasters[0].Crs = "EPSG:25832";
  rasters[1].Options = { "TILED=YES", "BLOCKXSIZE=16", "BLOCKYSIZE=16", "COMPRESS=DEFLATE" };
  rasters[1].Transform = { 100.0, 0.8, 0.6, 200.0, 0.6, -0.8 };
  rasters[2].Options = { "COMPRESS=LZW", "PREDICTOR=2" };
  rasters[2].Type = GDT_Int16;
  rasters[2].Mask.assign(rasters[2].Values.size(), 255);
  rasters[2].Mask[50] = 0;
  rasters[3].Options = { "BIGTIFF=YES", "INTERLEAVE=PIXEL", "COMPRESS=PACKBITS" };
  rasters[3].Type = GDT_Byte;
  rasters[3].Bands = 2;
  rasters[3].Unit = "ft";
  rasters[3].Scale = 0.1;
  rasters[4].Options = { "ENDIANNESS=BIG", "BLOCKYSIZE=3" };
  rasters[4].Crs = "EPSG:26915+6360";
  std::vector<std::string> files = { helios::MakeGeoTiffBytes(5, 4, std::vector<double>(20), 1) };
  for (const TestRaster& raster : rasters)
  {
    raster.Write(folder / "good.tif");
    files.push_back(helios::ReadText(folder / "good.tif"));
  }
  return files;
}

/// Why a scene is not valid; empty if it is.
std::string FindFault(GeoTiffReading& reading)
{
  vtkPolyData* scene = reading.Scene();
  if (scene->GetNumberOfCells() == 0)
  {
    return scene->GetNumberOfPoints() == 0 ? "" : "points without triangles";
  }
  vtkDataArray* ids = scene->GetCellData()->GetArray(vtkHeliosArrayNames::MaterialIds);
  if (!ids || ids->GetNumberOfTuples() != scene->GetNumberOfCells() || ids->GetRange()[1] != 0.0)
  {
    return "MaterialIds are wrong";
  }
  if (scene->GetPoints()->GetDataType() != VTK_DOUBLE || helios::GetMaterials(scene).size() != 1)
  {
    return "not a scene";
  }
  helios::TriangleMesh mesh;
  return mesh.Set(scene).Message(); // corners are valid and finite
}

} // namespace

TEST_CASE("GeoTiffMutations: damaged files give an error or a complete scene", "[mutation]")
{
  TempFolder folder;
  const std::vector<std::string> files = MakeGoodFiles(folder);
  const int count = helios::GetNumberOfMutations();
  int errorCount = 0;
  for (int seed = 0; seed < count; ++seed)
  {
    helios::Mutator mutate(static_cast<unsigned>(seed));
    helios::WriteBytes(folder / "a.tif", mutate(files[seed % files.size()]));
    GeoTiffReading reading(folder / "a.tif");
    INFO("seed " << seed);
    const bool isRead = reading.Read();
    errorCount += !isRead;
    REQUIRE(FindFault(reading) == "");
    REQUIRE((isRead || reading.Log->HasError(folder / "a.tif")));
    REQUIRE((isRead || reading.PointCount() == 0));
  }
  CHECK(errorCount > count / 10); // both occur
  CHECK(errorCount < count - count / 10);
}

TEST_CASE("GeoTiffMutations: every byte before the heights replaced", "[mutation]")
{
  TempFolder folder;
  const std::string good = helios::MakeGeoTiffBytes(5, 4, std::vector<double>(20), 1);
  for (std::size_t at = 0; at < good.size() - 160; ++at)
  {
    for (const char byte : { '\x00', '\x7f', '\xff' })
    {
      std::string bytes = good;
      bytes[at] = byte;
      helios::WriteBytes(folder / "a.tif", bytes);
      GeoTiffReading reading(folder / "a.tif");
      INFO("byte " << at << " is " << static_cast<int>(byte));
      const bool isRead = reading.Read();
      REQUIRE(FindFault(reading) == "");
      REQUIRE((isRead || reading.PointCount() == 0));
    }
  }
}
