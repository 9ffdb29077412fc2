// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// The loaders and filters of scene parts: their settings, and their errors.
#include "vtkHeliosSurveyReader.h"

#include "heliosSurveyFiles.h"
#include "vtkHeliosDialect.h"

#include <catch2/catch.hpp>

#include <string>
#include <utility>
#include <vector>

using namespace helios::test;

namespace
{

/// A <filter> with parameters.
std::string Filter(
  const std::string& type, const std::vector<std::pair<std::string, std::string>>& parameters = {})
{
  std::string text = "<filter type=\"" + type + "\">";
  for (const auto& parameter : parameters)
  {
    text += "<param key=\"" + parameter.first + "\" value=\"" + parameter.second + "\"/>";
  }
  return text + "</filter>";
}

/// The survey of a scene with one part.
Reading ReadPart(const Files& files, const std::string& filters, const std::string& scene = "")
{
  files.Write("scene.xml",
    "<document>\n<scene id=\"s\" " + scene + "><part id=\"p\">" + filters +
      "</part></scene></document>");
  files.Write("points.xyz", "0 0 0\n");
  files.Write("height.tif", "");
  files.Write("ground.mtl", "newmtl grass\n");
  return Reading(files, Tripod, OneLeg);
}

const std::string Points = Filter("xyzloader", { { "filepath", "points.xyz" } });

} // namespace

TEST_CASE("SurveyReader: a height raster and its material", "[SurveyReader]")
{
  const Files files;
  const Reading reading = ReadPart(files,
    Filter("GeoTIFFloader",
      { { "filepath", "height.tif" }, { "matfile", "ground.mtl" }, { "matname", "grass" } }));
  INFO(reading.Log->Errors);
  REQUIRE(reading.Good);
  const helios::PartData& part = reading.Data().Scene.Parts.at(0);
  CHECK(part.Type == helios::Loader::GeoTiff);
  CHECK(part.Files == std::vector<std::string>{ files / "height.tif" });
  CHECK(part.Material.File == files / "ground.mtl");
  CHECK(part.Material.Name == "grass");
}

TEST_CASE("SurveyReader: PLY and STL with a material, and y up", "[SurveyReader]")
{
  for (const auto& [loader, type] :
    { std::make_pair("plyloader", helios::Loader::Ply), { "stlloader", helios::Loader::Stl } })
  {
    const Files files;
    const Reading reading = ReadPart(files,
      Filter(loader, { { "filepath", "points.xyz" }, { "up", "y" }, { "matfile", "ground.mtl" } }));
    INFO(reading.Log->Errors);
    REQUIRE(reading.Good);
    const helios::PartData& part = reading.Data().Scene.Parts.at(0);
    CHECK(part.Type == type);
    CHECK(part.UpIsY);
    CHECK(part.Files == std::vector<std::string>{ files / "points.xyz" });
    CHECK(part.Material.File == files / "ground.mtl");
  }
}

TEST_CASE("SurveyReader: a city model at a level of detail", "[SurveyReader]")
{
  const Files files;
  const Reading reading =
    ReadPart(files, Filter("cityjsonloader", { { "filepath", "points.xyz" }, { "lod", "2.2" } }));
  INFO(reading.Log->Errors);
  REQUIRE(reading.Good);
  CHECK(reading.Data().Scene.Parts.at(0).Type == helios::Loader::CityJson);
  CHECK(reading.Data().Scene.Parts.at(0).LevelOfDetail == "2.2");
}

TEST_CASE("SurveyReader: a glTF document with materials", "[SurveyReader]")
{
  const Files files;
  const Reading reading = ReadPart(
    files, Filter("gltfloader", { { "filepath", "points.xyz" }, { "matfile", "ground.mtl" } }));
  INFO(reading.Log->Errors);
  REQUIRE(reading.Good);
  CHECK(reading.Data().Scene.Parts.at(0).Type == helios::Loader::Gltf);
  CHECK(reading.Data().Scene.Parts.at(0).Material.File == files / "ground.mtl");
}

TEST_CASE("SurveyReader: points as voxels", "[SurveyReader]")
{
  const Files files;
  SECTION("defaults")
  {
    const Reading reading = ReadPart(files, Points);
    INFO(reading.Log->Errors);
    REQUIRE(reading.Good);
    const helios::VoxelData& voxels = reading.Data().Scene.Parts.at(0).Voxels;
    CHECK(voxels.Size == 1.0);
    CHECK_FALSE(voxels.ReadNormals);
    CHECK_FALSE(voxels.EstimateNormals);
  }
  SECTION("everything given")
  {
    const Reading reading = ReadPart(files,
      Filter("xyzloader",
        { { "filepath", "points.xyz" }, { "separator", ";" }, { "voxelSize", "0.25" },
          { "normalXIndex", "6" }, { "normalYIndex", "7" }, { "normalZIndex", "8" },
          { "defaultNormal", "0;0;1" }, { "snapNeighborNormal", "true" }, { "sparse", "true" },
          { "maxColorValue", "1" }, { "rgbRIndex", "3" } }));
    INFO(reading.Log->Errors);
    REQUIRE(reading.Good);
    CHECK(reading.Log->Warnings.empty());
    const helios::VoxelData& voxels = reading.Data().Scene.Parts.at(0).Voxels;
    CHECK(voxels.Separators == ";");
    CHECK(voxels.Size == 0.25);
    CHECK(voxels.ReadNormals);
    CHECK(voxels.NormalIndex[0] == 6);
    CHECK(voxels.NormalIndex[2] == 8);
    CHECK(voxels.DefaultNormal[2] == 1.0);
    CHECK(voxels.SnapNeighborNormal);
  }
  SECTION("normals are fitted in batches, too")
  {
    const Reading reading = ReadPart(
      files, Filter("xyzloader", { { "filepath", "points.xyz" }, { "estimateNormals", "3" } }));
    REQUIRE(reading.Good);
    CHECK(reading.Data().Scene.Parts.at(0).Voxels.EstimateNormals);
    CHECK_FALSE(reading.Data().Scene.Parts.at(0).Voxels.ReadNormals);
  }
}

TEST_CASE("SurveyReader: coordinate systems of parts and scene", "[SurveyReader]")
{
  const Files files;
  for (const char* name : { "crs", "CrsTransform", "transform" })
  {
    const Reading reading = ReadPart(files,
      Points + Filter(name, { { "source", "EPSG:4326" }, { "target", "EPSG:32632" } }),
      "crs=\"EPSG:25832\"");
    INFO(name << reading.Log->Errors);
    REQUIRE(reading.Good);
    const std::vector<helios::CrsData>& crs = reading.Data().Scene.Parts.at(0).Crs;
    REQUIRE(crs.size() == 1);
    CHECK(crs[0].Source == "EPSG:4326");
    CHECK(crs[0].Target == "EPSG:32632");
    CHECK(reading.Data().Scene.Crs == "EPSG:25832");
  }
}

TEST_CASE("SurveyReader: repair and simplification", "[SurveyReader]")
{
  const Files files;
  const Reading reading = ReadPart(
    files, Points + Filter("repair") + Filter("simplify", { { "maximumDistance", "0.02" } }));
  INFO(reading.Log->Errors);
  REQUIRE(reading.Good);
  CHECK(reading.Data().Scene.Parts.at(0).Repair);
  CHECK(reading.Data().Scene.Parts.at(0).SimplifyDistance == 0.02);
}

TEST_CASE("SurveyReader: bad parts are errors", "[SurveyReader]")
{
  struct Wrong
  {
    std::string Filters;
    std::string Message;
  };
  const std::vector<Wrong> cases = {
    { Filter("geotiffloader"), "scene.xml:2: filter geotiffloader has no filepath" },
    { Filter("xyzloader"), "scene.xml:2: filter xyzloader has no filepath" },
    { Filter("plyloader"), "scene.xml:2: filter plyloader has no filepath" },
    { Filter("stlloader", { { "filepath", "none.stl" } }), "none.stl" },
    { Filter("cityjsonloader"), "scene.xml:2: filter cityjsonloader has no filepath" },
    { "",
      "<part> has no loader; add a <filter type=\"objloader\"> or another one of objloader, "
      "geotiffloader, xyzloader, detailedvoxels, plyloader, stlloader, cityjsonloader, "
      "gltfloader and lasloader" },
    { Points + Points, "a second loader in one <part>" },
    { Filter("xyzloader", { { "filepath", "points.xyz" }, { "voxelSize", "0" } }),
      "voxelSize=\"0\" is out of range" },
    { Filter("xyzloader", { { "filepath", "points.xyz" }, { "voxelSize", "big" } }),
      "voxelSize=\"big\" is not a number" },
    { Filter("xyzloader", { { "filepath", "points.xyz" }, { "normalXIndex", "-1" } }),
      "normalXIndex=\"-1\" is out of range" },
    { Filter("xyzloader", { { "filepath", "points.xyz" }, { "defaultNormal", "1;2" } }),
      "defaultNormal=\"1;2\"" },
    { Filter("xyzloader", { { "filepath", "none.xyz" } }), "none.xyz" },
    { Filter("xyzloader", { { "filepath", "points.xyz" }, { "matfile", "none.mtl" } }),
      "none.mtl" },
    { Points + Filter("crs"), "scene.xml:2:105: filter crs has no target" },
    { Points + Filter("crs", { { "target", "" } }), "filter crs has no target" },
    { Points + Filter("simplify"), "scene.xml:2:105: filter simplify has no maximumDistance" },
    { Points + Filter("simplify", { { "maximumDistance", "-1" } }),
      "maximumDistance=\"-1\" is out of range" },
    { Points + Filter("detailedvoxel"), "type=\"detailedvoxel\" is unknown" },
    { Points + Filter("simplfy"), "did you mean simplify?" },
  };
  for (const Wrong& wrong : cases)
  {
    const Files files;
    const Reading reading = ReadPart(files, wrong.Filters);
    INFO(wrong.Filters << "\n" << reading.Log->Errors);
    CHECK_FALSE(reading.Good);
    CHECK(reading.Log->HasError(wrong.Message));
  }
}

TEST_CASE("SurveyReader: unused parameters of parts are reported", "[SurveyReader]")
{
  const Files files;
  const Reading reading = ReadPart(files,
    Filter("xyzloader",
      { { "filepath", "points.xyz" }, { "matname", "oak" }, { "randomMaterials", "3" },
        { "voxelsize", "2" } }));
  INFO(reading.Log->Errors << reading.Log->Warnings);
  CHECK(reading.Good);
  CHECK(reading.Log->HasWarning("matname=\"oak\" is not used without a matfile"));
  CHECK(reading.Log->HasWarning("randomMaterials=\"3\" is not used without a matfile"));
  CHECK(reading.Log->HasWarning(
    "parameter \"voxelsize\" of filter xyzloader is unknown; did you mean voxelSize?"));
}

TEST_CASE("SurveyReader: meshes by the endings of their files", "[SurveyReader]")
{
  CHECK(vtkHeliosDialect::FindLoader("a/b.OBJ") == "objloader");
  CHECK(vtkHeliosDialect::FindLoader("delft.city.json") == "cityjsonloader");
  CHECK(vtkHeliosDialect::FindLoader("a.glb") == "gltfloader");
  CHECK(vtkHeliosDialect::FindLoader("a.dxf").empty());
  CHECK(vtkHeliosDialect::FindLoader("obj").empty());
  CHECK(vtkHeliosDialect::GetMeshEndings() ==
    ".obj, .tif, .tiff, .vrt, .ply, .stl, .json, .jsonl, .gltf, .glb");
  CHECK(vtkHeliosDialect::IsMesh("none.stl"));
}

TEST_CASE("SurveyReader: PLY files with faces are meshes, others clouds", "[SurveyReader]")
{
  const Files files;
  const std::string start = "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\n";
  const struct
  {
    std::string Text;
    bool IsMesh;
  } cases[] = { { start + "element face 12\nend_header\n", true },
    { start + "element face 0\r\nproperty list uchar int vertex_indices\nend_header\n", false },
    { start + "end_header\nelement face 3\n", false }, { start + "element face ", false },
    { "", false } };
  for (const auto& each : cases)
  {
    files.Write("a.ply", each.Text);
    INFO(each.Text);
    CHECK(vtkHeliosDialect::IsMesh(files / "a.ply") == each.IsMesh);
  }
  CHECK_FALSE(vtkHeliosDialect::IsMesh(files / "none.ply"));
}
