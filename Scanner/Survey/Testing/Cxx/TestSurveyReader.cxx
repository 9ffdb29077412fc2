// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Reads files in the HELIOS dialect; errors give the line.
#include "vtkHeliosSurveyReader.h"

#include "heliosSurveyChanges.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <string>
#include <vector>

namespace fs = std::filesystem;
using namespace helios::test;

namespace
{

std::size_t CountOf(const std::string& part, const std::string& text)
{
  std::size_t count = 0;
  for (std::size_t i = text.find(part); i != std::string::npos; i = text.find(part, i + 1))
  {
    ++count;
  }
  return count;
}

/// A <filter> with one parameter.
std::string Filter(const char* type, const char* key, const char* value)
{
  return std::string("<filter type=\"") + type + "\"><param key=\"" + key + "\" value=\"" + value +
    "\"/></filter>";
}

} // namespace

TEST_CASE("SurveyReader: scanner, platform and units", "[SurveyReader]")
{
  const Files files;
  Reading reading(files, Tripod, R"(<leg><platformSettings x="1" y="2" z="3"/>
<scannerSettings scanFreq_hz="100" headRotatePerSec_deg="30" headRotateStop_deg="90"/></leg>)");
  INFO(reading.Log->Errors);
  REQUIRE(reading.Good);
  const helios::ScannerData& scanner = reading.Data().Scanners.at(0);
  CHECK(scanner.PulseFrequencies == std::vector<double>{ 100000, 300000 });
  CHECK(scanner.Receiver.PulseLength == 5.0);
  CHECK(scanner.Receiver.RangeAccuracy == 0.005);
  CHECK(scanner.Receiver.DetectionThreshold == Approx(0.002e-9)); // in nanowatts
  CHECK(scanner.Receiver.NumberOfCircles == 2);
  CHECK(scanner.Beam.Position[2] == 0.2);
  CHECK(reading.Data().Platforms.at(0).Mount.Position[2] == 1.5);
  const helios::LegData& leg = reading.Data().Legs.at(0);
  CHECK(leg.Position[1] == 2.0);
  REQUIRE(leg.Scans.size() == 1);
  CHECK(leg.Scans[0].PulseFrequency == 100000); // the scanner's first
  CHECK(leg.Scans[0].BeamDivergence == 0.0004);
  CHECK(leg.Scans[0].VerticalAngleMin == -50);
  CHECK(leg.Scans[0].VerticalAngleMax == 50);
  CHECK(leg.GetHeadTime() == 3.0);
  CHECK(reading.Reader->GetSurvey()->GetName() == "test");
  CHECK(reading.Reader->GetSurvey()->GetNumberOfLegs() == 1);
}

TEST_CASE("SurveyReader: rotations of a mount, the last outermost", "[SurveyReader]")
{
  const Files files;
  Reading reading(files, Flight, R"(<leg><platformSettings z="100"/></leg>
<leg><platformSettings x="10" z="100"/></leg>)");
  REQUIRE(reading.Good);
  // x -90 rotates y down; z 90 keeps it there
  const helios::Vec3 down =
    helios::Rotate(reading.Data().Platforms.at(0).Mount.Orientation, { 0, 1, 0 });
  CHECK(down[2] == Approx(-1));
  const helios::Vec3 side =
    helios::Rotate(reading.Data().Platforms.at(0).Mount.Orientation, { 1, 0, 0 });
  CHECK(side[1] == Approx(1));
}

TEST_CASE("SurveyReader: given attributes of templates are inherited", "[SurveyReader]")
{
  const Files files;
  Reading reading(
    files, Tripod, R"(<scannerSettings id="base" pulseFreq_hz="300000" scanFreq_hz="50"
 headRotatePerSec_deg="10" headRotateStop_deg="20" beamDivergence_rad="0.001"/>
<scannerSettings id="fast" template="base" headRotatePerSec_deg="20"/>
<platformSettings id="place" x="5" y="6" z="7"/>
<leg><platformSettings template="place" y="8"/><scannerSettings template="fast" active="false"/></leg>
<leg><platformSettings template="place"/><scannerSettings template="base" scanFreq_hz="60"/></leg>)");
  INFO(reading.Log->Errors);
  REQUIRE(reading.Good);
  const auto& legs = reading.Data().Legs;
  REQUIRE(legs.size() == 2);
  CHECK(legs[0].Position == helios::Vec3(5, 8, 7));
  CHECK_FALSE(legs[0].Active);
  CHECK(legs[0].Scans.at(0).HeadRotateSpeed == 20);
  CHECK(legs[0].Scans.at(0).ScanFrequency == 50);
  CHECK(legs[0].Scans.at(0).BeamDivergence == 0.001);
  CHECK(legs[1].Position == helios::Vec3(5, 6, 7));
  CHECK(legs[1].Scans.at(0).HeadRotateSpeed == 10);
  CHECK(legs[1].Scans.at(0).ScanFrequency == 60);
  CHECK(legs[1].Scans.at(0).PulseFrequency == 300000);
}

TEST_CASE("SurveyReader: resolution in degrees sets line rate and head speed", "[SurveyReader]")
{
  const Files files;
  // f = 100 kHz, 240 degrees per facet: 0.12 deg need 50 lines per second, 0.1 deg per line 5 deg/s
  Reading reading(files, Tripod, R"(<leg><platformSettings/><scannerSettings
 verticalResolution_deg="0.12" horizontalResolution_deg="0.1" headRotateStop_deg="10"/></leg>)");
  INFO(reading.Log->Errors);
  REQUIRE(reading.Good);
  CHECK(reading.Data().Legs[0].Scans.at(0).ScanFrequency == Approx(50));
  CHECK(reading.Data().Legs[0].Scans.at(0).HeadRotateSpeed == Approx(5));
}

TEST_CASE("SurveyReader: asset folders have precedence over that of the survey", "[SurveyReader]")
{
  const Files files;
  std::string other = ReadText(files / "assets.xml");
  other.replace(other.find("pulseLength_ns=\"5\""), 18, "pulseLength_ns=\"9\"");
  files.Write("extra/assets.xml", other);
  Reading plain(files, Tripod,
    "<leg><platformSettings/><scannerSettings scanFreq_hz=\"50\" "
    "headRotatePerSec_deg=\"10\" headRotateStop_deg=\"20\"/></leg>");
  REQUIRE(plain.Good);
  CHECK(plain.Data().Scanners.at(0).Receiver.PulseLength == 5);
  vtkNew<vtkHeliosSurveyReader> reader;
  reader->AddAssetDirectory((files / "extra").c_str());
  reader->SetFileName((files / "survey.xml").c_str());
  REQUIRE(reader->Read());
  CHECK(reader->GetSurvey()->GetData().Scanners.at(0).Receiver.PulseLength == 9);
}

TEST_CASE(
  "SurveyReader: scene filters are applied as rotate, scale, translate, and the last scale counts",
  "[SurveyReader]")
{
  const Files files;
  files.Write("scene.xml", R"(<document><scene id="s"><part>
<filter type="translate"><param type="vec3" key="offset" value="1;2;3"/></filter>
<filter type="scale"><param type="double" key="scale" value="5"/></filter>
<filter type="objloader"><param type="string" key="filepath" value="plane.obj"/></filter>
<filter type="rotate"><param key="rotation" type="rotation"><rot axis="z" angle_deg="90"/></param></filter>
<filter type="scale"><param type="double" key="scale" value="2"/></filter>
</part></scene></document>)");
  Reading reading(files, Tripod,
    "<leg><platformSettings/><scannerSettings scanFreq_hz=\"50\" "
    "headRotatePerSec_deg=\"10\" headRotateStop_deg=\"20\"/></leg>");
  INFO(reading.Log->Errors);
  REQUIRE(reading.Good);
  const helios::PartData& part = reading.Data().Scene.Parts.at(0);
  CHECK(part.Scale == 2);
  CHECK(part.Translation == helios::Vec3(1, 2, 3));
  CHECK(helios::Rotate(part.Rotation, { 1, 0, 0 })[1] == Approx(1));
  CHECK(part.Name == "0");
  CHECK(reading.Log->HasWarning("scale"));
}

TEST_CASE("SurveyReader: repeated rotations of scene filters are kept", "[SurveyReader]")
{
  const Files files;
  const std::string turn = R"(<filter type="rotate"><param key="rotation" type="rotation">
<rot axis="AXIS" angle_deg="90"/></param></filter>)";
  std::string turns = turn + turn;
  turns.replace(turns.find("AXIS"), 4, "yaw").replace(turns.find("AXIS"), 4, "pitch");
  files.Replace("scene.xml", "</part>", turns + "</part>");
  Reading reading(files, Tripod, OneLeg);
  INFO(reading.Log->Errors);
  REQUIRE(reading.Good);
  // z: x to y; then x: y to z
  const helios::Quaternion& turned = reading.Data().Scene.Parts.at(0).Rotation;
  CHECK(helios::Rotate(turned, { 1, 0, 0 })[2] == Approx(1));
}

TEST_CASE("SurveyReader: rotations are global or local", "[SurveyReader]")
{
  const Files files;
  Reading global(files, Flight, ThreeLegs);
  files.Replace("assets.xml", "z=\"0.7\"", "z=\"0.7\" rotations=\"local\"");
  Reading local(files);
  REQUIRE(global.Good);
  REQUIRE(local.Good);
  // global: x by -90 first, so y ends down; local: z by 90 first, so y goes to -x and remains there
  CHECK(
    helios::Rotate(global.Data().Platforms.at(0).Mount.Orientation, { 0, 1, 0 })[2] == Approx(-1));
  CHECK(
    helios::Rotate(local.Data().Platforms.at(0).Mount.Orientation, { 0, 1, 0 })[0] == Approx(-1));
}

TEST_CASE("SurveyReader: attributes of the scanner that a survey overrides", "[SurveyReader]")
{
  const Files files;
  Reading reading(files, Tripod, std::string(OneLeg) + R"(
<FWFSettings binSize_ns="0.5"/><detectorSettings accuracy_m="0.02" rangeMax_m="80"/>)");
  INFO(reading.Log->Errors);
  REQUIRE(reading.Good);
  CHECK(reading.Data().Scanners.at(0).Receiver.BinSize == 0.5);
  CHECK(reading.Data().Scanners.at(0).Receiver.NumberOfCircles == 2); // the scanner's
  CHECK(reading.Data().Scanners.at(0).Receiver.RangeAccuracy == 0.02);
  CHECK(reading.Data().Scanners.at(0).Receiver.RangeMin == 0.5);
  CHECK(reading.Data().Scanners.at(0).Receiver.RangeMax == 80.0);
}

TEST_CASE(
  "SurveyReader: references and numbers in the notation of existing files", "[SurveyReader]")
{
  const Files files;
  files.Write("data/scanners.xml", ReadText(files / "assets.xml"));
  files.Write("lone.xml", ReadText(files / "scene.xml"));
  files.Write("sub/survey.xml", R"(<document><platform id="stand" type="dummy"/>
<survey platform="#stand" scanner="scanners.xml#tls" scene="near.xml#s">
<leg maxDuration_s="4"><platformSettings x=" +1.5e1 " y="-.5" onGround="FALSE"/>
<scannerSettings scanFreq_hz="50." active="True"/></leg>
<leg><scannerSettings scanFreq_hz="50" beamDivergenceRad="0"><maxDuration_s>2.5</maxDuration_s>
</scannerSettings></leg></survey></document>)");
  files.Write("sub/near.xml", R"(<document><scene id="s"><part><filter type="OBJLoader">
<param key="filepath" value="plane.obj"/></filter></part></scene></document>)");
  vtkNew<vtkHeliosSurveyReader> reader;
  const auto log = Observe(reader);
  reader->AddAssetDirectory((files / "").c_str());
  reader->SetFileName((files / "sub/survey.xml").c_str());
  REQUIRE(reader->Read());
  INFO(log->Warnings);
  CHECK(log->Warnings.empty());
  const helios::SurveyData& data = reader->GetSurvey()->GetData();
  CHECK(data.Name == "survey"); // name of the file
  CHECK(data.Scanners.at(0).Id == "tls");
  CHECK(data.Platforms.at(0).Type == helios::PlatformType::Static);
  CHECK(data.Scene.Parts.at(0).Files.at(0) == files / "plane.obj");
  CHECK(data.Legs.at(0).Position == helios::Vec3(15, -0.5, 0));
  CHECK(data.Legs.at(0).MaximumDuration == 4.0);
  CHECK(data.Legs.at(1).MaximumDuration == 2.5);
  CHECK(data.Legs.at(1).Scans.at(0).BeamDivergence == 0.0); // a single ray
}

TEST_CASE("SurveyReader: an expression for file names gives one part per file", "[SurveyReader]")
{
  const Files files;
  files.Write("trees/oak_2.obj", "v 0 0 0\n");
  files.Write("trees/oak_1.obj", "v 0 0 0\n");
  files.Write("trees/oak_1.mtl", "");
  files.Write("trees/ash.obj", "v 0 0 0\n");
  const std::string part =
    "<part>" + Filter("objloader", "efilepath", "trees/oak_.*[.]obj") + "</part>";
  files.Replace("scene.xml", "</scene>", part + part + "</scene>");
  const Reading first(files, Tripod, OneLeg);
  REQUIRE(first.Good);
  const auto& parts = first.Reader->GetSurvey()->GetData().Scene.Parts;
  REQUIRE(parts.size() == 5);
  CHECK(parts[1].Name == "1");
  CHECK(parts[1].Files == std::vector<std::string>{ files / "trees/oak_1.obj" });
  CHECK(parts[4].Name == "4");
  CHECK(parts[4].Files == std::vector<std::string>{ files / "trees/oak_2.obj" });
  CHECK(first.Reader->GetSurvey()->GetPartName(0) == "floor");
  CHECK(first.Reader->GetSurvey()->GetPartName(9).empty());

  files.Replace("scene.xml", "<part><filter type=\"objloader\"><param key=\"efilepath\"",
    "<part id=\"oaks\"><filter type=\"objloader\"><param key=\"efilepath\"");
  const Reading second(files);
  REQUIRE(second.Good);
  const auto& joined = second.Reader->GetSurvey()->GetData().Scene.Parts;
  REQUIRE(joined.size() == 4); // with an id one part has both files
  CHECK(joined[1].Name == "oaks");
  CHECK(joined[1].Files.size() == 2);
}

TEST_CASE("SurveyReader: input that is not XML, or of another kind", "[SurveyReader]")
{
  const Files files;
  struct Document
  {
    std::string Text;
    std::vector<std::string> Messages;
  };
  std::string deep;
  for (int i = 0; i < 200000; ++i)
  {
    deep += i < 3 ? "<a>\n" : "<a>";
  }
  for (int i = 0; i < 200000; ++i)
  {
    deep += "</a>";
  }
  const std::vector<Document> documents = {
    { "<document>" + deep + "</document>", { "survey.xml:4", "nested more than 64 times" } },
    { "", { "survey.xml:1", "empty" } },
    { " \n\n ", { "survey.xml:1", "empty" } },
    { "<document>\n<survey>\n</document>", { "survey.xml:3", "not XML", "tags mismatch" } },
    { "<document>\n<survey name=\"a\"", { "survey.xml:2", "not XML" } },
    { "<document>\n\n<survey name=unquoted/></document>", { "survey.xml:3", "not XML" } },
    { "<scene>\n</scene>", { "survey.xml:1", "the root element is <scene>", "<document>" } },
    { "<!-- only this -->", { "survey.xml:1", "root element is missing" } },
    { "<document/>\n\n<document/>", { "survey.xml:3", "second root element" } },
    { "<document>\n<survey name=\"a\"\nname=\"b\"/></document>",
      { "survey.xml:2", "attribute name twice" } },
    { "<document>\n</document>", { "survey.xml:1", "no <survey>" } },
    { "\xFF\xFE<", { "survey.xml:1", "UTF-16", "save it as UTF-8" } },
  };
  for (const Document& document : documents)
  {
    INFO(document.Text);
    files.Write("survey.xml", document.Text);
    CheckRefused(files, document.Messages);
  }
  fs::remove(files / "survey.xml");
  CheckRefused(files, { "survey.xml: no such file; give the name of an XML or YAML file" });
  fs::create_directory(files / "survey.xml");
  CheckRefused(files, { "survey.xml: cannot be read" });
  vtkNew<vtkHeliosSurveyReader> reader;
  const auto log = Observe(reader);
  CHECK_FALSE(reader->Read());
  CHECK(log->HasError("FileName is not set"));
}

TEST_CASE("SurveyReader: XML in other encodings and notations", "[SurveyReader]")
{
  const Files files;
  REQUIRE(Reading(files, Tripod, OneLeg).Good);
  SECTION("without a declaration")
  {
    files.Replace("survey.xml", "<?xml version=\"1.0\"?>\n", "");
    const Reading reading(files);
    CHECK(reading.Good);
    CHECK(reading.Log->Warnings.empty());
  }
  SECTION("with a byte order mark; line numbers are correct")
  {
    files.Write("survey.xml", "\xEF\xBB\xBF" + ReadText(files / "survey.xml"));
    CHECK(Reading(files).Good);
    files.Replace("survey.xml", "x=\"1\"", "x=\"one\"");
    CheckRefused(files, { "survey.xml:4", "x=\"one\"" });
  }
  SECTION("in Latin-1; line numbers are correct")
  {
    files.Replace("survey.xml", "version=\"1.0\"", "version=\"1.0\" encoding=\"ISO-8859-1\"");
    files.Replace(
      "survey.xml", "<document>", "<document><!-- \xE4\xF6\xFC\xE4\xF6\xFC\xE4\xF6 -->");
    files.Replace("survey.xml", "\"test\"", "\"B\xE4ume\"");
    const Reading reading(files);
    REQUIRE(reading.Good);
    CHECK(reading.Reader->GetSurvey()->GetName() == "B\xC3\xA4ume");
    files.Replace("survey.xml", "x=\"1\"", "x=\"one\"");
    CheckRefused(files, { "survey.xml:4", "x=\"one\"" });
  }
  SECTION("with a document type: it is not read, its entities are not expanded")
  {
    files.Replace("survey.xml", "<document>",
      "<!DOCTYPE document [<!ENTITY who SYSTEM \"file:///etc/hostname\">]>\n<document>");
    files.Replace("survey.xml", "\"test\"", "\"&who;\"");
    const Reading reading(files);
    REQUIRE(reading.Good);
    CHECK(reading.Log->HasWarning("entities are not expanded"));
    CHECK(reading.Reader->GetSurvey()->GetName() == "&who;");
  }
  SECTION("with two surveys: the first is run")
  {
    files.Replace("survey.xml", "</document>", "<survey name=\"second\"/></document>");
    const Reading reading(files);
    REQUIRE(reading.Good);
    CHECK(reading.Log->HasWarning("only the first"));
    CHECK(reading.Reader->GetSurvey()->GetName() == "test");
  }
  SECTION("with an invalid folder name")
  {
    files.Replace("survey.xml", "\"test\"", "\"../../up\"");
    const Reading reading(files);
    REQUIRE(reading.Good);
    CHECK(reading.Log->HasWarning("survey.xml:3"));
    CHECK(reading.Reader->GetSurvey()->GetName() == ".._.._up");
  }
}

TEST_CASE("SurveyReader: each element is itself, also in one line", "[SurveyReader]")
{
  const Files files;
  const std::string flight = R"(<leg scanner="assets.xml#als" platform="assets.xml#plane">
<platformSettings x="X" z="100"/><scannerSettings scanFreq_hz="50" scanAngle_deg="5"/></leg>)";
  const auto at = [&flight](const std::string& x)
  { return std::string(flight).replace(flight.find('X'), 1, x); };
  const Reading reading(files, Tripod, at("0") + at("9") + OneLeg + at("0") + at("9") + OneLeg);
  INFO(reading.Log->Errors);
  REQUIRE(reading.Good);
  std::string text = ReadText(files / "assets.xml");
  text.erase(std::remove(text.begin(), text.end(), '\n'), text.end());
  files.Write("assets.xml", text);
  const Reading again(files);
  REQUIRE(again.Good);
  REQUIRE(again.Data().Scanners.size() == 2);
  REQUIRE(again.Data().Platforms.size() == 2);
  for (std::size_t leg = 0; leg < 6; ++leg)
  {
    const bool isStill = leg % 3 == 2;
    CHECK(again.Data().GetScanner(leg).Id == (isStill ? "tls" : "als"));
    CHECK(again.Data().GetPlatform(leg).Id == (isStill ? "tripod" : "plane"));
    CHECK(again.Data().GetScanner(leg).Id == reading.Data().GetScanner(leg).Id);
  }
}

TEST_CASE("SurveyReader: lines end in LF, CR LF or CR", "[SurveyReader]")
{
  for (const std::string end : { "\n", "\r\n", "\r" })
  {
    const Files files;
    files.Write("survey.xml", "<document>" + end + end + "<survey/>" + end + "</document>");
    CheckRefused(files, { "survey.xml:3: <survey> has no attribute scene" });
  }
}

TEST_CASE("SurveyReader: values of the wrong type", "[SurveyReader]")
{
  CheckAllRefused(Tripod, OneLeg,
    {
      { "survey.xml", "x=\"1\"", "x=\"1,5\"",
        { "survey.xml:4", "x=\"1,5\" is not a number", "decimal point", "[m]" } },
      { "survey.xml", "x=\"1\"", "x=\"abc\"", { "survey.xml:4", "x=\"abc\" is not a number" } },
      { "survey.xml", "x=\"1\"", "x=\"\"", { "survey.xml:4", "x=\"\" is not a number" } },
      { "survey.xml", "x=\"1\"", "x=\"nan\"", { "survey.xml:4", "x=\"nan\" is not a number" } },
      { "survey.xml", "x=\"1\"", "x=\"inf\"", { "survey.xml:4", "x=\"inf\" is not a number" } },
      { "survey.xml", "x=\"1\"", "x=\"1e999\"", { "survey.xml:4", "x=\"1e999\" is not a number" } },
      { "survey.xml", "x=\"1\"", "x=\"5 m\"", { "survey.xml:4", "x=\"5 m\" is not a number" } },
      { "survey.xml", "x=\"1\"", "x=\"+-5\"", { "survey.xml:4", "x=\"+-5\" is not a number" } },
      { "survey.xml", "x=\"1\"", "x=\"0x10\"", { "survey.xml:4", "x=\"0x10\" is not a number" } },
      { "survey.xml", "x=\"1\"", "onGround=\"yes\"",
        { "survey.xml:4", "onGround=\"yes\" is neither true nor false" } },
      { "survey.xml", "scanFreq_hz", "pulseFreq_hz=\"0\" scanFreq_hz",
        { "survey.xml:5", "pulseFreq_hz=\"0\" is out of range", "from 0.001 to", "[Hz]" } },
      { "survey.xml", "scanFreq_hz", "pulseFreq_hz=\"-5\" scanFreq_hz",
        { "survey.xml:5", "pulseFreq_hz=\"-5\" is out of range" } },
      { "survey.xml", "scanFreq_hz", "pulseFreq_hz=\"fast\" scanFreq_hz",
        { "survey.xml:5", "pulseFreq_hz=\"fast\" is not a number" } },
      { "survey.xml", "scanFreq_hz", "beamDivergence_rad=\"-0.1\" scanFreq_hz",
        { "survey.xml:5", "beamDivergence_rad=\"-0.1\" is out of range", "from 0 to 1 [rad]" } },
      { "assets.xml", "rangeMin_m", "maxNOR=\"2.5\" rangeMin_m",
        { "assets.xml:5", "maxNOR=\"2.5\" is not an integer" } },
      { "assets.xml", "rangeMin_m", "maxNOR=\"300\" rangeMin_m",
        { "assets.xml:5", "maxNOR=\"300\" is out of range; give a number from 0 to 255" } },
      { "assets.xml", "100000, 300000", "100000; 300000",
        { "assets.xml:5", "is not a list of numbers", "\"100000; 300000\" is not one", "commas" } },
      { "assets.xml", "100000, 300000", "100000, -1",
        { "assets.xml:5", "pulseFreqs_Hz=\"100000, -1\" is out of range" } },
      { "assets.xml", "beamSampleQuality=\"2\"", "beamSampleQuality=\"0\"",
        { "assets.xml:8", "beamSampleQuality=\"0\" is out of range; give a number from 1 to 64" } },
      { "assets.xml", "z=\"1.5\"/>", "z=\"1.5\"><rot axis=\"w\" angle_deg=\"1\"/></scannerMount>",
        { "assets.xml:2", "axis=\"w\" is not valid", "x, y or z" } },
      { "assets.xml", "z=\"1.5\"/>", "z=\"1.5\"><rot axis=\"x\"/></scannerMount>",
        { "assets.xml:2", "<rot> has no angle_deg" } },
      { "assets.xml", "z=\"1.5\"/>", "z=\"1.5\" rotations=\"mine\"/>",
        { "assets.xml:2", "rotations=\"mine\" is neither global nor local" } },
    });
}

TEST_CASE("SurveyReader: all errors are reported, each once", "[SurveyReader]")
{
  const Files files;
  Reading reading(files, Tripod,
    R"(<scannerSettings id="t" scanFreq_hz="x"/><leg><scannerSettings template="t"/></leg>
<leg><scannerSettings template="t" pulseFreq_hz="0"/></leg>)");
  CHECK_FALSE(reading.Good);
  CHECK(CountOf("scanFreq_hz=\"x\"", reading.Log->Errors) == 1);
  CHECK(CountOf("pulseFreq_hz=\"0\"", reading.Log->Errors) == 1);
}

TEST_CASE("SurveyReader: references without a target", "[SurveyReader]")
{
  CheckAllRefused(Tripod, OneLeg,
    {
      { "survey.xml", "#tripod", "#tripot",
        { "survey.xml:3", "platform=\"assets.xml#tripot\"", "assets.xml has no <platform>",
          "did you mean tripod?", "Its ids are tripod, plane" } },
      { "survey.xml", "#tls", "#mls", { "survey.xml:3", "Its ids are tls, als" } },
      { "survey.xml", "#s\"", "#wood\"",
        { "survey.xml:3", "has no <scene> with the id \"wood\"" } },
      { "survey.xml", "assets.xml#tls", "als",
        { "survey.xml:3", "It has none; refer", "file.xml#id" } },
      { "survey.xml", "assets.xml#tls", "scanners.xml#tls",
        { "survey.xml:3", "scanner=\"scanners.xml\": no such file", "looked for",
          "asset directories" } },
      { "survey.xml", "scanner=\"assets.xml#tls\"", "",
        { "survey.xml:3", "<survey> has no attribute scanner", "scanner=\"file.xml#id\"" } },
      { "survey.xml", "assets.xml#tripod", "interpolated",
        { "survey.xml:5", "platform=\"interpolated\" needs a trajectory" } },
      { "survey.xml", "x=\"1\"", "template=\"none\"",
        { "survey.xml:4", "has no <platformSettings> with the id \"none\"" } },
      { "assets.xml", "</document>", "</docment>", { "assets.xml:11", "not XML" } },
      { "scene.xml", "plane.obj", "plain.obj",
        { "scene.xml:2", "filepath=\"plain.obj\": no such file", "looked for", "plain.obj" } },
    });
  const Files files;
  Reading circle(files, Tripod,
    R"(<platformSettings id="a" template="b"/><platformSettings id="b" template="a"/>
<leg><platformSettings template="a"/></leg>)");
  CHECK_FALSE(circle.Good);
  CHECK(circle.Log->HasError("refers back to itself"));
}

TEST_CASE("SurveyReader: surveys without legs", "[SurveyReader]")
{
  CheckAllRefused(
    Tripod, OneLeg, { { "survey.xml", OneLeg, "", { "survey.xml:3", "has 0 <leg>", "add one" } } });
  const std::string legs = ThreeLegs;
  CheckAllRefused(Flight, ThreeLegs,
    { { "survey.xml", legs, legs.substr(0, legs.find("<leg", 1)),
      { "survey.xml:5", "platform plane has 1 <leg>", "needs two" } } });
}

TEST_CASE("SurveyReader: unsupported elements", "[SurveyReader]")
{
  const std::string loader = R"(<filter type="objloader">)";
  CheckAllRefused(Tripod, OneLeg,
    {
      { "assets.xml", "optics=\"rotating\"", "optics=\"turning\"",
        { "assets.xml:5", "optics=\"turning\" is not valid",
          "expected rotating, oscillating, line, conic, palmer, risley or spinning" } },
      { "assets.xml", "type=\"static\"", "type=\"multicopter\"",
        { "survey.xml:5", "platform tripod has 1 <leg>", "needs two" } },
      { "assets.xml", "type=\"static\"", "type=\"sttic\"",
        { "assets.xml:2", "type=\"sttic\" is not valid",
          "did you mean static? Expected static, dummy, linearpath, groundvehicle or "
          "multicopter" } },
      { "scene.xml", "\"objloader\"", "\"assumematerials\"",
        { "scene.xml:2", "assumematerials", "is not supported by this version" } },
      { "scene.xml", "\"objloader\"", "\"objloder\"",
        { "scene.xml:2", "type=\"objloder\" is unknown", "did you mean objloader?" } },
    });
}

TEST_CASE("SurveyReader: invalid scenes", "[SurveyReader]")
{
  const std::string part = ReadText(Files() / "scene.xml");
  CheckAllRefused(Tripod, OneLeg,
    {
      { "scene.xml", part, "<document><scene id=\"s\"/></document>",
        { "scene.xml:1", "scene s has no <part>" } },
      { "scene.xml", "</scene>", "\n<part id=\"b\"/></scene>",
        { "scene.xml:4", "<part> has no loader", "objloader" } },
      { "scene.xml", "</part>", Filter("objloader", "filepath", "plane.obj") + "</part>",
        { "scene.xml:3", "second loader" } },
      { "scene.xml", "key=\"filepath\"", "key=\"up\"", { "scene.xml:2", "no filepath" } },
      { "scene.xml", "</filter>", "<param key=\"up\" value=\"x\"/></filter>",
        { "scene.xml:2", "up=\"x\"", "y or z" } },
      { "scene.xml", "</part>", Filter("scale", "scale", "-1") + "</part>",
        { "scene.xml:3", "scale=\"-1\" is out of range" } },
      { "scene.xml", "</part>", Filter("scale", "scale", "0") + "</part>",
        { "scene.xml:3", "scale=\"0\" is out of range; give a number from 1e-09" } },
      { "scene.xml", "</part>", Filter("scale", "scale", "1e-320") + "</part>",
        { "scene.xml:3", "scale=\"1e-320\" is out of range" } },
      { "scene.xml", "</part>", Filter("translate", "offset", "1;2;-1e13") + "</part>",
        { "scene.xml:3",
          "offset=\"1;2;-1e13\" is out of range; give a number from -1000000000000" } },
      { "scene.xml", "</part>", Filter("translate", "offset", "1;2") + "</part>",
        { "scene.xml:3", "offset=\"1;2\" is not a vector", "semicolons" } },
      { "scene.xml", "</part>", Filter("translate", "offset", "1;2;x") + "</part>",
        { "scene.xml:3", "offset=\"1;2;x\" is not a vector" } },
      { "scene.xml", "</part>", Filter("translate", "onGround", "true") + "</part>",
        { "scene.xml:3", "onGround=\"true\" is not an integer" } },
      { "scene.xml", "key=\"filepath\" value=\"plane.obj\"", "key=\"efilepath\" value=\"none.*\"",
        { "scene.xml:2", "efilepath=\"none.*\": no file matches", "looked in" } },
      { "scene.xml", "key=\"filepath\" value=\"plane.obj\"", "key=\"efilepath\" value=\"[\"",
        { "scene.xml:2", "efilepath=\"[\" is not a valid regular expression" } },
      { "scene.xml", "key=\"filepath\" value=\"plane.obj\"",
        "key=\"efilepath\" value=\"d/" + std::string(50000, '(') + "\"",
        { "scene.xml:2",
          "(50002 characters)\" is not a valid regular expression: it has 50000 characters" } },
      { "scene.xml", "key=\"filepath\" value=\"plane.obj\"",
        "key=\"efilepath\" value=\"(?!x).*obj\"",
        { "scene.xml:2", "is not a valid regular expression", "lookahead and back references" } },
    });
}

TEST_CASE("SurveyReader: invalid scanners", "[SurveyReader]")
{
  CheckAllRefused(Tripod, OneLeg,
    {
      { "assets.xml", "scanAngleMax_deg=\"120\"", "",
        { "assets.xml:5", "scanner tls", "scanAngleMax_deg is missing or 0" } },
      { "assets.xml", "<FWFSettings", "<FWFSettings binSize_ns=\"3\"",
        { "assets.xml:8", "binSize_ns=\"3\" is wider than half of pulseLength_ns=\"5\"" } },
      { "assets.xml", "rangeMin_m=\"0.5\"", "rangeMin_m=\"50\" rangeMax_m=\"20\"",
        { "assets.xml:5", "rangeMin_m=\"50\" is not below rangeMax_m=\"20\"" } },
      { "assets.xml", "pulseFreqs_Hz=\"100000, 300000\"", "",
        { "survey.xml:5", "no pulse frequency", "pulseFreqs_Hz for scanner tls" } },
    });
}

TEST_CASE("SurveyReader: invalid legs", "[SurveyReader]")
{
  const std::string stop = "headRotateStop_deg=\"10\"";
  CheckAllRefused(Tripod, OneLeg,
    {
      { "survey.xml", "scanFreq_hz=\"50\"", "horizontalResolution_deg=\"1\"",
        { "survey.xml:5", "needs verticalResolution_deg" } },
      { "survey.xml", stop, "headRotateStop_deg=\"-10\"",
        { "survey.xml:5", "headRotateStop_deg=\"-10\"", "never reaches it", "exchange" } },
      { "survey.xml", stop, "", { "survey.xml:5", "the leg has no duration" } },
      { "survey.xml", "headRotatePerSec_deg=\"10\"", "",
        { "survey.xml:5", "the leg never ends", "maxDuration_s" } },
      { "survey.xml", "headRotatePerSec_deg=\"10\"", "headRotatePerSec_deg=\"1e-12\"",
        { "survey.xml:5", "the leg never ends" } },
      { "survey.xml", stop, stop + " verticalAngleMin_deg=\"20\" verticalAngleMax_deg=\"10\"",
        { "survey.xml:5", "verticalAngleMin_deg=\"20\"", "is not a valid window" } },
    });
  CheckAllRefused(Flight, ThreeLegs,
    { { "survey.xml", "movePerSec_m=\"50\"", "movePerSec_m=\"0\"",
        { "survey.xml:5", "movePerSec_m=\"0\"", "above 0 [m/s]" } },
      { "survey.xml", "movePerSec_m=\"50\"", "movePerSec_m=\"1e-300\"",
        { "survey.xml:5", "movePerSec_m=\"1e-300\"", "never reaches the next leg" } } });
}

TEST_CASE("SurveyReader: values beyond a limit of the instrument are clipped", "[SurveyReader]")
{
  using Scan = helios::ScanData;
  struct Clipped
  {
    std::string Settings;
    double Scan::*Value;
    double Limit;
    std::string Warning;
  };
  const std::string window = "verticalAngleMin_deg=\"-50\" verticalAngleMax_deg=\"70\"";
  const std::string wide = "verticalAngleMin_deg=\"-40\" verticalAngleMax_deg=\"80\"";
  const std::string resolution = "verticalResolution_deg=\"2\" horizontalResolution_deg=\"0.5\"";
  const std::string of = " of scanner tls";
  const Clipped clips[] = {
    { "scanFreq_hz=\"500\"", &Scan::ScanFrequency, 120,
      "\"500\" is clipped to 120, scanFreqMax_Hz" },
    { "scanFreq_hz=\"1\"", &Scan::ScanFrequency, 3, "\"1\" is clipped to 3, scanFreqMin_Hz" },
    { "", &Scan::ScanFrequency, 3, "scanFreq_hz=\"0\" is clipped to 3, scanFreqMin_Hz" },
    { resolution, &Scan::ScanFrequency, 120,
      "requires, 833.333333333333 Hz, is clipped to 120, scanFreqMax_Hz" },
    { resolution, &Scan::HeadRotateSpeed, 60, "" },
    { "headRotatePerSec_deg=\"90\"", &Scan::HeadRotateSpeed, 60,
      "headRotatePerSec_deg=\"90\" is clipped to 60, headRotatePerSecMax_deg" },
    { "scanAngle_deg=\"150\"", &Scan::ScanAngle, 120,
      "scanAngle_deg=\"150\" is clipped to 120, scanAngleMax_deg" },
    { window, &Scan::VerticalAngleMin, -50,
      "verticalAngleMin_deg=\"-50\" to verticalAngleMax_deg=\"70\" (120 deg) is clipped to 100, "
      "twice scanAngleEffectiveMax_deg" },
    { window, &Scan::VerticalAngleMax, 50, "" },
    { wide, &Scan::VerticalAngleMin, -40, "(120 deg) is clipped to 100" },
    { wide, &Scan::VerticalAngleMax, 60, "" },
  };
  for (const Clipped& clip : clips)
  {
    CAPTURE(clip.Settings, clip.Warning);
    const bool hasSpeed = clip.Settings.find("headRotatePerSec") != std::string::npos;
    const bool hasFrequency = clip.Settings.find("erticalA") != std::string::npos ||
      clip.Settings.find("headR") != std::string::npos ||
      clip.Settings.find("scanA") != std::string::npos;
    const std::string leg = std::string("<leg><platformSettings/>\n<scannerSettings ") +
      clip.Settings + (hasSpeed ? "" : " headRotatePerSec_deg=\"10\"") +
      (hasFrequency ? " scanFreq_hz=\"50\"" : "") + " headRotateStop_deg=\"10\"/></leg>\n";
    const Files files;
    const Reading reading(files, Tripod, leg + leg); // the second gives no more warnings
    INFO(reading.Log->Errors << reading.Log->Warnings);
    REQUIRE(reading.Good);
    CHECK(reading.Data().Legs.at(1).Scans.at(0).*clip.Value == Approx(clip.Limit).epsilon(1e-12));
    if (!clip.Warning.empty())
    {
      CHECK(reading.Log->HasWarning("survey.xml:5: "));
      CHECK(CountOf(clip.Warning, reading.Log->Warnings) == 1);
      CHECK(CountOf(of, reading.Log->Warnings) == 1);
    }
  }
}

TEST_CASE(
  "SurveyReader: the end point of a path and inactive legs are not checked", "[SurveyReader]")
{
  const Files files;
  std::string legs = ThreeLegs;
  legs.replace(legs.rfind("scanFreq_hz=\"50\""), 16, "scanFreq_hz=\"500\"");
  legs.replace(legs.rfind("movePerSec_m=\"50\""), 17, "movePerSec_m=\"0\"");
  const Reading reading(files, Flight, legs);
  INFO(reading.Log->Errors);
  CHECK(reading.Good);
  CHECK(reading.Reader->GetSurvey()->IsLegActive(1));
  CHECK_FALSE(reading.Reader->GetSurvey()->IsLegActive(2));
  CHECK(Reading(files, Tripod, "<leg><scannerSettings active=\"false\"/></leg>").Good);
}

TEST_CASE("SurveyReader: unused attributes are reported", "[SurveyReader]")
{
  CheckAllWarned(Tripod, OneLeg,
    {
      { "survey.xml", "scanFreq_hz", "pulsFreq_hz=\"1\" scanFreq_hz",
        { "survey.xml:5", "attribute pulsFreq_hz of <scannerSettings> is unknown",
          "did you mean pulseFreq_hz?" } },
      { "survey.xml", "scanFreq_hz", "colour=\"red\" scanFreq_hz",
        { "survey.xml:5", "attribute colour", "is unknown and not used" } },
      { "survey.xml", "<survey", "<survei/><survey",
        { "survey.xml:3", "element <survei> in <document> is unknown; did you mean <survey>?" } },
      { "survey.xml", "</leg>", "<weather/></leg>",
        { "survey.xml:5", "element <weather> in <leg> is unknown and not used" } },
      { "survey.xml", "</survey>", "<FWFSettings peakEnergy=\"500\" numTimeBins=\"100\"/></survey>",
        { "survey.xml:6", "attribute peakEnergy of <FWFSettings> is not used",
          "attribute numTimeBins" } },
      { "survey.xml", "</leg>", "<scannerSettings/></leg>",
        { "survey.xml:5", "a second <scannerSettings> in one <leg> is not used" } },
      { "scene.xml", "</filter>", "<param key=\"filepth\" value=\"\"/></filter>",
        { "scene.xml:2", "parameter \"filepth\" of filter objloader is unknown",
          "did you mean filepath?" } },
      { "scene.xml", "</part>",
        Filter("translate", "offset", "1;2;3") + Filter("translate", "offset", "0;0;1") + "</part>",
        { "scene.xml:3", "repeated filter translate" } },
      { "assets.xml", "<beamOrigin", "<headRotateAxis z=\"0.01\"/><beamOrigin",
        { "assets.xml:9", "<headRotateAxis> is shorter than 0.1" } },
      { "survey.xml", "scanFreq_hz", "pulseFreq_hz=\"123456\" scanFreq_hz",
        { "survey.xml:5", "pulseFreq_hz=\"123456\" is not supported by scanner tls",
          "(supported: 100000, 300000 Hz); used anyway" } },
      { "survey.xml", "scanFreq_hz", "scanAngle_deg=\"150\" scanFreq_hz",
        { "survey.xml:5", "scanAngle_deg=\"150\" is clipped to 120" } },
      { "survey.xml", "headRotatePerSec_deg=\"10\"", "headRotatePerSec_deg=\"90\"",
        { "survey.xml:5", "headRotatePerSec_deg=\"90\" is clipped to 60" } },
    });
  CheckAllWarned(Flight, ThreeLegs,
    { { "survey.xml", "scanFreq_hz", "verticalResolution_deg=\"1\" scanFreq_hz",
      { "survey.xml:5", "not used by conic optics" } } });
}

TEST_CASE("SurveyReader: warnings are reported once", "[SurveyReader]")
{
  const Files files;
  const Reading reading(files, Tripod,
    R"(<leg><scannerSettings active="0" speed="1"/></leg><leg><scannerSettings active="0" speed="2"/>
</leg>)");
  CHECK(CountOf("attribute speed", reading.Log->Warnings) == 1);
  CHECK(reading.Log->HasWarning("survey.xml:4"));
}
