// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Polygon files as scenes.
#include "heliosPlyTesting.h"
#include "vtkHeliosMemoryLimit.h"

using helios::Vec3;
using helios::ply::MakeBinary;
using helios::ply::MakeHead;
using helios::ply::Reading;
using helios::ply::Square;

TEST_CASE("PLYSceneReader: text and both byte orders give the same scene", "[PLYSceneReader]")
{
  for (const std::string& bytes : { Square, MakeBinary(false), MakeBinary(true) })
  {
    Reading reading("a.ply", bytes);
    REQUIRE(reading.Read());
    INFO(reading.Log->Warnings);
    CHECK(reading.Log->Warnings.empty());
    CHECK(reading.Triangles() == 4);
    CHECK(reading.Points() == 5);
    CHECK(reading.Corner(1, 2) == Vec3(0, 1, 0));
    CHECK(reading.Corner(2, 2) == Vec3(447422.9990000001, 0.1, 1e-3)); // correctly rounded
    CHECK(reading.MaterialOf(3).Name == "default");
  }
}

TEST_CASE("PLYSceneReader: concave polygons are covered once", "[PLYSceneReader]")
{
  Reading reading("a.ply",
    "ply\r\nformat ascii 1.0\r\nelement vertex 8\r\nproperty float x\r\nproperty float y\r\n"
    "property int z\r\nelement face 1\r\nproperty list uchar uint vertex_index\r\nend_header\r\n"
    "0 0 0\r\n3 0 0\r\n3 3 0\r\n2 3 0\r\n2 1 0\r\n1 1 0\r\n1 3 0\r\n0 3 0\r\n8 0 1 2 3 4 5 6 7");
  REQUIRE(reading.Read());
  CHECK(reading.Triangles() == 6);
  CHECK(reading.Area() == Approx(7.0));
}

TEST_CASE("PLYSceneReader: the up axis", "[PLYSceneReader]")
{
  Reading reading("a.ply", Square);
  reading.Reader->SetUpAxisToY();
  REQUIRE(reading.Read());
  CHECK(reading.Corner(0, 2) == Vec3(1, 0, 1));
}

TEST_CASE("PLYSceneReader: warnings", "[PLYSceneReader]")
{
  Reading crossed("a.ply",
    MakeHead("ascii", 4, 1) + "0 0 0 0\n3 2 0 0\n3 0 0 0\n0 1 0 0\n0 4 0 1 2 3\n0\n1 2 3\n4 5 6\n");
  CHECK(crossed.Read());
  CHECK(crossed.Log->HasWarning(crossed.Path +
    ":20: the sides of the polygon cross, so its triangles may be wrong (1 such polygons "
    "in this file); correct it"));
  CHECK(crossed.Log->HasWarning(
    crossed.Path + ": 2 lines after the last element are not read; correct the counts"));
  Reading more("a.ply", MakeBinary(false) + "abc");
  CHECK(more.Read());
  CHECK(more.Log->HasWarning(more.Path + ": 3 bytes after the last element are not read"));
}

TEST_CASE("PLYSceneReader: memory is checked before it is needed", "[PLYSceneReader]")
{
  Reading reading("a.ply", MakeBinary(false));
  vtkHeliosMemoryLimit::SetLimit(0.0001);
  CHECK_FALSE(reading.Read());
  vtkHeliosMemoryLimit::SetLimit(0.0);
  CHECK(reading.Log->HasError(reading.Path + ": 3 faces need about 0.000309 MB of memory"));
}

TEST_CASE("PLYSceneReader: reading can be aborted", "[PLYSceneReader]")
{
  std::string text = MakeHead("ascii", 70000, 0);
  for (int i = 0; i < 70000; ++i)
  {
    text += "0 0 0 0\n";
  }
  Reading reading("a.ply", text + "0\n");
  reading.Reader->AddObserver(
    vtkCommand::ProgressEvent, reading.Reader.Get(), &vtkHeliosPLYSceneReader::AbortExecuteOn);
  CHECK_FALSE(reading.Read());
  CHECK(reading.Log->HasError(reading.Path + ":65551: reading was aborted here; update again"));
}
