// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Surveys made by the methods of vtkHeliosSurvey, without files of their own.
#include "heliosSurveyFiles.h"
#include "vtkHeliosSurveySource.h"

#include <vtkPlaneSource.h>
#include <vtkPolyData.h>

#include <catch2/catch.hpp>

#include <map>
#include <string>

using namespace helios::test;

namespace
{

using Attributes = std::map<std::string, std::string>;

/// A survey with the assets of the test files.
struct Making
{
  vtkNew<vtkHeliosSurvey> Survey;
  vtkSmartPointer<helios::ErrorObserver> Log = Observe(Survey);

  explicit Making(const Files& files)
  {
    this->Survey->AddAssetDirectory(files / "");
    this->Survey->SetName("test");
  }

  int AddLeg(const Attributes& attributes, int scanner = 0, int platform = 0)
  {
    const int leg = this->Survey->AddLeg(scanner, platform);
    for (const auto& [name, value] : attributes)
    {
      INFO(name << " " << this->Log->Errors);
      CHECK(this->Survey->SetLegAttribute(leg, name, value));
    }
    return leg;
  }

  /// Adds an instrument on a tripod, or flown.
  void AddInstrument(bool isFlown = false)
  {
    const std::string platform = isFlown ? "assets.xml#plane" : "assets.xml#tripod";
    REQUIRE(this->Survey->AddScannerFromFile(isFlown ? "assets.xml#als" : "assets.xml#tls") == 0);
    REQUIRE(this->Survey->AddPlatformFromFile(platform) == 0);
  }
};

const Attributes Head = { { "scanFreq_hz", "50" }, { "headRotatePerSec_deg", "10" },
  { "headRotateStop_deg", "10" } };

void CheckSameLegs(vtkHeliosSurvey* made, vtkHeliosSurvey* read)
{
  REQUIRE(made->GetNumberOfLegs() == read->GetNumberOfLegs());
  for (int leg = 0; leg < made->GetNumberOfLegs(); ++leg)
  {
    for (int i = 0; i < vtkHeliosSurvey::GetNumberOfAttributes("leg"); ++i)
    {
      const std::string name = vtkHeliosSurvey::GetAttributeName("leg", i);
      INFO("leg " << leg << " " << name);
      CHECK(made->GetLegAttribute(leg, name) == read->GetLegAttribute(leg, name));
    }
    const helios::LegData& a = made->GetData().Legs.at(static_cast<std::size_t>(leg));
    const helios::LegData& b = read->GetData().Legs.at(static_cast<std::size_t>(leg));
    CHECK(a.StartsTrajectory == b.StartsTrajectory);
    REQUIRE(a.Scans.size() == b.Scans.size());
    CHECK(a.Scans[0].PulseFrequency == b.Scans[0].PulseFrequency);
    CHECK(a.Scans[0].ScanFrequency == b.Scans[0].ScanFrequency);
    CHECK(a.Scans[0].VerticalAngleMin == b.Scans[0].VerticalAngleMin);
    CHECK(a.Scans[0].HeadRotateSpeed == b.Scans[0].HeadRotateSpeed);
    CHECK(a.Scans[0].BeamDivergence == b.Scans[0].BeamDivergence);
    CHECK(made->IsLegActive(leg) == read->IsLegActive(leg));
  }
}

} // namespace

TEST_CASE("SurveyMade: legs are as those of a file", "[SurveyMade]")
{
  const Files files;
  const Reading reading(files, Tripod,
    OneLeg + std::string(R"(<leg stripId="a"><platformSettings x="4" y="5" onGround="true"/>
<scannerSettings pulseFreq_hz="300000" scanFreq_hz="500" headRotatePerSec_deg="10" headRotateStart_deg="3"
 headRotateStop_deg="10" verticalAngleMin_deg="-20" beamDivergence_rad="0.001"/></leg>)"));
  REQUIRE(reading.Good);
  Making making(files);
  making.AddInstrument();
  Attributes first = Head;
  first.insert({ { "x", "1" }, { "y", "2" }, { "z", "3" } });
  CHECK(making.AddLeg(first) == 0);
  Attributes second = Head;
  second.insert(
    { { "onGround", "true" }, { "pulseFreq_hz", "300000" }, { "headRotateStart_deg", "3" },
      { "verticalAngleMin_deg", "-20" }, { "beamDivergence_rad", "0.001" }, { "stripId", "a" } });
  second["scanFreq_hz"] = "500";
  CHECK(making.AddLeg(second) == 1);
  CHECK(making.Survey->SetLegPosition(1, 4, 5, 0));
  CheckSameLegs(making.Survey, reading.Reader->GetSurvey());
  CHECK(making.Log->Warnings.empty());
  CHECK(making.Survey->Check());
  CHECK(making.Log->HasWarning(
    "leg 1: scanFreq_hz=\"500\" is clipped to 120, scanFreqMax_Hz of scanner tls"));
  CHECK(making.Survey->GetLegScanFrequency(1) == 120);
  CHECK(making.Survey->GetLegAttribute(1, "scanFreq_hz") == "500");
  CHECK(making.Survey->GetName() == "test");
  CHECK(making.Survey->GetScannerName() == "tls");
}

TEST_CASE("SurveyMade: a flight", "[SurveyMade]")
{
  const Files files;
  const Reading reading(files, Flight, ThreeLegs);
  REQUIRE(reading.Good);
  Making making(files);
  making.AddInstrument(true);
  for (const char* x : { "0", "10", "20" })
  {
    making.AddLeg({ { "x", x }, { "z", "100" }, { "movePerSec_m", "50" }, { "scanFreq_hz", "50" },
      { "scanAngle_deg", "5" } });
  }
  CHECK(making.Survey->SetLegAttribute(2, "active", "false"));
  CHECK(making.Survey->Check());
  CheckSameLegs(making.Survey, reading.Reader->GetSurvey());
  making.Survey->RemoveLeg(0);
  making.Survey->RemoveLeg(7);
  CHECK(making.Survey->Check());
  CHECK(making.Survey->SetLegAttribute(0, "movePerSec_m", "0"));
  CHECK_FALSE(making.Survey->Check());
  CHECK(making.Log->HasError("leg 0: movePerSec_m=\"0\": the platform never reaches the next leg"));
  making.Survey->RemoveLeg(1);
  making.Log->Clear();
  CHECK_FALSE(making.Survey->Check());
  CHECK(making.Log->HasError("leg 0: platform plane has 1 <leg>; a moving platform needs two"));
  making.Survey->RemoveAllLegs();
  making.Log->Clear();
  CHECK_FALSE(making.Survey->Check());
  CHECK(making.Log->HasError("survey test: survey test has 0 <leg>; add one"));
}

TEST_CASE("SurveyMade: a change of a leg resolves it again", "[SurveyMade]")
{
  const Files files;
  const Reading reading(files, Tripod, OneLeg);
  REQUIRE(reading.Good);
  vtkHeliosSurvey* survey = reading.Reader->GetSurvey();
  const auto log = Observe(survey);
  CHECK(survey->Check());
  const vtkMTimeType before = survey->GetMTime();
  CHECK(survey->SetLegAttribute(0, "scanFreq_hz", " 100 "));
  CHECK(survey->GetMTime() > before);
  CHECK(survey->GetLegScanFrequency(0) == 100);
  CHECK(survey->SetLegAttribute(0, "scanFreq_hz", ""));
  CHECK(survey->GetLegAttribute(0, "scanFreq_hz").empty());
  CHECK(survey->GetLegScanFrequency(0) == 3); // scanFreqMin_Hz
  CHECK(log->Warnings.empty());
  CHECK(survey->Check());
  CHECK(log->HasWarning("leg 0: scanFreq_hz=\"0\" is clipped to 3"));
  CHECK(survey->SetLegAttribute(0, "headRotatePerSec_deg", "0"));
  CHECK_FALSE(survey->Check());
  CHECK_FALSE(survey->Check()); // still
  CHECK(log->HasError("leg 0: the head rotates from headRotateStart_deg=\"0\""));
}

TEST_CASE("SurveyMade: wrong values are refused as in a file", "[SurveyMade]")
{
  const Files files;
  Making making(files);
  making.AddInstrument();
  making.AddLeg(Head);
  const auto refuses =
    [&making](const std::string& name, const std::string& value, const std::string& message)
  {
    const std::string before = making.Survey->GetLegAttribute(0, name);
    making.Log->Clear();
    CHECK_FALSE(making.Survey->SetLegAttribute(0, name, value));
    INFO(making.Log->Errors);
    CHECK(making.Log->HasError("leg 0: " + message));
    making.Log->Clear();
    CHECK(making.Survey->GetLegAttribute(0, name) == before);
  };
  refuses("scanFreq_hz", "1,5", "scanFreq_hz=\"1,5\" is not a number; give one [Hz]");
  refuses("scanFreq_hz", "-1", "scanFreq_hz=\"-1\" is out of range; give a number from 0 to");
  refuses("onGround", "maybe", "onGround=\"maybe\" is neither true nor false");
  refuses("scanFrq_hz", "1", "attribute scanFrq_hz is unknown; did you mean scanFreq_hz?");
  refuses("qqqqqqqqqqqq", "1", "attribute qqqqqqqqqqqq is unknown; give one of ");
  refuses("stripId", "a/b", "stripId=\"a/b\" is not valid in a file name");
  CHECK_FALSE(making.Survey->SetLegPosition(0, NAN, 0, 0));
  CHECK(making.Log->HasError("leg 0: x=\"nan\" is not a number"));
  CHECK_FALSE(making.Survey->SetLegAttribute(1, "x", "1"));
  CHECK(making.Log->HasError("leg 1 does not exist; there are 1, counted from 0"));
  CHECK(making.Survey->GetLegAttribute(-1, "x").empty());
  CHECK(making.Log->HasError("leg -1 does not exist"));
  CHECK(making.Survey->AddLeg(1, 0) == -1);
  CHECK(making.Log->HasError("scanner 1 does not exist"));
  CHECK(making.Survey->AddLeg(0, 1) == -1);
  CHECK(making.Log->HasError("platform 1 does not exist"));
}

TEST_CASE("SurveyMade: references that cannot be resolved", "[SurveyMade]")
{
  const Files files;
  files.Replace("assets.xml", "rangeMin_m=\"0.5\"", "rangeMin_m=\"9\" rangeMax_m=\"8\"");
  Making making(files);
  CHECK(making.Survey->AddScannerFromFile("assets.xml#tsl") == -1);
  CHECK(making.Log->HasError("survey test: scanner=\"assets.xml#tsl\": "));
  CHECK(making.Log->HasError("has no <scanner> with the id \"tsl\"; did you mean tls?"));
  CHECK(making.Survey->AddPlatformFromFile("nowhere.xml#tripod") == -1);
  CHECK(making.Log->HasError("survey test: platform=\"nowhere.xml\": no such file"));
  CHECK(making.Survey->AddScannerFromFile("assets.xml#tls") == -1);
  CHECK(making.Log->HasError("rangeMin_m=\"9\" is not below rangeMax_m=\"8\""));
  CHECK(making.Survey->GetNumberOfScanners() == 0);
  making.Survey->RemoveAllAssetDirectories();
  CHECK(making.Survey->AddPlatformFromFile("assets.xml#tripod") == -1);
  CHECK(making.Survey->GetNumberOfPlatforms() == 0);
}

TEST_CASE("SurveyMade: scanners, channels and platforms from nothing", "[SurveyMade]")
{
  Making making(Files{});
  vtkHeliosSurvey* survey = making.Survey;
  CHECK(survey->AddScanner("own") == 0);
  CHECK(survey->AddPlatform("mast") == 0);
  CHECK(survey->AddChannel(0) == 1);
  CHECK(survey->GetNumberOfChannels(0) == 2);
  CHECK(survey->AddLeg() == 0);
  CHECK_FALSE(survey->Check());
  CHECK(making.Log->HasError(
    "scanner 0, channel 0: scanner own, channel 0: scanAngleMax_deg is missing or 0"));
  CHECK(survey->SetScannerAttribute(0, "scanAngleMax_deg", "60"));
  CHECK(survey->SetScannerAttribute(0, "rangeTolerance_m", "0.002"));
  CHECK(survey->SetScannerAttribute(0, "beamSampleQuality", "3"));
  CHECK(survey->SetChannelAttribute(0, 1, "beamDivergence_rad", "0.002"));
  CHECK(survey->GetScannerAttribute(0, "beamDivergence_rad") == "0.0003");
  CHECK(survey->GetChannelAttribute(0, 1, "beamDivergence_rad") == "0.002");
  CHECK(survey->SetChannelAttribute(0, 1, "rangeError/expr", "0.01 * THETA"));
  CHECK(survey->SetPlatformAttribute(0, "scannerMount/z", "2"));
  CHECK(survey->SetPlatformAttribute(0, "attitudeZNoise/stdev", "0.1"));
  CHECK(survey->SetLegAttribute(0, "pulseFreq_hz", "1000"));
  CHECK(survey->SetLegAttribute(0, "maxDuration_s", "1"));
  making.Log->Clear();
  CHECK(survey->Check());
  INFO(making.Log->Errors);
  const helios::SurveyData& data = survey->GetData();
  CHECK(data.Scanners.at(0).Id == "own, channel 0");
  CHECK(data.Scanners.at(0).GetChannel(1).Id == "own, channel 1");
  CHECK(data.Scanners.at(0).GetChannel(1).Receiver.Errors.RangeName ==
    "scanner 0, channel 1, rangeError: expr=\"0.01 * THETA\"");
  CHECK(data.Scanners.at(0).Receiver.NumberOfCircles == 3);
  CHECK(data.Platforms.at(0).Noise[5].IsOn);
  CHECK_FALSE(data.Platforms.at(0).Noise[4].IsOn);
  CHECK(data.Legs.at(0).Scans.at(1).BeamDivergence == 0.002);
  CHECK(survey->SetScannerAttribute(0, "energyTolerance", "0.05"));
  CHECK(survey->GetScannerAttribute(0, "beamSampleQuality").empty()); // adaptive
  CHECK(survey->SetPlatformAttribute(0, "attitudeZNoise/min", "5"));
  CHECK_FALSE(survey->Check());
  CHECK(making.Log->HasError("platform 0, attitudeZNoise: min=\"5\" is above max=\"1\""));
  CHECK_FALSE(survey->SetChannelAttribute(0, 2, "maxNOR", "1"));
  CHECK(making.Log->HasError("scanner 0, channel 2 does not exist; there are 2, counted from 0"));
  CHECK_FALSE(survey->SetScannerAttribute(0, "rangeError/expr", "0.01 *"));
  CHECK(making.Log->HasError("scanner 0: rangeError/expr=\"0.01 *\": "));
  CHECK_FALSE(survey->SetScannerAttribute(0, "optics", "turning"));
  CHECK(making.Log->HasError("scanner 0: optics=\"turning\" is not valid: expected rotating, "));
  CHECK_FALSE(survey->SetScannerAttribute(0, "pulseShape", "none.txt"));
  CHECK(making.Log->HasError("scanner 0: pulseShape=\"none.txt\" is neither a pulse shape nor"));
  CHECK_FALSE(survey->SetScannerAttribute(3, "optics", "conic"));
  CHECK(making.Log->HasError("scanner 3 does not exist; there are 1, counted from 0"));
  CHECK(survey->AddChannel(3) == -1);
}

TEST_CASE("SurveyMade: parts of the scene", "[SurveyMade]")
{
  const Files files;
  Making making(files);
  vtkHeliosSurvey* survey = making.Survey;
  CHECK(survey->AddPart("objloader", "plane.obj") == 0);
  CHECK(survey->AddPart("xyzloader", "plane.obj") == 1);
  CHECK(survey->SetPartAttribute(0, "translate/offset", "1;2;3"));
  CHECK(survey->SetPartAttribute(0, "translate/onGround", "1"));
  CHECK(survey->RotatePart(0, "z", 90));
  CHECK(survey->RotatePart(0, "pitch", 90));
  CHECK(survey->SetPartAttribute(1, "xyzloader/normalZIndex", "8"));
  CHECK(survey->SetSceneAttribute("crs", "EPSG:25832"));
  const helios::SceneData& scene = survey->GetData().Scene;
  const helios::PartData& part = scene.Parts.at(0);
  CHECK(part.Files == std::vector<std::string>{ files / "plane.obj" });
  CHECK(part.OnGround);
  const helios::Vec3 x = helios::Rotate(part.Rotation, { 1, 0, 0 });
  CHECK(x[2] == Approx(1)); // to y, then up
  CHECK(scene.Parts.at(1).Type == helios::Loader::Xyz);
  CHECK(scene.Parts.at(1).Voxels.ReadNormals);
  CHECK(scene.Parts.at(1).Voxels.NormalIndex[2] == 8);
  CHECK(scene.SpectraFolders.at(0) == files / "spectra");
  CHECK(survey->GetPartName(1) == "1");
  CHECK(survey->AddPart("objloder", "plane.obj") == -1);
  CHECK(making.Log->HasError("part 2: filter=\"objloder\" is not valid; did you mean objloader?"));
  CHECK(survey->AddPart("objloader", "none.obj") == -1);
  CHECK(making.Log->HasError("part 2: filepath=\"none.obj\": no such file"));
  CHECK_FALSE(survey->SetPartAttribute(0, "translate/ofset", "1;2;3"));
  CHECK(making.Log->HasError("part 0: attribute translate/ofset is unknown; did you mean offset?"));
  CHECK_FALSE(survey->RotatePart(0, "w", 90));
  CHECK(making.Log->HasError("part 0: axis=\"w\" is not valid"));
  CHECK_FALSE(survey->RotatePart(0, "z", NAN));
  CHECK(making.Log->HasError("part 0: angle_deg=\"nan\" is not a number"));
  CHECK_FALSE(survey->RotatePart(5, "z", 1));
  CHECK(making.Log->HasError("part 5 does not exist"));
  survey->RemoveAllParts();
  CHECK(survey->GetNumberOfParts() == 0);
}

TEST_CASE("SurveyMade: attributes of the survey, and lists of names", "[SurveyMade]")
{
  Making making(Files{});
  vtkHeliosSurvey* survey = making.Survey;
  CHECK(survey->GetSurveyAttribute("name") == "test");
  CHECK(survey->SetSurveyAttribute("name", "a/b"));
  CHECK(survey->GetName() == "a_b");
  CHECK(survey->SetSurveyAttribute("seed", "2020-01-02 03:04:05"));
  CHECK(survey->GetSeed() == 20200102030405);
  CHECK(survey->SetSurveyAttribute("seed", "auto"));
  CHECK(survey->GetSeed() == -1);
  CHECK(survey->GetSurveyAttribute("seed").empty());
  CHECK_FALSE(survey->SetSurveyAttribute("seed", "x"));
  CHECK(making.Log->HasError("survey a_b: seed=\"x\" is not valid: expected an integer"));
  CHECK(survey->GetSurveyAttribute("legRandomOffsetStdev") == "0.1");
  CHECK(vtkHeliosSurvey::GetNumberOfAttributes("legs") == 0);
  CHECK(vtkHeliosSurvey::GetAttributeName("leg", -1).empty());
  CHECK(vtkHeliosSurvey::GetAttributeName("leg", 1000).empty());
}

TEST_CASE("SurveyMade: a source runs what is valid, and reports what is not", "[SurveyMade]")
{
  const Files files;
  Making making(files);
  making.AddInstrument();
  making.AddLeg(Head);
  CHECK(making.Survey->SetLegPosition(0, 0.0, 0.0, 2.0));
  vtkNew<vtkPlaneSource> floor;
  floor->SetOrigin(-50.0, -50.0, 0.0);
  floor->SetPoint1(50.0, -50.0, 0.0);
  floor->SetPoint2(-50.0, 50.0, 0.0);
  vtkNew<vtkHeliosSurveySource> source;
  const auto log = Observe(source);
  source->SetSurvey(making.Survey);
  source->SetInputConnection(0, floor->GetOutputPort());
  source->SetPulseWindow(0, 4000); // two lines
  source->Update();
  INFO(log->Errors);
  CHECK(source->GetOutput()->GetNumberOfPoints() > 100);
  CHECK(source->GetNumberOfPulses() == 100000); // 1 s of head rotation

  CHECK(making.Survey->SetLegAttribute(0, "headRotateStop_deg", "20"));
  CHECK(source->Load());
  CHECK(source->GetNumberOfPulses() == 200000);
  CHECK(making.Survey->SetLegAttribute(0, "headRotatePerSec_deg", "-10"));
  CHECK_FALSE(source->Load());
  CHECK(log->HasError("leg 0: the head rotates from"));
  CHECK(making.Survey->SetLegAttribute(0, "headRotatePerSec_deg", "10"));
  CHECK(source->Load());
}
