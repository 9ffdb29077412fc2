// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Errors of the CityJSON reader on bad files.
#include "heliosCityTesting.h"
#include "vtkHeliosMemoryLimit.h"

using helios::BadFile;
using namespace helios::city;

namespace
{

void Check(const std::vector<BadFile>& cases)
{
  helios::CheckErrors<vtkHeliosCityJSONReader>("a.json", cases);
}

std::string Replace(std::string text, const std::string& from, const std::string& to)
{
  const std::size_t at = text.find(from);
  REQUIRE(at != std::string::npos);
  return text.replace(at, from.size(), to);
}

/// A file with one surface of a yard.
std::string MakeYard(const std::string& boundaries, const std::string& semantics = "null")
{
  return MakeFile(
    MakeObject("yard", "LandUse", MakeGeometry("MultiSurface", "1", boundaries, semantics)));
}

std::string MakeTree(const std::string& members, const std::string& vertices)
{
  return MakeFile(MakeObject("tree", "CityFurniture",
                    "{\"type\":\"GeometryInstance\",\"template\":0" + members + "}"),
    "\"geometry-templates\":{\"templates\":[" + MakeGeometry("MultiSurface", "2", "[[[0,1,2]]]") +
      "],\"vertices-templates\":" + vertices + "},\n");
}

} // namespace

TEST_CASE("CityJSONErrors: files that are no CityJSON", "[CityJSONErrors]")
{
  const std::string good = MakeHouse();
  Check(
    { { "", ":1: is not valid JSON at column 1: Syntax error: value, object or array expected" },
      { "[1, 2]", ": is JSON, but no object; check the name of the file" },
      { "{\"type\": \"CityJSON\",\n \"version\" \"2.0\"}", ":2: is not valid JSON at column 12: " },
      { "{} {}", ":1: is not valid JSON at column 4: Extra non-whitespace after JSON value" },
      { "{\"a\": " + std::string(2000, '['),
        ": is not valid JSON: Exceeded stackLimit in readValue" },
      { "{\"type\": \"Feature\"}",
        ":1: type is \"Feature\", not \"CityJSON\"; give a file of CityJSON" },
      { "{\"type\": \"CityJSONFeature\"}",
        ":1: type is \"CityJSONFeature\", not \"CityJSON\"; give a file of CityJSON, or a text "
        "sequence" },
      { Replace(good, "2.0", "1.0"),
        ":1: version \"1.0\" is not supported: expected 1.1 or 2.0; upgrade the file" },
      { Replace(good, "\"scale\"", "\"size\""),
        ":2: transform has no scale and translate of three numbers each; write the file again" },
      { Replace(good, "\"vertices\":", "\"vertices\":{},\"points\":"),
        ":7: vertices are an object, not a list of at most 2147483647" },
      { Replace(good, "[400,0,0]", "[400,\"0\",0]"),
        ":7: vertex 1 is a list of 3, not three numbers that are finite after" },
      { Replace(Replace(good, "[400,0,0]", "[1e308,0,0]"), "[0.01,", "[1000,"),
        ":7: vertex 1 is a list of 3, not three numbers that are finite after the transform" },
      { Replace(good, "\"CityObjects\":", "\"CityObjects\":[],\"Objects\":"),
        ":3: CityObjects are a list of 0, not an object; write the file again" },
      { Replace(good, "\"LandUse\"", "7"),
        ":5: object \"yard\": has no type; write the file again" } });
}

TEST_CASE("CityJSONErrors: surfaces", "[CityJSONErrors]")
{
  const std::string at = ":4: object \"yard\": ";
  Check({ { MakeYard("7"), at + "boundaries of the geometry have 7 in place of a list" },
    { MakeYard("[7]"), at + "a surface is 7, not a list of rings; write the file again" },
    { MakeYard("[[7]]"), at + "a ring is 7, not a list of three vertices or more; correct" },
    { MakeYard("[[[1,2]]]"), at + "a ring is a list of 2, not a list of three vertices" },
    { MakeYard("[[[1,2,16]]]"),
      at + "a ring refers to vertex 16, but there are 16, counted from 0; correct the index" },
    { MakeYard("[[[1,2,-1]]]"), at + "a ring refers to vertex -1, but there are 16" },
    { MakeYard("[[[1,2,0.5]]]"), at + "a ring refers to vertex 0.5, but there are 16" },
    { MakeYard("[[[1,2,\"3\"]]]"), at + "a ring refers to vertex \"3\", but there are 16" },
    { MakeYard("[[[0,1,2]]]", "{\"surfaces\":[{\"type\":\"Roof\"}],\"values\":[1]}"),
      at + "semantics refer to surface 1, but there are 1; correct the index" },
    { MakeFile(MakeObject("yard", "LandUse", MakeGeometry("Solid", "1", "[[[0,1,2]]]"))),
      at + "a ring is 0, not a list of three vertices or more" } });
}

TEST_CASE("CityJSONErrors: templates", "[CityJSONErrors]")
{
  const std::string matrix = ",\"transformationMatrix\":[1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1]";
  const std::string three = "[[0,0,0],[1,0,0],[0,1,0]]";
  Check({ { MakeTree(",\"boundaries\":[1]", three),
            ":5: object \"tree\": transformationMatrix is null, not 16 numbers; correct it" },
    { MakeTree(matrix + ",\"boundaries\":[1,2]", three),
      ":5: object \"tree\": boundaries of a GeometryInstance are not the index of one vertex" },
    { MakeTree(matrix + ",\"boundaries\":[99]", three),
      ":5: object \"tree\": boundaries of a GeometryInstance are not the index" },
    { MakeTree(matrix + ",\"boundaries\":[1]", "7"),
      ":5: object \"tree\": vertices-templates are 7, not a list; write the file again" },
    { MakeTree(matrix + ",\"boundaries\":[1]", "[[0,0]]"),
      ":3: object \"tree\": vertex 0 of vertices-templates is a list of 2, not three numbers" },
    { MakeTree(",\"transformationMatrix\":[9,9,0,0,0,1,0,0,0,0,1,0,0,0,0,1],\"boundaries\":[1]",
        "[[1e308,1e308,0]]"),
      ":5: object \"tree\": transformationMatrix moves a vertex to infinity; correct it" },
    { MakeTree(matrix + ",\"boundaries\":[1]", "[[0,0,0]]"),
      ":3: object \"tree\": a ring refers to vertex 1, but there are 1" } });
}

TEST_CASE("CityJSONErrors: warnings", "[CityJSONErrors]")
{
  Reading outside("a.json", MakeYard("[[[0,1,2,3],[12,13,14]]]"));
  CHECK(outside.Read());
  CHECK(outside.Log->HasWarning(outside.Path +
    ":4: object \"yard\": the sides of the polygon cross, so its triangles may be wrong (1 such "
    "polygons in this file); correct it"));
  Reading empty("a.json", MakeFile(""));
  CHECK(empty.Read());
  CHECK(empty.Log->HasWarning(
    empty.Path + ": no triangles, so the scene is empty; add objects with surfaces"));
}

TEST_CASE("CityJSONErrors: memory is checked before it is needed", "[CityJSONErrors]")
{
  Reading reading("a.json", MakeHouse());
  vtkHeliosMemoryLimit::SetLimit(0.001);
  CHECK_FALSE(reading.Read());
  vtkHeliosMemoryLimit::SetLimit(0.0);
  CHECK(reading.Log->HasError("bytes of the file need about"));
}

TEST_CASE("CityJSONErrors: many copies of a template need memory", "[CityJSONErrors]")
{
  std::string surfaces = "[[0,1,2]]";
  std::string instances;
  const std::string instance = "{\"type\":\"GeometryInstance\",\"template\":0,\"boundaries\":[0],"
                               "\"transformationMatrix\":[1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1]}";
  for (int i = 0; i < 1000; ++i)
  {
    surfaces += ",[[0,1,2]]";
    instances += (i == 0 ? "" : ",") + (i < 256 ? instance : std::string("{}"));
  }
  Reading reading("a.json",
    MakeFile(MakeObject("tree", "CityFurniture", instances),
      "\"geometry-templates\":{\"templates\":[" +
        MakeGeometry("MultiSurface", "2", "[" + surfaces + "]") +
        "],\"vertices-templates\":[[0,0,0],[1,0,0],[0,1,0]]},\n"));
  vtkHeliosMemoryLimit::SetLimit(10.0 + vtkHeliosMemoryLimit::GetUsed());
  CHECK_FALSE(reading.Read());
  vtkHeliosMemoryLimit::SetLimit(0.0);
  CHECK(reading.Log->HasError(":5: object \"tree\": 255255 triangles of templates need about"));
}

TEST_CASE("CityJSONErrors: reading can be aborted", "[CityJSONErrors]")
{
  std::string objects;
  for (int i = 0; i < 300; ++i)
  {
    objects += (i == 0 ? "\"" : ",\"") + std::to_string(i) + "\":{\"type\":\"Road\"}";
  }
  Reading reading("a.json", MakeFile(objects));
  reading.Reader->AddObserver(
    vtkCommand::ProgressEvent, reading.Reader.Get(), &vtkHeliosCityJSONReader::AbortExecuteOn);
  CHECK_FALSE(reading.Read());
  CHECK(reading.Log->HasError(reading.Path + ": reading was aborted at object 256; update again"));
}
