// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosGeoTiffTesting.h"
#include "heliosMaterialTable.h"
#include "heliosSceneCrs.h"
#include "vtkHeliosArrayNames.h"

#include <vtkCallbackCommand.h>
#include <vtkCellData.h>
#include <vtkIdList.h>
#include <vtkIntArray.h>

#include <catch2/catch.hpp>

#include <cstdlib>

using helios::GeoTiffReading;
using helios::NaN;
using helios::TempFolder;
using helios::TestRaster;

namespace
{

// Triangles and points of a raster with some pixels without height.
std::array<vtkIdType, 2> Count(TestRaster raster, const std::vector<std::array<int, 2>>& holes)
{
  for (const auto& [column, row] : holes)
  {
    raster.At(column, row) = NaN;
  }
  TempFolder folder;
  GeoTiffReading reading(folder, raster);
  REQUIRE(reading.Read());
  REQUIRE(reading.FindFault().empty());
  return { reading.TriangleCount(), reading.PointCount() };
}

std::vector<vtkIdType> GetCorners(vtkPolyData* scene, vtkIdType cell)
{
  vtkNew<vtkIdList> ids;
  scene->GetCellPoints(cell, ids);
  return { ids->begin(), ids->end() };
}

} // namespace

TEST_CASE(
  "GeoTiffSceneReader: area and point samples of the plane z = 2x - 3y + 7", "[GeoTiffSceneReader]")
{
  const int columns = 5;
  const int rows = 4;
  for (const bool isPoint : { false, true })
  {
    const double shift = isPoint ? 0.0 : 0.25; // from the tie point to the first sample
    std::vector<double> values;
    for (int row = 0; row < rows; ++row)
    {
      for (int column = 0; column < columns; ++column)
      {
        const double x = 100.0 + shift + 0.5 * column;
        const double y = 200.0 - shift - 0.5 * row;
        values.push_back(2.0 * x - 3.0 * y + 7.0);
      }
    }
    TempFolder folder;
    helios::WriteBytes(
      folder / "a.tif", helios::MakeGeoTiffBytes(columns, rows, values, isPoint ? 2 : 1));
    GeoTiffReading reading(folder / "a.tif");
    REQUIRE(reading.Read());
    CHECK(reading.Log->Warnings.empty());
    vtkPolyData* scene = reading.Scene();
    CHECK(reading.FindFault().empty());
    CHECK(reading.TriangleCount() == 2 * (columns - 1) * (rows - 1));
    REQUIRE(reading.PointCount() == columns * rows);
    CHECK(scene->GetPoints()->GetDataType() == VTK_DOUBLE);
    CHECK(reading.Height(0) == (isPoint ? -393.0 : -391.75));
    CHECK(scene->GetPoint(0)[0] == (isPoint ? 100.0 : 100.25));
    CHECK(scene->GetPoint(0)[1] == (isPoint ? 200.0 : 199.75));
    for (vtkIdType i = 0; i < columns * rows; ++i)
    {
      const double* p = scene->GetPoint(i);
      CHECK(p[2] == 2.0 * p[0] - 3.0 * p[1] + 7.0);
    }
  }
}

TEST_CASE("GeoTiffSceneReader: the scene has triangles in order and one default material",
  "[GeoTiffSceneReader]")
{
  TempFolder folder;
  GeoTiffReading reading(folder, TestRaster(3, 2));
  REQUIRE(reading.Read());
  vtkPolyData* scene = reading.Scene();
  REQUIRE(reading.TriangleCount() == 4);
  CHECK(GetCorners(scene, 0) == std::vector<vtkIdType>{ 0, 3, 1 }); // UL, LL, UR
  CHECK(GetCorners(scene, 1) == std::vector<vtkIdType>{ 3, 4, 1 }); // LL, LR, UR
  CHECK(GetCorners(scene, 2) == std::vector<vtkIdType>{ 1, 4, 2 });
  CHECK(GetCorners(scene, 3) == std::vector<vtkIdType>{ 4, 5, 2 });
  auto* ids =
    vtkIntArray::SafeDownCast(scene->GetCellData()->GetArray(vtkHeliosArrayNames::MaterialIds));
  REQUIRE(ids);
  CHECK(ids->GetNumberOfValues() == 4);
  CHECK(ids->GetValueRange()[0] == 0);
  CHECK(ids->GetValueRange()[1] == 0);
  CHECK(helios::GetMaterials(scene) == helios::MaterialTable(1));
  CHECK(scene->GetFieldData()->HasArray(vtkHeliosArrayNames::MaterialName));
  CHECK(helios::GetCRS(scene).empty());
}

TEST_CASE("GeoTiffSceneReader: a pixel without height removes only its own triangles",
  "[GeoTiffSceneReader]")
{
  const int n = 6;
  const int m = 5;
  const TestRaster raster(n, m);
  const vtkIdType all = 2 * (n - 1) * (m - 1);
  using Counts = std::array<vtkIdType, 2>;
  CHECK(Count(raster, {}) == Counts{ all, n * m });
  CHECK(Count(raster, { { 2, 2 } }) == Counts{ all - 6, n * m - 1 });
  for (const std::array<int, 2>& border :
    { std::array{ 2, 0 }, std::array{ 2, m - 1 }, std::array{ 0, 2 }, std::array{ n - 1, 2 } })
  {
    CHECK(Count(raster, { border }) == Counts{ all - 3, n * m - 1 });
  }
  // The diagonal runs from LL to UR: the other two corners have one triangle each.
  CHECK(Count(raster, { { 0, 0 } }) == Counts{ all - 1, n * m - 1 });
  CHECK(Count(raster, { { n - 1, m - 1 } }) == Counts{ all - 1, n * m - 1 });
  CHECK(Count(raster, { { n - 1, 0 } }) == Counts{ all - 2, n * m - 1 });
  CHECK(Count(raster, { { 0, m - 1 } }) == Counts{ all - 2, n * m - 1 });
  // Both neighbours of a corner: the corner is no longer used.
  CHECK(Count(raster, { { 1, 0 }, { 0, 1 } }) == Counts{ all - 4, n * m - 3 });
}

TEST_CASE("GeoTiffSceneReader: rasters with holes, compared with a count of all blocks",
  "[GeoTiffSceneReader]")
{
  unsigned state = 1;
  for (const int columns : { 2, 3, 17, 64 })
  {
    TestRaster raster(columns, 33);
    for (double& value : raster.Values)
    {
      state = state * 1664525u + 1013904223u;
      value = state >> 30 ? value : NaN; // one in four
    }
    vtkIdType triangles = 0;
    std::vector<char> used(raster.Values.size());
    const auto add = [&](std::array<int, 3> corners)
    {
      for (const int corner : corners)
      {
        if (std::isnan(raster.Values[corner]))
        {
          return;
        }
      }
      ++triangles;
      for (const int corner : corners)
      {
        used[corner] = 1;
      }
    };
    for (int i = 0; i + columns < static_cast<int>(used.size()); ++i)
    {
      if (i % columns + 1 < columns)
      {
        add({ i, i + columns, i + 1 });
        add({ i + columns, i + columns + 1, i + 1 });
      }
    }
    TempFolder folder;
    GeoTiffReading reading(folder, raster);
    REQUIRE(reading.Read());
    CHECK(reading.FindFault().empty());
    CHECK(reading.TriangleCount() == triangles);
    vtkIdType point = 0;
    for (std::size_t i = 0; i < used.size(); ++i)
    {
      if (used[i])
      {
        REQUIRE(reading.Height(point++) == static_cast<double>(i));
      }
    }
    CHECK(reading.PointCount() == point);
  }
}

TEST_CASE("GeoTiffSceneReader: normals point up for any geotransform", "[GeoTiffSceneReader]")
{
  const std::vector<std::vector<double>> transforms = { { 5e5, 1.0, 0.0, 5.5e6, 0.0, -1.0 },
    { 5e5, 1.0, 0.0, 5.5e6, 0.0, 1.0 },     // rows to the north
    { 5e5, -1.0, 0.0, 5.5e6, 0.0, -1.0 },   // columns to the west
    { 5e5, -1.0, 0.0, 5.5e6, 0.0, 1.0 },    // rotated by 180 degrees
    { 5e5, 0.0, 1.0, 5.5e6, 1.0, 0.0 },     // transposed
    { 5e5, 0.0, -2.0, 5.5e6, 1.0, 0.0 },    // rotated by 90 degrees
    { 5e5, 0.8, 0.6, 5.5e6, 0.6, -0.8 },    // rotated
    { 5e5, 1.0, 0.7, 5.5e6, 0.1, -0.25 } }; // sheared
  for (const std::vector<double>& t : transforms)
  {
    TestRaster raster(4, 3);
    raster.Transform = t;
    TempFolder folder;
    GeoTiffReading reading(folder, raster);
    REQUIRE(reading.Read());
    CHECK(reading.FindFault().empty());
    CHECK(reading.TriangleCount() == 12);
    for (int i = 0; i < 12; ++i)
    {
      const double column = i % 4 + 0.5;
      const double row = i / 4 + 0.5;
      const double* p = reading.Scene()->GetPoint(i);
      CHECK(p[0] == Approx(t[0] + t[1] * column + t[2] * row).margin(1e-9));
      CHECK(p[1] == Approx(t[3] + t[4] * column + t[5] * row).margin(2e-9));
      CHECK(p[2] == i);
    }
  }
}

TEST_CASE(
  "GeoTiffSceneReader: no-data values are compared in the type of the band", "[GeoTiffSceneReader]")
{
  struct Case
  {
    GDALDataType Type;
    double NoData;
    double Value; // value of the pixel
    vtkIdType Triangles;
  };
  constexpr double lowest = -std::numeric_limits<float>::max();
  const Case cases[] = { { GDT_Float32, -9999.0, -9999.0, 11 }, // 11 of 12 pixels
    { GDT_Float32, -9999.9, -9999.9, 11 }, { GDT_Float32, 0.1, 0.1, 11 },
    { GDT_Float32, lowest, lowest, 11 },
    { GDT_Float32, -3.4028230607370965e+38, -3.4028230607370965e+38, 11 },
    { GDT_Float32, 1000.0, 1000.00006103515625, 12 }, // adjacent values in single precision
    { GDT_Float64, 0.1, 0.1, 11 }, { GDT_Float64, 0.1, 0.1 + 2e-17, 12 },
    { GDT_Float64, 1e-300, 0.0, 12 }, { GDT_Float32, NaN, NaN, 11 },
    { GDT_Float64, -std::numeric_limits<double>::infinity(),
      -std::numeric_limits<double>::infinity(), 11 },
    { GDT_Byte, 255.0, 255.0, 11 }, { GDT_Byte, -9999.0, 241.0, 12 },
    { GDT_Int16, -32768.0, -32768.0, 11 }, { GDT_UInt16, 65535.0, 65535.0, 11 },
    { GDT_Int64, -9223372036854775808.0, -9223372036854775808.0, 11 },
    { GDT_UInt64, 1e15, 1e15, 11 }, { GDT_Int32, -2147483648.0, -2147483648.0, 11 },
    { GDT_UInt32, 4294967295.0, 4294967295.0, 11 } };
  for (const Case& c : cases)
  {
    TestRaster raster(4, 3);
    raster.Type = c.Type;
    raster.HasNoData = true;
    raster.NoData = c.NoData;
    raster.Values[0] = c.Value;
    TempFolder folder;
    GeoTiffReading reading(folder, raster);
    INFO(GDALGetDataTypeName(c.Type) << ' ' << c.NoData << ' ' << c.Value);
    REQUIRE(reading.Read());
    CHECK(reading.TriangleCount() == c.Triangles);
    CHECK(reading.FindFault().empty());
  }
}

TEST_CASE("GeoTiffSceneReader: NoDataValue overrides that of the file", "[GeoTiffSceneReader]")
{
  TestRaster raster(4, 3);
  raster.Type = GDT_Float32;
  raster.At(0, 0) = -9999.9;
  raster.At(3, 2) = 77.0;
  TempFolder folder;
  {
    GeoTiffReading reading(folder, raster);
    REQUIRE(reading.Read());
    CHECK(reading.TriangleCount() == 12);
    CHECK(reading.Log->HasWarning(folder / "a.tif" +
      ": heights range from -9999.9 to 77 m; if these include pixels without height, set their "
      "value with NoDataValue"));
    reading.Log->Clear();
    reading.Reader->SetNoDataValue(-9999.9); // not a float; compared as one
    REQUIRE(reading.Read());
    CHECK(reading.TriangleCount() == 11);
    CHECK(reading.Log->Warnings.empty());
  }
  raster.HasNoData = true;
  raster.NoData = 77.0;
  GeoTiffReading reading(folder, raster);
  reading.Reader->SetNoDataValue(-9999.9);
  REQUIRE(reading.Read());
  CHECK(reading.TriangleCount() == 11);
  CHECK(reading.Scene()->GetBounds()[5] == 77.0);
}

TEST_CASE("GeoTiffSceneReader: masks and alpha bands hide pixels", "[GeoTiffSceneReader]")
{
  TempFolder folder;
  {
    TestRaster raster(4, 3);
    raster.Mask.assign(12, 255);
    raster.Mask[5] = 0;
    raster.At(1, 1) = std::numeric_limits<double>::infinity(); // masked, so ignored
    GeoTiffReading reading(folder, raster);
    REQUIRE(reading.Read());
    CHECK(reading.TriangleCount() == 6);
    CHECK(reading.FindFault().empty());
  }
  {
    TestRaster raster(4, 3); // a mask, a no-data value and NaN in one file
    raster.Mask.assign(12, 255);
    raster.Mask[0] = 0;
    raster.HasNoData = true;
    raster.NoData = raster.At(3, 2);
    raster.At(3, 0) = NaN;
    GeoTiffReading reading(folder, raster);
    REQUIRE(reading.Read());
    CHECK(reading.TriangleCount() == 12 - 1 - 1 - 2);
  }
  {
    TestRaster raster(4, 3); // the second band is the first + 1000: as alpha clamped to 255
    raster.Type = GDT_Byte;
    raster.Bands = 2;
    raster.Options = { "ALPHA=YES" };
    raster.Values.assign(12, 5.0);
    raster.At(0, 0) = -1000.0; // clamped to 0 in both
    GeoTiffReading reading(folder, raster);
    REQUIRE(reading.Read());
    CHECK(reading.TriangleCount() == 11);
  }
}

TEST_CASE("GeoTiffSceneReader: bands, types, scale, offset and units", "[GeoTiffSceneReader]")
{
  TempFolder folder;
  TestRaster raster(4, 3);
  raster.Bands = 3;
  raster.Type = GDT_Int16;
  raster.Scale = 0.25;
  raster.Offset = 100.0;
  raster.Unit = "ft";
  GeoTiffReading reading(folder, raster);
  REQUIRE(reading.Read());
  CHECK(reading.Height(8) == (8 * 0.25 + 100.0) * 0.3048);
  reading.Reader->SetBand(3);
  REQUIRE(reading.Read());
  CHECK(reading.Height(8) == (2008 * 0.25 + 100.0) * 0.3048);
  reading.Reader->SetHeightUnit(2.0);
  REQUIRE(reading.Read());
  CHECK(reading.Height(8) == (2008 * 0.25 + 100.0) * 2.0);
  CHECK(reading.Log->Warnings.empty());

  for (const GDALDataType type : { GDT_Byte, GDT_UInt16, GDT_Int16, GDT_UInt32, GDT_Int32,
         GDT_UInt64, GDT_Int64, GDT_Float32, GDT_Float64 })
  {
    TestRaster typed(4, 3);
    typed.Type = type;
    GeoTiffReading typedReading(folder, typed);
    REQUIRE(typedReading.Read());
    CHECK(typedReading.Height(11) == 11.0);
  }
  TestRaster negative(4, 3);
#if GDAL_VERSION_NUM >= 3070000
  negative.Type = GDT_Int8;
  negative.At(0, 0) = -3.0;
#else
  negative.Type = GDT_Byte;
  negative.Options = { "PIXELTYPE=SIGNEDBYTE" };
  negative.At(0, 0) = 253.0;
#endif
  GeoTiffReading signedReading(folder, negative);
  REQUIRE(signedReading.Read());
  CHECK(signedReading.Height(0) == -3.0);
  CHECK(signedReading.Height(11) == 11.0);
}

TEST_CASE("GeoTiffSceneReader: units in all spellings", "[GeoTiffSceneReader]")
{
  const std::pair<const char*, double> units[] = { { "m", 1.0 }, { "metre", 1.0 },
    { "Meters", 1.0 }, { "ft", 0.3048 }, { "foot", 0.3048 }, { "US survey foot", 1200.0 / 3937.0 },
    { "us-ft", 1200.0 / 3937.0 }, { "ftUS", 1200.0 / 3937.0 }, { "Foot_US", 1200.0 / 3937.0 },
    { "cm", 0.01 }, { "dm", 0.1 }, { "mm", 0.001 }, { "km", 1000.0 }, { "yard", 0.9144 },
    { "fathom", 1.8288 } };
  TempFolder folder;
  for (const auto& [name, metres] : units)
  {
    TestRaster raster(4, 3);
    raster.Unit = name;
    GeoTiffReading reading(folder, raster);
    INFO(name);
    REQUIRE(reading.Read());
    CHECK(reading.Height(7) == 7.0 * metres);
  }
}

TEST_CASE("GeoTiffSceneReader: the coordinate system is read", "[GeoTiffSceneReader]")
{
  TempFolder folder;
  TestRaster raster(4, 3);
  raster.Crs = "EPSG:25832";
  {
    GeoTiffReading reading(folder, raster);
    REQUIRE(reading.Read());
    CHECK(reading.Log->Warnings.empty());
    const std::string crs = helios::GetCRS(reading.Scene());
    CHECK(crs.find("PROJCRS[\"ETRS89 / UTM zone 32N\"") == 0);
    CHECK(crs.find("ID[\"EPSG\",25832]") != std::string::npos);
  }
  raster.Crs = "EPSG:4326";
  {
    GeoTiffReading reading(folder, raster);
    REQUIRE(reading.Read());
    CHECK(helios::GetCRS(reading.Scene()).find("GEOGCRS[\"WGS 84\"") == 0);
  }
  raster.Crs = "EPSG:25832+7837";
  {
    GeoTiffReading reading(folder, raster);
    REQUIRE(reading.Read());
    const std::string crs = helios::GetCRS(reading.Scene());
    CHECK(crs.find("COMPOUNDCRS[") == 0);
    CHECK(crs.find("DHHN2016 height") != std::string::npos);
    CHECK(crs.find("ID[\"EPSG\",7837]") != std::string::npos);
    CHECK(reading.Height(7) == 7.0);
  }
}

TEST_CASE(
  "GeoTiffSceneReader: heights in feet are converted to metres, also in the vertical system",
  "[GeoTiffSceneReader]")
{
  TempFolder folder;
  TestRaster raster(4, 3);
  raster.Crs = "EPSG:26915+6360"; // NAVD88 height (ftUS)
  GeoTiffReading reading(folder, raster);
  reading.Read();
  INFO(reading.Log->Errors);
  REQUIRE(reading.Log->Errors.empty());
  CHECK(reading.Height(7) == 7.0 * (1200.0 / 3937.0));
  const std::string crs = helios::GetCRS(reading.Scene());
  CHECK(crs.find("VERTCRS[\"NAVD88 height (ftUS), in metres\"") != std::string::npos);
  CHECK(crs.find("North American Vertical Datum 1988") != std::string::npos);
  CHECK(crs.find("foot") == std::string::npos);
  CHECK(crs.find("6360") == std::string::npos);
  CHECK(crs.find("ID[\"EPSG\",26915]") != std::string::npos);

  raster.Unit = "m"; // the band takes precedence
  GeoTiffReading metres(folder, raster);
  REQUIRE(metres.Read());
  CHECK(metres.Height(7) == 7.0);
  CHECK(helios::GetCRS(metres.Scene()).find(", in metres\"") != std::string::npos);
}

TEST_CASE(
  "GeoTiffSceneReader: a map in feet is kept, and needs a unit of heights", "[GeoTiffSceneReader]")
{
  TempFolder folder;
  TestRaster raster(4, 3);
  raster.Crs = "EPSG:2263"; // New York, US survey feet
  GeoTiffReading reading(folder, raster);
  REQUIRE(reading.Read());
  CHECK(reading.Height(7) == 7.0);
  CHECK(reading.Scene()->GetPoint(0)[0] == 100.25);
  CHECK(reading.Log->HasWarning(folder / "a.tif" +
    ": does not give the unit of its heights, which are read as metres although its map is not in "
    "metres; set HeightUnit (metres: 1)"));
  reading.Log->Clear();
  reading.Reader->SetHeightUnit(1.0);
  REQUIRE(reading.Read());
  CHECK(reading.Log->Warnings.empty());
}

TEST_CASE(
  "GeoTiffSceneReader: layouts and compressions give the same scene", "[GeoTiffSceneReader]")
{
  const std::vector<std::vector<std::string>> layouts = { { "BLOCKYSIZE=1" }, { "BLOCKYSIZE=7" },
    { "BLOCKYSIZE=150" }, { "TILED=YES", "BLOCKXSIZE=16", "BLOCKYSIZE=32" },
    { "COMPRESS=DEFLATE", "PREDICTOR=3" }, { "COMPRESS=LZW", "TILED=YES" }, { "COMPRESS=PACKBITS" },
    { "BIGTIFF=YES" }, { "ENDIANNESS=BIG" } };
  for (const auto& options : layouts)
  {
    TestRaster raster(131, 150);
    raster.Type = GDT_Float32;
    raster.Options = options;
    TempFolder folder;
    GeoTiffReading reading(folder, raster);
    INFO(options[0]);
    REQUIRE(reading.Read());
    CHECK(reading.TriangleCount() == 2 * 130 * 149);
    REQUIRE(reading.PointCount() == 131 * 150);
    vtkIdType wrong = 0;
    for (vtkIdType i = 0; i < reading.PointCount(); ++i)
    {
      wrong += reading.Height(i) != static_cast<double>(i);
    }
    CHECK(wrong == 0);
  }
}

TEST_CASE("GeoTiffSceneReader: missing blocks are holes", "[GeoTiffSceneReader]")
{
  for (const bool isTiled : { false, true })
  {
    TestRaster raster(40, 40); // 0 outside of one block: GDAL omits such blocks
    raster.Values.assign(1600, 0.0);
    raster.At(20, 18) = 5.0;
    raster.Options = isTiled
      ? std::vector<std::string>{ "SPARSE_OK=YES", "TILED=YES", "BLOCKXSIZE=16", "BLOCKYSIZE=16" }
      : std::vector<std::string>{ "SPARSE_OK=YES", "BLOCKYSIZE=16" };
    TempFolder folder;
    GeoTiffReading reading(folder, raster);
    REQUIRE(reading.Read());
    const int columns = isTiled ? 16 : 40;
    CHECK(reading.PointCount() == 16 * columns);
    CHECK(reading.TriangleCount() == 2 * 15 * (columns - 1));
    CHECK(reading.Scene()->GetBounds()[0] == (isTiled ? 108.25 : 100.25));
    CHECK(reading.Scene()->GetBounds()[3] == 200.0 - 8.25);
  }
}

TEST_CASE("GeoTiffSceneReader: rasters without triangles are empty scenes with a warning",
  "[GeoTiffSceneReader]")
{
  TempFolder folder;
  const std::string warning = folder / "a.tif" +
    ": no triangles, so the scene is empty; four neighbours with height make two (the raster is ";
  for (const auto& [columns, rows] : { std::pair(1, 1), std::pair(5, 1), std::pair(1, 5) })
  {
    GeoTiffReading reading(folder, TestRaster(columns, rows));
    REQUIRE(reading.Read());
    CHECK(reading.PointCount() == 0);
    CHECK(reading.Log->HasWarning(
      warning + std::to_string(columns) + " x " + std::to_string(rows) + ")"));
  }
  TestRaster holes(4, 3);
  holes.Values.assign(12, NaN);
  GeoTiffReading reading(folder, holes);
  REQUIRE(reading.Read());
  CHECK(reading.PointCount() == 0);
  CHECK(reading.Log->HasWarning(warning + "4 x 3)"));
}

TEST_CASE(
  "GeoTiffSceneReader: reads again if a property changes, reports progress", "[GeoTiffSceneReader]")
{
  TempFolder folder;
  TestRaster(4, 3).Write(folder / "b.tif");
  GeoTiffReading reading(folder, TestRaster(3, 3));
  int count = 0;
  vtkNew<vtkCallbackCommand> counter;
  counter->SetClientData(&count);
  counter->SetCallback(
    [](vtkObject*, unsigned long, void* data, void*) { ++*static_cast<int*>(data); });
  reading.Reader->AddObserver(vtkCommand::StartEvent, counter);
  vtkNew<vtkCallbackCommand> progress;
  double share = 0.0;
  progress->SetClientData(&share);
  progress->SetCallback([](vtkObject* caller, unsigned long, void* data, void*)
    { *static_cast<double*>(data) = static_cast<vtkAlgorithm*>(caller)->GetProgress(); });
  reading.Reader->AddObserver(vtkCommand::ProgressEvent, progress);
  REQUIRE(reading.Read());
  CHECK(share > 0.0);
  REQUIRE(reading.Read());
  CHECK(count == 1);
  reading.Reader->SetFileName((folder / "b.tif").c_str());
  REQUIRE(reading.Read());
  CHECK(count == 2);
  CHECK(reading.TriangleCount() == 12);
  reading.Reader->SetBand(1);
  REQUIRE(reading.Read());
  CHECK(count == 2);
}

TEST_CASE("GeoTiffSceneReader: prints its properties", "[GeoTiffSceneReader]")
{
  vtkNew<vtkHeliosGeoTiffSceneReader> reader;
  CHECK(reader->GetBand() == 1);
  CHECK(reader->GetHeightUnit() == 0.0);
  CHECK(std::isnan(reader->GetNoDataValue()));
  reader->SetFileName("a.tif");
  reader->SetBand(-3);
  CHECK(reader->GetBand() == 1);
  std::ostringstream text;
  reader->Print(text);
  for (const char* word : { "FileName: a.tif", "Band: 1", "HeightUnit: 0", "NoDataValue: nan" })
  {
    CHECK(text.str().find(word) != std::string::npos);
  }
}
