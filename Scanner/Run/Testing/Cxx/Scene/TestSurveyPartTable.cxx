// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Parts from a table are those that are written out.
#include "heliosLowestCorners.h"
#include "heliosPartTable.h"
#include "heliosSha256.h"
#include "heliosSurveyFiles.h"
#include "heliosSurveyPlaying.h"
#include "vtkHeliosRunOptions.h"
#include "vtkHeliosScene.h"
#include "vtkHeliosSurvey.h"
#include "vtkHeliosSurveyPlayer.h"
#include "vtkHeliosSurveySource.h"

#include <vtkPolyData.h>
#include <vtkSphereSource.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

using namespace helios;
using namespace helios::test;

namespace
{

std::string MakeLoader(const std::string& file)
{
  return "<filter type=\"objloader\"><param type=\"string\" key=\"filepath\" value=\"" + file +
    "\"/></filter>";
}

std::string MakePart(const std::string& id, const std::string& file, const std::string& filters,
  const std::string& attributes = "")
{
  return "<part id=\"" + id + "\"" + attributes + ">" + MakeLoader(file) + filters + "</part>\n";
}

std::string MakePlace(const std::string& yaw, const std::string& scale, const std::string& offset,
  bool onGround, const std::string& before = "")
{
  return before + "<filter type=\"rotate\"><param key=\"rotation\" type=\"rotation\">" +
    "<rot axis=\"z\" angle_deg=\"" + yaw + "\"/></param></filter>" +
    "<filter type=\"scale\"><param type=\"double\" key=\"scale\" value=\"" + scale +
    "\"/></filter><filter type=\"translate\"><param type=\"vec3\" key=\"offset\" value=\"" +
    offset + "\"/>" + (onGround ? "<param type=\"integer\" key=\"onGround\" value=\"1\"/>" : "") +
    "</filter>";
}

/// A hill, the files of two trees, and what a scene has besides.
void WriteScene(const Files& files, const std::string& more)
{
  files.Write("a.mtl", "newmtl earth\nhelios_isGround true\nnewmtl leaf\nhelios_reflectance 0.3\n");
  files.Write("hill.obj",
    "mtllib a.mtl\nusemtl earth\nv -50 -50 -4\nv 50 -50 2\nv 50 50 3\nv -50 50 -5\nf 1 2 3\nf 1 3 "
    "4\n");
  files.Write("oak.obj",
    "mtllib a.mtl\nusemtl leaf\nv -1 0 0.5\nv 1 0 0\nv 0 0.5 6\nv 0 -1 1\nv 0.2 1 2\nv 0.1 0 5\n"
    "f 1 2 3\nf 4 5 6\nf 1 5 3\n");
  files.Write("fir.obj", "v -1 0 0\nv 1 0 0\nv 0 0 7\nv 0 -1 0\nv 0 1 0\nf 1 2 3\nf 4 5 3\n");
  files.Write("scene.xml",
    "<document><scene id=\"s\">\n" + MakePart("hill", "hill.obj", "") + more +
      "</scene></document>");
}

/// A table with the file stand.csv.
std::string MakeTable(const std::string& models, const std::string& attributes = "")
{
  return "<partTable file=\"stand.csv\"" + attributes + ">" + models + "</partTable>";
}

const std::string Models = "<model id=\"oak\">" + MakeLoader("oak.obj") +
  "</model>\n<model id=\"fir\" classification=\"5\">" + MakeLoader("fir.obj") + "</model>";

constexpr const char* Leg = R"(<leg><platformSettings onGround="true"/>
<scannerSettings scanFreq_hz="100" headRotatePerSec_deg="60" headRotateStart_deg="-40"
 headRotateStop_deg="40"/></leg>)";

/// The SHA-256 of the cloud of a run, which is text.
std::string Scan(const Files& files, bool areInstances)
{
  const Reading reading(files, Tripod, Leg);
  INFO(reading.Log->Errors);
  REQUIRE(reading.Good);
  Playing playing(files, reading);
  playing.Player->SetOverwrite(true);
  playing.Player->GetSource()->SetInstances(areInstances);
  playing.Player->GetOptions()->SetNumberOfSubRays(19);
  INFO(playing.Log->Errors);
  REQUIRE(playing.Player->Run());
  CHECK((vtkHeliosScene::SafeDownCast(playing.Player->GetSource()->GetScene()) != nullptr) ==
    areInstances);
  return HashFile(files / "out/test/leg000_points.xyz");
}

/// The parts of a scene with a table of rows.
std::vector<PartData> ReadParts(
  const Files& files, const std::string& rows, const std::string& table)
{
  files.Write("stand.csv", rows);
  WriteScene(files, table);
  const Reading reading(files, Tripod, Leg);
  INFO(reading.Log->Errors);
  REQUIRE(reading.Good);
  return reading.Data().Scene.Parts;
}

void CheckRefused(
  const std::string& rows, const std::string& table, const std::vector<std::string>& messages)
{
  const Files files;
  files.Write("stand.csv", rows);
  WriteScene(files, table);
  const Reading reading(files, Tripod, Leg);
  INFO(rows << table << '\n' << reading.Log->Errors);
  CHECK_FALSE(reading.Good);
  for (const std::string& message : messages)
  {
    INFO("missing: " << message);
    CHECK(reading.Log->HasError(message));
  }
}

} // namespace

TEST_CASE("SurveyPartTable: a run is that of the parts written out", "[SurveyPartTable]")
{
  const Files files;
  files.Write("stand.csv",
    "# a stand\nmodel,x,y,z,yaw_deg,scale,id,classification\r\noak,4,9,,30,1.5,,\n"
    "oak , -4 ,8, ,75,0.8,t1,17\n\nfir,8,12,1.25,200,1,t2,\nfir.obj,-7,14,,160,0.6,t3,\n"
    "\"oak\",0,7,0.5,10,1,\"t \"\"4\"\"\",17\n");
  const std::string tilt =
    "<filter type=\"rotate\"><param key=\"rotation\" type=\"rotation\"><rot axis=\"x\" "
    "angle_deg=\"20\"/></param></filter>";
  const std::string models = "<model id=\"oak\">" + MakeLoader("oak.obj") + tilt +
    "</model><model id=\"fir\" classification=\"5\">" + MakeLoader("fir.obj") + "</model>";
  WriteScene(files, MakeTable(models));
  const std::string table[] = { Scan(files, false), Scan(files, true) };
  const std::string points = ReadText(files / "out/test/leg000_points.xyz");
  const std::string seventeen = " classification=\"17\"";
  WriteScene(files,
    MakePart("1", "oak.obj", MakePlace("30", "1.5", "4;9;0", true, tilt)) +
      MakePart("t1", "oak.obj", MakePlace("75", "0.8", "-4;8;0", true, tilt), seventeen) +
      MakePart(
        "t2", "fir.obj", MakePlace("200", "1", "8;12;1.25", false), " classification=\"5\"") +
      MakePart("t3", "fir.obj", MakePlace("160", "0.6", "-7;14;0", true)) +
      MakePart(
        "t &quot;4&quot;", "oak.obj", MakePlace("10", "1", "0;7;0.5", false, tilt), seventeen));
  CHECK(table[0] == table[1]);
  CHECK(table[0] == Scan(files, false));
  CHECK(table[0] == Scan(files, true));
  CHECK(points == ReadText(files / "out/test/leg000_points.xyz"));
  std::map<std::string, std::set<long long>> classes;
  for (const Point& point : ReadPoints(files / "out/test/leg000_points.xyz"))
  {
    classes[point.Part].insert(point.Classification);
  }
  using Classes = std::set<long long>;
  CHECK(classes["1"] == Classes{ 0 });
  CHECK(classes["t1"] == Classes{ 17 });
  CHECK(classes["t2"] == Classes{ 5 });
  CHECK(classes["t3"] == Classes{ 0 });
}

TEST_CASE("SurveyPartTable: rows rotate, scale and move what a model is", "[SurveyPartTable]")
{
  const Files files;
  const std::string model =
    "<model id=\"oak\">" + MakeLoader("oak.obj") + MakePlace("90", "2", "1;0;3", true) + "</model>";
  const auto parts =
    ReadParts(files, "x,y,z,yaw_deg,scale\n10,20,30,90,3\n5,6,,0,1\n", MakeTable(model));
  REQUIRE(parts.size() == 3);
  CHECK(parts[1].Scale == 6.0);
  CHECK(parts[1].Translation[0] == Approx(10.0));
  CHECK(parts[1].Translation[1] == Approx(20.0 + 3.0));
  CHECK(parts[1].Translation[2] == Approx(30.0 + 9.0));
  CHECK(Rotate(parts[1].Rotation, { 1, 0, 0 })[0] == Approx(-1.0));
  CHECK_FALSE(parts[1].OnGround);
  CHECK(parts[2].OnGround);
  CHECK(parts[2].Scale == 2.0);
  CHECK(parts[1].Where == files / "stand.csv:2");
  CHECK(parts[1].Name == "1");
}

TEST_CASE("SurveyPartTable: what rows leave out is random", "[SurveyPartTable]")
{
  const Files files;
  std::string rows = "x;y;yaw_deg;dbh\n";
  constexpr int Count = 20000;
  for (int i = 0; i < Count; ++i)
  {
    rows += std::to_string(i) + ";1;" + (i == 7 ? "12" : "") + ";30\n";
  }
  const std::string ranges =
    " seed=\"3\" yawMin_deg=\"-90\" yawMax_deg=\"270\" scaleMin=\"0.8\" scaleMax=\"1.2\"";
  const std::string shares = "<model id=\"oak\" share=\"3\">" + MakeLoader("oak.obj") +
    "</model><model id=\"none\" share=\"0\">" + MakeLoader("oak.obj") +
    "</model><model id=\"fir\">" + MakeLoader("fir.obj") + "</model>";
  const auto parts = ReadParts(files, rows, MakeTable(shares, ranges));
  REQUIRE(parts.size() == 1 + Count);
  int oaks = 0;
  int turnedOaks = 0;
  int largeAhead = 0;
  double turned = 0.0;
  double scale = 0.0;
  double lowest = 2.0;
  double highest = 0.0;
  for (int i = 1; i <= Count; ++i)
  {
    const bool isOak = parts[i].Files.front() == files / "oak.obj";
    const bool isTurned = Rotate(parts[i].Rotation, { 1, 0, 0 })[1] > 0.0;
    oaks += isOak;
    turned += isTurned;
    turnedOaks += isOak && isTurned;
    largeAhead += parts[i].Scale > 1.0 && Rotate(parts[i].Rotation, { 1, 0, 0 })[0] > 0.0;
    scale += parts[i].Scale;
    lowest = std::min(lowest, parts[i].Scale);
    highest = std::max(highest, parts[i].Scale);
  }
  // Five standard deviations of the binomial and of the uniform distribution.
  CHECK(std::abs(oaks - 0.75 * Count) < 5.0 * std::sqrt(0.75 * 0.25 * Count));
  CHECK(std::abs(turned - 0.5 * Count) < 5.0 * std::sqrt(0.25 * Count));
  CHECK(std::abs(turnedOaks - 0.375 * Count) < 5.0 * std::sqrt(0.375 * 0.625 * Count));
  CHECK(std::abs(largeAhead - 0.25 * Count) < 5.0 * std::sqrt(0.25 * 0.75 * Count));
  CHECK(std::abs(scale / Count - 1.0) < 5.0 * 0.4 / std::sqrt(12.0 * Count));
  CHECK((lowest >= 0.8 && lowest < 0.801));
  CHECK((highest <= 1.2 && highest > 1.199));
  CHECK(Rotate(parts[8].Rotation, { 1, 0, 0 })[1] == Approx(std::sin(12 * 3.14159265358979 / 180)));

  const auto again = ReadParts(files, rows, MakeTable(shares, ranges));
  const auto other =
    ReadParts(files, rows, MakeTable(shares, " seed=\"4\" scaleMin=\"0.8\" scaleMax=\"1.2\""));
  CHECK(again[100].Scale == parts[100].Scale);
  CHECK(again[100].Rotation[0] == parts[100].Rotation[0]);
  CHECK(other[100].Scale != parts[100].Scale);
  CHECK(other[100].Rotation[0] == 1.0); // without a range
}

TEST_CASE("SurveyPartTable: rows are also elements", "[SurveyPartTable]")
{
  const Files files;
  const auto parts = ReadParts(files, "",
    "<partTable>" + Models +
      "<row model=\"fir\" x=\"1\" y=\"2\" z=\"3\" id=\"a\"/>"
      "<row model=\"oak.obj\" x=\"4\" y=\"5\" classification=\"9\"/></partTable>");
  REQUIRE(parts.size() == 3);
  CHECK(parts[1].Name == "a");
  CHECK(parts[1].Classification == 5);
  CHECK(parts[1].Translation[2] == 3.0);
  CHECK(parts[2].Name == "2");
  CHECK(parts[2].Classification == 9);
  CHECK(parts[2].OnGround);
  CHECK(parts[2].Where == files / "scene.xml:4:174");
}

TEST_CASE("SurveyPartTable: a table alone has no ground", "[SurveyPartTable]")
{
  const Files files;
  WriteScene(files, "");
  files.Write("stand.csv", "model,x,y,z\noak.obj,1,8,0\n");
  files.Write("scene.xml", "<document><scene id=\"s\">" + MakeTable("") + "</scene></document>");
  const Reading reading(files, Tripod, OneLeg);
  INFO(reading.Log->Errors);
  CHECK(reading.Good);
  files.Write("stand.csv", "model,x,y\noak.obj,1,8\n");
  const Reading onGround(files, Tripod, OneLeg);
  REQUIRE(onGround.Good);
  Playing(files, onGround).CheckFails({ "every part has onGround, so no part is the ground" });
}

TEST_CASE("SurveyPartTable: rows beside the ground name their lines", "[SurveyPartTable]")
{
  const Files files;
  WriteScene(files, MakeTable(Models));
  std::string rows = "model,x,y\n";
  for (int i = 0; i < 100; ++i)
  {
    rows += "oak," + std::string(i == 60 ? "400" : "4") + ",8\n";
  }
  files.Write("stand.csv", rows);
  const Reading reading(files, Tripod, Leg);
  REQUIRE(reading.Good);
  Playing playing(files, reading);
  playing.CheckFails(
    { "stand.csv:62: part 61 is on the ground, but there is no ground above or "
      "below its lowest corner at x 401, y 8; move the part, or give its height" });
  CHECK(playing.Log->Errors.size() < 1000);
}

TEST_CASE("SurveyPartTable: tables that are not valid", "[SurveyPartTable]")
{
  const std::string table = MakeTable(Models);
  CheckRefused("", table, { "stand.csv: the table has no rows; give a file with a line" });
  CheckRefused("model,x,y\n", table, { "stand.csv: the table has no rows" });
  CheckRefused("model,x\noak,1\n", table,
    { "stand.csv:1: there is no column y; add it, the place of the part [m]" });
  CheckRefused("model,x,y,x\noak,1,2,3\n", table, { "stand.csv:1: there are two columns x" });
  CheckRefused("model,x,y\noak,1,2\noak,1\n", table,
    { "stand.csv:3: a row of 2 columns, and the first has 3 names" });
  CheckRefused("model,x,y\noak,,2\n", table,
    { "stand.csv:2: column x is empty; give it, the place of the part [m]" });
  CheckRefused("model;x;y\noak;1,5;2\n", table, { "stand.csv:2: x=\"1,5\" is not a number" });
  CheckRefused(
    "model,x,y,scale\noak,1,2,0\n", table, { "stand.csv:2: scale=\"0\" is out of range" });
  CheckRefused("model,x,y,classification\noak,1,2,256\n", table,
    { "stand.csv:2: classification=\"256\" is out of range" });
  CheckRefused("model,x,y\noak,1,2\nelm,1,2\n", table,
    { "stand.csv:3: model=\"elm\" is neither a <model> of the table nor a file with a mesh; the "
      "models are oak and fir" });
  CheckRefused("model,x,y\nstand.csv,1,2\n", MakeTable(""),
    { "stand.csv:2: model=\"stand.csv\" is neither", "add a <model>, or give the name of a file" });
  CheckRefused("x,y\n1,2\n", MakeTable(""),
    { "stand.csv:2: model is not given, and the table has no <model> to choose from; give" });
  CheckRefused("x,y\n1,2\n",
    MakeTable("<model id=\"a\" share=\"0\">" + MakeLoader("oak.obj") + "</model>"),
    { "stand.csv:2: model is not given" });
  CheckRefused("x,y\n1,2\n", MakeTable("<model>" + MakeLoader("oak.obj") + "</model>"),
    { "scene.xml:3: <model> has no id; give the name" });
  CheckRefused("x,y\n1,2\n", MakeTable(Models + Models),
    { "a second <model id=\"oak\"> in one <partTable>; give each an id of its own" });
  CheckRefused("x,y\n1,2\n", MakeTable("<model id=\"a\"/>"), { "<model> has no loader; add a" });
  CheckRefused("x,y\n1,2\n", MakeTable(Models, " yawMin_deg=\"9\" yawMax_deg=\"8\""),
    { "scene.xml:3: yawMin_deg=\"9\" is above yawMax_deg=\"8\"; exchange them" });
  CheckRefused("x,y\n1,2\n", MakeTable(Models, " scaleMin=\"2\""),
    { "scene.xml:3: scaleMin=\"2\" is above scaleMax=\"1\"; exchange them" });
  CheckRefused("x,y\n1,2\n", MakeTable(Models + "<row x=\"1\" y=\"2\"/>"),
    { "<partTable> has a file and <row> children; give one of them" });
  CheckRefused("", "<partTable>" + Models + "<row x=\"1\"/></partTable>",
    { "<row> has no y; give the place of the part [m]" });
  CheckRefused("", "<partTable>" + Models + "</partTable>", { "the table has no rows" });
  CheckRefused("", "<partTable file=\"none.csv\">" + Models + "</partTable>",
    { "scene.xml:3: file=\"none.csv\": no such file; looked for" });
}

TEST_CASE("SurveyPartTable: other columns are not used", "[SurveyPartTable]")
{
  const Files files;
  files.Write("stand.csv", "x\ty\tY\tcrown\tmodel\n1\t2\t3\tQuercus robur\toak\n");
  WriteScene(files, MakeTable(Models));
  const Reading reading(files, Tripod, Leg);
  INFO(reading.Log->Errors);
  CHECK(reading.Good);
  CHECK(reading.Data().Scene.Parts.size() == 2);
  CHECK(reading.Log->HasWarning(
    "stand.csv:1: column \"crown\" is unknown and not used; the columns are model, x, y, z"));
  CHECK(reading.Log->HasWarning("column \"Y\" is unknown and not used; did you mean y?"));
}

TEST_CASE("SurveyPartTable: a changed table is not resumed", "[SurveyPartTable]")
{
  const Files files;
  files.Write("stand.csv", "model,x,y\noak,4,9\n");
  WriteScene(files, MakeTable(Models));
  const Reading reading(files, Tripod, Leg);
  REQUIRE(reading.Good);
  Playing playing(files, reading);
  REQUIRE(playing.Player->Run());
  playing.Player->SetResume(true);
  CHECK(playing.Player->Run());
  files.Write("stand.csv", "model,x,y\noak,4,9.5\n");
  const Reading changed(files, Tripod, Leg);
  Playing other(files, changed);
  other.Player->SetResume(true);
  other.CheckFails({ "stand.csv has changed" });
}

TEST_CASE("SurveyPartTable: tables are made by methods", "[SurveyPartTable]")
{
  const Files files;
  files.Write("stand.csv", "model,x,y\noak,4,9\nfir,1,2\n");
  WriteScene(files, MakeTable(Models, " seed=\"2\" yawMax_deg=\"360\""));
  const Reading reading(files, Tripod, Leg);
  REQUIRE(reading.Good);
  vtkNew<vtkHeliosSurvey> made;
  const auto log = Observe(made);
  made->AddAssetDirectory(files / "");
  CHECK(made->AddPart("objloader", "hill.obj") == 0);
  CHECK(made->AddPartTable("stand.csv") == 0);
  const std::vector<std::pair<std::string, std::string>> values = { { "seed", "2" },
    { "yawMax_deg", "360" }, { "model/id", "oak" }, { "model/objloader/filepath", "oak.obj" },
    { "model[1]/id", "fir" }, { "model[1]/classification", "5" },
    { "model[1]/objloader/filepath", "fir.obj" } };
  for (const auto& [name, value] : values)
  {
    INFO(name << " " << log->Errors);
    CHECK(made->SetPartTableAttribute(0, name, value));
    const bool isFile = value.find(".obj") != std::string::npos;
    CHECK(made->GetPartTableAttribute(0, name) == (isFile ? files / value : value));
  }
  const auto& a = made->GetData().Scene.Parts;
  const auto& b = reading.Data().Scene.Parts;
  REQUIRE(a.size() == 3);
  for (std::size_t i = 1; i < 3; ++i)
  {
    CHECK(a[i].Files == b[i].Files);
    CHECK(a[i].Name == b[i].Name);
    CHECK(a[i].Classification == b[i].Classification);
    CHECK(a[i].Rotation[0] == b[i].Rotation[0]);
    CHECK(a[i].Translation[1] == b[i].Translation[1]);
  }
  CHECK(made->GetData().Documents == std::vector<std::string>{ files / "stand.csv" });
  CHECK(made->AddPart("objloader", "oak.obj") == 1); // before the table's parts
  CHECK(made->GetNumberOfParts() == 4);
  CHECK(made->GetPartName(1) == "1");
  CHECK(made->SetPartAttribute(1, "classification", "3"));
  CHECK_FALSE(made->SetPartAttribute(2, "id", "x"));
  CHECK(log->HasError("part 2 does not exist; there are 2, counted from 0"));

  CHECK(made->AddPartTable("") == 1);
  CHECK(made->SetPartTableRows(1, "model,x,y\noak.obj,1,1\noak.obj,2,2\n"));
  CHECK(made->GetNumberOfParts() == 6);
  CHECK(made->GetData().Scene.Parts[5].Where == "part table 1, rows:3");
  CHECK(made->SetPartTableRows(1, ""));
  CHECK(made->SetPartTableAttribute(1, "row/x", "7"));
  CHECK(made->SetPartTableAttribute(1, "row/y", "8"));
  CHECK(made->SetPartTableAttribute(1, "row/model", "oak.obj"));
  CHECK(made->GetNumberOfParts() == 5);
  CHECK(made->SetPartTableAttribute(1, "file", "stand.csv"));
  CHECK_FALSE(made->Check());
  CHECK(log->HasError("part table 1: <partTable> has a file and <row> children"));
  CHECK(made->SetPartTableAttribute(1, "file", ""));
  CHECK_FALSE(made->SetPartTableRows(1, "model,x\n"));
  CHECK(log->HasError("part table 1, rows:1: there is no column y"));

  CHECK_FALSE(made->SetPartTableAttribute(2, "seed", "1"));
  CHECK(made->GetPartTableAttribute(2, "seed").empty());
  CHECK_FALSE(made->SetPartTableRows(2, "x,y\n"));
  CHECK(log->HasError("part table 2 does not exist; there are 2, counted from 0"));
  CHECK_FALSE(made->SetPartTableAttribute(0, "seed", "x"));
  CHECK(log->HasError("part table 0: seed=\"x\" is not"));
  CHECK(made->AddPartTable("none.csv") == -1);
  CHECK(log->HasError("part table: file=\"none.csv\": no such file"));
  made->RemoveAllParts();
  CHECK(made->GetNumberOfParts() == 0);
  CHECK(made->AddPart("objloader", "hill.obj") == 0);
  CHECK(made->GetNumberOfParts() == 1);
}

TEST_CASE(
  "SurveyPartTable: lowest corners of tilted models are those of copies", "[SurveyPartTable]")
{
  vtkNew<vtkSphereSource> source;
  source->SetThetaResolution(40);
  source->SetPhiResolution(40);
  source->SetCenter(3.0, -2.0, 1.0);
  source->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
  source->Update();
  vtkPolyData* mesh = source->GetOutput();
  LowestCorners lowest;
  const Quaternion tilt = AxisAngle({ 1.0, 2.0, 0.0 }, 77.0);
  for (int i = 0; i < 500; ++i) // every tenth is upright
  {
    const Quaternion turn = AxisAngle({ 0.0, 0.0, 1.0 }, 0.7 * i);
    Quaternion placed = i % 10 == 0 ? turn : turn * tilt;
    placed.Normalize();
    const Vec3 up(Rotation(placed).M[2]);
    Vec3 corner;
    Vec3 expected;
    REQUIRE(lowest.Find(mesh, up, corner));
    REQUIRE(FindLowestCorner(mesh, up, expected));
    CHECK(corner == expected);
  }
  vtkNew<vtkPolyData> nothing;
  Vec3 corner;
  CHECK_FALSE(lowest.Find(nothing, { 0.0, 0.0, 1.0 }, corner));
}
