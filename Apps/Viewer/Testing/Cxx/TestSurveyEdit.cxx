// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Edited surveys: leg positions, limits of instruments, and their saved files.
#include "heliosSurveyEdit.h"

#include "heliosCatalogue.h"
#include "heliosEditDocument.h"
#include "heliosMessages.h"
#include "heliosStatus.h"
#include "heliosSurveyDocument.h"
#include "heliosSurveyEquality.h"
#include "heliosSurveyFiles.h"
#include "heliosXmlValue.h"
#include "vtkHeliosSurveySource.h"

#include <vtkDataArray.h>
#include <vtkMath.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>

#include <catch2/catch.hpp>

#include <cmath>
#include <cstdlib>
#include <cstring>
#include <filesystem>

using Catch::Contains;
using namespace helios;
using namespace helios::test;

namespace
{

/// The files' tripod and scanner over their scene.
struct Hand
{
  vtkNew<vtkHeliosSurvey> Owner;
  vtkSmartPointer<ErrorObserver> Heard = Observe(Owner);
  Messages Log{ Owner };
  Catalogue Choice;
  SurveyEdit Edit;

  explicit Hand(const Files& files, const char* platform = "tripod", const char* scanner = "tls")
    : Choice(ReadCatalogue({ files / "" }, {}))
  {
    this->Edit.Scene = "scene.xml#s";
    for (const auto& entry : this->Choice.Platforms)
    {
      entry.second.Id == platform ? ChoosePlatform(this->Edit, entry.first, entry.second) : void();
    }
    for (const auto& entry : this->Choice.Scanners)
    {
      entry.second.Id == scanner ? ChooseScanner(this->Edit, entry.first, entry.second) : void();
    }
    REQUIRE(this->Edit.Scanner == files / "assets.xml#" + scanner);
    REQUIRE(this->Edit.Platform == files / "assets.xml#" + platform);
  }

  Status Save(const Files& files)
  {
    return SaveSurvey(this->Edit, files / "survey.xml", { files / "" }, this->Log);
  }
};

vtkSmartPointer<vtkPolyData> Run(vtkHeliosSurvey* survey)
{
  vtkNew<vtkHeliosSurveySource> source;
  source->SetSurvey(survey);
  source->Update();
  return source->GetOutput();
}

/// Whether points and all arrays are byte-identical.
bool IsSame(vtkPolyData* a, vtkPolyData* b)
{
  const auto same = [](vtkDataArray* x, vtkDataArray* y)
  {
    const auto bytes = static_cast<std::size_t>(
      x->GetNumberOfValues() * static_cast<vtkIdType>(x->GetDataTypeSize()));
    return y && x->GetNumberOfValues() == y->GetNumberOfValues() &&
      std::memcmp(x->GetVoidPointer(0), y->GetVoidPointer(0), bytes) == 0;
  };
  bool good = same(a->GetPoints()->GetData(), b->GetPoints()->GetData());
  for (int i = 0; i < a->GetPointData()->GetNumberOfArrays(); ++i)
  {
    vtkDataArray* array = a->GetPointData()->GetArray(i);
    good = good && (!array || same(array, b->GetPointData()->GetArray(array->GetName())));
  }
  return good;
}

} // namespace

TEST_CASE("SurveyEdit: flight lines fire, turns do not", "[SurveyEdit]")
{
  const Files files;
  Hand hand(files, "plane", "als");
  CHECK(SetSetting(hand.Edit, "height", 40.0).empty());
  CHECK(SetSetting(hand.Edit, "scanAngle", 15.0).empty());
  CHECK(SetSetting(hand.Edit, "overlap", 75.0).empty());
  SetLines(hand.Edit,
    { { { -20.0, 10.0, 40.0 }, { 20.0, 10.0, 40.0 } },
      { { 20.0, 0.0, 40.0 }, { -20.0, 0.0, 40.0 } },
      { { -20.0, -10.0, 40.0 }, { 20.0, -10.0, 40.0 } } });
  REQUIRE(hand.Edit.Legs.size() == 6);
  for (std::size_t i = 0; i < 6; ++i)
  {
    CHECK(hand.Edit.Legs[i].Settings.Leg.Active == (i % 2 == 0));
    CHECK(hand.Edit.Legs[i].Settings.Leg.Position[2] == 40.0);
  }
  CHECK(hand.Edit.Legs[3].Settings.Leg.Position[0] == -20.0);
  SetSetting(hand.Edit, "height", 30.0);
  CHECK(hand.Edit.Legs.front().Settings.Leg.Position[2] == 30.0);
  SetSetting(hand.Edit, "speed", 20.0);
  SurveyEdit far = hand.Edit;
  far.ScannerModel.Receiver.RangeMin = 100.0; // nothing nearer gives returns
  CHECK_THAT(SetSetting(far, "height", 50.0), Contains("becomes 100 m"));
  REQUIRE(hand.Save(files).IsOk());
  const Reading reading(files);
  REQUIRE(reading.Good);
  CHECK(reading.Log->Warnings.empty());
  const SurveyData& data = reading.Data();
  CHECK(data.Fires(0));
  CHECK_FALSE(data.Fires(1));
  CHECK(data.Fires(data.Legs.size() - 2));
  CHECK(data.Legs[0].Speed == 20.0);
  CHECK(data.Legs[0].Scans[0].ScanAngle == 15.0);
}

TEST_CASE(
  "SurveyEdit: a tripod is placed at the click, on ground and on other surfaces", "[SurveyEdit]")
{
  const Files files;
  Hand hand(files);
  AddLeg(hand.Edit, { 1.0, 2.0, 0.25 }, false);
  AddLeg(hand.Edit, { 5.0, 6.0, 0.0 }, true);
  AddLeg(hand.Edit, { 7.0, 7.0, 0.0 }, true);
  RemoveLeg(hand.Edit, 2);
  MoveLeg(hand.Edit, 0, { 1.5, 2.5, 0.5 }, false);
  REQUIRE(hand.Save(files).IsOk());
  const Reading reading(files);
  REQUIRE(reading.Good);
  const SurveyData& data = reading.Data();
  REQUIRE(data.Legs.size() == 2);
  CHECK(data.Legs[0].Position == Vec3(1.5, 2.5, 0.5));
  CHECK_FALSE(data.Legs[0].OnGround);
  CHECK(data.Legs[1].OnGround);
  CHECK(data.Platforms[0].Mount.Position[2] == 1.5); // the height of the instrument
}

TEST_CASE("SurveyEdit: values are limited to those of the instrument", "[SurveyEdit]")
{
  const Files files;
  Hand hand(files);
  AddLeg(hand.Edit, { 0.0, 0.0, 0.0 }, true);
  const auto set = [&hand](const char* name, double value, double expected)
  {
    const std::string said = SetSetting(hand.Edit, name, value);
    CHECK(GetSetting(hand.Edit, name) == expected);
    return said;
  };
  CHECK_THAT(set("scanFrequency", 500.0, 120.0),
    Contains("scan frequency 500 Hz becomes 120 Hz (3 to 120)"));
  CHECK_THAT(set("headSpeed", 90.0, 60.0), Contains("rotation speed 90 deg/s becomes 60 deg/s"));
  CHECK_THAT(set("pulseFrequency", 180000.0, 100000.0),
    Contains("becomes 100000 Hz, which the instrument supports"));
  CHECK_THAT(set("headStop", -10.0, 1.0), Contains("horizontal FOV end -10 deg becomes 1 deg"));
  CHECK_THAT(
    set("headStart", 200.0, 200.0), Contains("the head rotates by at least 1 deg, to 201 deg"));
  CHECK(set("verticalMax", 50.0, 50.0).empty());
  CHECK_THAT(
    set("verticalMin", -80.0, -80.0), Contains("the window of 1 to 100 deg ends at 20 deg"));
  CHECK_THAT(SetSetting(hand.Edit, "scanAngle", 9.0), Contains("scanAngle is not a setting of"));
  CHECK_THAT(
    SetSetting(hand.Edit, "speed", 3.0), Contains("speed is not a setting of tls on tripod"));
  CHECK(hand.Edit.Legs[0].Settings.Scan.HeadRotateSpeed == 60.0);
  REQUIRE(hand.Save(files).IsOk());
  const Reading reading(files);
  REQUIRE(reading.Good);
  CHECK(reading.Log->Warnings.empty()); // nothing needs clipping
  const ScanData& scan = reading.Data().Legs[0].Scans[0];
  CHECK(scan.ScanFrequency == 120.0);
  CHECK(scan.PulseFrequency == 100000.0);
  CHECK(scan.HeadRotateSpeed == 60.0);
  CHECK(scan.HeadRotateStart == 200.0);
  CHECK(scan.HeadRotateStop == 201.0);
  CHECK(scan.VerticalAngleMin == -80.0);
  CHECK(scan.VerticalAngleMax == 20.0);
}

TEST_CASE(
  "SurveyEdit: an oscillating mirror has a smaller angle at higher frequency", "[SurveyEdit]")
{
  const Files files;
  Hand hand(files, "plane", "als");
  hand.Edit.ScannerModel.Type = Optics::OscillatingMirror;
  hand.Edit.ScannerModel.ScanProduct = 1000.0;
  SetSetting(hand.Edit, "scanFrequency", 50.0);
  CHECK_THAT(
    SetSetting(hand.Edit, "scanAngle", 20.0) + SetSetting(hand.Edit, "scanFrequency", 60.0),
    Contains("scan frequency is 50 Hz at most with this scan angle"));
  CHECK(GetSetting(hand.Edit, "scanFrequency") == 50.0);
}

TEST_CASE(
  "SurveyEdit: a saved survey equals the survey that was run, byte for byte", "[SurveyEdit]")
{
  const Files files;
  const bool isMoving = GENERATE(false, true);
  Hand hand(files, isMoving ? "plane" : "tripod", isMoving ? "als" : "tls");
  AddLeg(hand.Edit, { -1.0 / 3.0, 2.0, 0.1 }, false);
  AddLeg(hand.Edit, { 1.0 / 7.0, 3.0, 0.1 }, false);
  hand.Edit.Seed = 5;
  isMoving ? SetSetting(hand.Edit, "height", 100.0 / 3.0) : SetSetting(hand.Edit, "headStop", 2.0);
  isMoving ? SetSetting(hand.Edit, "speed", 10.0) : "";
  vtkNew<vtkHeliosSurvey> shown;
  REQUIRE(ReadEdit(hand.Edit, files / "survey.xml", {}, shown));
  CHECK_FALSE(hand.Log.HasError());
  REQUIRE(hand.Save(files).IsOk());
  const Reading reading(files);
  REQUIRE(reading.Good);
  CHECK(reading.Data().Seed == 5);
  CHECK(reading.Data().Legs[0].Position[0] == RoundComputed(-1.0 / 3.0));
  const auto before = Run(shown);
  CHECK(before->GetNumberOfPoints() > 1000);
  CHECK(IsSame(before, Run(reading.Reader->GetSurvey())));
  vtkHeliosSurvey* other = reading.Reader->GetSurvey();
  other->GetData().Legs[0].Position[0] += 1e-9;
  other->Modified();
  CHECK_FALSE(IsSame(before, Run(other)));
}

TEST_CASE("SurveyEdit: an unchanged survey is written unchanged", "[SurveyEdit]")
{
  const Files files;
  const bool isMoving = GENERATE(false, true);
  const Reading first(files, std::string(isMoving ? Flight : Tripod) + " seed=\"9\"",
    std::string(isMoving ? ThreeLegs : OneLeg) + R"(<FWFSettings beamSampleQuality="1"/>)");
  REQUIRE(first.Good);
  const auto before = Run(first.Reader->GetSurvey());
  Hand hand(files);
  const std::string left = EditSurvey(first.Data(), hand.Edit);
  CHECK(left.empty());
  CHECK(hand.Edit.Scene == files / "scene.xml#s");
  CHECK(hand.Edit.Scanner == files / (isMoving ? "assets.xml#als" : "assets.xml#tls"));
  REQUIRE(hand.Save(files).IsOk());
  CHECK_THAT(ReadText(files / "survey.xml"), Contains("made by hand"));
  const Reading second(files);
  REQUIRE(second.Good);
  CHECK(second.Log->Warnings.empty());
  CHECK(second.Data().Seed == 9);
  CHECK(before->GetNumberOfPoints() > 1000);
  CHECK(IsSame(before, Run(second.Reader->GetSurvey())));
}

TEST_CASE("SurveyEdit: what is not edited of a survey is saved with it", "[SurveyEdit]")
{
  const Files files;
  const Reading first(files, std::string(Tripod) + " rayCaster=\"embree\"",
    std::string(OneLeg) + R"(<FWFSettings binSize_ns="0.1"/>)");
  REQUIRE(first.Good);
  Hand hand(files);
  CHECK(EditSurvey(first.Data(), hand.Edit).empty());
  MoveLeg(hand.Edit, 0, { 3.0, 4.0, 0.0 }, false);
  const Files other;
  REQUIRE(SaveSurvey(hand.Edit, other / "survey.xml", {}, hand.Log).IsOk());
  const Reading second(other);
  REQUIRE(second.Good);
  CHECK(second.Data().RayCaster == "embree");
  CHECK(second.Data().Scanners[0].Receiver.BinSize == 0.1);
  CHECK(second.Data().Legs[0].Position == Vec3(3.0, 4.0, 0.0));
}

namespace
{

/// Reads a survey; null after an error.
vtkSmartPointer<vtkHeliosSurvey> Read(
  const std::string& file, const std::vector<std::string>& assets)
{
  vtkNew<vtkHeliosSurveyReader> reader;
  const auto log = Observe(reader);
  reader->SetFileName(file.c_str());
  for (const std::string& folder : assets)
  {
    reader->AddAssetDirectory(folder.c_str());
  }
  return reader->Read() ? reader->GetSurvey() : nullptr;
}

/// Saves a survey that was not edited; returns what differs then.
std::string FindSaved(
  const SurveyData& survey, const SurveyEdit& edit, const std::vector<std::string>& assets)
{
  const Files other;
  vtkNew<vtkHeliosSurvey> owner;
  Messages log(owner);
  const Status status = SaveSurvey(edit, other / "saved.xml", assets, log);
  INFO(status.Message());
  REQUIRE(status.IsOk());
  const auto saved = Read(other / "saved.xml", assets);
  REQUIRE(saved);
  std::istringstream all(FindDifferences(survey, saved->GetData()));
  std::string differences;
  for (std::string line; std::getline(all, line);) // settings are resolved, as legs are
  {
    differences += line.compare(0, 15, "survey.Settings") == 0 ? "" : line + "\n";
  }
  return differences;
}

} // namespace

TEST_CASE(
  "SurveyEdit: surveys of the tree and of HELIOS_SURVEYS are saved as they are", "[SurveyEdit]")
{
  const std::string root = std::filesystem::path(__FILE__).parent_path() / "../../../..";
  const Files files;
  files.Replace("scene.xml", "id=\"s\"", "id=\"village\"");
  std::filesystem::rename(files / "scene.xml", files / "village_scene.xml");
  std::vector<std::string> assets = { files / "", root + "/Data/Assets", root + "/Data" };
  std::vector<std::string> folders = { root + "/Data/Surveys" };
  if (const char* more = std::getenv("HELIOS_SURVEYS"))
  {
    assets.emplace_back(more);
    folders.emplace_back(more);
  }
  int count = 0;
  for (const std::string& folder : folders)
  {
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder))
    {
      const bool isXml = entry.path().extension() == ".xml";
      const auto survey = isXml ? Read(entry.path().string(), assets) : nullptr;
      SurveyEdit edit;
      if (survey && EditSurvey(survey->GetData(), edit).empty())
      {
        INFO(entry.path());
        CHECK(FindSaved(survey->GetData(), edit, assets) == "");
        ++count;
      }
    }
  }
  CHECK(count >= 3);
}

TEST_CASE("SurveyEdit: an invalid survey is not written, with the reason", "[SurveyEdit]")
{
  const Files files;
  Hand hand(files);
  CHECK_THAT(hand.Save(files).Message(),
    Contains("not written: the survey could not be run") && Contains("has 0 <leg>"));
  AddLeg(hand.Edit, { 0.0, 0.0, 0.0 }, true);
  hand.Edit.Scanner = "assets.xml#none";
  CHECK_THAT(hand.Save(files).Message(), Contains("has no <scanner> with the id \"none\""));
  CHECK_FALSE(std::filesystem::exists(files / "survey.xml"));
}

TEST_CASE("SurveyEdit: legs that cannot be edited are named", "[SurveyEdit]")
{
  const Files files;
  Hand hand(files);
  const Reading reading(files, Tripod,
    std::string(OneLeg) + R"(<leg platform="assets.xml#plane" scanner="assets.xml#als">
<platformSettings z="50"/></leg><leg platform="assets.xml#plane" scanner="assets.xml#als">
<platformSettings x="9" z="50"/></leg>)");
  REQUIRE(reading.Good);
  CHECK_THAT(EditSurvey(reading.Data(), hand.Edit), Contains("2 of 3 legs are left out"));
}

TEST_CASE("SurveyEdit: references to files are kept", "[SurveyEdit]")
{
  CHECK(ReferTo("/a/b/c.xml", "/x", { "/a" }) == "b/c.xml");
  CHECK(ReferTo("/a/b/c.xml", "/x", { "/a/" }) == "b/c.xml");
  CHECK(ReferTo("/x/c.xml", "/x/", { "/a" }) == "c.xml");
  CHECK(ReferTo("/x/../y/c.xml", "/x", { "/a" }) == "/y/c.xml");
  CHECK(ReferTo("/ab/c.xml", "/x", { "/a" }) == "/ab/c.xml");
  CHECK(ReferTo("/a/b/c.xml", "/x", { "/", "/a/b", "/a" }) == "c.xml");
  const std::string here = std::filesystem::current_path().string();
  CHECK(ReferTo(here + "/c.xml", "/x", { "", "." }) == here + "/c.xml");
  CHECK(ReferTo(here + "/c.xml", here, { "." }) == "c.xml");
}
