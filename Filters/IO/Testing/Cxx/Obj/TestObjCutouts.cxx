// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Images that cut leaves out of triangles, and warnings of those that cannot.
#include "heliosImage.h"
#include "heliosMaskMaking.h"
#include "heliosObjTestFiles.h"
#include "vtkHeliosMemoryLimit.h"

#include <vtkFieldData.h>
#include <vtkImageData.h>
#include <vtkImageWriter.h>
#include <vtkPNGWriter.h>
#include <vtkTIFFWriter.h>
#include <vtkTriangle.h>

#include <catch2/catch.hpp>

#include <array>
#include <string>

using helios::ImageHeader;
using helios::ObjReading;
using helios::ObjSquare;
using helios::ReadImageHeader;
using helios::TestFolder;

namespace
{

/// Writes an image: grey, grey with alpha, colours, or colours with alpha.
template <typename WriterT>
std::string WriteImage(const std::string& path, int components)
{
  vtkNew<vtkImageData> image;
  image->SetDimensions(4, 4, 1);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, components);
  vtkNew<WriterT> writer;
  writer->SetInputData(image);
  writer->SetFileName(path.c_str());
  writer->Write();
  return path;
}

bool HasAlpha(const std::string& path)
{
  ImageHeader header;
  REQUIRE(ReadImageHeader({ path }, header).IsOk());
  return header.HasAlpha;
}

const std::string Faces =
  "vt 0 0\nvt 1 0\nvt 1 1\nusemtl leaf\nf 1/1 2/2 3/3\nusemtl bark\nf 1 3 4\n";

helios::MaskImage MakeDisc()
{
  return helios::MakeDisc(64, 16.0);
}

double ComputeArea(vtkPolyData* scene)
{
  double area = 0.0;
  for (vtkIdType i = 0; i < scene->GetNumberOfCells(); ++i)
  {
    vtkNew<vtkIdList> ids;
    scene->GetCellPoints(i, ids);
    double p[3][3];
    for (int k = 0; k < 3; ++k)
    {
      scene->GetPoint(ids->GetId(k), p[k]);
    }
    double normal[3];
    vtkTriangle::ComputeNormalDirection(p[0], p[1], p[2], normal);
    CHECK(normal[2] > 0.0); // like the triangles of the file
    area += vtkTriangle::TriangleArea(p[0], p[1], p[2]);
  }
  return area;
}

/// Reads a scene of a leaf and bark, with colours and without; returns the area that is left.
double ReadArea(TestFolder& folder, const std::string& materials, const std::string& warning = "",
  const std::string& faces = Faces)
{
  const std::string path = folder.Write("a.mtl", materials);
  double area = 0.0;
  for (const bool isColored : { false, true })
  {
    ObjReading reading(folder.Write("a.obj", "mtllib a.mtl\n" + ObjSquare + faces));
    reading.Reader->SetReadColors(isColored);
    INFO(materials);
    REQUIRE(reading.Read());
    INFO("said: " << reading.Log->Warnings);
    CHECK(warning.empty() == (reading.Log->Warnings.find("opaque") == std::string::npos));
    CHECK((warning.empty() || reading.Log->HasWarning(path + warning)));
    CHECK(isColored == reading.Scene()->GetCellData()->HasArray("TextureCoordinates"));
    const double found = ComputeArea(reading.Scene());
    CHECK((!isColored || found == area));
    area = found;
  }
  return area;
}

} // namespace

TEST_CASE("ObjCutouts: headers tell of transparency", "[ObjCutouts]")
{
  TestFolder folder;
  const std::string path = folder.GetPath("a");
  for (const int components : { 1, 2, 3, 4 })
  {
    INFO(components << " components");
    const bool hasAlpha = components % 2 == 0;
    CHECK(HasAlpha(WriteImage<vtkPNGWriter>(path, components)) == hasAlpha);
  }
  CHECK_FALSE(HasAlpha(WriteImage<vtkTIFFWriter>(path, 3)));
  CHECK(HasAlpha(WriteImage<vtkTIFFWriter>(path, 4)));
}

TEST_CASE("ObjCutouts: half of a disc stays of a triangle", "[ObjCutouts]")
{
  TestFolder folder;
  helios::WritePng(MakeDisc(), 4, folder.GetPath("leaf.png"));
  helios::WritePng(MakeDisc(), 4, folder.GetPath("my leaf.png"));
  helios::WritePng(MakeDisc(), 1, folder.GetPath("mask.png"));
  const double disc = 0.5 * 3.14159265 / 16.0;
  const std::string bark = "newmtl bark\n";
  for (const char* image :
    { "map_Kd leaf.png", "map_Kd my leaf.png", "map_d mask.png", "map_d leaf.png",
      "map_d -imfchan m leaf.png", "map_d -imfchan l mask.png", "map_d -clamp on mask.png",
      "map_Kd -s 1 1 1 -o 0 0 0 leaf.png", "map_Kd leaf.png\nmap_d mask.png" })
  {
    INFO(image);
    CHECK(ReadArea(folder, std::string("newmtl leaf\n") + image + "\n" + bark) ==
      Approx(0.5 + disc).epsilon(2e-3));
  }
  // The channel says what is read: red is 30 and green 200 of 255 everywhere.
  CHECK(ReadArea(folder, "newmtl leaf\nmap_d -imfchan r leaf.png\n" + bark) == Approx(0.5));
  CHECK(ReadArea(folder, "newmtl leaf\nmap_d -imfchan g leaf.png\n" + bark) == Approx(1.0));
  CHECK(ReadArea(folder, "newmtl leaf\nmap_d -imfchan b leaf.png\n" + bark) == Approx(0.5));
}

TEST_CASE("ObjCutouts: pieces keep material and texture, notes tell", "[ObjCutouts]")
{
  TestFolder folder;
  helios::WritePng(MakeDisc(), 4, folder.GetPath("leaf.png"));
  folder.Write("a.mtl", "newmtl bark\nnewmtl leaf\nKd 1 1 1\nmap_Kd leaf.png\n");
  ObjReading reading(folder.Write("a.obj", "mtllib a.mtl\n" + ObjSquare + Faces));
  reading.Reader->ReadColorsOn();
  REQUIRE(reading.Read());
  vtkPolyData* scene = reading.Scene();
  vtkDataArray* textures = scene->GetCellData()->GetArray("TextureCoordinates");
  vtkDataArray* ids = scene->GetCellData()->GetArray("MaterialIds");
  CHECK(ids->GetComponent(0, 0) == 0.0);
  for (vtkIdType i = 1; i < scene->GetNumberOfCells(); ++i)
  {
    CHECK(ids->GetComponent(i, 0) == 1.0);
    for (int k = 0; k < 3; ++k) // the square is the texture
    {
      const double* p = scene->GetPoint(reading.Corners(i)[static_cast<std::size_t>(k)]);
      CHECK(textures->GetComponent(i, 2 * k) == Approx(p[0]).margin(1e-6));
      CHECK(textures->GetComponent(i, 2 * k + 1) == Approx(p[1]).margin(1e-6));
    }
  }
  vtkAbstractArray* notes = scene->GetFieldData()->GetAbstractArray("Notes");
  REQUIRE(notes);
  REQUIRE(notes->GetNumberOfValues() == 1);
  const std::string note = notes->GetVariantValue(0).ToString();
  INFO(note);
  CHECK(note.find("the transparency of map_Kd leaf.png of material \"leaf\" leaves 19.6 % of 0.5 "
                  "m2: 1 -> ") == 0);
}

TEST_CASE("ObjCutouts: nothing and all", "[ObjCutouts]")
{
  TestFolder folder;
  const auto write = [&](double opacity)
  {
    helios::WritePng(helios::MakeMask(4, 4, [opacity](double, double) { return opacity; }), 4,
      folder.GetPath("leaf.png"));
    return ReadArea(folder, "newmtl leaf\nmap_Kd leaf.png\nnewmtl bark\n");
  };
  CHECK(write(0.2) == Approx(0.5));
  CHECK(write(0.8) == Approx(1.0));
}

TEST_CASE("ObjCutouts: what cannot be cut is opaque, and named", "[ObjCutouts]")
{
  TestFolder folder;
  WriteImage<vtkTIFFWriter>(folder.GetPath("leaf.tif"), 4);
  helios::WritePng(MakeDisc(), 4, folder.GetPath("leaf.png"));
  const std::string one = " of material \"leaf\" is not applied: 1 triangle, 0.5 m2, of 1 material "
                          "is scanned as opaque: ";
  const std::string bark = "newmtl bark\n";
  const auto check = [&](const std::string& line, const std::string& warning)
  { CHECK(ReadArea(folder, "newmtl leaf\n" + line + "\n" + bark, warning) == Approx(1.0)); };
  check("map_d mask.png",
    ":2: map_d mask.png" + one + folder.GetPath("mask.png") + " does not exist; give it");
  check("map_Kd leaf.tif",
    ":2: the transparency of map_Kd leaf.tif" + one + folder.GetPath("leaf.tif") +
      ": the transparency of TIFF images is not read; save it as PNG");
  for (const char* option : { "-s 2 2 1", "-o 0.5 0 0", "-t 0.1", "-mm 0 2" })
  {
    const std::string name = std::string(option).substr(0, std::string(option).find(' '));
    check("map_d " + std::string(option) + " leaf.png",
      ":2: map_d leaf.png" + one + "its option " + name +
        " is not read; change the texture coordinates or the image instead");
  }
  check("map_d -imfchan z leaf.png",
    ":2: map_d leaf.png" + one + "-imfchan z is not read; give m, l, r, g or b");
  const std::string leaf = "newmtl leaf\nmap_Kd leaf.png\n" + bark;
  const std::string what = ":2: the transparency of map_Kd leaf.png" + one;
  CHECK(ReadArea(folder, leaf, what + "they have no texture coordinates; give them (vt)",
          "vt 0 0\nusemtl leaf\nf 1 2 3\nusemtl bark\nf 1 3 4\n") == Approx(1.0));
  CHECK(ReadArea(folder, leaf,
          what +
            "the texture repeats more than 4096 times over a triangle, or ends within it; correct "
            "the texture coordinates",
          "vt 0 0\nvt 1e6 0\nvt 1e6 1e6\nusemtl leaf\nf 1/1 2/2 3/3\nusemtl bark\nf 1 3 4\n") ==
    Approx(1.0));
}

TEST_CASE("ObjCutouts: opaque, unused and unreadable images are none", "[ObjCutouts]")
{
  TestFolder folder;
  WriteImage<vtkPNGWriter>(folder.GetPath("leaf.png"), 4);
  WriteImage<vtkPNGWriter>(folder.GetPath("bark.png"), 3);
  CHECK(ReadArea(folder, "newmtl leaf\nmap_Kd bark.png\nnewmtl bark\n") == Approx(1.0));
  CHECK(
    ReadArea(folder, "newmtl leaf\nnewmtl bark\nnewmtl other\nmap_Kd leaf.png\nmap_d leaf.png\n") ==
    Approx(1.0));
  folder.Write("bad.png", "\x89PNG\r\n\x1a\n");
  folder.Write("a.mtl", "newmtl leaf\nmap_Kd bad.png\nnewmtl bark\nmap_Kd none.png\n");
  ObjReading reading(folder.Write("a.obj", "mtllib a.mtl\n" + ObjSquare + Faces));
  REQUIRE(reading.Read());
  CHECK(reading.Log->Warnings.empty());
}

TEST_CASE(
  "ObjCutouts: more triangles than memory are an error before they are made", "[ObjCutouts]")
{
  TestFolder folder;
  helios::WritePng(MakeDisc(), 4, folder.GetPath("leaf.png"));
  const std::string path = folder.Write("a.mtl", "newmtl leaf\nmap_Kd leaf.png\n");
  std::string text = "mtllib a.mtl\nvt 0 0\nvt 1 0\nvt 1 1\nusemtl leaf\n" + ObjSquare;
  for (int i = 0; i < 6000; ++i)
  {
    text += "f 1/1 2/2 3/3\n";
  }
  ObjReading reading(folder.Write("a.obj", text));
  vtkHeliosMemoryLimit::SetLimit(vtkHeliosMemoryLimit::GetUsed() + 3.0);
  const bool isRead = reading.Read();
  vtkHeliosMemoryLimit::SetLimit(0.0);
  CHECK_FALSE(isRead);
  INFO(reading.Log->Errors);
  CHECK(
    reading.Log->HasError(path + ":2: the transparency of map_Kd leaf.png of material \"leaf\": "));
  CHECK(reading.Log->HasError(" triangles cut by images need about "));
  CHECK(reading.Log->HasError("; or place trees as instances, or simplify the image"));
}
