// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Text of points as other programs write it: separators, names of columns, PTS and PTX.
#include "heliosPointTextTesting.h"
#include "heliosXyzTesting.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>

namespace names = vtkHeliosArrayNames;
using helios::PointTextReading;
using helios::XyzReading;

namespace
{

/// The header of a scan of PTX with 2 x 2 points, turned by 90 degrees about z and moved.
std::string MakeScan(const std::string& rows, const std::string& move = "1000 2000 30 1")
{
  return "2\n2\n1000 2000 30\n0 1 0\n-1 0 0\n0 0 1\n0 1 0 0\n-1 0 0 0\n0 0 1 0\n" + move + "\n" +
    rows;
}

const std::string Rows = "1 2 3 0.25 255 0 51\n0 0 0 0.5 0 0 0\n4 5 6 1 0 0 0\n7 8 9 0 1 2 3\n";

double GetColor(PointTextReading& reading, vtkIdType point, int component)
{
  return reading.Get(names::RGB)->GetComponent(point, component);
}

bool IsAt(vtkPolyData* cloud, vtkIdType point, double x, double y, double z)
{
  const double* p = cloud->GetPoint(point);
  return p[0] == x && p[1] == y && p[2] == z;
}

} // namespace

TEST_CASE("PointColumns: separators and line ends give the same points", "[PointColumns]")
{
  PointTextReading reading;
  XyzReading scene;
  for (const std::string text : { "x,y,z\n1.5,2,3\n4,5,6\n", "X;Y;Z\n1,5;2;3\n4;5;6\n",
         "x\ty\tz\n1.5\t2\t3\n4\t5\t6\n", "//X Y Z\n1.5 2 3\n4 5 6\n",
         "# x, y, z\n1.5, 2, 3\n4,5,6", "\"X\",\"Y\",\"Z\"\n\"1.5\",\"2\",\"3\"\n4,5,6\n",
         "x|y|z\r\n1.5|2|3\r\n4|5|6\r\n", "1.5 2 3\r4 5 6\r", "\xEF\xBB\xBFx,y,z\r1.5,2,3\r4,5,6",
         "1.5;2;3\n\n4;5;6\n", "2\n1.5 2 3\n4 5 6\n", "z,id,x,y\n3,7,1.5,2\n6,8,4,5\n",
         "X [m],Y [m],Z (m)\n1.5,2,3\n4,5,6\n", "Points:0,Points:1,Points:2\n1.5,2,3\n4,5,6\n",
         "% x y z\n1.5 2 3\n4 5 6\n", "1.5,2,3,\n4,5,6,\n" })
  {
    INFO(text);
    reading.Set(text);
    REQUIRE(reading.Read());
    REQUIRE(reading.CountPoints() == 2);
    CHECK(IsAt(reading.Cloud(), 0, 1.5, 2, 3));
    CHECK(IsAt(reading.Cloud(), 1, 4, 5, 6));
    scene.Set(text); // the loader of scenes reads it like this
    REQUIRE(scene.Read());
    REQUIRE(scene.CountPoints() == 2);
    CHECK(IsAt(scene.Cloud(), 0, 1.5, 2, 3));
    CHECK(IsAt(scene.Cloud(), 1, 4, 5, 6));
  }
}

TEST_CASE("PointColumns: names become arrays", "[PointColumns]")
{
  // CSV by PDAL
  PointTextReading reading(
    "\"X\",\"Y\",\"Z\",\"Intensity\",\"ReturnNumber\",\"NumberOfReturns\","
    "\"Classification\",\"ScanAngleRank\",\"PointSourceId\",\"GpsTime\","
    "\"Red\",\"Green\",\"Blue\",\"Own\"\n"
    "1.000,2.000,3.000,65535,1,2,6,-12.5,7,245380.78254962614,256,0,65535,x\n");
  REQUIRE(reading.Read());
  CHECK(reading.Kind() == "named columns");
  CHECK(reading.Get(names::Intensity, 0) == 65535);
  CHECK(reading.Get(names::ReturnNumber, 0) == 1);
  CHECK(reading.Get(names::NumberOfReturns)->GetDataType() == VTK_UNSIGNED_CHAR);
  CHECK(reading.Get(names::ClassificationIds, 0) == 6);
  CHECK(reading.Get(names::ScanAngle, 0) == -12.5);
  CHECK(reading.Get(names::LegIds, 0) == 6); // point sources of LAS begin at 1
  CHECK(reading.Get(names::GpsTime, 0) == 245380.78254962614);
  CHECK(GetColor(reading, 0, 0) == Approx(256.0 / 65535.0)); // 16 bits
  CHECK(GetColor(reading, 0, 2) == 1.0);
  CHECK(reading.Log->HasWarning("a.xyz: columns with unknown names are not read: \"Own\""));
  CHECK(reading.Reader->GetIntensityRange()[1] == 65535);
  CHECK(reading.Reader->GetHasWholeIntensities());

  // text by CloudCompare
  reading.Set("//X Y Z R G B scalar_Intensity Nx Ny Nz\n1 2 3 255 0 51 0.5 0 0.6 0.8\n");
  REQUIRE(reading.Read());
  CHECK(GetColor(reading, 0, 2) == Approx(0.2));
  CHECK(reading.Get(names::Intensity, 0) == 0.5);
  CHECK_FALSE(reading.Reader->GetHasWholeIntensities());
  CHECK(reading.Cloud()->GetPointData()->GetNormals()->GetComponent(0, 2) == 0.8);
  reading.Set("X,Y,Z,Rf,Gf,Bf\n1,2,3,1,0,0.5\n");
  REQUIRE(reading.Read());
  CHECK(GetColor(reading, 0, 0) == 1.0);

  // Dark rows before a bright one, and an array without all of its columns.
  std::string dark = "x y z r g b nx ny\n";
  for (int i = 0; i < 3000; ++i)
  {
    dark += "1 2 3 200 0 0 0 1\n";
  }
  reading.Set(dark + "1 2 3 65535 0 0 0 1\n");
  REQUIRE(reading.Read());
  CHECK(GetColor(reading, 0, 0) == Approx(200.0 / 65535.0));
  CHECK(reading.Log->HasWarning("are not read: \"nx\", \"ny\""));
  CHECK(vtkHeliosPointTextReader::GetArrayOfColumn("scalar_Classification") ==
    std::string(names::ClassificationIds));
  CHECK(vtkHeliosPointTextReader::GetArrayOfColumn("other") == nullptr);
  CHECK(vtkHeliosPointTextReader::GetComponentOfColumn("ny") == 1);
  CHECK(vtkHeliosPointTextReader::GetCommonName(names::ClassificationIds) ==
    std::string("Classification"));
}

TEST_CASE("PointColumns: the loader of scenes finds normals and colours by name", "[PointColumns]")
{
  XyzReading scene("x,y,z,intensity,nx,ny,nz,red,green,blue\n1,2,3,9,0,0.6,0.8,255,0,0\n");
  scene.Reader->ReadNormalsOn();
  scene.Reader->ReadColorsOn();
  REQUIRE(scene.Read());
  CHECK(scene.GetTriple(names::Normals, 0) == std::array<double, 3>{ 0.0, 0.6, 0.8 });
  CHECK(scene.GetTriple(names::RGB, 0) == std::array<double, 3>{ 1.0, 0.0, 0.0 });
}

TEST_CASE("PointColumns: PTS begins with the number of its points", "[PointColumns]")
{
  PointTextReading reading;
  reading.Set("2\n1 2 3 -2048 255 0 51\n4 5 6 2047 0 0 0\n1\n7 8 9 0 1 1 1\n", "a.pts");
  REQUIRE(reading.Read());
  CHECK(reading.Kind() == "PTS");
  REQUIRE(reading.CountPoints() == 3); // rows of two scans
  CHECK(reading.Reader->GetNumberOfCounted() == 3);
  CHECK(reading.Get(names::Intensity, 0) == -2048);
  CHECK(reading.Reader->GetIntensityRange()[0] == -2048);
  CHECK(GetColor(reading, 0, 2) == Approx(0.2));
  reading.Set("1 2 3 120\n4 5 6 130\n", "a.pts");
  REQUIRE(reading.Read());
  CHECK(reading.Get(names::Intensity, 1) == 130);
  reading.Set("3\n1 2 3 0 0 255\n", "a.pts");
  REQUIRE(reading.Read());
  CHECK(GetColor(reading, 0, 2) == 1.0);
}

TEST_CASE("PointColumns: scans of PTX are placed by their matrix", "[PointColumns]")
{
  const std::string text = MakeScan(Rows) +
    MakeScan("1 0 0 1 0 0 0\n0 0 0 0.5 0 0 0\n"
             "0 0 0 0.5 0 0 0\n0 0 0 0.5 0 0 0\n",
      "-5 0 0 1");
  PointTextReading reading;
  reading.Set(text, "a.ptx");
  REQUIRE(reading.Read());
  CHECK(reading.Kind() == "PTX");
  CHECK(reading.Log->Warnings.empty());
  REQUIRE(reading.CountPoints() == 4);
  CHECK(IsAt(reading.Cloud(), 0, 998, 2001, 33));
  CHECK(IsAt(reading.Cloud(), 3, -5, 1, 0));
  CHECK(reading.Reader->GetNumberOfDropped() == 4);
  CHECK(reading.Reader->GetNumberOfScans() == 2);
  double matrix[16];
  REQUIRE(reading.Reader->GetScanMatrix(0, matrix));
  CHECK((matrix[1] == -1 && matrix[4] == 1 && matrix[3] == 1000 && matrix[11] == 30));
  CHECK_FALSE(reading.Reader->GetScanMatrix(2, matrix));
  CHECK(reading.Get(names::Intensity, 0) == 0.25);
  CHECK(GetColor(reading, 0, 2) == Approx(0.2));

  // In parts of one scan each.
  PointTextReading parts(text);
  parts.Reader->SetMaximumNumberOfPoints(2);
  std::string sizes;
  do
  {
    parts.Reader->SetBegin(parts.Reader->GetEnd());
    REQUIRE(parts.Read());
    sizes +=
      std::to_string(parts.CountPoints()) + " of " + std::to_string(parts.Reader->GetScan()) + "; ";
  } while (parts.Reader->GetEnd() < parts.Reader->GetFileSize() && sizes.size() < 100);
  CHECK(sizes == "2 of 0; 1 of 0; 1 of 1; ");

  XyzReading scene(text); // in pieces
  vtkIdType count = 0;
  double sum = 0.0;
  for (int piece = 0; piece < 7; ++piece)
  {
    REQUIRE(scene.Read(piece, 7));
    count += scene.CountPoints();
    for (vtkIdType i = 0; i < scene.CountPoints(); ++i)
    {
      sum += scene.GetPoint(i)[0];
    }
  }
  CHECK(count == 4);
  CHECK(sum == 998 + 995 + 992 - 5);
}

TEST_CASE("PointColumns: errors name the line, the value and the remedy", "[PointColumns]")
{
  PointTextReading reading;
  CHECK(reading.FailsWith("1,5 2,5 3,5\n",
    "a.xyz:1: \"1,5\" has a decimal comma, which separates "
    "columns, too; write a point, or separate columns by"));
  CHECK(reading.FailsWith("x,y,z\n1,2,3\n1,b,3\n", "a.xyz:3: \"b\" in column 2 is not a number"));
  CHECK(reading.FailsWith("x,y,z\n1,2,3\n1,2\n",
    "a.xyz:3: the row has 2 columns, but columns are "
    "read up to 3 from 1 (x y z in 1 2 3)"));
  CHECK(reading.FailsWith("x,y,z,intensity\n1,2,3,4\n1,2,3\n", "(x y z in 1 2 3, Intensity in 4)"));
  CHECK(reading.FailsWith("x,y,z\n1,nan,3\n", "a.xyz:2: \"nan\" in column 2 is not finite"));
  CHECK(reading.FailsWith("x;y;z\n1.234,5;2;3\n", "a.xyz:2: \"1.234.5\" in column 1"));
  CHECK(reading.FailsWith("x,y,z,class\n1,2,3,1.5\n",
    "a.xyz:2: 1.5 in column 4 (ClassificationIds) is not a whole number from -2147483648 to "
    "2147483647; correct or remove the row"));
  CHECK(
    reading.FailsWith("x,y,z,ReturnNumber\n1,2,3,256\n", "is not a whole number from 0 to 255"));
  CHECK(reading.FailsWith("x,y,z,r,g,b\n1,2,3,0,-1,0\n",
    "a.xyz:2: the colour in column 5 is not within 0 and 255; correct or remove the row"));
  CHECK(reading.FailsWith("x,y,z,r,g,b\n1,2,3,0,65536,0\n", "is not within 0 and 65535"));
  CHECK(reading.FailsWith(std::string("\xFF\xFE"
                                      "1\0 \0",
                            6),
    "a.xyz: is text of UTF-16 or UTF-32; save it as UTF-8"));
  CHECK(reading.FailsWith(std::string("\0"
                                      "1\0 \0"
                                      "2",
                            6),
    "is text of UTF-16"));
  CHECK(reading.FailsWith("ncols 100\nnrows 100\n",
    "a.xyz:1: begins a raster (ESRI ASCII grid), "
    "not points; convert it: gdal_translate"));
  CHECK(reading.FailsWith("x,y,z\n", "a.xyz: has no points; give a file with points"));
  CHECK(reading.FailsWith(MakeScan(Rows + "2\n2\n0 0 0\nx\n"),
    "a.xyz:18: line 4 of the header of scan 2 has not 3 numbers; PTX has columns, rows, four "
    "lines"));
  CHECK(reading.FailsWith("1e20\n2\n0 0 0\n", "columns; give x y z"));
  CHECK(reading.FailsWith(MakeScan(Rows).replace(0, 1, std::string(18, '9')),
    "a.xyz:10: the header of scan 1 gives no valid numbers of columns and rows; correct them"));

  reading.Set(MakeScan("1 2 3 0.5\n")); // cut off
  REQUIRE(reading.Read());
  CHECK(reading.CountPoints() == 1);
  CHECK(
    reading.Log->HasWarning("a.xyz: scan 1 has 1 of its 4 points; it is cut off: copy it again"));
  reading.Set("a b c d\n1 2 3 4\n");
  REQUIRE(reading.Read());
  CHECK(reading.CountPoints() == 1);
  CHECK(reading.Log->HasWarning("a.xyz:1: \"a b c d\" has no numbers, and no names x, y and z of 4 "
                                "columns; it is left out as a header, and the first three"));
}

TEST_CASE("PointColumns: numbers that are not finite are kept on request", "[PointColumns]")
{
  PointTextReading reading("x,y,z,intensity\n1,2,3,nan\n4,nan,6,7\n");
  reading.Reader->KeepInvalidOn();
  REQUIRE(reading.Read());
  REQUIRE(reading.CountPoints() == 2);
  CHECK(std::isnan(reading.Get(names::Intensity, 0)));
  CHECK(std::isnan(reading.Cloud()->GetPoint(1)[1]));
}
