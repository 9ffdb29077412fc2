// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Errors of the GeoTIFF reader on bad files.
#include "heliosGeoTiffTesting.h"
#include "heliosInputFile.h"
#include "heliosRasterFile.h"
#include "heliosRasterMesh.h"
#include "heliosRasterUnits.h"
#include "heliosSceneCrs.h"
#include "heliosStatus.h"

#include <vtkCallbackCommand.h>
#include <vtkTypeInt32Array.h>
#include <vtkTypeInt64Array.h>

#include <catch2/catch.hpp>

#include <cstdio>
#include <memory>
#include <string>
#include <vector>

#include <fcntl.h>
#include <unistd.h>

#ifdef __linux__
#include <sys/resource.h>
#endif

using helios::GeoTiffReading;
using helios::NaN;
using helios::TempFolder;
using helios::TestRaster;

namespace
{

constexpr double Infinity = std::numeric_limits<double>::infinity();

void CheckError(GeoTiffReading& reading, const std::string& message)
{
  INFO("expected: " << message);
  CHECK_FALSE(reading.Read());
  INFO("said: " << reading.Log->Errors);
  CHECK(reading.Log->HasError(message));
  CHECK(reading.PointCount() == 0);
  CHECK(reading.TriangleCount() == 0);
}

void CheckError(const TestRaster& raster, const std::string& message)
{
  TempFolder folder;
  GeoTiffReading reading(folder, raster);
  CheckError(reading, folder / "a.tif" + message);
}

void CheckBytes(const std::string& bytes, const std::string& message)
{
  TempFolder folder;
  helios::WriteBytes(folder / "a.tif", bytes);
  GeoTiffReading reading(folder / "a.tif");
  CheckError(reading, message);
}

std::string MakeGoodBytes()
{
  return helios::MakeGeoTiffBytes(3, 2, { 1, 2, 3, 4, 5, 6 }, 1);
}

/// Captures console output during its lifetime.
class ConsoleCatcher
{
public:
  explicit ConsoleCatcher(const std::string& path)
    : Path(path)
    , Before(::dup(2))
  {
    const int file = ::open(path.c_str(), O_CREAT | O_WRONLY | O_TRUNC, 0600);
    ::dup2(file, 2);
    ::close(file);
  }
  ~ConsoleCatcher() { this->Finish(); }
  std::string Finish()
  {
    if (this->Before >= 0)
    {
      std::fflush(stderr);
      ::dup2(this->Before, 2);
      ::close(this->Before);
      this->Before = -1;
    }
    return helios::ReadText(this->Path);
  }

private:
  std::string Path;
  int Before;
};

} // namespace

TEST_CASE("GeoTiffErrors: files of other kinds are errors", "[GeoTiffErrors]")
{
  TempFolder folder;
  const std::string cure =
    "; check the file (gdal_translate -of GTiff turns other formats into GeoTIFF)";
  helios::WriteBytes(folder / "text.tif", "ncols 4\nnrows 3\n");
  helios::WriteBytes(folder / "empty.tif", "");
  helios::WriteBytes(folder / "other.png", "\x89PNG\r\n\x1a\n");
  std::filesystem::create_directory(folder / "folder.tif");
  for (const char* name : { "missing.tif", "text.tif", "empty.tif", "other.png" })
  {
    GeoTiffReading reading(folder / name);
    CheckError(reading, folder / name + ": cannot be read as GeoTIFF or VRT: ");
    CHECK(reading.Log->HasError(cure));
  }
  GeoTiffReading inFolder(folder / "folder.tif");
  CheckError(
    inFolder, folder / "folder.tif" + ": cannot be read: it is a folder; give the name of a file");
  GeoTiffReading missing(folder / "missing.tif");
  CheckError(missing, "missing.tif: No such file or directory");

  GeoTiffReading unnamed("");
  CheckError(unnamed, "FileName is not set; give the GeoTIFF file with SetFileName");
  unnamed.Log->Clear();
  unnamed.Reader->SetFileName(nullptr);
  CheckError(unnamed, "FileName is not set");
}

TEST_CASE("GeoTiffErrors: tiles of a VRT are inputs, and folders are none", "[GeoTiffErrors]")
{
  TempFolder folder;
  const auto writeVrt = [&folder](const std::string& name, const std::string& tile)
  {
    helios::WriteBytes(folder / name,
      R"(<VRTDataset rasterXSize="3" rasterYSize="2"><GeoTransform>0, 1, 0, 0, 0, -1</GeoTransform>
<VRTRasterBand dataType="Float32" band="1"><SimpleSource><SourceFilename relativeToVRT="1">)" +
        tile +
        R"(</SourceFilename><SourceProperties RasterXSize="3" RasterYSize="2" DataType="Float32"
BlockXSize="3" BlockYSize="2"/><SourceBand>1</SourceBand><SrcRect xOff="0" yOff="0" xSize="3" ySize="2"/>
<DstRect xOff="0" yOff="0" xSize="3" ySize="2"/></SimpleSource></VRTRasterBand></VRTDataset>)");
  };
  helios::WriteBytes(folder / "tile.tif", MakeGoodBytes());
  helios::WriteBytes(folder / "tile.tif.aux.xml", "<PAMDataset></PAMDataset>");
  writeVrt("inner.vrt", "tile.tif");
  writeVrt("outer.vrt", "inner.vrt");
  helios::InputFiles files;
  const helios::InputWatch watch(files);
  GeoTiffReading reading(folder / "outer.vrt");
  CHECK(reading.Read());
  std::vector<std::string> names;
  for (const auto& file : files)
  {
    names.push_back(file.first);
  }
  CHECK(names ==
    std::vector<std::string>{ folder / "inner.vrt", folder / "outer.vrt", folder / "tile.tif",
      folder / "tile.tif.aux.xml" });
  std::filesystem::create_directory(folder / "folder");
  writeVrt("bad.vrt", "folder");
  GeoTiffReading bad(folder / "bad.vrt");
  CheckError(bad,
    folder / "bad.vrt" + ": needs " + folder / "folder" +
      ", which cannot be read: it is a folder; give the name of a file");
}

TEST_CASE("GeoTiffErrors: truncated files are errors", "[GeoTiffErrors]")
{
  const std::string whole = MakeGoodBytes();
  for (std::size_t size = 1; size < whole.size(); ++size)
  {
    TempFolder folder;
    helios::WriteBytes(folder / "a.tif", whole.substr(0, size));
    GeoTiffReading reading(folder / "a.tif");
    INFO("the first " << size << " bytes");
    CHECK_FALSE(reading.Read());
    CHECK(reading.Log->HasError(folder / "a.tif: "));
    CHECK(reading.PointCount() == 0);
  }
  CheckBytes(whole.substr(0, whole.size() - 4), ": rows 0 to 1 (from 0) cannot be read: ");
  CheckBytes(whole.substr(0, whole.size() - 4), "; the file is damaged, get it again");
}

TEST_CASE("GeoTiffErrors: more pixels than the file can contain", "[GeoTiffErrors]")
{
  std::string bytes = MakeGoodBytes();
  bytes[33] = '\x7f'; // byte of the number of rows
  CheckBytes(bytes,
    ": is damaged: 3 x 2130706434 pixels in 1065353217 blocks do not fit into a file of 326 bytes; "
    "get it again");
  bytes = MakeGoodBytes();
  bytes[21] = '\x7f'; // byte of the number of columns
  CheckBytes(bytes,
    ": is damaged: 2130706435 x 2 pixels in 2 blocks do not fit into a file of 326 bytes; get it "
    "again");
}

TEST_CASE("GeoTiffErrors: nothing is written to the console", "[GeoTiffErrors]")
{
  TempFolder folder;
  const std::string whole = MakeGoodBytes();
  ConsoleCatcher console(folder / "console.txt");
  for (std::size_t size = 0; size <= whole.size(); size += 8)
  {
    helios::WriteBytes(folder / "a.tif", whole.substr(0, size));
    GeoTiffReading reading(folder / "a.tif");
    reading.Read();
  }
  CHECK(console.Finish() == "");
}

TEST_CASE("GeoTiffErrors: bands", "[GeoTiffErrors]")
{
  TempFolder folder;
  TestRaster raster(4, 3);
  raster.Bands = 2;
  GeoTiffReading reading(folder, raster);
  reading.Reader->SetBand(3);
  CheckError(reading,
    folder / "a.tif" +
      ": Band 3 is not in the file, whose bands are 1 to 2; set Band to one of them");
  raster.Bands = 1;
  raster.Type = GDT_CFloat32;
  CheckError(raster,
    ": band 1 has complex numbers (CFloat32), which are not heights; choose another with Band");
}

TEST_CASE("GeoTiffErrors: geotransforms", "[GeoTiffErrors]")
{
  TestRaster raster(4, 3);
  raster.Transform.clear();
  CheckError(raster, ": is not georeferenced; give it corners with gdal_edit.py -a_ullr");
  raster.NumberOfGroundPoints = 4;
  raster.Crs = "EPSG:4326";
  CheckError(raster,
    ": has ground control points only, which do not place its pixels exactly; rectify it with "
    "gdalwarp");
  const std::string cure = ", in which pixels have no area; correct it with gdal_edit.py -a_ullr";
  const std::vector<std::vector<double>> bad = { { 0, 1, 2, 0, 2, 4 }, // columns parallel to rows
    { 0, 1, 0, 0, 1, 0 }, { 5e5, 1e-12, 0, 5.5e6, 0, -1e-12 }, { 0, 1, 0, NaN, 0, -1 },
    { 0, 1, 0, 0, 0, -Infinity }, { 1e308, 1e308, 0, 0, 0, -1 } };
  for (const auto& transform : bad)
  {
    TestRaster flat(4, 3);
    flat.Transform = transform;
    TempFolder folder;
    GeoTiffReading reading(folder, flat);
    INFO(transform[1] << ' ' << transform[2] << ' ' << transform[4] << ' ' << transform[5]);
    CheckError(reading, cure);
  }
  TestRaster flat(4, 3);
  flat.Transform = bad[0];
  CheckError(flat, ": has the geotransform 0, 1, 2, 0, 2, 4" + cure);
}

TEST_CASE("GeoTiffErrors: infinite heights are named", "[GeoTiffErrors]")
{
  const std::string cure = " (from 0) is infinite; correct it, or make it the no-data value with "
                           "gdal_edit.py -a_nodata";
  TestRaster raster(70, 90);
  raster.Options = { "BLOCKYSIZE=16" };
  raster.At(33, 77) = -Infinity;
  CheckError(raster, ": the height at row 77, column 33" + cure);
  raster.At(33, 77) = 1e308;
  raster.Scale = 100.0;
  CheckError(raster, ": the height at row 77, column 33" + cure);
  raster.At(0, 0) = Infinity;
  CheckError(raster, ": the height at row 0, column 0" + cure);
}

TEST_CASE("GeoTiffErrors: scale, offset and units", "[GeoTiffErrors]")
{
  TestRaster raster(4, 3);
  raster.Scale = 0.0;
  CheckError(raster,
    ": has heights with scale 0 and offset 0; correct them with gdal_edit.py -scale 1 "
    "-offset 0");
  raster.Scale = NaN;
  CheckError(raster, ": has heights with scale nan and offset 0; correct them");
  raster.Scale = 1.0;
  raster.Offset = Infinity;
  CheckError(raster, ": has heights with scale 1 and offset inf; correct them");
  raster.Offset = 0.0;
  raster.Unit = "kelvin";
  CheckError(raster,
    ": has heights in \"kelvin\", which is not a known unit; give its length in metres with "
    "HeightUnit");

  TempFolder folder;
  GeoTiffReading reading(folder, raster);
  reading.Reader->SetHeightUnit(0.5);
  CHECK(reading.Read());
  CHECK(helios::GetUnitInMetres("") == 0.0);
  CHECK(helios::GetUnitInMetres("foot meter") == 0.0);
}

TEST_CASE("GeoTiffErrors: without the library linked to GDAL", "[GeoTiffErrors]")
{
  std::unique_ptr<helios::RasterFile> file;
  const helios::Status status = helios::MakeRasterFile("libvtkHeliosNothing.so", file);
  CHECK(status.Message().find("rasters cannot be read: libvtkHeliosNothing.so: ") == 0);
  CHECK(status.Message().find("; install GDAL (Debian: ") != std::string::npos);
  CHECK(file == nullptr);
}

TEST_CASE("GeoTiffErrors: heights in feet of a three-dimensional system", "[GeoTiffErrors]")
{
  const std::string wkt =
    "GEOGCRS[\"WGS 84 in feet\",DATUM[\"World Geodetic System 1984\",ELLIPSOID[\"WGS "
    "84\",6378137,298.257223563,LENGTHUNIT[\"metre\",1]]],CS[ellipsoidal,3],AXIS[\"geodetic "
    "latitude "
    "(Lat)\",north,ORDER[1],ANGLEUNIT[\"degree\",0.0174532925199433]],AXIS[\"geodetic longitude "
    "(Lon)\",east,ORDER[2],ANGLEUNIT[\"degree\",0.0174532925199433]],AXIS[\"ellipsoidal height "
    "(h)\",up,ORDER[3],LENGTHUNIT[\"foot\",0.3048]]]";
  CHECK(helios::MakeHeightsMetric(wkt).empty());
  CHECK(helios::MakeHeightsMetric("no system") == "no system");
  TempFolder folder;
  GeoTiffReading reading(folder, TestRaster(4, 3));
  helios::WriteBytes(folder / "a.tif.aux.xml", "<PAMDataset><SRS>" + wkt + "</SRS></PAMDataset>\n");
  CheckError(reading,
    folder / "a.tif" +
      ": has a coordinate system with heights in feet that cannot be converted to metres; "
      "transform it with gdalwarp -t_srs");
}

TEST_CASE("GeoTiffErrors: warnings of GDAL are passed on", "[GeoTiffErrors]")
{
  std::string bytes = MakeGoodBytes();
  bytes[10 + 9 * 12] = '\xff'; // tag 284 becomes 511, out of order
  TempFolder folder;
  helios::WriteBytes(folder / "a.tif", bytes);
  GeoTiffReading reading(folder / "a.tif");
  REQUIRE(reading.Read());
  INFO(reading.Log->Warnings);
  CHECK(reading.Log->HasWarning(folder / "a.tif: "));
  CHECK(reading.Log->HasWarning("tags are not sorted in ascending order (2 warnings of GDAL)"));
}

TEST_CASE(
  "GeoTiffErrors: an invalid coordinate system is dropped with a warning", "[GeoTiffErrors]")
{
  TempFolder folder;
  TestRaster raster(4, 3);
  raster.Crs = "LOCAL_CS[\"site\",UNIT[\"metre\",1]]";
  const std::string warning = ": its coordinate system \"site\" is not tied to the Earth and is "
                              "ignored; to replace it, use gdal_edit.py -a_srs";
  {
    GeoTiffReading reading(folder, raster);
    REQUIRE(reading.Read());
    INFO(reading.Log->Warnings);
    CHECK(reading.Log->HasWarning(folder / "a.tif" + warning));
    CHECK(helios::GetCRS(reading.Scene()).empty());
  }
  raster.Crs = "EPSG:25832";
  raster.Write(folder / "a.tif");
  std::string bytes = helios::ReadText(folder / "a.tif");
  const std::size_t at = bytes.find("\xe8\x64"); // 25832
  REQUIRE(at != std::string::npos);
  bytes[at + 1] = 0x71; // not a valid code
  helios::WriteBytes(folder / "a.tif", bytes);
  GeoTiffReading reading(folder / "a.tif");
  REQUIRE(reading.Read());
  INFO(reading.Log->Warnings);
  CHECK(reading.Log->HasWarning("\"ETRS89 / UTM zone 32N\" is not tied to the Earth"));
  CHECK(helios::GetCRS(reading.Scene()).empty());
}

TEST_CASE("GeoTiffErrors: abort", "[GeoTiffErrors]")
{
  TempFolder folder;
  TestRaster raster(1000, 3000);
  raster.Options = { "BLOCKYSIZE=16" };
  GeoTiffReading reading(folder, raster);
  vtkNew<vtkCallbackCommand> abort;
  abort->SetCallback([](vtkObject* caller, unsigned long, void*, void*)
    { static_cast<vtkAlgorithm*>(caller)->SetAbortExecute(1); });
  const unsigned long tag = reading.Reader->AddObserver(vtkCommand::ProgressEvent, abort);
  CheckError(reading, folder / "a.tif: reading was aborted at row ");
  CHECK(reading.Log->HasError("; update again to read it"));
  reading.Reader->RemoveObserver(tag);
  reading.Reader->SetAbortExecute(0); // see heliosAborts.h
  reading.Log->Clear();
  reading.Reader->Modified();
  REQUIRE(reading.Read());
  CHECK(reading.TriangleCount() == 2 * 999 * 2999);
}

TEST_CASE("GeoTiffErrors: more points than a scene can hold", "[GeoTiffErrors]")
{
  const double transform[6] = { 0.0, 1.0, 0.0, 0.0, 0.0, -1.0 };
  const std::vector<double> row(3, 5.0);
  helios::RasterMesh<vtkTypeInt32Array> mesh(3, transform);
  mesh.MaximumNumberOfPoints = 7;
  CHECK(mesh.AddRow(row.data()));
  CHECK(mesh.AddRow(row.data()));
  CHECK(mesh.AddRow(row.data()));
  CHECK_FALSE(mesh.Finish());
}

TEST_CASE("GeoTiffErrors: 64-bit cells hold the same mesh", "[GeoTiffErrors]")
{
  const double transform[6] = { 0.0, 1.0, 0.0, 0.0, 0.0, 1.0 };
  const std::vector<double> rows[3] = { { 1, 2, NaN, 4 }, { 5, 6, 7, 8 }, { 9, 10, NaN, 12 } };
  helios::RasterMesh<vtkTypeInt32Array> small(4, transform);
  helios::RasterMesh<vtkTypeInt64Array> large(4, transform);
  for (const auto& row : rows)
  {
    REQUIRE((small.AddRow(row.data()) && large.AddRow(row.data())));
  }
  REQUIRE((small.Finish() && large.Finish()));
  vtkNew<vtkPolyData> a, b;
  small.MoveTo(a);
  large.MoveTo(b);
  helios::TriangleMesh first, second;
  REQUIRE(first.Set(a).IsOk());
  REQUIRE(second.Set(b).IsOk());
  REQUIRE(first.GetNumberOfTriangles() == 6);
  REQUIRE(second.GetNumberOfTriangles() == 6);
  CHECK(std::equal(first.GetCorners(), first.GetCorners() + 18, second.GetCorners()));
  CHECK(std::equal(
    first.GetPoints(), first.GetPoints() + 3 * a->GetNumberOfPoints(), second.GetPoints()));
}

#if defined(__linux__) && !defined(__SANITIZE_ADDRESS__)
TEST_CASE("GeoTiffErrors: out of memory", "[GeoTiffErrors]")
{
  TempFolder folder;
  TestRaster raster(2000, 2000);
  raster.Type = GDT_Byte;
  GeoTiffReading reading(folder, raster);
  long pages = 0;
  std::FILE* size = std::fopen("/proc/self/statm", "r");
  REQUIRE(size);
  REQUIRE(std::fscanf(size, "%ld", &pages) == 1);
  std::fclose(size);
  rlimit before;
  getrlimit(RLIMIT_AS, &before);
  rlimit tight = before;
  tight.rlim_cur = static_cast<rlim_t>(pages) * getpagesize() + (rlim_t(64) << 20);
  setrlimit(RLIMIT_AS, &tight);
  const bool isGood = reading.Read();
  setrlimit(RLIMIT_AS, &before);
  CHECK_FALSE(isGood);
  INFO(reading.Log->Errors);
  CHECK(reading.Log->HasError(folder / "a.tif" +
    ": not enough memory for its mesh; free some, or cut out a part with gdal_translate -srcwin"));
}
#endif
