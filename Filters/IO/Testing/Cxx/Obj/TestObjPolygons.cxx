// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Faces with more than three corners, and corners that name what is not there.
#include "heliosObjTestFiles.h"

#include <vtkDataArray.h>
#include <vtkTriangle.h>

#include <catch2/catch.hpp>

#include <algorithm>

using helios::ObjReading;
using helios::ObjSquare;
using helios::TestFolder;

namespace
{

double ComputeArea(ObjReading& reading)
{
  double area = 0.0;
  for (vtkIdType i = 0; i < reading.TriangleCount(); ++i)
  {
    double corners[3][3];
    const std::vector<vtkIdType> ids = reading.Corners(i);
    for (std::size_t k = 0; k < 3; ++k)
    {
      reading.Scene()->GetPoint(ids[k], corners[k]);
    }
    area += vtkTriangle::TriangleArea(corners[0], corners[1], corners[2]);
  }
  return area;
}

const std::string Plan = // an L, a square in it, and corners of other shapes
  "v 0 0 0\nv 4 0 0\nv 4 1 0\nv 1 1 0\nv 1 4 0\nv 0 4 0\n"
  "v 4 4 0\nv 2 2 0\nv 3 2 0\nv 3 3 0\nv 2 3 0\nv 2 0.5 0\n";

} // namespace

TEST_CASE("ObjPolygons: faces have their own area from any first corner", "[ObjPolygons]")
{
  const struct
  {
    std::vector<int> Face;
    double Area;
  } cases[] = {
    { { 1, 2, 3, 4, 5, 6 }, 7.0 },                // an L
    { { 1, 12, 2, 7, 6 }, 15.0 },                 // a dart in a side
    { { 1, 2, 7, 6, 1, 8, 11, 10, 9, 8 }, 15.0 }, // a hole, by a side that is used twice
    { { 1, 2, 7, 10, 9, 8, 11, 10, 7, 6 }, 15.0 },
    { { 8, 9, 10, 7, 6, 10, 11 }, 3.0 }, // two that share a corner
  };
  for (const auto& shape : cases)
  {
    for (std::size_t first = 0; first < shape.Face.size(); ++first)
    {
      std::string text = Plan + "f";
      for (std::size_t i = 0; i < shape.Face.size(); ++i)
      {
        text += ' ' + std::to_string(shape.Face[(first + i) % shape.Face.size()]);
      }
      TestFolder folder;
      ObjReading reading(folder.Write("a.obj", text + '\n'));
      INFO(text);
      REQUIRE(reading.Read());
      CHECK(ComputeArea(reading) == Approx(shape.Area).epsilon(1e-12));
      CHECK(reading.Log->Warnings.empty());
    }
  }
}

TEST_CASE("ObjPolygons: concave faces keep their material and orientation", "[ObjPolygons]")
{
  TestFolder folder;
  ObjReading reading(folder.Write(
    "a.obj", Plan + "usemtl a\nf 8 9 10\nusemtl b\nf 6 5 4 3 2 1\nusemtl a\nf 8 9 10 11\n"));
  REQUIRE(reading.Read());
  REQUIRE(reading.TriangleCount() == 7);
  for (vtkIdType i = 0; i < 7; ++i)
  {
    const std::vector<vtkIdType> c = reading.Corners(i);
    double normal[3];
    double p[3][3];
    for (std::size_t k = 0; k < 3; ++k)
    {
      reading.Scene()->GetPoint(c[k], p[k]);
    }
    vtkTriangle::ComputeNormal(p[0], p[1], p[2], normal);
    const bool isConcave = i > 0 && i < 5;
    CHECK(normal[2] == (isConcave ? -1.0 : 1.0));
    CHECK(reading.MaterialOf(i).Name == (isConcave ? "b" : "a"));
  }
}

TEST_CASE("ObjPolygons: vertices may follow concave faces", "[ObjPolygons]")
{
  TestFolder folder;
  ObjReading reading(folder.Write("a.obj", "usemtl a\nf 4 5 6 1 2 3\nusemtl b\nf 1 2 3\n" + Plan));
  REQUIRE(reading.Read());
  REQUIRE(reading.TriangleCount() == 5);
  CHECK(ComputeArea(reading) == Approx(7.0 + 2.0));
  CHECK(reading.MaterialOf(0).Name == "a");
  CHECK(reading.Corners(4) == std::vector<vtkIdType>{ 0, 1, 2 });
  CHECK(reading.MaterialOf(4).Name == "b");
}

TEST_CASE("ObjPolygons: corners of concave faces keep their texture coordinates", "[ObjPolygons]")
{
  TestFolder folder;
  ObjReading reading(folder.Write(
    "a.obj", Plan + "vt 0 0\nvt 4 0\nvt 4 1\nvt 1 1\nvt 1 4\nvt 0 4\nf 1/1 2/2 3/3 4/4 5/5 6/6\n"));
  reading.Reader->ReadColorsOn();
  REQUIRE(reading.Read());
  REQUIRE(reading.TriangleCount() == 4);
  vtkDataArray* textures =
    reading.Scene()->GetCellData()->GetArray(vtkHeliosArrayNames::TextureCoordinates);
  REQUIRE(textures);
  for (vtkIdType i = 0; i < 4; ++i)
  {
    const std::vector<vtkIdType> c = reading.Corners(i);
    for (int k = 0; k < 3; ++k)
    {
      const double* point = reading.Scene()->GetPoint(c[static_cast<std::size_t>(k)]);
      CHECK(textures->GetComponent(i, 2 * k) == point[0]);
      CHECK(textures->GetComponent(i, 2 * k + 1) == point[1]);
    }
  }
}

TEST_CASE("ObjPolygons: faces whose sides cross are counted", "[ObjPolygons]")
{
  TestFolder folder;
  const std::string path =
    folder.Write("a.obj", Plan + "f 1 2 7 6\nf 1 2 6 7\nf 1 7 2 6\nf 1 2 3 4 5 6\n");
  ObjReading reading(path);
  REQUIRE(reading.Read());
  CHECK(reading.Log->HasWarning(path +
    ":14: the sides of the polygon cross, so its triangles may be wrong (2 such polygons in this "
    "file); correct it"));
}

TEST_CASE("ObjPolygons: a face without area is counted", "[ObjPolygons]")
{
  TestFolder folder;
  const std::string path = folder.Write("a.obj", Plan + "v 3 0 0\nf 1 2 7 6\nf 1 2 13 1\n");
  ObjReading reading(path);
  REQUIRE(reading.Read());
  CHECK(reading.TriangleCount() == 2);
  CHECK(reading.Log->HasWarning(path + ": dropped 2 of 4 triangles, which have no area"));
}

TEST_CASE("ObjPolygons: what corners name and the file has not is one warning", "[ObjPolygons]")
{
  const struct
  {
    const char* Text;
    const char* Message;
  } cases[] = {
    { "f 1/1/1 2/2/2 3/3/3\nf 1/1/1 3/3/3 4/4/4\n",
      ":6: faces refer to texture coordinate 4 (the file has 0) and normal 4 (the file has 0): "
      "they "
      "are read without; correct these indices, or leave them out" },
    { "f 1//1 2//2 3//3\nf 1//4 3//2 4//1\n",
      ":6: faces refer to normal 4 (the file has 0): they" },
    { "vt 0 0\nf 1/1 2/1 3/2\nf 1 3 4\n",
      ":6: faces refer to texture coordinate 2 (the file has 1)" },
    { "f 1/0 2/0 3/0\nf 1/-7 3 4\n", ":5: faces refer to texture coordinate 0 (the file has 0)" },
    { "vn 0 0 1\nf 1//1 2//-2 3//1\nf 1//-1 3 4\n",
      ":6: faces refer to normal -2 (the file has 1)" },
    { "f 1 2 3/2147483647\nf 1 3 4\n",
      ":5: faces refer to texture coordinate 2147483647 (the file has 0)" },
  };
  for (const auto& each : cases)
  {
    for (const bool isColored : { false, true })
    {
      TestFolder folder;
      const std::string path = folder.Write("a.obj", ObjSquare + each.Text);
      ObjReading reading(path);
      reading.Reader->SetReadColors(isColored);
      INFO(each.Text);
      REQUIRE(reading.Read());
      INFO("said: " << reading.Log->Warnings);
      CHECK(reading.Log->HasWarning(path + each.Message));
      CHECK(reading.Log->Warnings.find("Warning", 1) == std::string::npos); // no second one
      CHECK(reading.TriangleCount() == 2);
      CHECK(ComputeArea(reading) == Approx(1.0));
    }
  }
}

TEST_CASE("ObjPolygons: an empty normal after slashes is none", "[ObjPolygons]")
{
  TestFolder folder;
  ObjReading reading(folder.Write("a.obj", ObjSquare + "f 1// 2// 3// 4//\n"));
  REQUIRE(reading.Read());
  CHECK(reading.Log->Warnings.empty());
  CHECK(ComputeArea(reading) == Approx(1.0));
}
