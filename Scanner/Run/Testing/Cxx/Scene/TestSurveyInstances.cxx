// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Parts of the same mesh become instances; a run is the same as with copies.
#include "heliosSurveyFiles.h"
#include "heliosSurveyPlaying.h"
#include "vtkHeliosRunOptions.h"
#include "vtkHeliosScene.h"
#include "vtkHeliosSurvey.h"
#include "vtkHeliosSurveyPlayer.h"
#include "vtkHeliosSurveySource.h"

#include <catch2/catch.hpp>

#include <string>

using namespace helios::test;

namespace
{

std::string MakePart(const std::string& id, const std::string& file, const std::string& filters)
{
  return "<part id=\"" + id +
    "\"><filter type=\"objloader\"><param type=\"string\" key=\"filepath\" value=\"" + file +
    "\"/></filter>" + filters + "</part>\n";
}

std::string MakePlace(
  double x, double y, double yaw, double scale, bool onGround, const char* axis = "z")
{
  std::ostringstream text;
  text.precision(17);
  text << "<filter type=\"rotate\"><param key=\"rotation\" type=\"rotation\"><rot axis=\"" << axis
       << "\" angle_deg=\"" << yaw << "\"/></param></filter>"
       << "<filter type=\"scale\"><param type=\"double\" key=\"scale\" value=\"" << scale
       << "\"/></filter>"
       << "<filter type=\"translate\"><param type=\"vec3\" key=\"offset\" value=\"" << x << ";" << y
       << ";0\"/>" << (onGround ? "<param type=\"integer\" key=\"onGround\" value=\"1\"/>" : "")
       << "</filter>";
  return text.str();
}

/// A hill with five trees, three of them on the ground, one of these tilted, and a house.
void WriteScene(const Files& files, const std::string& more = "")
{
  files.Write("a.mtl", "newmtl earth\nhelios_isGround true\nnewmtl leaf\nhelios_reflectance 0.3\n");
  files.Write("hill.obj",
    "mtllib a.mtl\nusemtl earth\nv -50 -50 -4\nv 50 -50 2\nv 50 50 3\nv -50 50 -5\nf 1 2 3\nf 1 3 "
    "4\n");
  files.Write("tree.obj",
    "mtllib a.mtl\nusemtl leaf\nv -1 0 0.5\nv 1 0 0\nv 0 0.5 6\nv 0 -1 1\nv 0.2 1 2\nv 0.1 0 5\n"
    "f 1 2 3\nf 4 5 6\nf 1 5 3\n");
  files.Write("house.obj", "v -3 12 -3\nv 3 12 -3\nv 3 12 7\nv -3 12 7\nf 1 2 3 4\n");
  files.Write("scene.xml",
    "<document><scene id=\"s\">\n" + MakePart("hill", "hill.obj", "") +
      MakePart("t0", "tree.obj", MakePlace(4, 9, 30, 1.5, true)) +
      MakePart("t1", "tree.obj", MakePlace(-4, 8, 75, 0.8, true)) +
      MakePart("house", "house.obj", "") +
      MakePart("t2", "tree.obj", MakePlace(8, 12, 200, 1, false)) +
      MakePart("t3", "tree.obj", MakePlace(-7, 14, 160, 2, true, "x")) +
      MakePart("t4", "tree.obj", MakePlace(0, 7, 10, 1, false)) + more + "</scene></document>");
}

constexpr const char* Leg = R"(<leg><platformSettings onGround="true"/>
<scannerSettings scanFreq_hz="100" headRotatePerSec_deg="60" headRotateStart_deg="-40"
 headRotateStop_deg="40"/></leg>)";

} // namespace

TEST_CASE("SurveyInstances: files are those of copies", "[SurveyInstances]")
{
  const Files files;
  WriteScene(files);
  const Reading reading(files, Tripod, Leg);
  INFO(reading.Log->Errors);
  REQUIRE(reading.Good);
  std::string points[2];
  for (const bool areInstances : { false, true })
  {
    Playing playing(files, reading);
    playing.Player->SetOverwrite(true);
    playing.Player->GetSource()->SetInstances(areInstances);
    playing.Player->GetOptions()->SetNumberOfSubRays(19);
    REQUIRE(playing.Player->Run());
    auto* scene = vtkHeliosScene::SafeDownCast(playing.Player->GetSource()->GetScene());
    REQUIRE((scene != nullptr) == areInstances);
    if (scene)
    {
      CHECK(scene->GetNumberOfInstances() == 5);
      CHECK(scene->GetNumberOfPrototypes() == 1);
      CHECK(scene->GetNumberOfPolys() == 4);
      CHECK(scene->GetNumberOfTriangles() == 19);
    }
    points[areInstances] = ReadText(files / "out/test/leg000_points.xyz");
  }
  CHECK(points[0].size() > 100000);
  CHECK((points[0] == points[1]));
  for (const char* part : { " hill ", " t0 ", " t1 ", " house ", " t2 ", " t3 ", " t4 " })
  {
    INFO(part);
    CHECK(points[1].find(part) != std::string::npos);
  }
}

TEST_CASE("SurveyInstances: they are resumed", "[SurveyInstances]")
{
  const Files files;
  WriteScene(files);
  const Reading reading(files, Tripod, Leg);
  REQUIRE(reading.Good);
  Playing playing(files, reading);
  REQUIRE(playing.Player->Run());
  playing.Player->SetResume(true);
  CHECK(playing.Player->Run()); // complete: the scene has the same digest
}

TEST_CASE("SurveyInstances: parts that move are instances, too", "[SurveyInstances]")
{
  const std::string motion =
    "<dmotion id=\"all\" loop=\"0\"><motion type=\"translation\" vec=\"0.01;0;0\"/></dmotion>";
  const Files files;
  WriteScene(files,
    MakePart("car", "house.obj", motion) +
      MakePart("t5", "tree.obj", MakePlace(3, 8, 20, 1, true) + motion));
  files.Replace("scene.xml", "<scene id=\"s\"", "<scene id=\"s\" dynTimeStep=\"0.05\"");
  const Reading reading(files, Tripod, Leg);
  INFO(reading.Log->Errors);
  REQUIRE(reading.Good);
  std::string points[2];
  for (const bool areInstances : { false, true })
  {
    Playing playing(files, reading);
    playing.Player->SetOverwrite(true);
    playing.Player->GetSource()->SetInstances(areInstances);
    playing.Player->GetOptions()->SetNumberOfSubRays(19);
    REQUIRE(playing.Player->Run());
    auto* scene = vtkHeliosScene::SafeDownCast(playing.Player->GetSource()->GetScene());
    REQUIRE((scene != nullptr) == areInstances);
    if (scene)
    {
      CHECK(scene->GetNumberOfInstances() == 5 + 3); // house and car, and t5 of the trees
      CHECK(scene->GetNumberOfPolys() == 2);         // hill
    }
    points[areInstances] = ReadText(files / "out/test/leg000_points.xyz");
  }
  CHECK(points[0].size() > 100000);
  CHECK((points[0] == points[1]));
  for (const char* part : { " t0 ", " t1 ", " t5 ", " car ", " house " })
  {
    INFO(part);
    CHECK(points[1].find(part) != std::string::npos);
  }
}

TEST_CASE(
  "SurveyInstances: meshes that differ before they are placed are apart", "[SurveyInstances]")
{
  const Files files;
  const auto add = [](const std::string& id, const std::string& param, const std::string& filter)
  {
    return "<part id=\"" + id +
      "\"><filter type=\"objloader\"><param type=\"string\" key=\"filepath\" "
      "value=\"tree.obj\"/>" +
      param + "</filter>" + filter + "</part>\n";
  };
  const std::string up = "<param type=\"string\" key=\"up\" value=\"y\"/>";
  WriteScene(files,
    add("lying", up, "") + add("lying too", up, "") +
      add("repaired", "", "<filter type=\"repair\"/>"));
  const Reading reading(files, Tripod, Leg);
  INFO(reading.Log->Errors);
  REQUIRE(reading.Good);
  vtkNew<vtkHeliosSurveySource> source;
  source->SetSurvey(reading.Reader->GetSurvey());
  source->InstancesOn();
  REQUIRE(source->Load());
  auto* scene = vtkHeliosScene::SafeDownCast(source->GetScene());
  REQUIRE(scene);
  CHECK(scene->GetNumberOfInstances() == 7); // five trees, two lying
  CHECK(scene->GetNumberOfPrototypes() == 2);
  CHECK(scene->GetNumberOfPolys() == 4 + 3); // hill, house, repaired
}

TEST_CASE("SurveyInstances: meshes reprojected in different ways are apart", "[SurveyInstances]")
{
  const Files files;
  files.Write("roof.obj", "v 984000 200000 0\nv 984009 200000 9\nv 984000 200009 9\nf 1 2 3\n");
  const auto add = [](const std::string& id, const std::string& more)
  {
    return MakePart(id, "roof.obj",
      R"(<filter type="crs"><param key="source" value="EPSG:2263"/>
<param key="target" value="EPSG:32618"/>)" +
        more + "</filter>");
  };
  const std::string metres = R"(<param key="heightUnit" value="1"/>)";
  const std::string year = R"(<param key="epoch" value="2020"/>)";
  WriteScene(
    files, add("feet", "") + add("metres", metres) + add("metres too", metres) + add("2020", year));
  const Reading reading(files, Tripod, Leg);
  INFO(reading.Log->Errors);
  REQUIRE(reading.Good);
  vtkNew<vtkHeliosSurveySource> source;
  source->SetSurvey(reading.Reader->GetSurvey());
  source->InstancesOn();
  REQUIRE(source->Load());
  auto* scene = vtkHeliosScene::SafeDownCast(source->GetScene());
  REQUIRE(scene);
  CHECK(scene->GetNumberOfInstances() == 5 + 2); // trees, in metres
  CHECK(scene->GetNumberOfPrototypes() == 2);
  CHECK(scene->GetNumberOfPolys() == 4 + 2); // hill, house, in feet, of 2020
}

TEST_CASE("SurveyInstances: parts of the same PLY, STL, CityJSON or glTF file", "[SurveyInstances]")
{
  const Files files;
  files.Write("a.ply",
    "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float "
    "z\n"
    "element face 1\nproperty list uchar int vertex_indices\nend_header\n0 0 0\n1 0 0\n0 1 0\n"
    "3 0 1 2\n");
  files.Write("a.stl",
    "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\n"
    "endfacet\nendsolid a\n");
  const std::string surface = "\"type\":\"MultiSurface\",\"boundaries\":[[[0,1,2]]]}";
  files.Write("a.city.json",
    "{\"type\":\"CityJSON\",\"version\":\"2.0\",\"transform\":{\"scale\":[1,1,1],"
    "\"translate\":[0,0,0]},\"CityObjects\":{\"a\":{\"type\":\"Road\",\"geometry\":[{\"lod\":"
    "\"1\"," +
      surface + ",{\"lod\":\"2\"," + surface + "]}},\"vertices\":[[0,0,0],[1,0,0],[0,1,0]]}");
  files.Write("a.gltf",
    "{\"asset\":{\"version\":\"2.0\"},\"nodes\":[{\"mesh\":0}],\"meshes\":[{\"primitives\":[{"
    "\"attributes\":{\"POSITION\":0}}]}],\"accessors\":[{\"bufferView\":0,\"componentType\":5121,"
    "\"count\":3,\"type\":\"VEC3\"}],\"bufferViews\":[{\"buffer\":0,\"byteLength\":9}],\"buffers\":"
    "[{\"byteLength\":9,\"uri\":\"data:;base64,AAAAAQAAAAEA\"}]}");
  const auto add = [](const std::string& loader, const std::string& file, const std::string& more)
  {
    return "<part><filter type=\"" + loader + "\"><param key=\"filepath\" value=\"" + file +
      "\"/>" + more + "</filter></part>\n";
  };
  std::string parts;
  for (int i = 0; i < 2; ++i)
  {
    parts += add("plyloader", "a.ply", "") + add("stlloader", "a.stl", "") +
      add("gltfloader", "a.gltf", "") +
      add("cityjsonloader", "a.city.json", "<param key=\"lod\" value=\"1\"/>");
  }
  parts += add("cityjsonloader", "a.city.json", "<param key=\"lod\" value=\"2\"/>");
  files.Write("scene.xml", "<document><scene id=\"s\">" + parts + "</scene></document>");
  const Reading reading(files, Tripod, Leg);
  INFO(reading.Log->Errors);
  REQUIRE(reading.Good);
  vtkNew<vtkHeliosSurveySource> source;
  source->SetSurvey(reading.Reader->GetSurvey());
  source->InstancesOn();
  REQUIRE(source->Load());
  auto* scene = vtkHeliosScene::SafeDownCast(source->GetScene());
  REQUIRE(scene);
  CHECK(scene->GetNumberOfInstances() == 8);
  CHECK(scene->GetNumberOfPrototypes() == 4);
  CHECK(scene->GetNumberOfPolys() == 1); // the other level of detail
}

TEST_CASE("SurveyInstances: the digest of a scene has the instances", "[SurveyInstances]")
{
  const Files files;
  const auto getDigest = [&files](double x, double corner)
  {
    WriteScene(files, MakePart("t5", "tree.obj", MakePlace(x, 11, 0, 1, false)));
    std::string tree = ReadText(files / "tree.obj");
    const std::size_t at = tree.find("0.2 1 2");
    files.Write("tree.obj", tree.replace(at, 3, std::to_string(corner)));
    const Reading reading(files, Tripod, Leg);
    REQUIRE(reading.Good);
    Playing playing(files, reading);
    playing.Player->SetOverwrite(true);
    REQUIRE(playing.Player->Run());
    const std::string report = playing.Player->GetReport();
    const std::size_t found = report.find("\"scene\"");
    REQUIRE(found != std::string::npos);
    return report.substr(found, 90);
  };
  const std::string first = getDigest(11.0, 0.2);
  INFO(first);
  CHECK(getDigest(11.0, 0.2) == first);
  CHECK(getDigest(11.0 + 1e-9, 0.2) != first); // an instance
  CHECK(getDigest(11.0, 0.3) != first);        // the prototype
}

TEST_CASE("SurveyInstances: a source makes them only if asked", "[SurveyInstances]")
{
  const Files files;
  WriteScene(files);
  const Reading reading(files, Tripod, Leg);
  REQUIRE(reading.Good);
  vtkNew<vtkHeliosSurveySource> source;
  source->SetSurvey(reading.Reader->GetSurvey());
  REQUIRE(source->Load());
  CHECK(source->GetScene()->GetNumberOfPolys() == 19);
  source->InstancesOn();
  REQUIRE(source->Load());
  CHECK(source->GetScene()->GetNumberOfPolys() == 4);
}
