// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Material files of the OBJ reader.
#include "heliosObjTestFiles.h"

#include <catch2/catch.hpp>

#include <cmath>

using helios::Material;
using helios::ObjReading;
using helios::ObjSquare;
using helios::TestFolder;

namespace
{

void CheckError(const std::string& text, const std::string& message)
{
  TestFolder folder;
  const std::string path = folder.Write("a.mtl", text);
  ObjReading reading(folder.Write("a.obj", "mtllib a.mtl\n" + ObjSquare + "usemtl m\nf 1 2 3\n"));
  INFO(text << "\nexpected: " << message);
  CHECK_FALSE(reading.Read());
  INFO("said: " << reading.Log->Errors);
  CHECK(reading.Log->HasError(path + message));
  CHECK(reading.TriangleCount() == 0);
}

} // namespace

TEST_CASE("ObjMaterials: every key, for every material", "[ObjMaterials]")
{
  TestFolder folder;
  folder.Write("a.mtl",
    "# materials\r\nnewmtl grass field\r\nNs 96.078431\r\nKa 1 1 1\r\nKd 0.25 0.5 0.25\r\nKs 0.5 "
    "0.25 0.25\r\n"
    "Ke 0 0 0\r\nNi 1\r\nd 1\r\nillum 2\r\nmap_Kd a b.png\r\nhelios_spectra grass\r\n"
    "helios_reflectance 0.125 # a fraction\r\nhelios_isGround true\r\nhelios_classification 2\r\n"
    "helios_receiveShadows 1\r\n#helios_reflectance 50\r\n"
    "newmtl roof\nKs 0.7\nhelios_isGround 0\nnewmtl wall\nKd 1 1 1\nhelios_isGround "
    "1\nhelios_isGround false\n");
  ObjReading reading(folder.Write("a.obj",
    "mtllib a.mtl\n" + ObjSquare +
      "f 1 2 3\nusemtl grass of another kind\nf 1 2 3\nusemtl wall\nf 1 2 4\nusemtl roof\nf 1 3 "
      "4\n"));
  REQUIRE(reading.Read());
  CHECK(reading.Log->Warnings.empty());

  const helios::MaterialTable table = helios::GetMaterials(reading.Scene());
  REQUIRE(table.size() == 4);
  Material grass;
  grass.Name = "grass field";
  grass.Reflectance = 0.125;
  grass.Specularity = 0.5;
  grass.SpecularExponent = 96.078431;
  grass.Classification = 2;
  grass.IsGround = true;
  grass.Spectrum = "grass";
  CHECK(table[0] == grass);
  CHECK(table[1].Name == "roof");
  CHECK(table[1].Specularity == 1.0);
  CHECK(table[2].Specularity == 0.0);
  CHECK(std::isnan(table[2].Reflectance));
  CHECK_FALSE(table[2].IsGround);
  CHECK(table[3] == Material());

  CHECK(reading.MaterialOf(0).Name == "default");
  CHECK(reading.MaterialOf(1).Name == "grass field");
  CHECK(reading.MaterialOf(2).Name == "wall");
  CHECK(reading.MaterialOf(3).Name == "roof");
}

TEST_CASE("ObjMaterials: specularity is sum Ks / (sum Kd + sum Ks)", "[ObjMaterials]")
{
  TestFolder folder;
  folder.Write("a.mtl",
    "newmtl a\nKd 0.64 0.64 0.64\nKs 0.5 0.5 0.5\nnewmtl b\nKd 0.1 0.2 0.3\nKs 0.4 0.3 0.2\n");
  ObjReading reading(folder.Write("a.obj", "mtllib a.mtl\n" + ObjSquare + "usemtl a\nf 1 2 3\n"));
  REQUIRE(reading.Read());
  const auto table = helios::GetMaterials(reading.Scene());
  CHECK(table.at(0).Specularity == Approx(0.5 / 1.14).epsilon(1e-15));
  CHECK(table.at(1).Specularity == Approx(0.9 / 1.5).epsilon(1e-15));
}

TEST_CASE(
  "ObjMaterials: libraries with blanks in the name, several names, several lines", "[ObjMaterials]")
{
  TestFolder folder;
  folder.Write("sub/my first.mtl", "newmtl a\nhelios_reflectance 0.1\n");
  folder.Write("sub/b.mtl", "newmtl b\nhelios_reflectance 0.2\n");
  folder.Write("sub/deep/c.mtl", "newmtl c\nhelios_reflectance 0.3\n");
  const std::string absolute = folder.Write("d.mtl", "newmtl d\nhelios_reflectance 0.4\n");
  ObjReading reading(folder.Write("sub/a.obj",
    "mtllib my first.mtl  \r\nmtllib b.mtl deep/c.mtl\nmtllib " + absolute +
      "\nmtllib b.mtl deep/c.mtl\n" + ObjSquare +
      "usemtl a\nf 1 2 3\nusemtl b\nf 1 2 3\nusemtl c\nf 1 2 3\nusemtl d\nf 1 2 3\n"));
  REQUIRE(reading.Read());
  INFO(reading.Log->Warnings);
  CHECK(reading.Log->Warnings.empty());
  for (int i = 0; i < 4; ++i)
  {
    CHECK(reading.MaterialOf(i).Reflectance == Approx(0.1 * (i + 1)).epsilon(1e-15));
  }
}

TEST_CASE("ObjMaterials: a library may follow the use of its materials", "[ObjMaterials]")
{
  TestFolder folder;
  folder.Write("a.mtl", "newmtl a\nhelios_reflectance 0.1\n");
  ObjReading reading(folder.Write("a.obj", ObjSquare + "usemtl a\nf 1 2 3\nmtllib a.mtl\n"));
  REQUIRE(reading.Read());
  CHECK(reading.Log->Warnings.empty());
  CHECK(reading.MaterialOf(0).Reflectance == 0.1);
}

TEST_CASE("ObjMaterials: missing libraries and unknown materials are reported", "[ObjMaterials]")
{
  TestFolder folder;
  const std::string path = folder.Write("a.obj",
    "# head\nmtllib lost.mtl\n" + ObjSquare +
      "usemtl a\nf 1 2 3\nusemtl b\nf 1 2 3\nusemtl a\nf 1 2 3\n");
  ObjReading reading(path);
  REQUIRE(reading.Read());
  INFO(reading.Log->Warnings);
  CHECK(reading.Log->HasWarning(path + ":2: material library " + folder.GetPath("lost.mtl") +
    " does not exist; its materials get default properties"));
  CHECK(reading.Log->HasWarning(path +
    ":7: unknown material \"a\", default properties are used (2 such names in this file); define "
    "it in a mtllib"));
  CHECK(reading.TriangleCount() == 3);
  Material unknown;
  unknown.Name = "b";
  CHECK(reading.MaterialOf(1) == unknown);
  CHECK(reading.MaterialOf(2).Name == "a");

  folder.Write("there.mtl", "newmtl a\n");
  ObjReading half(folder.Write(
    "a.obj", "mtllib there.mtl gone.mtl\nmtllib\n" + ObjSquare + "usemtl a\nf 1 2 3\n"));
  REQUIRE(half.Read());
  CHECK(
    half.Log->HasWarning(":1: material library " + folder.GetPath("gone.mtl") + " does not exist"));
  CHECK(half.Log->HasWarning(":2: mtllib has no name; give that of a material file"));
  CHECK_FALSE(half.Log->HasWarning("there.mtl"));
}

TEST_CASE(
  "ObjMaterials: a reflectance above 1 is read as percent, with a warning", "[ObjMaterials]")
{
  TestFolder folder;
  const std::string path = folder.Write("a.mtl",
    "newmtl a\nhelios_reflectance 1\nnewmtl b\nhelios_reflectance 1.5\nnewmtl c\n"
    "helios_reflectance 100\nnewmtl d\nhelios_reflectance 0\n");
  ObjReading reading(folder.Write("a.obj", "mtllib a.mtl\n" + ObjSquare + "usemtl a\nf 1 2 3\n"));
  REQUIRE(reading.Read());
  const auto table = helios::GetMaterials(reading.Scene());
  CHECK(table.at(0).Reflectance == 1.0);
  CHECK(table.at(1).Reflectance == 0.015);
  CHECK(table.at(2).Reflectance == 1.0);
  CHECK(table.at(3).Reflectance == 0.0);
  INFO(reading.Log->Warnings);
  CHECK(reading.Log->HasWarning(path +
    ":4: helios_reflectance 1.5 is above 1 and read as percent; write it as the fraction 0.015 (2 "
    "such lines in this file)"));
}

TEST_CASE("ObjMaterials: names with blanks, of which the first word is sufficient if unique",
  "[ObjMaterials]")
{
  TestFolder folder;
  folder.Write("a.mtl",
    "newmtl oak leaf  # spring\nhelios_reflectance 0.25\nnewmtl oak bark\nhelios_reflectance 0.5\n"
    "newmtl elm tree\nhelios_reflectance 0.75\nnewmtl #7 b\nhelios_reflectance 0.125\n");
  const std::string path = folder.Write("a.obj",
    "mtllib a.mtl\n" + ObjSquare +
      "usemtl oak leaf\nf 1 2 3\nusemtl  oak bark \r\nf 1 2 3\nusemtl elm\nf 1 2 3\n"
      "usemtl elm wood # trunk\nf 1 2 3\nusemtl #7 b\nf 1 2 3\nusemtl oak\nf 1 2 3\n");
  ObjReading reading(path);
  REQUIRE(reading.Read());
  CHECK(reading.MaterialOf(0).Reflectance == 0.25);
  CHECK(reading.MaterialOf(1).Reflectance == 0.5);
  CHECK(reading.MaterialOf(2).Name == "elm tree");
  CHECK(reading.MaterialOf(3).Name == "elm tree");
  CHECK(reading.MaterialOf(4).Reflectance == 0.125);
  CHECK(std::isnan(reading.MaterialOf(5).Reflectance)); // leaf or bark: ambiguous
  INFO(reading.Log->Warnings);
  CHECK(
    reading.Log->HasWarning(path + ":16: unknown material \"oak\", default properties are used"));
}

TEST_CASE("ObjMaterials: errors name the file, the line and the remedy", "[ObjMaterials]")
{
  CheckError("newmtl m\nhelios_reflectance 101\n",
    ":2: helios_reflectance 101 is outside [0, 1]; it is a fraction, so 50 percent is 0.5");
  CheckError(
    "newmtl m\nhelios_reflectance -0.1\n", ":2: helios_reflectance -0.1 is outside [0, 1]");
  CheckError("newmtl m\nhelios_reflectance 0,5\n",
    ":2: helios_reflectance \"0,5\" is not a number; it is a fraction from 0 to 1");
  CheckError(
    "newmtl m\nhelios_reflectance nan\n", ":2: helios_reflectance \"nan\" is not a number");
  CheckError("newmtl m\nhelios_reflectance\n", ":2: helios_reflectance \"\" is not a number");
  CheckError("newmtl m\nhelios_classification ground\n",
    ":2: helios_classification \"ground\" is not a whole number; give a class such as 2");
  CheckError("newmtl m\nhelios_classification 2.5\n",
    ":2: helios_classification \"2.5\" is not a whole number");
  CheckError("newmtl m\nhelios_isGround yes\n",
    ":2: helios_isGround \"yes\" is neither true nor false; give one");
  CheckError("newmtl m\nhelios_spectra\n",
    ":2: helios_spectra has no name; give that of a spectrum, such as grass");
  CheckError("newmtl m\nNs shiny\n",
    ":2: Ns \"shiny\" is not a finite number >= 0; it is the specular exponent");
  CheckError("newmtl m\nNs -1\n", ":2: Ns \"-1\" is not a finite number >= 0");
  CheckError("newmtl m\nNs inf\n", ":2: Ns \"inf\" is not a finite number >= 0");
  const std::string cure = "; expected three finite numbers >= 0: red green blue";
  CheckError("newmtl m\nKd 1 1 x\n", ":2: Kd of material \"m\" is malformed at \"x\"" + cure);
  CheckError("newmtl m\nKs 1 1\n", ":2: Ks of material \"m\" is malformed" + cure);
  CheckError("newmtl m\nKa -1 1 1\n", ":2: Ka of material \"m\" is malformed at \"-1\"" + cure);
  CheckError("newmtl m\nKs 1e308 1e308 1e308\n",
    ":2: Ks of material \"m\" is malformed at \"1e308\"" + cure);
  CheckError("newmtl m\nKd 1 1 1 1\n", ":2: Kd of material \"m\" is malformed at \"1\"" + cure);
  CheckError("# head\nNs 5\nnewmtl m\n",
    ":2: \"Ns\" comes before any material; begin one with newmtl NAME above it");
  CheckError("newmtl\n", ":1: newmtl has no name; give the material one");
}

TEST_CASE("ObjMaterials: unknown keys and repeated definitions are reported", "[ObjMaterials]")
{
  TestFolder folder;
  const std::string first =
    folder.Write("a.mtl", "newmtl m\nhelios_reflectence 0.5\nwhat 1\nnewmtl same\nNs 3\n");
  const std::string second =
    folder.Write("b.mtl", "newmtl same\nNs 3\n\nnewmtl m\nhelios_reflectance 0.75\n");
  ObjReading reading(
    folder.Write("a.obj", "mtllib a.mtl\nmtllib b.mtl\n" + ObjSquare + "usemtl m\nf 1 2 3\n"));
  REQUIRE(reading.Read());
  INFO(reading.Log->Warnings);
  CHECK(reading.Log->HasWarning(
    first + ":2: unknown keyword \"helios_reflectence\", ignored (2 such lines in this file)"));
  CHECK(reading.Log->HasWarning(
    second + ":4: material \"m\" was defined differently before; this definition is used"));
  CHECK_FALSE(reading.Log->HasWarning("\"same\""));
  CHECK(reading.MaterialOf(0).Reflectance == 0.75);
  CHECK(helios::GetMaterials(reading.Scene()).size() == 2);
}
