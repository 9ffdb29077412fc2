// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Objects of city models as parts, and text sequences of features.
#include "heliosCityTesting.h"
#include "heliosSceneCrs.h"

#include <vtkFieldData.h>
#include <vtkIntArray.h>
#include <vtkStringArray.h>

#include <algorithm>
#include <map>
#include <string>
#include <vector>

using namespace helios::city;

namespace
{

/// The triangles of each part, by name; also of those without.
std::map<std::string, int> CountParts(Reading& reading)
{
  auto* ids = vtkIntArray::SafeDownCast(reading.Scene()->GetCellData()->GetArray("PartIds"));
  auto* given =
    vtkStringArray::SafeDownCast(reading.Scene()->GetFieldData()->GetAbstractArray("Part.Name"));
  REQUIRE(ids);
  REQUIRE(given);
  REQUIRE(ids->GetNumberOfValues() == reading.Triangles());
  std::map<std::string, int> counts;
  for (vtkIdType i = 0; i < given->GetNumberOfValues(); ++i)
  {
    counts[given->GetValue(i)] = 0;
  }
  for (vtkIdType i = 0; i < ids->GetNumberOfValues(); ++i)
  {
    ++counts[given->GetValue(ids->GetValue(i))];
  }
  return counts;
}

std::string MakeRoof(const std::string& boundaries)
{
  return MakeGeometry("MultiSurface", "2", boundaries);
}

const std::string Header =
  "{\"type\":\"CityJSON\",\"version\":\"2.0\",\"transform\":{\"scale\":[0.5,"
  "0.5,1],\"translate\":[1000,2000,3]},\"metadata\":{\"referenceSystem\":"
  "\"https://www.opengis.net/def/crs/EPSG/0/7415\"},\"geometry-templates\":"
  "{\"templates\":[{\"type\":\"MultiSurface\",\"lod\":\"2\",\"boundaries\":"
  "[[[0,1,2]]]}],\"vertices-templates\":[[0,0,0],[1,0,0],[0,1,0]]},"
  "\"CityObjects\":{},\"vertices\":[]}\n";

/// A line of a sequence: a square at x and a triangle.
std::string MakeFeature(const std::string& name, int x)
{
  const auto vertex = [](int a, int b)
  { return "[" + std::to_string(a) + "," + std::to_string(b) + ",0]"; };
  return "{\"type\":\"CityJSONFeature\",\"id\":\"" + name + "\",\"CityObjects\":{" +
    MakeObject(name, "Building", MakeRoof("[[[0,1,2,3]]]")) + "," +
    MakeObject(name + "-tree", "SolitaryVegetationObject",
      "{\"type\":\"GeometryInstance\",\"template\":0,\"boundaries\":[1],\"transformationMatrix\":["
      "1,"
      "0,0,0,0,1,0,0,0,0,1,0,0,0,0,1]}") +
    "},\"vertices\":[" + vertex(x, 0) + "," + vertex(x + 2, 0) + "," + vertex(x + 2, 2) + "," +
    vertex(x, 2) + "]}\n";
}

void CheckLines(const std::string& text, const std::string& message)
{
  Reading reading("a.city.jsonl", text);
  INFO(message);
  CHECK_FALSE(reading.Read());
  INFO("said: " << reading.Log->Errors);
  CHECK(reading.Log->HasError(reading.Path + message));
}

} // namespace

TEST_CASE("CityJSONParts: every object with triangles is a part with its id", "[CityJSONParts]")
{
  Reading reading("a.city.json",
    MakeFile(MakeObject("NL.IMBAG.Pand.1", "Building", MakeRoof("[[[4,5,6,7]],[[0,1,2]]]")) + "," +
      MakeObject("bare", "Building", "") + "," +
      MakeObject("yard", "LandUse", MakeRoof("[[[12,13,14,15],[0,1,2,3]]]"))));
  REQUIRE(reading.Read());
  CHECK(
    CountParts(reading) == std::map<std::string, int>{ { "NL.IMBAG.Pand.1", 3 }, { "yard", 8 } });
}

TEST_CASE("CityJSONParts: a triangle without area leaves the others their part", "[CityJSONParts]")
{
  Reading reading("a.city.json",
    MakeFile(MakeObject("a", "Building", MakeRoof("[[[0,1,0]],[[4,5,6]],[[0,1,1]]]")) + "," +
      MakeObject("b", "Building", MakeRoof("[[[4,5,6,7]]]"))));
  REQUIRE(reading.Read());
  CHECK(CountParts(reading) == std::map<std::string, int>{ { "a", 1 }, { "b", 2 } });
}

TEST_CASE("CityJSONParts: a sequence has its metadata in the first line", "[CityJSONParts]")
{
  Reading reading(
    "a.city.jsonl", Header + "\n" + MakeFeature("one", 0) + MakeFeature("two", 100) + "\n");
  REQUIRE(reading.Read());
  CHECK(reading.Log->Warnings.empty());
  CHECK(CountParts(reading) ==
    std::map<std::string, int>{ { "one", 2 }, { "one-tree", 1 }, { "two", 2 }, { "two-tree", 1 } });
  CHECK(reading.Area("Building") == Approx(2.0));
  CHECK(reading.Area("SolitaryVegetationObject") == Approx(1.0));
  CHECK(reading.Corner(0, 0) == helios::Vec3(1000, 2000, 3));
  CHECK(reading.Corner(3, 0) == helios::Vec3(1050, 2000, 3)); // with the vertices of its own line
  CHECK(reading.Corner(5, 0) == helios::Vec3(1051, 2000, 3));
  CHECK(helios::GetCRS(reading.Scene()) == "EPSG:7415");
}

TEST_CASE("CityJSONParts: a sequence of the first line alone is a whole city", "[CityJSONParts]")
{
  std::string text = MakeHouse();
  text.erase(std::remove(text.begin(), text.end(), '\n'), text.end());
  Reading reading("a.city.jsonl", text);
  REQUIRE(reading.Read());
  CHECK(CountParts(reading).size() == 2);
}

TEST_CASE("CityJSONParts: errors of sequences name the line", "[CityJSONParts]")
{
  CheckLines("", ": is empty; its first line must be the metadata, of type \"CityJSON\"");
  CheckLines("\n\n", ": is empty; its first line must be the metadata");
  CheckLines(Header + MakeFeature("a", 0) + "{\"type\":\n", ":3: is not valid JSON at column 9: ");
  CheckLines(MakeFeature("a", 0),
    ":1: type is \"CityJSONFeature\", not \"CityJSON\"; give a file of CityJSON, or a text "
    "sequence "
    "(.city.jsonl) whose first line is the metadata");
  CheckLines(Header + MakeFeature("a", 0) + Header,
    ":3: type is \"CityJSON\", not \"CityJSONFeature\"; only the first line is the metadata: write "
    "the file again");
  std::string bad = MakeFeature("b", 0);
  bad.replace(bad.find("[[[0,1,2,3]]]"), 13, "[[[0,1,2,7]]]");
  CheckLines(Header + MakeFeature("a", 0) + bad,
    ":3: object \"b\": a ring refers to vertex 7, but there are 4, counted from 0; correct the "
    "index");
  std::string text = Header;
  text.replace(text.find("[[[0,1,2]]]"), 11, "[[[0,1,5]]]");
  CheckLines(text + MakeFeature("a", 0), ":1: object \"a-tree\": a ring refers to vertex 5");
  bad = MakeFeature("b", 0);
  bad.replace(bad.find("\"vertices\""), 10, "\"points\"");
  CheckLines(Header + bad, ":2: vertices are null, not a list of at most ");
}
