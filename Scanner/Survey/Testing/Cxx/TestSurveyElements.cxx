// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Every attribute of every element of the dialect is made by a method, or on a list with a reason.
#include "heliosEpochs.h"
#include "heliosSurveyFiles.h"
#include "heliosXmlFilter.h"
#include "heliosXmlRules.h"

#include <catch2/catch.hpp>

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

/// Attributes that are made in another way, by element or element/attribute, and why.
const std::map<std::string, std::string> Exceptions = {
  { "survey/scanner", "AddScannerFromFile, AddLeg" },
  { "survey/platform", "AddPlatformFromFile, AddLeg" },
  { "survey/basePlatform", "a platform with the type interpolated" },
  { "survey/scene", "AddPart, or an input" },
  { "survey/rangeTolerance_m", "an attribute of the scanner" },
  { "survey/energyTolerance", "an attribute of the scanner" },
  { "survey/scatteringOrders", "an attribute of the scanner" },
  { "survey/scatteringPaths", "an attribute of the scanner" },
  { "survey/scatteringPhase", "an attribute of the scanner" },
  { "survey/echoDetector", "an attribute of the scanner" },
  { "survey/pulseShape", "an attribute of the scanner" },
  { "survey/returnSelection", "an attribute of the scanner" },
  { "leg/scanner", "AddLeg" },
  { "leg/platform", "AddLeg" },
  { "scan", "groups legs of files of the Java program; each leg has its own settings" },
  { "scannerRotation", "of a scan; headRotateStart_deg and headRotateStop_deg of its legs" },
  { "origin", "an offset of files of the Java program; SetLegPosition" },
  { "platformSettings/id", "of a template of a file" },
  { "platformSettings/template", "of a file" },
  { "scannerSettings/id", "of a template of a file" },
  { "scannerSettings/template", "of a file" },
  { "scanner/id", "AddScanner" },
  { "platform/visModel", "model" },
  { "FWFSettings/winSize", "winSize_ns" },
  { "FWFSettings/apertureDiameter_m", "not used" },
  { "FWFSettings/apartureDiameter", "not used" },
  { "filter", "named in paths by its type" },
  { "param/type", "not needed" },
  { "param/key", "named in paths" },
  { "param/value", "the value of a path" },
  { "surveyPlanner", "a task of vtkHeliosScanPositionPlanner, not of a survey" },
};

/// The kinds of attributes, and the elements that begin their paths: an element is left out of the
/// path if it is in the first list.
struct Kind
{
  std::string Name;
  std::vector<std::string> Own;    // attributes without a prefix
  std::vector<std::string> Inside; // with one
};

const std::vector<Kind> Kinds = {
  { "survey", { "survey" }, {} },
  { "scene", { "scene" }, {} },
  { "part", { "part" }, { "swap", "dmotion", "trajectory" } },
  { "table", { "partTable" }, { "model", "row" } },
  { "scanner", { "scanner", "FWFSettings", "detectorSettings" },
    { "beamOrigin", "headRotateAxis", "incidentBeam", "rangeError", "deflectionError", "headError",
      "panoramicError", "channel", "beams" } },
  { "platform", { "platform" },
    { "scannerMount", "positionXNoise", "positionYNoise", "positionZNoise", "attitudeXNoise",
      "attitudeYNoise", "attitudeZNoise", "navigationError" } },
  { "leg", { "leg", "platformSettings", "scannerSettings" }, {} },
};

/// The kinds and paths of an attribute of an element, any of which may be known.
using Paths = std::vector<std::pair<std::string, std::string>>;

Paths FindPaths(const std::string& element, const std::string& attribute)
{
  Paths paths;
  for (const Kind& kind : Kinds)
  {
    for (const std::string& own : kind.Own)
    {
      if (own == element)
      {
        paths.emplace_back(kind.Name, attribute);
      }
    }
    for (const std::string& inside : kind.Inside)
    {
      const std::string between = inside == element ? "/" : "/" + element + "/";
      paths.emplace_back(kind.Name, inside + between + attribute);
    }
  }
  const std::string filter = element.rfind("filter:", 0) == 0 ? element.substr(7) : "";
  if (!filter.empty())
  {
    paths.emplace_back("part", filter + "/" + attribute);
    paths.emplace_back("part", "swap/" + filter + "/" + attribute);
  }
  if (element == "param" || element == "rot")
  {
    paths.emplace_back(
      "part", "swap/rotate/rotation/" + (element == "rot" ? "rot[0]/" + attribute : attribute));
  }
  if (element == "channel")
  {
    paths.emplace_back("scanner", attribute);
  }
  return paths;
}

/// A valid value.
std::string MakeValue(const XmlValueRule& rule)
{
  const std::vector<std::string> words = rule.GetChoices();
  if (!words.empty())
  {
    return words.back();
  }
  const std::string name = rule.Name;
  for (const char* number : { "1", "0.5", "0.0005", "300" })
  {
    if (rule.Kind != XmlKind::Text && rule.Range.Contains(std::stod(number)) &&
      (rule.Kind == XmlKind::Real || (rule.Kind == XmlKind::Integer && number[1] == '\0')))
    {
      return number;
    }
  }
  return rule.Kind == XmlKind::Integer ? "300"
    : rule.Kind == XmlKind::Boolean    ? "true"
    : rule.Kind == XmlKind::Vector     ? "0;1;0"
    : rule.Kind == XmlKind::RealList   ? rule.Range.Contains(1000.0) ? "1000" : "1"
    : rule.Kind == XmlKind::Rotation   ? ""
    : name == "pulseShape"             ? "helios"
    : name == "efilepath"              ? "pl.*[.]obj"
    : name == "weather"                ? "fog 0.5"
    : name == "gpsStartTime"           ? "gps:1400000000"
    : name == "seed"                   ? "40"
    : name == "expr" || name == "distanceMeasurementError" ? "0.5"
                                                           : "plane.obj";
}

/// A survey with one of each kind; parts are by each loader.
struct Bench
{
  Files Folder;
  vtkNew<vtkHeliosSurvey> Survey;
  vtkSmartPointer<ErrorObserver> Log = Observe(Survey);

  Bench()
  {
    this->Survey->AddAssetDirectory(this->Folder / "");
    this->Survey->AddScanner("tls");
    this->Survey->SetScannerAttribute(0, "scanAngleMax_deg", "60");
    this->Survey->SetScannerAttribute(0, "pulseFreqs_Hz", "100000");
    this->Survey->AddPlatform("tripod");
    this->Survey->AddLeg();
    this->Survey->SetLegAttribute(0, "maxDuration_s", "1");
    for (const std::string& loader : helios::GetLoaders())
    {
      this->Survey->AddPart(loader, "plane.obj");
    }
    this->Survey->AddPartTable("");
  }

  bool Set(const std::string& kind, const std::string& name, const std::string& value, int part = 0)
  {
    vtkHeliosSurvey* s = this->Survey;
    return kind == "survey" ? s->SetSurveyAttribute(name, value)
      : kind == "scene"     ? s->SetSceneAttribute(name, value)
      : kind == "part"      ? s->SetPartAttribute(part, name, value)
      : kind == "table"     ? s->SetPartTableAttribute(0, name, value)
      : kind == "scanner"   ? s->SetScannerAttribute(0, name, value)
      : kind == "platform"  ? s->SetPlatformAttribute(0, name, value)
                            : s->SetLegAttribute(0, name, value);
  }

  std::string Get(const std::string& kind, const std::string& name, int part = 0)
  {
    vtkHeliosSurvey* s = this->Survey;
    return kind == "survey" ? s->GetSurveyAttribute(name)
      : kind == "scene"     ? s->GetSceneAttribute(name)
      : kind == "part"      ? s->GetPartAttribute(part, name)
      : kind == "table"     ? s->GetPartTableAttribute(0, name)
      : kind == "scanner"   ? s->GetScannerAttribute(0, name)
      : kind == "platform"  ? s->GetPlatformAttribute(0, name)
                            : s->GetLegAttribute(0, name);
  }

  /// Whether one of the paths sets a value, which Get then returns, or a file of that name.
  bool SetsAny(const Paths& paths, const std::string& value)
  {
    for (const auto& [kind, path] : paths)
    {
      const int parts = kind == "part" ? static_cast<int>(helios::GetLoaders().size()) : 1;
      for (int part = 0; part < parts; ++part)
      {
        const std::string file = this->Folder / "plane.obj";
        if (this->Set(kind, path, value, part))
        {
          const std::string got = this->Get(kind, path, part);
          return got == value || got == file || got == this->Folder / value;
        }
      }
    }
    return false;
  }
};

bool IsException(const std::string& element, const std::string& attribute)
{
  return Exceptions.count(element) > 0 || Exceptions.count(element + "/" + attribute) > 0;
}

} // namespace

TEST_CASE("SurveyElements: every attribute of the dialect is set by a method", "[SurveyElements]")
{
  int count = 0;
  std::set<std::string> used;
  for (const XmlElementRule& rule : GetXmlRules())
  {
    for (const XmlValueRule& value : rule.Values)
    {
      const std::string element = rule.Name;
      CAPTURE(element, value.Name);
      if (IsException(element, value.Name))
      {
        used.insert(Exceptions.count(element) > 0 ? element : element + "/" + value.Name);
      }
      else if (value.Use == XmlUse::Used && !value.IsAlias && value.Kind != XmlKind::Rotation)
      {
        ++count;
        Bench bench;
        CHECK(bench.SetsAny(FindPaths(element, value.Name), MakeValue(value)));
      }
    }
  }
  CHECK(count > 230);
  CHECK(used.size() == Exceptions.size()); // each is still in the table
}

TEST_CASE("SurveyElements: elements of a part are those of a file", "[SurveyElements]")
{
  const Files files;
  files.Write("ball.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  files.Write("scene.xml", R"(<document><scene id="s" dynTimeStep="0.01">
<part id="floor" dynTimeStep="0.05" kdtDynTimeStep="0.2">
<filter type="objloader"><param key="filepath" value="plane.obj"/></filter>
<filter type="crs"><param key="source" value="EPSG:25832"/><param key="target" value="EPSG:25833"/></filter>
<filter type="crs"><param key="source" value="EPSG:25833"/><param key="target" value="EPSG:25832"/></filter>
<filter type="repair"/>
<dmotion id="a" loop="10" next="b"><motion type="translation" vec="0.1;0;0"/>
<motion type="rotation" axis="0;0;1" angle="3" center="1;2;3" selfMode="true"/></dmotion>
<dmotion id="b" loop="5" next="a"><motion type="helical" axis="0;0;1" angle="2" glide="0.1"/></dmotion>
<swap swapStep="2"><filter type="objloader"><param key="filepath" value="ball.obj"/></filter>
<filter type="rotate"><param key="rotation" rotations="local"><rot axis="z" angle_deg="90"/>
<rot axis="x" angle_deg="30"/></param></filter>
<filter type="translate"><param key="offset" value="1;2;3"/></filter></swap>
<swap force_null="true"/></part>
<part id="other"><filter type="objloader"><param key="filepath" value="plane.obj"/></filter></part>
</scene></document>)");
  const Reading reading(files, Tripod, OneLeg);
  INFO(reading.Log->Errors);
  REQUIRE(reading.Good);
  vtkNew<vtkHeliosSurvey> made;
  const auto log = Observe(made);
  made->AddAssetDirectory(files / "");
  made->AddPart("objloader", "plane.obj");
  made->AddPart("objloader", "plane.obj");
  CHECK(made->SetSceneAttribute("dynTimeStep", "0.01"));
  const std::vector<std::pair<std::string, std::string>> values = { { "id", "floor" },
    { "dynTimeStep", "0.05" }, { "kdtDynTimeStep", "0.2" }, { "crs/source", "EPSG:25832" },
    { "crs/target", "EPSG:25833" }, { "crs[1]/source", "EPSG:25833" },
    { "crs[1]/target", "EPSG:25832" }, { "repair", "true" }, { "dmotion/id", "a" },
    { "dmotion/loop", "10" }, { "dmotion/next", "b" }, { "dmotion/motion/type", "translation" },
    { "dmotion/motion/vec", "0.1;0;0" }, { "dmotion/motion[1]/type", "rotation" },
    { "dmotion/motion[1]/axis", "0;0;1" }, { "dmotion/motion[1]/angle", "3" },
    { "dmotion/motion[1]/center", "1;2;3" }, { "dmotion/motion[1]/selfMode", "true" },
    { "dmotion[1]/id", "b" }, { "dmotion[1]/loop", "5" }, { "dmotion[1]/next", "a" },
    { "dmotion[1]/motion/type", "helical" }, { "dmotion[1]/motion/axis", "0;0;1" },
    { "dmotion[1]/motion/angle", "2" }, { "dmotion[1]/motion/glide", "0.1" },
    { "swap/swapStep", "2" }, { "swap/objloader/filepath", "ball.obj" },
    { "swap/rotate/rotation/rotations", "local" }, { "swap/rotate/rotation/rot/axis", "z" },
    { "swap/rotate/rotation/rot/angle_deg", "90" }, { "swap/rotate/rotation/rot[1]/axis", "x" },
    { "swap/rotate/rotation/rot[1]/angle_deg", "30" }, { "swap/translate/offset", "1;2;3" },
    { "swap[1]/force_null", "true" } };
  for (const auto& [name, value] : values)
  {
    INFO(name << " " << log->Errors);
    CHECK(made->SetPartAttribute(0, name, value));
    const bool isFile = name == "swap/objloader/filepath";
    CHECK(made->GetPartAttribute(0, name) == (isFile ? files / value : value));
  }
  const PartData& a = made->GetData().Scene.Parts.at(0);
  const PartData& b = reading.Data().Scene.Parts.at(0);
  CHECK(made->GetNumberOfEpochs() == 4);
  REQUIRE(a.Crs.size() == 2);
  CHECK(a.Crs[1].Target == b.Crs[1].Target);
  CHECK(a.Crs[0].Source == b.Crs[0].Source);
  CHECK((a.Repair && b.Repair));
  REQUIRE(a.Swaps.size() == 2);
  CHECK(a.Swaps[0].Epochs == 2);
  CHECK(a.Swaps[0].Part.Files == b.Swaps[0].Part.Files);
  for (int i = 0; i < 4; ++i)
  {
    CHECK(a.Swaps[0].Part.Rotation[i] == b.Swaps[0].Part.Rotation[i]);
  }
  CHECK(a.Swaps[0].Part.Translation[2] == 3.0);
  CHECK(a.Swaps[1].IsRemoved);
  CHECK(a.Motion.Seconds == b.Motion.Seconds);
  CHECK(a.Motion.Every == b.Motion.Every);
  CHECK(a.Swaps[0].Part.Motion.Sequences.size() == 2);
  const PartMotion now(a.Motion.Sequences);
  const PartMotion then(b.Motion.Sequences);
  for (const vtkIdType step : { 1, 7, 10, 12, 15, 40 })
  {
    const Vec3 p(1.0, 2.0, 3.0);
    CHECK((now.GetMap(step) * p - then.GetMap(step) * p).Norm() == 0.0);
  }
  CHECK(made->SetPartAttribute(0, "crs[1]", "")); // removed
  CHECK(made->SetPartAttribute(0, "repair", "false"));
  CHECK(made->SetPartAttribute(0, "dmotion", "") == true);
  CHECK(made->GetData().Scene.Parts.at(0).Crs.size() == 1);
  CHECK_FALSE(made->GetData().Scene.Parts.at(0).Repair);
  CHECK(made->GetData().Scene.Parts.at(0).Motion.Sequences.size() == 1);
  CHECK(made->GetPartAttribute(0, "repair").empty());
  made->RemoveAllParts();
  CHECK(made->AddPart("objloader", "plane.obj") == 0);
  CHECK(made->GetNumberOfEpochs() == 1); // nothing of the earlier part 0
}

TEST_CASE("SurveyElements: axes and mounts are those of a file", "[SurveyElements]")
{
  Bench bench;
  vtkHeliosSurvey* made = bench.Survey;
  CHECK(made->AddChannel(0) == 1);
  CHECK(bench.Set("scanner", "headRotateAxis/y", "2")); // x and z are then 0, like in a file
  CHECK(made->SetChannelAttribute(0, 1, "headRotateAxis/x", "1"));
  CHECK(made->SetChannelAttribute(0, 1, "headRotateAxis/y", "1"));
  CHECK(bench.Set("scanner", "incidentBeam/y", "1"));
  CHECK(bench.Set("scanner", "incidentBeam/z", "0.1"));
  CHECK(bench.Set("scanner", "beamOrigin/z", "0.2"));
  CHECK(bench.Set("scanner", "beamOrigin/rot/axis", "x"));
  CHECK(bench.Set("scanner", "beamOrigin/rot/angle_deg", "90"));
  const ScannerData& scanner = made->GetData().Scanners.at(0);
  CHECK(scanner.HeadRotateAxis[1] == 1.0);
  CHECK(scanner.HeadRotateAxis[2] == 0.0);
  CHECK(scanner.GetChannel(1).HeadRotateAxis[0] == Approx(std::sqrt(0.5)));
  CHECK(scanner.IncidentBeam[2] == 0.1);
  CHECK(scanner.Beam.Position[2] == 0.2);
  CHECK(Rotate(scanner.Beam.Orientation, { 0, 1, 0 })[2] == Approx(1.0));
  CHECK(made->AddChannel(0) == 2); // has what the first has
  CHECK(made->GetData().Scanners.at(0).GetChannel(2).HeadRotateAxis[1] == 1.0);
  CHECK(made->SetChannelAttribute(0, 2, "channel/id", "left"));
  CHECK(made->GetData().Scanners.at(0).GetChannel(2).Id == "tls, channel left");

  CHECK(bench.Set("platform", "scannerMount[0]/z", "0.7"));
  CHECK(bench.Get("platform", "scannerMount/z") == "0.7");
  for (const auto& [name, value] :
    std::vector<std::pair<std::string, std::string>>{ { "rot/axis", "x" },
      { "rot/angle_deg", "-90" }, { "rot[1]/axis", "z" }, { "rot[1]/angle_deg", "90" } })
  {
    CHECK(bench.Set("platform", "scannerMount/" + name, value));
  }
  CHECK(made->AddPlatformFromFile("assets.xml#plane") == 1); // has the same mount
  const auto& platforms = made->GetData().Platforms;
  for (int i = 0; i < 4; ++i)
  {
    CHECK(platforms[0].Mount.Orientation[i] == platforms[1].Mount.Orientation[i]);
  }
  CHECK(platforms[0].Mount.Position[2] == 0.7);
  CHECK(bench.Set("platform", "scannerMount/rotations", "local"));
  CHECK(platforms[0].Mount.Orientation[0] == made->GetData().Platforms[0].Mount.Orientation[0]);
  CHECK(made->SetPlatformAttribute(1, "scannerMount", "")); // the default replaces the file's
  CHECK(made->GetData().Platforms[1].Mount.Orientation[0] == 1.0);
  CHECK(bench.Set("scanner", "headRotateAxis", ""));
  CHECK(made->GetData().Scanners.at(0).HeadRotateAxis[2] == 1.0);

  CHECK(made->SetPlatformAttribute(1, "type", "interpolated"));
  CHECK(made->GetPlatformAttribute(1, "type") == "interpolated");
  CHECK(made->SetPlatformAttribute(1, "model", "plane.obj"));
  CHECK(made->GetData().Platforms[1].Model.File == bench.Folder / "plane.obj");
  CHECK(bench.Set("scanner", "visModel", "none.obj")); // only shown
  CHECK(made->GetData().Scanners[0].Model.File.empty());
  CHECK(bench.Log->Errors.empty());
}

TEST_CASE("SurveyElements: errors of elements name their path", "[SurveyElements]")
{
  Bench bench;
  vtkHeliosSurvey* made = bench.Survey;
  made->RemoveAllParts();
  REQUIRE(made->AddPart("objloader", "plane.obj") == 0);
  const auto fails = [&](const std::string& name, const std::string& value, const std::string& text)
  {
    CHECK_FALSE(made->SetPartAttribute(0, name, value));
    INFO(bench.Log->Errors);
    CHECK(bench.Log->HasError(text));
  };
  fails("dmotion/lop", "1", "part 0: attribute dmotion/lop is unknown; did you mean loop?");
  fails("dmotion/colour", "1",
    "part 0: attribute dmotion/colour is unknown; give one of id, loop, next");
  fails("swap/swapIndices", "1",
    "part 0: attribute swap/swapIndices is unknown: swapIndices cannot be set");
  fails("dmotion[x]/loop", "1",
    "part 0: dmotion[x]/loop is not a path; give names and indices, as in "
    "dmotion[0]/motion[1]/angle");
  fails("dmotion[2]/loop", "1",
    "part 0: dmotion[2]/loop: dmotion[2] does not exist; there are 0, counted from 0, and the next "
    "can be added");
  fails("dmotion/loop", "-1", "part 0: dmotion/loop=\"-1\" is out of range");
  fails("dmotion/motion/type", "jump", "part 0: dmotion/motion/type=\"jump\" is not valid");
  fails("repair", "maybe", "part 0: repair=\"maybe\" is neither true nor false");
  fails("objloader/filepath", "none.obj", "part 0: objloader/filepath=\"none.obj\": no such file");
  fails("swap/xyzloader/matfile", "none.mtl",
    "part 0: swap/xyzloader/matfile=\"none.mtl\": no such file");
  fails(
    "xyzloader/voxelSize", "1", "part 0: its loader is objloader, not xyzloader; add another part");
  CHECK(made->GetPartAttribute(0, "dmotion/loop").empty()); // nothing was set
  CHECK(made->GetPartAttribute(0, "repair").empty());
  CHECK_FALSE(bench.Set("leg", "trajectory", "none.txt"));
  CHECK(bench.Log->HasError("leg 0: trajectory=\"none.txt\": no such file"));
  CHECK_FALSE(bench.Set("platform", "scannerMount/rot[1]/axis", "x"));
  CHECK(bench.Log->HasError("platform 0: scannerMount/rot[1]/axis: rot[1] does not exist"));

  CHECK(made->Check());
  CHECK(made->SetPartAttribute(0, "dmotion/motion/type", "rotation"));
  CHECK_FALSE(made->Check());
  CHECK(bench.Log->HasError("part 0, dmotion: <dmotion id=\"\"> has no loop"));
  CHECK(bench.Log->HasError("part 0, dmotion/motion: <motion type=\"rotation\"> has no axis"));
  CHECK(made->SetPartAttribute(0, "dmotion", ""));
  CHECK(made->SetPartAttribute(0, "crs/source", "EPSG:25832"));
  CHECK_FALSE(made->Check());
  CHECK(bench.Log->HasError("part 0, crs: filter crs has no target"));
  CHECK(made->SetPartAttribute(0, "crs", ""));
  CHECK(made->SetPartAttribute(0, "swap/swapStep", "2"));
  CHECK_FALSE(made->SetPartAttribute(0, "swap[1]/objloader/filepath", "none.obj"));
  CHECK(bench.Log->HasError("part 0: swap[1]/objloader/filepath=\"none.obj\": no such file"));
  CHECK_FALSE(made->Check());
  CHECK(bench.Log->HasError("part 0, swap: <swap> has no filter"));
  CHECK(made->SetPartAttribute(0, "swap/force_null", "true"));
  CHECK_FALSE(made->Check());
  CHECK(bench.Log->HasError("scene: scene scene has no part in epoch 1 (the first is 0)"));
  CHECK(made->SetPartAttribute(0, "swap", ""));
  CHECK(made->Check());
}
