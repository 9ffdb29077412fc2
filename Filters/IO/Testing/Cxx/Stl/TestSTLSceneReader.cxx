// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Stereolithography files as scenes, and the errors of bad ones.
#include "heliosStlTesting.h"
#include "vtkHeliosMemoryLimit.h"

#include <limits>

using helios::BadFile;
using helios::Vec3;
using helios::stl::MakeBinary;
using helios::stl::Reading;
using helios::stl::Square;

namespace
{

const std::vector<float> BinarySquare = { 0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 0, 0, 1, 1, 0, 0, 1, 0 };

} // namespace

TEST_CASE("STLSceneReader: text and binary files give the same scene", "[STLSceneReader]")
{
  // Binary files may begin with "solid", too.
  for (const std::string& bytes :
    { Square, MakeBinary(BinarySquare), MakeBinary(BinarySquare, "x") })
  {
    Reading reading("a.stl", bytes);
    REQUIRE(reading.Read());
    CHECK(reading.Triangles() == 2);
    CHECK(reading.Points() == 4); // shared, and -0 is 0
    CHECK(reading.Area() == Approx(1.0));
    CHECK(reading.Corner(1, 2) == Vec3(0, 1, 0));
    CHECK(reading.MaterialOf(1).Name == "default");
    CHECK(reading.Scene()->GetPoints()->GetDataType() == VTK_DOUBLE);
    CHECK(reading.Log->Warnings.empty());
  }
}

TEST_CASE("STLSceneReader: numbers of text are correctly rounded doubles", "[STLSceneReader]")
{
  Reading reading("a.stl",
    "SOLID\r\nFacet Normal nan nan nan\r\nouter loop\r\nvertex 447422.9990000001 0.1 1e-3\r\n"
    "vertex 447424 0 0\r\nvertex 447423 5 0\r\nendloop\r\nendfacet\r\nendsolid\r\n");
  REQUIRE(reading.Read());
  CHECK(reading.Corner(0, 0) == Vec3(447422.9990000001, 0.1, 1e-3));
}

TEST_CASE("STLSceneReader: the up axis and flat triangles", "[STLSceneReader]")
{
  Reading reading("a.stl", MakeBinary({ 1, 2, 3, 4, 5, 6, 0, 1, 0, 0, 0, 0, 1, 1, 1, 2, 2, 2 }));
  reading.Reader->SetUpAxisToY();
  REQUIRE(reading.Read());
  CHECK(reading.Corner(0, 0) == Vec3(1, -3, 2));
  CHECK(reading.Triangles() == 1);
  CHECK(reading.Reader->GetNumberOfDroppedTriangles() == 1);
  CHECK(reading.Log->HasWarning(reading.Path + ": dropped 1 of 2 triangles, which have no area"));
}

TEST_CASE("STLSceneReader: errors of text", "[STLSceneReader]")
{
  const std::string loop = "solid a\nfacet normal 0 0 1\nouter loop\n";
  helios::CheckErrors<vtkHeliosSTLSceneReader>("a.stl",
    { { loop + "vertex 0 0 1,5\n",
        ":4: \"1,5\" is not a number; vertex needs three numbers: vertex x y z" },
      { loop + "vertex 0 0\n", ":4: too few numbers; vertex needs three numbers" },
      { loop + "vertex 0 0 0 0\n", ":4: \"0\" comes after vertex x y z; remove it" },
      { loop + "vertex 0 0 nan\n", ":4: vertex coordinate z is NaN; correct the vertex" },
      { loop + "vertex inf 0 0\n", ":4: vertex coordinate x is infinite" },
      { loop + "vertex 0 0 0\nvertex 1 0 0\nendloop\n",
        ":6: the loop has 2 vertices; a facet of STL has three" },
      { loop + "vertex 0 0 0\nvertex 1 0 0\nvertex 1 1 0\nvertex 0 1 0\n",
        ":7: the loop has a fourth vertex" },
      { loop + "corner 0 0 0\n", ":4: \"corner\" is no keyword of STL; expected one of solid" },
      { Square.substr(0, Square.rfind("endsolid")),
        ":15: the file ends before endsolid, so it is cut off; copy or write it again" } });
}

TEST_CASE("STLSceneReader: errors of binary files", "[STLSceneReader]")
{
  const std::string good = MakeBinary(BinarySquare, "x");
  std::vector<float> bad = BinarySquare;
  bad[13] = std::numeric_limits<float>::quiet_NaN();
  helios::CheckErrors<vtkHeliosSTLSceneReader>("a.stl",
    { { "", ": is not an STL file, or is cut off: it has 0 bytes, and a header alone needs 84" },
      { good.substr(0, 183),
        ": is not an STL file, or is cut off: it has 183 bytes, and its header tells of 2 "
        "triangles, which need 184; copy or write the file again" },
      { MakeBinary(bad), ": triangle 2: vertex coordinate y is NaN; correct the vertex" } });
  Reading missing("a.stl", "");
  missing.Reader->SetFileName("none.stl");
  CHECK_FALSE(missing.Read());
  CHECK(missing.Log->HasError("none.stl: cannot be read: No such file or directory"));
  missing.Reader->SetFileName(nullptr);
  CHECK_FALSE(missing.Read());
  CHECK(missing.Log->HasError("FileName is not set; give the STL file with SetFileName"));
}

TEST_CASE("STLSceneReader: bytes after the last triangle are reported", "[STLSceneReader]")
{
  Reading reading("a.stl", MakeBinary(BinarySquare, "x") + "more");
  CHECK(reading.Read());
  CHECK(reading.Log->HasWarning(reading.Path + ": 4 bytes after the last triangle are not read"));
  Reading empty("a.stl", MakeBinary({}));
  CHECK(empty.Read());
  CHECK(empty.Log->HasWarning(empty.Path + ": no triangles, so the scene is empty; add faces"));
}

TEST_CASE("STLSceneReader: memory is checked before it is needed", "[STLSceneReader]")
{
  Reading reading("a.stl", MakeBinary(std::vector<float>(9 * 100)));
  vtkHeliosMemoryLimit::SetLimit(0.001);
  CHECK_FALSE(reading.Read());
  vtkHeliosMemoryLimit::SetLimit(0.0);
  CHECK(reading.Log->HasError(reading.Path + ": 100 triangles need about 0.0075 MB of memory"));
}

TEST_CASE("STLSceneReader: reading can be aborted", "[STLSceneReader]")
{
  Reading reading("a.stl", MakeBinary(std::vector<float>(9 * 25000)));
  reading.Reader->AddObserver(
    vtkCommand::ProgressEvent, reading.Reader.Get(), &vtkHeliosSTLSceneReader::AbortExecuteOn);
  CHECK_FALSE(reading.Read());
  CHECK(
    reading.Log->HasError(reading.Path + ": reading was aborted at triangle 20000; update again"));
}
