// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Colours and texture coordinates of the OBJ reader.
#include "heliosObjTestFiles.h"

#include "vtkHeliosObjSceneWriter.h"

#include <catch2/catch.hpp>

#include <vtkDataArray.h>
#include <vtkFieldData.h>

#include <array>
#include <cmath>
#include <string>
#include <vector>

using helios::MaterialColor;
using helios::ObjReading;
using helios::ObjSquare;
using helios::TestFolder;
namespace names = vtkHeliosArrayNames;

namespace
{

const std::string Materials = "newmtl brick\nKd 1 0.5 2\nmap_Kd images/red brick.png\n"
                              "newmtl plain\nKd 0.25\nnewmtl image\nmap_Kd a.png\n"
                              "newmtl none\nhelios_reflectance 0.2\n"
                              "newmtl scaled\nKd 0.5 0.5 0.5\nmap_Kd -s 2 2 1 a.png\n";

const std::string OnePixel = "P5 1 1 255\nx"; // the name does not give the kind of an image

std::vector<double> GetCoordinates(ObjReading& reading, vtkIdType cell)
{
  vtkDataArray* array = reading.Scene()->GetCellData()->GetArray(names::TextureCoordinates);
  std::vector<double> values(6, -1.0);
  if (array && array->GetNumberOfComponents() == 6)
  {
    array->GetTuple(cell, values.data());
  }
  return values;
}

} // namespace

TEST_CASE("ObjColors: Kd and map_Kd are the colour of a material, if asked", "[ObjColors]")
{
  TestFolder folder;
  folder.Write("a.mtl", Materials);
  folder.Write("a.png", OnePixel);
  folder.Write("images/red brick.png", OnePixel);
  ObjReading reading(
    folder.Write("a.obj", "mtllib a.mtl\n" + ObjSquare + "usemtl brick\nf 1 2 3\n"));
  REQUIRE(reading.Read());
  CHECK(reading.Log->Warnings.empty());
  CHECK_FALSE(reading.Scene()->GetFieldData()->HasArray(names::MaterialColor));
  CHECK_FALSE(reading.Scene()->GetFieldData()->HasArray(names::MaterialTexture));

  reading.Reader->ReadColorsOn();
  REQUIRE(reading.Read());
  const helios::MaterialTable table = helios::GetMaterials(reading.Scene());
  REQUIRE(table.size() == 5);
  CHECK(
    table[0].Color == MaterialColor{ { 1.0, 0.5, 1.0 }, folder.GetPath("images/red brick.png") });
  CHECK(table[1].Color == MaterialColor{ { 0.25, 0.25, 0.25 }, "" });
  CHECK(table[2].Color == MaterialColor{ { 1.0, 1.0, 1.0 }, folder.GetPath("a.png") });
  CHECK_FALSE(table[3].Color.IsSet());
  CHECK(table[4].Color == MaterialColor{ { 0.5, 0.5, 0.5 }, "" });
  CHECK(reading.Log->HasWarning(folder.GetPath("a.mtl") +
    ":12: map_Kd of material \"scaled\" has options, which are not read: \"-s 2 2 1 a.png\", so "
    "its "
    "colour is Kd; give the name of an image alone"));
}

TEST_CASE(
  "ObjColors: a texture that is no image is an error with the line of map_Kd", "[ObjColors]")
{
  TestFolder folder;
  folder.Write("a.mtl", "newmtl brick\nKd 1 1 1\n\nmap_Kd brick.png\n");
  const std::string place = folder.GetPath("a.mtl") + ":4: map_Kd of material \"brick\": texture " +
    folder.GetPath("brick.png");
  ObjReading reading(
    folder.Write("a.obj", "mtllib a.mtl\n" + ObjSquare + "usemtl brick\nf 1 2 3\n"));
  REQUIRE(reading.Read()); // without colours the image is not opened
  reading.Reader->ReadColorsOn();
  CHECK_FALSE(reading.Read());
  CHECK(reading.Log->HasError(place + " does not exist; give it, or remove map_Kd"));
  folder.Write("brick.png", "P5 7 7 255\nx");
  ObjReading damaged(folder.GetPath("a.obj"));
  damaged.Reader->ReadColorsOn();
  CHECK_FALSE(damaged.Read());
  CHECK(damaged.Log->HasError(place +
    ": PNM image is damaged: 7 x 7 pixels do not fit into a file of 12 bytes; get it again, or "
    "save "
    "it with another program, or remove map_Kd"));
}

TEST_CASE(
  "ObjColors: texture coordinates are those of the corners of every triangle", "[ObjColors]")
{
  TestFolder folder;
  // A fan of two triangles, one with indices that count backwards, one without coordinates, one
  // whose vt follows, and one without area.
  ObjReading reading(folder.Write("a.obj",
    ObjSquare +
      "vt 0 0\nvt 1 0 0\nvt 1 1\nvt 0.5\nf 1/1 2/2 3/3 4/4\nf 1/-4 2/-3 3/-2\nf 1 2 3\n"
      "f 1/1 1/1 2/2\nf 1/5 2/5 3/5\nvt 2.5 -3\n"));
  REQUIRE(reading.Read());
  CHECK_FALSE(reading.Scene()->GetCellData()->HasArray(names::TextureCoordinates));

  reading.Reader->ReadColorsOn();
  REQUIRE(reading.Read());
  REQUIRE(reading.TriangleCount() == 5);
  CHECK(GetCoordinates(reading, 0) == std::vector<double>{ 0, 0, 1, 0, 1, 1 });
  CHECK(GetCoordinates(reading, 1) == std::vector<double>{ 0, 0, 1, 1, 0.5, 0 });
  CHECK(GetCoordinates(reading, 2) == std::vector<double>{ 0, 0, 1, 0, 1, 1 });
  CHECK(std::isnan(GetCoordinates(reading, 3)[0]));
  CHECK(GetCoordinates(reading, 4) == std::vector<double>{ 2.5, -3, 2.5, -3, 2.5, -3 });
}

TEST_CASE("ObjColors: the writer keeps colours of materials without a lobe", "[ObjColors]")
{
  TestFolder folder;
  folder.Write("a.png", OnePixel);
  folder.Write(
    "a.mtl", "newmtl m\nKd 0.1 0.2 0.7\nmap_Kd a.png\nnewmtl n\nKd 0.5 0.25 0.25\nKs 0.5 0.5 0\n");
  ObjReading reading(folder.Write("a.obj", "mtllib a.mtl\n" + ObjSquare + "usemtl m\nf 1 2 3\n"));
  reading.Reader->ReadColorsOn();
  REQUIRE(reading.Read());
  vtkNew<vtkHeliosObjSceneWriter> writer;
  writer->SetInputData(reading.Scene());
  writer->SetFileName(folder.GetPath("b.obj").c_str());
  REQUIRE(writer->Write() == 1);
  ObjReading again(folder.GetPath("b.obj"));
  again.Reader->ReadColorsOn();
  REQUIRE(again.Read());
  const helios::MaterialTable table = helios::GetMaterials(again.Scene());
  REQUIRE(table.size() == 2);
  CHECK(table[0].Color == MaterialColor{ { 0.1, 0.2, 0.7 }, folder.GetPath("a.png") });
  CHECK(table[0].Specularity == 0.0);
  CHECK(table[1].Specularity == 0.5);
}

TEST_CASE("ObjColors: numbers of texture coordinates are checked", "[ObjColors]")
{
  TestFolder folder;
  const std::string wrong = GENERATE("vt", "vt x", "vt 1 y");
  ObjReading reading(folder.Write("a.obj", ObjSquare + wrong + "\nf 1 2 3\n"));
  reading.Reader->ReadColorsOn();
  CHECK_FALSE(reading.Read());
  CHECK(reading.Log->HasError("a.obj:5: "));
  CHECK(reading.Log->HasError("vt needs one to three numbers: vt u v w"));
}
