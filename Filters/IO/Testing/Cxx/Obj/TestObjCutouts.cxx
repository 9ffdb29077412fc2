// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Textures that cut leaves out of triangles: one warning with what is scanned as opaque.
#include "heliosImage.h"
#include "heliosObjTestFiles.h"

#include <vtkImageData.h>
#include <vtkImageWriter.h>
#include <vtkPNGWriter.h>
#include <vtkTIFFWriter.h>

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
  REQUIRE(ReadImageHeader(path, header).IsOk());
  return header.HasAlpha;
}

const std::string Faces = "vt 0 0\nusemtl leaf\nf 1/1 2/1 3/1\nusemtl bark\nf 1 3 4\n";

/// Reads a scene of a leaf and bark; a message is after the path of the material file.
void CheckCutout(TestFolder& folder, const std::string& materials, const std::string& message)
{
  const std::string path = folder.Write("a.mtl", materials);
  for (const bool isColored : { false, true })
  {
    ObjReading reading(folder.Write("a.obj", "mtllib a.mtl\n" + ObjSquare + Faces));
    reading.Reader->SetReadColors(isColored);
    INFO(materials);
    REQUIRE(reading.Read());
    INFO("said: " << reading.Log->Warnings);
    CHECK(reading.TriangleCount() == 2);
    CHECK(message.empty() == (reading.Log->Warnings.find("opaque") == std::string::npos));
    CHECK((message.empty() || reading.Log->HasWarning(path + message)));
  }
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

TEST_CASE("ObjCutouts: map_d and transparent textures are named", "[ObjCutouts]")
{
  TestFolder folder;
  WriteImage<vtkPNGWriter>(folder.GetPath("leaf.png"), 4);
  WriteImage<vtkPNGWriter>(folder.GetPath("my leaf.png"), 4);
  WriteImage<vtkPNGWriter>(folder.GetPath("bark.png"), 3);
  const std::string opaque =
    " of material \"leaf\" is not applied: 1 of 2 triangles, 0.5 m2, of 1 "
    "material are scanned as opaque; give leaves their outline as triangles";
  const std::string bark = "newmtl bark\nmap_Kd bark.png\n";
  CheckCutout(folder, "newmtl leaf\nmap_d mask.png\n" + bark, ":2: map_d mask.png" + opaque);
  CheckCutout(folder, "newmtl leaf\nmap_d -imfchan m mask.png\n" + bark, ":2: map_d mask.png");
  CheckCutout(folder, "newmtl leaf\nmap_Kd leaf.png\n" + bark,
    ":2: the transparency of map_Kd leaf.png" + opaque);
  CheckCutout(folder, "newmtl leaf\nmap_Kd my leaf.png\n" + bark,
    ":2: the transparency of map_Kd my leaf.png" + opaque);
  CheckCutout(folder, "newmtl leaf\nmap_Kd -s 1 1 1 leaf.png\n" + bark,
    ":2: the transparency of map_Kd leaf.png");
  CheckCutout(folder, "newmtl leaf\nmap_Kd leaf.png\nmap_d leaf.png\n" + bark,
    ":3: map_d leaf.png of material");
  CheckCutout(folder, "newmtl bark\nmap_d mask.png\nnewmtl leaf\nmap_Kd leaf.png\n",
    ":2: map_d mask.png of material \"bark\" is not applied: 2 of 2 triangles, 1 m2, of 2 "
    "materials");
}

TEST_CASE("ObjCutouts: opaque, unused and unreadable images are none", "[ObjCutouts]")
{
  TestFolder folder;
  WriteImage<vtkPNGWriter>(folder.GetPath("leaf.png"), 4);
  WriteImage<vtkPNGWriter>(folder.GetPath("bark.png"), 3);
  CheckCutout(folder, "newmtl leaf\nmap_Kd bark.png\nnewmtl bark\n", "");
  CheckCutout(folder, "newmtl other\nmap_Kd leaf.png\nmap_d leaf.png\n", "");
  folder.Write("bad.png", "\x89PNG\r\n\x1a\n");
  folder.Write("a.mtl", "newmtl leaf\nmap_Kd bad.png\nnewmtl bark\nmap_Kd none.png\n");
  ObjReading reading(folder.Write("a.obj", "mtllib a.mtl\n" + ObjSquare + Faces));
  REQUIRE(reading.Read());
  CHECK(reading.Log->Warnings.empty());
}
