// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Scenes that exceed the available memory are rejected before allocation.
#include "heliosGeoTiffTesting.h"
#include "heliosObjMemory.h"
#include "heliosObjTestFiles.h"
#include "heliosRasterFile.h"
#include "heliosVoxTesting.h"
#include "vtkHeliosMemoryLimit.h"

#include <catch2/catch.hpp>

#include <memory>

namespace
{

/// A memory limit for one test [MiB].
struct Limit
{
  explicit Limit(double mebibytes) { vtkHeliosMemoryLimit::SetLimit(mebibytes); }
  ~Limit() { vtkHeliosMemoryLimit::SetLimit(0.0); }
};

/// A raster of empty blocks except for one pixel, if any.
std::string WriteSparse(const helios::TempFolder& folder, int side, bool hasBlock)
{
  GDALRegister_GTiff();
  const std::string path = folder / "sparse.tif";
  const char* options[] = { "SPARSE_OK=YES", "TILED=YES", "COMPRESS=DEFLATE", nullptr };
  GDALDatasetH file = GDALCreate(GDALGetDriverByName("GTiff"), path.c_str(), side, side, 1,
    GDT_Float32, const_cast<char**>(options));
  double transform[] = { 0.0, 1.0, 0.0, 0.0, 0.0, -1.0 };
  GDALSetGeoTransform(file, transform);
  float block[4] = { 1.0f, 2.0f, 3.0f, 4.0f };
  if (hasBlock)
  {
    REQUIRE(GDALRasterIO(GDALGetRasterBand(file, 1), GF_Write, 300, 300, 2, 2, block, 2, 2,
              GDT_Float32, 0, 0) == CE_None);
  }
  GDALClose(file);
  return path;
}

} // namespace

TEST_CASE("ReaderMemory: GeoTIFF: pixels of existing blocks count", "[ReaderMemory]")
{
  const helios::TempFolder folder;
  std::unique_ptr<helios::RasterFile> file;
  REQUIRE(helios::MakeRasterFile(file).IsOk());
  REQUIRE(file->Open(WriteSparse(folder, 1000, true), {}).IsOk());
  CHECK(file->CountPixels() == Approx(256.0 * 256.0).epsilon(1e-6));

  const Limit limit(0.001);
  helios::GeoTiffReading reading(folder / "sparse.tif");
  CHECK_FALSE(reading.Read());
  CHECK(
    reading.Log->HasError(folder / "sparse.tif: 65536 pixels of two triangles need about 9.83 MB"));
  CHECK(reading.Log->HasError("; gdal_translate -srcwin cuts out a part"));
}

TEST_CASE("ReaderMemory: GeoTIFF: a file without blocks needs no memory", "[ReaderMemory]")
{
  const helios::TempFolder folder;
  helios::GeoTiffReading reading(WriteSparse(folder, 100000, false));
  REQUIRE(reading.Read()); // without delay
  CHECK(reading.Log->HasWarning("no triangles, so the scene is empty"));
}

TEST_CASE("ReaderMemory: OBJ: lines are counted if the size is not conclusive", "[ReaderMemory]")
{
  helios::TestFolder folder;
  const std::string path = folder.Write("a.obj",
    "# f 1 2 3\nv 0 0 0\nv  1 0 0 \r\nvn 0 0 1\nv 1 1 0\nv 0 1 0\nf 1 2 3\nf 1/1 2/2 3/3  4/4\nvt "
    "0 0\n");
  const helios::ObjCounts counts = helios::CountObj(path);
  CHECK(counts.Vertices == 4.0);
  CHECK(counts.Triangles == 3.0);
  CHECK(helios::CheckObjMemory(path).IsOk());

  const Limit limit(0.001);
  helios::ObjReading reading(path);
  CHECK_FALSE(reading.Read());
  CHECK(reading.Log->HasError(path + ": 3 triangles with their vertices need about 0.000321 MB"));
}

TEST_CASE("ReaderMemory: voxels are counted in the header", "[ReaderMemory]")
{
  helios::vox::Reading reading(helios::vox::Head + helios::vox::Columns + helios::vox::Rows);
  const Limit limit(0.001);
  CHECK_FALSE(reading.Read());
  CHECK(reading.Log->HasError("a.vox: 24 cells need about 0.000384 MB of memory, and 0 MB are"));
}
