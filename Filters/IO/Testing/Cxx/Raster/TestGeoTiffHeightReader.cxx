// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHeliosGeoTiffHeightReader.h"

#include "heliosGeoTiffTesting.h"
#include "heliosHeightField.h"
#include "heliosMaterialTable.h"
#include "heliosSceneCrs.h"
#include "vtkHeliosArrayNames.h"
#include "vtkHeliosMemoryLimit.h"

#include <vtkCallbackCommand.h>
#include <vtkFieldData.h>
#include <vtkImageData.h>
#include <vtkPointData.h>

#include <catch2/catch.hpp>

#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <iterator>

using helios::GeoTiffReading;
using helios::NaN;
using helios::TempFolder;
using helios::TestRaster;

namespace
{

/// A reader of a file with recorded messages, and its output.
struct HeightReading
{
  vtkNew<vtkHeliosGeoTiffHeightReader> Reader;
  vtkSmartPointer<helios::ErrorObserver> Log =
    vtkSmartPointer<helios::ErrorObserver>::Take(helios::ErrorObserver::New());
  vtkSmartPointer<helios::ErrorObserver> Quiet =
    vtkSmartPointer<helios::ErrorObserver>::Take(helios::ErrorObserver::New());

  explicit HeightReading(const std::string& path)
  {
    this->Log->Watch(this->Reader);
    this->Reader->GetExecutive()->AddObserver(vtkCommand::ErrorEvent, this->Quiet);
    this->Reader->SetFileName(path.c_str());
  }

  bool Read()
  {
    this->Reader->Update();
    return this->Log->Errors.empty();
  }

  vtkImageData* Image() { return this->Reader->GetOutput(); }
  vtkDataArray* Heights()
  {
    return this->Image()->GetPointData()->GetArray(vtkHeliosArrayNames::Heights);
  }
};

/// The number of triangles of a file that are not the same in the height field and in the mesh.
vtkIdType CountDifferences(const std::string& path)
{
  HeightReading raster(path);
  GeoTiffReading reading(path);
  REQUIRE(raster.Read());
  REQUIRE(reading.Read());
  helios::HeightField field;
  helios::TriangleMesh mesh;
  REQUIRE(field.Set(raster.Image()).IsOk());
  REQUIRE(mesh.Set(reading.Scene()).IsOk());
  REQUIRE(field.GetNumberOfTriangles() == mesh.GetNumberOfTriangles());
  vtkIdType differences = 0;
  for (vtkIdType i = 0; i < mesh.GetNumberOfTriangles(); ++i)
  {
    double p[3][3];
    field.GetCorners(i, p);
    bool isSame = true;
    for (int corner = 0; corner < 3; ++corner)
    {
      isSame = isSame && std::memcmp(p[corner], mesh.GetCorner(i, corner), sizeof(p[corner])) == 0;
    }
    differences += !isSame;
  }
  return differences;
}

/// Memory for no more than 3 MiB, and a folder for temporary files.
class TinyMemory
{
public:
  explicit TinyMemory(const std::string& folder)
  {
    vtkHeliosMemoryLimit::SetLimit(vtkHeliosMemoryLimit::GetUsed() + 3.0);
    setenv("TMPDIR", folder.c_str(), 1);
  }
  ~TinyMemory()
  {
    vtkHeliosMemoryLimit::SetLimit(0.0);
    unsetenv("TMPDIR");
  }
  TinyMemory(const TinyMemory&) = delete;
  void operator=(const TinyMemory&) = delete;
};

std::ptrdiff_t CountFiles(const std::string& folder)
{
  return std::distance(std::filesystem::directory_iterator(folder), {});
}

std::string GetError(const std::string& path, int band = 1)
{
  HeightReading reading(path);
  reading.Reader->SetBand(band);
  CHECK_FALSE(reading.Read());
  return reading.Log->Errors;
}

} // namespace

TEST_CASE("GeoTiffHeightReader: an image with a point a pixel", "[GeoTiffHeightReader]")
{
  TempFolder folder;
  TestRaster raster(4, 3);
  raster.Crs = "EPSG:25832";
  raster.At(2, 1) = NaN;
  raster.Write(folder / "a.tif");
  HeightReading reading(folder / "a.tif");
  REQUIRE(reading.Read());
  CHECK(reading.Log->Warnings.empty());
  vtkImageData* image = reading.Image();
  CHECK(image->GetNumberOfPoints() == 12);
  REQUIRE(reading.Heights());
  CHECK(reading.Heights()->GetTuple1(11) == 11.0);
  CHECK(std::isnan(reading.Heights()->GetTuple1(6)));
  vtkDataArray* transform = image->GetFieldData()->GetArray(vtkHeliosArrayNames::GeoTransform);
  REQUIRE(transform);
  for (int i = 0; i < 6; ++i)
  {
    CHECK(transform->GetComponent(0, i) == raster.Transform[static_cast<std::size_t>(i)]);
  }
  CHECK(helios::GetMaterials(image) == helios::MaterialTable(1));
  CHECK(helios::GetCRS(image).find("25832") != std::string::npos);
}

TEST_CASE("GeoTiffHeightReader: points are at the pixel centres", "[GeoTiffHeightReader]")
{
  TempFolder folder;
  TestRaster raster(4, 3);
  raster.Transform = { 1000.0, 0.7, 0.2, 2000.0, 0.35, -0.9 }; // rotated and sheared
  raster.Write(folder / "a.tif");
  HeightReading reading(folder / "a.tif");
  REQUIRE(reading.Read());
  double point[3];
  reading.Image()->GetPoint(2 * 4 + 3, point);
  CHECK(point[0] == Approx(1000.0 + 0.7 * 3.5 + 0.2 * 2.5).epsilon(1e-14));
  CHECK(point[1] == Approx(2000.0 + 0.35 * 3.5 - 0.9 * 2.5).epsilon(1e-14));
  CHECK(point[2] == 0.0);
}

TEST_CASE("GeoTiffHeightReader: floats if all heights are", "[GeoTiffHeightReader]")
{
  TempFolder folder;
  TestRaster raster(600, 2000); // read in several blocks
  raster.Options = { "BLOCKYSIZE=16" };
  raster.Write(folder / "a.tif");
  HeightReading whole(folder / "a.tif");
  REQUIRE(whole.Read());
  CHECK(whole.Heights()->GetDataType() == VTK_FLOAT);
  raster.At(5, 1900) = 0.1;
  raster.Write(folder / "b.tif");
  HeightReading mixed(folder / "b.tif");
  REQUIRE(mixed.Read());
  CHECK(mixed.Heights()->GetDataType() == VTK_DOUBLE);
  int differences = 0;
  for (vtkIdType i = 0; i < 600 * 2000; ++i)
  {
    const double height = raster.Values[static_cast<std::size_t>(i)];
    differences += mixed.Heights()->GetTuple1(i) != height;
  }
  CHECK(differences == 0);
}

TEST_CASE("GeoTiffHeightReader: the triangles of GeoTiffSceneReader", "[GeoTiffHeightReader]")
{
  TempFolder folder;
  const std::string path = folder / "a.tif";
  TestRaster raster(37, 41);
  raster.At(7, 5) = -9999.0;
  raster.HasNoData = true;
  raster.NoData = -9999.0;
  for (const GDALDataType type : { GDT_Int16, GDT_Float32, GDT_Float64 })
  {
    raster.Type = type;
    raster.Write(path);
    CHECK(CountDifferences(path) == 0);
  }
  raster.Scale = 0.1;
  raster.Offset = 1000.3;
  raster.Unit = "ft";
  raster.Transform = { 476000.1, 0.7, 0.2, 5473000.3, 0.35, -0.9 };
  raster.Mask.assign(37 * 41, 255);
  raster.Mask[500] = 0;
  raster.Write(path);
  CHECK(CountDifferences(path) == 0);
}

TEST_CASE("GeoTiffHeightReader: a file without blocks has no heights", "[GeoTiffHeightReader]")
{
  TempFolder folder;
  TestRaster raster(600, 500);
  raster.Values.assign(raster.Values.size(), 0.0);
  raster.Options = { "SPARSE_OK=TRUE", "TILED=YES", "COMPRESS=DEFLATE" };
  raster.Write(folder / "a.tif");
  HeightReading reading(folder / "a.tif");
  REQUIRE(reading.Read());
  helios::HeightField field;
  CHECK(field.Set(reading.Image()).Message().find("the raster has no triangles") == 0);
}

TEST_CASE("GeoTiffHeightReader: options are those of GeoTiffSceneReader", "[GeoTiffHeightReader]")
{
  TempFolder folder;
  TestRaster raster(4, 3);
  raster.Bands = 2;
  raster.Write(folder / "a.tif");
  HeightReading reading(folder / "a.tif");
  reading.Reader->SetBand(2);
  reading.Reader->SetHeightUnit(10.0);
  reading.Reader->SetNoDataValue(1005.0);
  REQUIRE(reading.Read());
  CHECK(reading.Heights()->GetTuple1(11) == 10110.0);
  CHECK(std::isnan(reading.Heights()->GetTuple1(5)));
  CHECK(reading.Log->HasWarning("a.tif: heights range from 10000 to 10110 m; if these include"));
}

TEST_CASE("GeoTiffHeightReader: heights beyond the memory are in a file", "[GeoTiffHeightReader]")
{
  TempFolder folder;
  for (const bool areFloats : { true, false })
  {
    TestRaster raster(1000, 700);
    raster.Type = GDT_Float64;
    for (int row = 0; row < 700; ++row)
    {
      for (int column = 0; column < 1000; ++column)
      {
        raster.At(column, row) = column * 0.25 + row + (!areFloats && row > 200 ? 1e-9 : 0.0);
      }
    }
    raster.Write(folder / "a.tif");
    HeightReading inMemory(folder / "a.tif"), inFile(folder / "a.tif");
    REQUIRE(inMemory.Read());
    std::string error;
    {
      const TinyMemory tiny(folder / "none");
      error = GetError(folder / "a.tif");
    }
    CHECK_THAT(error,
      Catch::Contains("a.tif: a temporary file of 2 MB in " + (folder / "none") +
        " cannot be made: No such file or directory; set TMPDIR to a folder with "
        "enough room"));
    {
      const TinyMemory tiny(folder / "");
      REQUIRE(inFile.Read());
    }
    auto* truth = inMemory.Heights();
    auto* heights = inFile.Heights();
    CHECK(heights->GetDataType() == (areFloats ? VTK_FLOAT : VTK_DOUBLE));
    REQUIRE(heights->GetDataType() == truth->GetDataType());
    REQUIRE(heights->GetNumberOfValues() == truth->GetNumberOfValues());
    CHECK(std::memcmp(heights->GetVoidPointer(0), truth->GetVoidPointer(0),
            static_cast<std::size_t>(truth->GetNumberOfValues() * truth->GetDataTypeSize())) == 0);
    CHECK(CountFiles(folder / "") == 1); // the raster: the heights' file has no name
  }
}

TEST_CASE("GeoTiffHeightReader: errors name the file and the remedy", "[GeoTiffHeightReader]")
{
  using Catch::Contains;
  TempFolder folder;
  CHECK_THAT(GetError(""), Contains("FileName is not set; give the GeoTIFF file"));
  CHECK_THAT(GetError(folder / "none.tif"), Contains(folder / "none.tif"));
  TestRaster raster(400, 300);
  raster.Write(folder / "a.tif");
  CHECK_THAT(GetError(folder / "a.tif", 2), Contains("Band 2 is not in the file"));
  vtkHeliosMemoryLimit::SetLimit(vtkHeliosMemoryLimit::GetUsed() / 2.0);
  const std::string error = GetError(folder / "a.tif");
  vtkHeliosMemoryLimit::SetLimit(0.0);
  CHECK_THAT(error, Contains("120000 pixels of a raster need about 0.12 MB of memory"));
  CHECK_THAT(error, Contains("; gdal_translate -srcwin cuts out a part"));
  raster.At(7, 5) = HUGE_VAL;
  raster.Write(folder / "a.tif");
  CHECK_THAT(
    GetError(folder / "a.tif"), Contains("the height at row 5, column 7 (from 0) is infinite"));
}

TEST_CASE("GeoTiffHeightReader: abort", "[GeoTiffHeightReader]")
{
  TempFolder folder;
  TestRaster raster(1000, 3000);
  raster.Options = { "BLOCKYSIZE=16" };
  raster.Write(folder / "a.tif");
  HeightReading reading(folder / "a.tif");
  vtkNew<vtkCallbackCommand> abort;
  abort->SetCallback([](vtkObject* caller, unsigned long, void*, void*)
    { static_cast<vtkAlgorithm*>(caller)->SetAbortExecute(1); });
  const unsigned long tag = reading.Reader->AddObserver(vtkCommand::ProgressEvent, abort);
  CHECK_FALSE(reading.Read());
  CHECK(reading.Log->HasError(folder / "a.tif: reading was aborted at row "));
  CHECK(reading.Log->HasError("; update again to read it"));
  reading.Reader->RemoveObserver(tag);
  reading.Reader->SetAbortExecute(0); // see heliosAborts.h
  reading.Log->Clear();
  reading.Reader->Modified();
  REQUIRE(reading.Read());
  CHECK(reading.Image()->GetNumberOfPoints() == 3000000);
}
