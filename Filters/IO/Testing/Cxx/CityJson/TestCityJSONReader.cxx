// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// City models as scenes: areas and volumes by the formulas of a box.
#include "heliosCityTesting.h"
#include "heliosSceneCrs.h"

using helios::Material;
using helios::Vec3;
using namespace helios::city;

namespace
{

std::string MakeReference(const std::string& text)
{
  return "\"metadata\":{\"referenceSystem\":\"" + text + "\"},\n";
}

/// A building with a footprint, and its part with a higher level of detail.
std::string MakeParts()
{
  const std::string foot = MakeGeometry("MultiSurface", "0", "[[[12,13,14,15]]]");
  const std::string roof = MakeGeometry("MultiSurface", "1.2", "[[[4,5,6,7]]]") + "," +
    MakeGeometry("MultiSurface", "1.3", "[[[4,5,6]]]") + "," +
    "{\"type\":\"MultiPoint\",\"lod\":\"3\",\"boundaries\":[1]}";
  std::string whole = MakeObject("a", "Building", foot);
  whole.insert(whole.size() - 1, ",\"children\":[\"b\"]");
  return MakeFile(whole + ",\n" + MakeObject("b", "BuildingPart", roof));
}

} // namespace

TEST_CASE("CityJSONReader: a solid with a hole, and a surface with a hole", "[CityJSONReader]")
{
  Reading reading("a.city.json", MakeHouse());
  REQUIRE(reading.Read());
  INFO(reading.Log->Warnings);
  CHECK(reading.Log->Warnings.empty());
  CHECK(reading.Area("RoofSurface") == Approx(12.0));
  CHECK(reading.Area("GroundSurface") == Approx(12.0));
  CHECK(reading.Area("WallSurface") == Approx(8.0 - 1.0 + 6.0 + 8.0));
  CHECK(reading.Area("Building") == Approx(6.0)); // without semantics
  CHECK(reading.Area("LandUse") == Approx(100.0 - 12.0));
  CHECK(reading.Corner(0, 0) == Vec3(85000.5, 447000.25, -1.0));
  CHECK(reading.Scene()->GetPoints()->GetDataType() == VTK_DOUBLE);
}

TEST_CASE("CityJSONReader: surfaces keep their orientation", "[CityJSONReader]")
{
  std::string box = Box;
  box.replace(box.find(",[8,11,10,9]"), 12, "");
  Reading reading("a.json", MakeFile(MakeObject("a", "Building", MakeGeometry("Solid", "1", box))));
  REQUIRE(reading.Read());
  CHECK(reading.Volume() == Approx(24.0));
}

TEST_CASE("CityJSONReader: materials and classes", "[CityJSONReader]")
{
  const std::string roof =
    MakeGeometry("MultiSurface", "2", "[[[4,5,6,7]],[[0,1,2,3]],[[0,1,5,4]]]",
      "{\"surfaces\":[{\"type\":\"RoofSurface\"},{\"type\":\"ClosureSurface\"}],"
      "\"values\":[0,1,null]}");
  Reading reading("a.json",
    MakeFile(MakeObject("a", "Bridge", roof) + "," + MakeObject("b", "Building", roof) + "," +
      MakeObject("c", "Road", roof) + "," + MakeObject("d", "+Odd", roof)));
  REQUIRE(reading.Read());
  CHECK(reading.Area() == Approx(4 * (12.0 + 8.0))); // closure surfaces are left out
  const struct
  {
    const char* Name;
    int Class;
    bool IsGround;
  } expected[] = { { "RoofSurface", 17, false }, { "Bridge", 17, false },
    { "RoofSurface", 6, false }, { "Building", 6, false }, { "RoofSurface", 11, true },
    { "Road", 11, true }, { "RoofSurface", 0, false }, { "+Odd", 0, false } };
  for (vtkIdType i = 0; i < 8; ++i)
  {
    const Material material = reading.MaterialOf(2 * i);
    CHECK(material.Name == expected[i].Name);
    CHECK(material.Classification == expected[i].Class);
    CHECK(material.IsGround == expected[i].IsGround);
  }
}

TEST_CASE("CityJSONReader: materials are replaced by name", "[CityJSONReader]")
{
  Reading reading("a.json", MakeHouse());
  reading.Reader->SetMaterialFileName(
    reading
      .Write("a.mtl",
        "newmtl RoofSurface\nhelios_reflectance 0.3\nnewmtl LandUse\nhelios_reflectance 0.2\n"
        "helios_classification 3\n")
      .c_str());
  REQUIRE(reading.Read());
  const Material roof = reading.MaterialOf(2);
  CHECK(roof.Reflectance == 0.3);
  CHECK(roof.Classification == 6); // class of the model
  const Material ground = reading.MaterialOf(reading.Triangles() - 1);
  CHECK(ground.Reflectance == 0.2);
  CHECK(ground.Classification == 3);
  CHECK_FALSE(ground.IsGround);

  const std::string other = reading.Write("a.mtl", "newmtl Other\n");
  REQUIRE(reading.Read());
  CHECK(reading.Log->HasWarning(
    other + ": no material has the name of one of the scene, such as \"GroundSurface\""));
  reading.Write("a.mtl", "newmtl Other\nKd x\n");
  CHECK_FALSE(reading.Read());
  CHECK(reading.Log->HasError(other + ":2: Kd of material"));
}

TEST_CASE("CityJSONReader: the coordinate system", "[CityJSONReader]")
{
  const struct
  {
    const char* Text;
    const char* Crs;
  } cases[] = { { "https://www.opengis.net/def/crs/EPSG/0/7415", "EPSG:7415" },
    { "urn:ogc:def:crs:EPSG::28992", "EPSG:28992" },
    { "http://www.opengis.net/def/crs/OGC/1.3/CRS84h", "OGC:CRS84h" } };
  for (const auto& each : cases)
  {
    Reading reading("a.json", MakeHouse(MakeReference(each.Text)));
    CHECK(reading.Read());
    CHECK(helios::GetCRS(reading.Scene()) == each.Crs);
  }
  Reading odd("a.json", MakeHouse(MakeReference("somewhere")));
  CHECK(odd.Read());
  CHECK(helios::GetCRS(odd.Scene()).empty());
  CHECK(odd.Log->HasWarning(
    odd.Path + ":3: referenceSystem \"somewhere\" is not understood and not used: expected https"));
}

TEST_CASE("CityJSONReader: the highest level of detail of each object", "[CityJSONReader]")
{
  Reading reading("a.json", MakeParts());
  REQUIRE(reading.Read());
  CHECK(reading.Area() == Approx(6.0)); // 1.3 of the part; the footprint of the whole is left out
}

TEST_CASE("CityJSONReader: a level of detail by name", "[CityJSONReader]")
{
  Reading reading("a.json", MakeParts());
  reading.Reader->SetLevelOfDetail("1.2");
  REQUIRE(reading.Read());
  CHECK(reading.Area() == Approx(12.0));
  CHECK(reading.Log->HasWarning(reading.Path +
    ": only 1 of 2 objects have the level of detail "
    "\"1.2\"; the file has 0, 1.2, 1.3: the others"));
  reading.Reader->SetLevelOfDetail("0");
  REQUIRE(reading.Read());
  CHECK(reading.Area() == Approx(100.0));
  reading.Reader->SetLevelOfDetail("2");
  CHECK_FALSE(reading.Read());
  CHECK(reading.Log->HasError(reading.Path +
    ": none of 2 objects have the level of detail \"2\"; the "
    "file has 0, 1.2, 1.3: give one of them"));
}

TEST_CASE("CityJSONReader: templates are placed by matrix and vertex", "[CityJSONReader]")
{
  // A triangle of 1 m, turned about z by 90 degrees, scaled by 2, moved by (1, 0, 0), at vertex 6.
  const std::string instance = "{\"type\":\"GeometryInstance\",\"template\":0,\"boundaries\":[6],"
                               "\"transformationMatrix\":[0,-2,0,1,2,0,0,0,0,0,2,0,0,0,0,1]}";
  const std::string templates = "\"geometry-templates\":{\"templates\":[" +
    MakeGeometry("MultiSurface", "2", "[[[0,1,2]]]") +
    "],\"vertices-templates\":[[0,0,0],[1,0,0],[0,1,0.5]]},\n";
  Reading reading("a.json",
    MakeFile(MakeObject("t", "SolitaryVegetationObject", instance + "," + instance), templates));
  REQUIRE(reading.Read());
  REQUIRE(reading.Triangles() == 2);
  const Vec3 place = Vec3(400 * 0.01 + 85000.5, 300 * 0.01 + 447000.25, 200 * 0.01 - 1.0);
  for (vtkIdType i = 0; i < 2; ++i)
  {
    CHECK((reading.Corner(i, 0) - place - Vec3(1, 0, 0)).Norm() < 1e-9);
    CHECK((reading.Corner(i, 1) - place - Vec3(1, 2, 0)).Norm() < 1e-9);
    CHECK((reading.Corner(i, 2) - place - Vec3(-1, 0, 1)).Norm() < 1e-9);
  }
  CHECK(reading.MaterialOf(0).Classification == 5);
}

TEST_CASE("CityJSONReader: composite solids, and version 1.1", "[CityJSONReader]")
{
  std::string text = MakeFile(MakeObject("a", "BuildingPart",
    MakeGeometry("MultiSolid", "1", "[" + Box + "," + Box + "]",
      "{\"surfaces\":[{\"type\":\"RoofSurface\"}],\"values\":[[[null,0]],null]}")));
  text.replace(text.find("2.0"), 3, "1.1");
  Reading reading("a.json", text);
  REQUIRE(reading.Read());
  CHECK(reading.Area("RoofSurface") == Approx(12.0));
  CHECK(reading.Area() == Approx(2 * 51.0));
}
