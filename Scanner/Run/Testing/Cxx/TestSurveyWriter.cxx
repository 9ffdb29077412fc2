// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Scan positions are written as surveys that read back to the nanometre.
#include "vtkHeliosSurveyWriter.h"

#include "heliosSceneCrs.h"
#include "heliosSurveyEquality.h"
#include "heliosSurveyFiles.h"
#include "vtkHeliosArrayNames.h"
#include "vtkHeliosFlightArrayNames.h"
#include "vtkHeliosSurveyPlayer.h"

#include <vtkDoubleArray.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>

#include <catch2/catch.hpp>

#include <cmath>
#include <limits>
#include <vector>

namespace fs = std::filesystem;
using namespace helios::test;

namespace
{

using Positions = std::vector<helios::Vec3>;

vtkSmartPointer<vtkPolyData> MakePositions(const Positions& positions)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (const helios::Vec3& p : positions)
  {
    points->InsertNextPoint(p.GetData());
  }
  auto data = vtkSmartPointer<vtkPolyData>::New();
  data->SetPoints(points);
  return data;
}

/// A writer of survey.xml, and its messages.
struct Writing
{
  vtkNew<vtkHeliosSurveyWriter> Writer;
  vtkSmartPointer<helios::ErrorObserver> Log = Observe(Writer);

  Writing(const Files& files, const Positions& positions)
  {
    this->Writer->SetFileName((files / "survey.xml").c_str());
    this->Writer->SetScene("scene.xml#s");
    this->Writer->SetPlatform("assets.xml#tripod");
    this->Writer->SetScanner("assets.xml#tls");
    this->Writer->SetScanFrequency(50.0);
    this->Writer->SetInputData(MakePositions(positions));
  }
};

/// The beam origin of a leg: the tripod's mount, and the beam origin on the head axis.
helios::Vec3 FindBeam(const helios::SurveyData& survey, std::size_t leg)
{
  const helios::PlatformData& platform = survey.GetPlatform(leg);
  return survey.Legs[leg].Position + platform.Mount.Position +
    helios::Rotate(platform.Mount.Orientation, survey.GetScanner(leg).Beam.Position);
}

constexpr double Rounding = 0.5e-9 * (1.0 + 1e-6); // to whole nanometres

const Positions Two = { { 1.0, 2.0, 1.7 }, { -1.0 / 3.0, 1e-7, 2.5 } };

} // namespace

TEST_CASE("SurveyWriter: positions are read back", "[SurveyWriter]")
{
  const Files files;
  Writing writing(files, Two);
  writing.Writer->SetSurveyName("two & more");
  writing.Writer->SetPulseFrequency(300000.0);
  writing.Writer->SetScanFrequency(100.0 / 3.0);
  writing.Writer->SetVerticalAngleMin(-40.0);
  writing.Writer->SetVerticalAngleMax(50.1);
  writing.Writer->SetHeadRotatePerSecond(0.1 + 0.2);
  REQUIRE(writing.Writer->Write());
  CHECK(writing.Log->Warnings.empty());
  const Reading reading(files);
  INFO(reading.Log->Errors << ReadText(files / "survey.xml"));
  REQUIRE(reading.Good);
  CHECK(reading.Log->Warnings.empty());
  const helios::SurveyData& survey = reading.Data();
  CHECK(survey.Name == "two & more");
  REQUIRE(survey.Legs.size() == 2);
  for (std::size_t i = 0; i < 2; ++i)
  {
    const helios::LegData& leg = survey.Legs[i];
    CHECK_FALSE(leg.OnGround);
    CHECK(leg.Active);
    CHECK(leg.Crs.empty());
    for (int axis = 0; axis < 3; ++axis)
    {
      CHECK(FindBeam(survey, i)[axis] == Approx(Two[i][axis]).margin(Rounding).epsilon(0));
    }
    CHECK(leg.Scans.front().PulseFrequency == 300000.0);
    CHECK(leg.Scans.front().ScanFrequency == 100.0 / 3.0);
    CHECK(leg.Scans.front().VerticalAngleMin == -40.0);
    CHECK(leg.Scans.front().VerticalAngleMax == 50.1);
    CHECK(leg.Scans.front().HeadRotateStart == 0.0);
    CHECK(leg.Scans.front().HeadRotateStop == 360.0);
    CHECK(leg.Scans.front().HeadRotateSpeed == 0.1 + 0.2);
  }
  CHECK_FALSE(fs::exists(files / "survey.xml.part"));
}

TEST_CASE("SurveyWriter: coordinates have no more digits than matter", "[SurveyWriter]")
{
  const Files files;
  Writing writing(files, { { 0.1 + 0.2, 5427001.3, 3.3000000000123 } }); // the beam is 1.7 m above
  REQUIRE(writing.Writer->Write());
  const std::string text = ReadText(files / "survey.xml");
  INFO(text);
  CHECK(text.find("x=\"0.3\" y=\"5427001.3\" z=\"1.6\"") != std::string::npos);
}

TEST_CASE("SurveyWriter: large and tiny coordinates", "[SurveyWriter]")
{
  const Files files;
  files.Replace("assets.xml", "<scannerMount x=\"0\" y=\"0\" z=\"1.5\"/>", "");
  files.Replace("assets.xml", "<beamOrigin x=\"0\" y=\"0\" z=\"0.2\"/>", "");
  const Positions far = { { 500000.1, 5427001.3, 123.456789 },
    { 0x1.fffffffffffffp+33, -0x1.0000000000001p-60, 1e-300 } };
  Writing writing(files, far);
  REQUIRE(writing.Writer->Write());
  const Reading reading(files);
  REQUIRE(reading.Good);
  CHECK(reading.Data().Legs[0].Position == far[0]);
  CHECK(reading.Data().Legs[1].Position == helios::Vec3(far[1][0], 0.0, 0.0));
}

TEST_CASE("SurveyWriter: a rotated mount, a beam beside the axis", "[SurveyWriter]")
{
  const Files files;
  files.Replace("assets.xml", "<scannerMount x=\"0\" y=\"0\" z=\"1.5\"/>",
    "<scannerMount x=\"0.3\" y=\"0\" z=\"1.5\"><rot axis=\"x\" angle_deg=\"90\"/></scannerMount>");
  files.Replace("assets.xml", "<beamOrigin x=\"0\" y=\"0\" z=\"0.2\"/>",
    "<beamOrigin x=\"0.05\" y=\"0\" z=\"0.2\"/>");
  Writing writing(files, { { 10.0, 20.0, 30.0 } });
  REQUIRE(writing.Writer->Write());
  const Reading reading(files);
  REQUIRE(reading.Good);
  // x by 90 tilts the head axis from up to backward: 0.2 m; the offset from the axis rotates with
  // it.
  const helios::Vec3 wanted(9.7, 20.2, 28.5);
  CHECK((reading.Data().Legs[0].Position - wanted).Norm() < 1e-14);
}

TEST_CASE("SurveyWriter: the player fires from the positions", "[SurveyWriter]")
{
  const Files files;
  files.Replace("assets.xml", "accuracy_m=\"0.005\"", "");
  Writing writing(files, { { 0.0, 0.0, 4.0 } });
  writing.Writer->SetHeadRotatePerSecond(60.0);
  REQUIRE(writing.Writer->Write());
  const Reading reading(files);
  REQUIRE(reading.Good);
  vtkNew<vtkHeliosSurveyPlayer> player;
  const auto log = Observe(player);
  player->SetSurvey(reading.Reader->GetSurvey());
  player->SetOutputDirectory((files / "out").c_str());
  player->SetWritePulses(true);
  INFO(log->Errors);
  REQUIRE(player->Run());
  std::istringstream pulses(ReadText(files / "out/survey/leg000_pulse.txt"));
  double x = 1.0;
  double y = 1.0;
  double z = 1.0;
  REQUIRE(pulses >> x >> y >> z);
  CHECK(x == Approx(0.0).margin(1e-12));
  CHECK(y == Approx(0.0).margin(1e-12));
  CHECK(z == Approx(4.0));
}

namespace
{

/// Two strips of a flight: waypoints with a speed, of which every second one begins a turn.
vtkSmartPointer<vtkPolyData> MakeWaypoints(double speed)
{
  auto waypoints =
    MakePositions({ { 0, 0, 500 }, { 0, 90, 520 }, { 40, 90, 500 }, { 40, 0, 500 } });
  const auto add = [&](const char* name, std::vector<double> values)
  {
    vtkNew<vtkDoubleArray> array;
    array->SetName(name);
    for (const double value : values)
    {
      array->InsertNextValue(value);
    }
    waypoints->GetPointData()->AddArray(array);
  };
  add(vtkHeliosArrayNames::Speed, { speed, 61, speed, 61 });
  add(vtkHeliosArrayNames::LegIds, { 0, 0, 1, 1 });
  add(vtkHeliosFlightArrayNames::Active, { 1, 0, 1, 0 });
  return waypoints;
}

} // namespace

TEST_CASE("SurveyWriter: waypoints are read back", "[SurveyWriter]")
{
  const Files files;
  Writing writing(files, Two);
  writing.Writer->SetPlatform("assets.xml#plane");
  writing.Writer->SetInputData(MakeWaypoints(60.0));
  INFO(writing.Log->Errors);
  REQUIRE(writing.Writer->Write());
  const Reading reading(files);
  INFO(reading.Log->Errors << ReadText(files / "survey.xml"));
  REQUIRE(reading.Good);
  const helios::SurveyData& survey = reading.Data();
  REQUIRE(survey.Legs.size() == 4);
  const double heights[4] = { 500, 520, 500, 500 };
  for (std::size_t i = 0; i < 4; ++i)
  {
    const helios::LegData& leg = survey.Legs[i];
    CHECK(leg.Position[0] == (i < 2 ? 0.0 : 40.0));
    CHECK(FindBeam(survey, i)[2] == Approx(heights[i]));
    CHECK(leg.Speed == (i % 2 == 0 ? 60.0 : 61.0));
    CHECK(leg.Active == (i % 2 == 0));
    CHECK(leg.Strip == (i < 2 ? "000" : "001"));
    CHECK(leg.Scans.front().HeadRotateSpeed == 0.0);
  }
}

TEST_CASE("SurveyWriter: waypoints that cannot be written are errors", "[SurveyWriter]")
{
  const Files files;
  Writing writing(files, Two);
  writing.Writer->SetInputData(MakeWaypoints(60.0));
  CHECK_FALSE(writing.Writer->Write());
  CHECK(writing.Log->HasError("Platform assets.xml#tripod is static, but waypoints need a moving"));
  writing.Writer->SetPlatform("assets.xml#plane");
  writing.Writer->SetInputData(MakeWaypoints(-1.0));
  CHECK_FALSE(writing.Writer->Write());
  CHECK(writing.Log->HasError("Speed of waypoint 0 is -1 m/s; give a positive speed"));
}

TEST_CASE("SurveyWriter: a mesh becomes a scene file", "[SurveyWriter]")
{
  const Files files;
  Writing writing(files, Two);
  writing.Writer->SetScene("plane.obj");
  REQUIRE(writing.Writer->Write());
  const Reading reading(files);
  INFO(reading.Log->Errors << ReadText(files / "survey.xml"));
  REQUIRE(reading.Good);
  REQUIRE(reading.Data().Scene.Parts.size() == 1);
  CHECK(reading.Data().Scene.Parts[0].Files[0] == files / "plane.obj");
  CHECK(reading.Data().Scene.Crs.empty());
}

TEST_CASE("SurveyWriter: coordinate systems", "[SurveyWriter]")
{
  const Files files;
  Writing writing(files, Two);
  auto positions = MakePositions(Two);
  helios::SetCRS(positions, "EPSG:32632");
  writing.Writer->SetInputData(positions);
  SECTION("that of the scene: not written")
  {
    files.Replace("scene.xml", "id=\"s\"", "id=\"s\" crs=\"EPSG:32632\"");
    REQUIRE(writing.Writer->Write());
    CHECK(Reading(files).Data().Legs[0].Crs.empty());
  }
  SECTION("another one than that of the scene, or one that its parts bring")
  {
    REQUIRE(writing.Writer->Write());
    CHECK(Reading(files).Data().Legs[1].Crs == "EPSG:32632");
  }
  SECTION("of a mesh")
  {
    writing.Writer->SetScene("plane.obj");
    REQUIRE(writing.Writer->Write());
    CHECK(Reading(files).Data().Scene.Crs == "EPSG:32632");
    CHECK(Reading(files).Data().Legs[0].Crs.empty());
  }
}

TEST_CASE("SurveyWriter: a survey is made as it is written, without a file", "[SurveyWriter]")
{
  const Files files;
  const bool isMoving = GENERATE(false, true);
  Writing writing(files, Two);
  if (isMoving)
  {
    writing.Writer->SetPlatform("assets.xml#plane");
    writing.Writer->SetInputData(MakeWaypoints(60.0));
  }
  REQUIRE(writing.Writer->Write());
  const Reading written(files);
  REQUIRE(written.Good);
  writing.Writer->SetFileName(nullptr);
  writing.Writer->SetScene((files / "scene.xml#s").c_str());
  writing.Writer->SetSurveyName("survey");
  writing.Writer->AddAssetDirectory((files / "").c_str());
  vtkNew<vtkHeliosSurvey> made;
  REQUIRE(writing.Writer->BuildSurvey(made));
  CHECK(FindDifferences(written.Data(), made->GetData()) == "");
  CHECK(made->Check());
  writing.Writer->SetScene(nullptr); // an input of the run
  REQUIRE(writing.Writer->BuildSurvey(made));
  CHECK(made->GetNumberOfParts() == 0);
  CHECK(made->GetNumberOfLegs() == (isMoving ? 4 : 2));
  writing.Writer->SetScanner("assets.xml#none");
  CHECK_FALSE(writing.Writer->BuildSurvey(made));
  CHECK(writing.Log->HasError("survey: not written: the survey could not be run"));
  writing.Writer->SetScanner(nullptr);
  CHECK_FALSE(writing.Writer->BuildSurvey(made));
  CHECK(writing.Log->HasError("Scanner is not set; give the scanner"));
}

TEST_CASE("SurveyWriter: a file is replaced only after success", "[SurveyWriter]")
{
  const Files files;
  files.Write("survey.xml", "as it was");
  Writing writing(files, Two);
  writing.Writer->SetScanner("assets.xml#tsl");
  CHECK_FALSE(writing.Writer->Write());
  CHECK(ReadText(files / "survey.xml") == "as it was");
  CHECK_FALSE(fs::exists(files / "survey.xml.part"));
  writing.Writer->SetScanner("assets.xml#tls");
  CHECK(writing.Writer->Write());
  CHECK(Reading(files).Good);
}

TEST_CASE("SurveyWriter: asset directories", "[SurveyWriter]")
{
  const Files files;
  Writing writing(files, Two);
  writing.Writer->SetFileName((files / "new/folder/survey.xml").c_str());
  CHECK_FALSE(writing.Writer->Write());
  CHECK(writing.Log->HasError("scene=\"scene.xml\": no such file"));
  writing.Writer->AddAssetDirectory((files / ".").c_str());
  CHECK(writing.Writer->Write());
  writing.Writer->RemoveAllAssetDirectories();
  CHECK_FALSE(writing.Writer->Write());
}

TEST_CASE("SurveyWriter: surveys that cannot be written are errors", "[SurveyWriter]")
{
  const Files files;
  const auto fails = [&files](void (*change)(vtkHeliosSurveyWriter*), const std::string& message)
  {
    Writing writing(files, Two);
    change(writing.Writer);
    CHECK_FALSE(writing.Writer->Write());
    INFO(writing.Log->Errors);
    CHECK(writing.Log->HasError(message));
    CHECK_FALSE(fs::exists(files / "survey.xml"));
  };
  using Writer = vtkHeliosSurveyWriter*;
  fails([](Writer w) { w->SetFileName(nullptr); }, "FileName is not set; give the survey file");
  fails([](Writer w) { w->SetScene(""); }, "Scene is not set; give what is scanned");
  fails([](Writer w) { w->SetPlatform(nullptr); }, "Platform is not set; give what carries");
  fails([](Writer w) { w->SetScanner(nullptr); }, "Scanner is not set; give the scanner");
  fails([](Writer w) { w->SetInputData(nullptr); }, "no positions to write; give them with");
  fails([](Writer w) { w->SetInputData(MakePositions({})); },
    "survey.xml: not written: the input has no position; give it the positions that");
  fails(
    [](Writer w) {
      w->SetInputData(MakePositions({ { 0, 0, 0 }, { 0, NAN, 1 } }));
    },
    "not written: position 1 is (0, nan, 1); give finite coordinates");
  fails([](Writer w) { w->SetPlatform("assets.xml#plane"); },
    "Platform assets.xml#plane moves, but scan positions need a static one");
  fails([](Writer w) { w->SetScene("nowhere.obj"); }, "\"nowhere.obj\": no such file");
  fails([](Writer w) { w->SetHeadRotatePerSecond(-1.0); },
    "not written: the survey could not be run; correct the properties");
  fails([](Writer w) { w->SetHeadRotatePerSecond(-1.0); }, "never reaches it");
  files.Write("plain", "");
  Writing writing(files, Two);
  writing.Writer->AddAssetDirectory((files / ".").c_str());
  writing.Writer->SetFileName((files / "plain/survey.xml").c_str());
  CHECK_FALSE(writing.Writer->Write());
  CHECK(writing.Log->HasError("plain"));
  CHECK(writing.Log->HasError("give another FileName"));
}
