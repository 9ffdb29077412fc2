// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Vegetation grids in surveys: their settings, and flights over them compared with closed forms.
#include "vtkHeliosRunOptions.h"
#include "vtkHeliosSurveyPlayer.h"

#include "heliosMaterialTable.h"
#include "heliosSurveyFiles.h"
#include "vtkHeliosArrayNames.h"
#include "vtkHeliosPlannerReader.h"
#include "vtkHeliosSurveySource.h"

#include <vtkCellData.h>
#include <vtkImageData.h>

#include <catch2/catch.hpp>

#include <cmath>
#include <sstream>
#include <vector>

using namespace helios::test;

namespace
{

using Parameters = std::vector<std::pair<std::string, std::string>>;

std::string Filter(const std::string& type, const Parameters& parameters = {})
{
  std::string text = "<filter type=\"" + type + "\">";
  for (const auto& parameter : parameters)
  {
    text += "<param key=\"" + parameter.first + "\" value=\"" + parameter.second + "\"/>";
  }
  return text + "</filter>";
}

std::string Voxels(Parameters parameters = {}, const std::string& type = "detailedvoxels")
{
  parameters.insert(parameters.begin(), { "filepath", "slab.vox" });
  return Filter(type, parameters);
}

constexpr double Pad = 0.4;   // density of the slab [m2/m3]
constexpr double Angle = 5.0; // angle of the beams from the vertical [deg]
constexpr int Pulses = 80000;

/// A slab of 2 m from z = 10 m above the whole ground of 100 m, in cells of 2 m.
std::string MakeSlab()
{
  std::ostringstream text;
  text << "VOXEL SPACE\n#min_corner: -60 -60 10\n#max_corner: 60 60 12\n#split: 60 60 1\n"
       << "#res: 2 #max_pad: 1.6\ni j k PadBVTotal transmittance\n";
  for (int cell = 0; cell < 3600; ++cell)
  {
    text << cell % 60 << ' ' << cell / 60 << " 0 " << Pad << " 0.5\n";
  }
  return text.str();
}

/// The survey of a floor and a part of voxels.
Reading ReadPart(const Files& files, const std::string& filters, const char* setting = Flight,
  const char* legs = ThreeLegs)
{
  files.Write("slab.vox", MakeSlab());
  files.Write("lad.txt", "0,0,1,1\n1,0,0,1\n");
  files.Write("leaf.mtl", "newmtl leaf\nhelios_classification 4\nhelios_reflectance 0.4\n");
  files.Replace("scene.xml", "</scene>", "<part id=\"trees\">" + filters + "</part></scene>");
  files.Replace("assets.xml", "optics=\"conic\"", "optics=\"conic\" beamDivergence_rad=\"0\"");
  return Reading(files, setting, legs);
}

struct Point
{
  double Z;
  long long Classification;
  std::string Part;
};

/// The points of a flight over the slab.
std::vector<Point> Fly(const std::string& filters)
{
  const Files files;
  const Reading reading = ReadPart(files, filters);
  INFO(reading.Log->Errors);
  REQUIRE(reading.Good);
  vtkNew<vtkHeliosSurveyPlayer> player;
  reading.Log->Watch(player);
  player->SetSurvey(reading.Reader->GetSurvey());
  player->SetOutputDirectory((files / "out").c_str());
  player->GetOptions()->SetSeed(7);
  const bool isGood = player->Run();
  INFO(player->GetMessage());
  REQUIRE(isGood);
  CHECK(reading.Log->Warnings.empty());
  std::vector<Point> points;
  for (const char* leg : { "leg000", "leg001" })
  {
    std::ifstream file(files / ("out/test/" + std::string(leg) + "_points.xyz"));
    Point p;
    double x, y, intensity, width, time;
    long long number, returns, pulse;
    while (file >> x >> y >> p.Z >> intensity >> width >> number >> returns >> pulse >> p.Part >>
      p.Classification >> time)
    {
      points.push_back(p);
    }
  }
  return points;
}

/// Checks that the ratio of ground points equals a probability, within four standard deviations.
void CheckShare(const std::vector<Point>& points, double probability)
{
  double ground = 0.0;
  for (const Point& p : points)
  {
    ground += p.Part == "floor" ? 1.0 : 0.0;
    REQUIRE((p.Part == "trees" || std::abs(p.Z) < 1e-3));
  }
  REQUIRE(points.size() == Pulses);
  CHECK(std::abs(ground / Pulses - probability) <
    4.0 * std::sqrt(probability * (1.0 - probability) / Pulses));
}

double GetSlope()
{
  return 1.0 / std::cos(Angle * 0.017453292519943295);
}

} // namespace

TEST_CASE("SurveyReader: vegetation grids", "[SurveyVoxels]")
{
  const Files files;
  SECTION("defaults")
  {
    const Reading reading = ReadPart(files, Voxels());
    INFO(reading.Log->Errors);
    REQUIRE(reading.Good);
    const helios::PartData& part = reading.Data().Scene.Parts.at(1);
    CHECK(part.Type == helios::Loader::Vegetation);
    CHECK(part.Files == std::vector<std::string>{ files / "slab.vox" });
    CHECK(part.Vegetation.Mode == helios::CellMode::Turbid);
    CHECK(part.IsTurbid());
    CHECK(part.Vegetation.Exponent == 0.5);
    CHECK_FALSE(part.Vegetation.RandomShift);
    CHECK(part.Vegetation.LeafTable.empty());
    CHECK(part.Material.Count == 1);
  }
  SECTION("everything given")
  {
    const Reading reading = ReadPart(files,
      Voxels({ { "intersectionMode", "scaled" }, { "intersectionArgument", "0.25" },
        { "randomShift", "true" }, { "ladlut", "lad.txt" }, { "matfile", "leaf.mtl" },
        { "matname", "leaf" }, { "randomMaterials", "3" }, { "randomRange", "0.1" } }));
    INFO(reading.Log->Errors);
    REQUIRE(reading.Good);
    CHECK(reading.Log->Warnings.empty());
    const helios::PartData& part = reading.Data().Scene.Parts.at(1);
    CHECK(part.Vegetation.Mode == helios::CellMode::Scaled);
    CHECK_FALSE(part.IsTurbid());
    CHECK(part.Vegetation.Exponent == 0.25);
    CHECK(part.Vegetation.RandomShift);
    CHECK(part.Vegetation.LeafTable == files / "lad.txt");
    CHECK(part.Material.Count == 4);
    CHECK(part.Material.RandomRange == 0.1);
  }
}

TEST_CASE("SurveyReader: bad vegetation grids are errors", "[SurveyVoxels]")
{
  struct Wrong
  {
    std::string Filters;
    std::string Message;
  };
  const std::vector<Wrong> cases = {
    { Voxels({ { "intersectionMode", "solid" } }),
      "intersectionMode=\"solid\" is not valid: expected transmittive, scaled or fixed" },
    { Voxels({ { "intersectionArgument", "-1" } }), "intersectionArgument=\"-1\" is out of range" },
    { Voxels({ { "ladlut", "none.txt" } }), "none.txt" },
    { Voxels({ { "randomRange", "2" } }), "randomRange=\"2\" is out of range" },
    { Filter("detailedvoxels"), "filter detailedvoxels has no filepath" },
    { Voxels() + Filter("crs", { { "target", "EPSG:25832" } }),
      "filter crs cannot reproject transmittive voxels" },
    { Voxels() + Voxels(), "a second loader in one <part>" },
    { Voxels({}, "detailedvoxel"), "did you mean detailedvoxels?" },
  };
  for (const Wrong& wrong : cases)
  {
    const Files files;
    const Reading reading = ReadPart(files, wrong.Filters);
    INFO(wrong.Filters << "\n" << reading.Log->Errors);
    CHECK_FALSE(reading.Good);
    CHECK(reading.Log->HasError(wrong.Message));
  }
  const Files files;
  const Reading reading =
    ReadPart(files, Voxels({ { "randomMaterials", "2" } }) + Filter("repair"));
  CHECK(reading.Good);
  CHECK(reading.Log->HasWarning("randomMaterials=\"2\" is not used without a matfile"));
  CHECK(reading.Log->HasWarning("repair and simplify have no effect on transmittive voxels"));
}

TEST_CASE("SurveyPlayer: a flight over turbid voxels", "[SurveyVoxels]")
{
  const double length = 2.0 * GetSlope();
  const double k = 0.5 * Pad;
  const auto points = Fly(Voxels({ { "matfile", "leaf.mtl" } }));
  CheckShare(points, std::exp(-k * length));
  double count = 0.0;
  double sum = 0.0;
  double squares = 0.0;
  for (const Point& p : points)
  {
    if (p.Part == "trees")
    {
      const double depth = (12.0 - p.Z) * GetSlope();
      REQUIRE((depth >= -1e-3 && depth <= length + 1e-3));
      REQUIRE(p.Classification == 4);
      ++count;
      sum += depth;
      squares += depth * depth;
    }
  }
  // An exponential truncated at the length.
  const double stopped = 1.0 - std::exp(-k * length);
  const double mean = 1.0 / k - length * (1.0 - stopped) / stopped;
  const double variance = 1.0 / (k * k) - length * length * (1.0 - stopped) / (stopped * stopped);
  CHECK(std::abs(sum / count - mean) < 4.0 * std::sqrt(variance / count));
  CHECK(squares / count - sum * sum / (count * count) == Approx(variance).epsilon(0.03));
}

TEST_CASE("SurveyPlayer: the leaf angle table changes the transmission", "[SurveyVoxels]")
{
  CheckShare(Fly(Voxels({ { "ladlut", "lad.txt" } })), std::exp(-1.0 * Pad * 2.0 * GetSlope()));
}

TEST_CASE(
  "SurveyPlayer: turbid voxels are rotated, scaled, moved and put on the ground", "[SurveyVoxels]")
{
  const std::string turn = "<filter type=\"rotate\"><param key=\"rotation\"><rot axis=\"z\" "
                           "angle_deg=\"30\"/></param></filter>";
  const auto check = [](const std::string& filters, double low, double high)
  {
    const auto points = Fly(Voxels() + filters);
    CheckShare(points, std::exp(-0.5 * Pad * (high - low) * GetSlope()));
    double lowest = 1e9;
    double highest = -1e9;
    for (const Point& p : points)
    {
      lowest = std::min(lowest, p.Part == "trees" ? p.Z : lowest);
      highest = std::max(highest, p.Part == "trees" ? p.Z : highest);
    }
    CHECK(lowest == Approx(low).margin(0.01));
    CHECK(highest == Approx(high).margin(0.01));
  };
  check(
    turn + Filter("scale", { { "scale", "2" } }) + Filter("translate", { { "offset", "0;0;5" } }),
    25.0, 29.0);
  check(Filter("translate", { { "offset", "15;15;9" }, { "onGround", "1" } }), 0.0, 2.0);
}

TEST_CASE("SurveyPlayer: fixed and scaled cubes are opaque", "[SurveyVoxels]")
{
  const auto fixed = Fly(Voxels({ { "intersectionMode", "fixed" } }));
  REQUIRE(fixed.size() == Pulses);
  for (const Point& p : fixed)
  {
    REQUIRE(p.Part == "trees");
    REQUIRE(p.Z == Approx(12.0).margin(1e-3));
  }
  // Cubes of (0.4 / 1.6)^0.5 of 2 m: area of their tops and of the shadows of their sides.
  const auto scaled = Fly(Voxels({ { "intersectionMode", "scaled" } }));
  REQUIRE(scaled.size() == Pulses);
  double hidden = 0.0;
  for (const Point& p : scaled)
  {
    REQUIRE((p.Part == "floor" || (p.Z <= 11.501 && p.Z >= 10.499)));
    hidden += p.Part == "trees" ? 1.0 / Pulses : 0.0;
  }
  const double pi = 3.141592653589793;
  CHECK(hidden ==
    Approx((1.0 + 4.0 / pi * std::tan(Angle * pi / 180.0)) / 4.0)
      .margin(0.02)); // few cells are hit
}

TEST_CASE("SurveyPlayer: a scene of voxels only", "[SurveyVoxels]")
{
  const Files files;
  files.Write("slab.vox", MakeSlab());
  files.Write("scene.xml",
    "<document><scene id=\"s\"><part id=\"trees\">" + Voxels() + "</part></scene></document>");
  const Reading reading(files, Flight, ThreeLegs);
  REQUIRE(reading.Good);
  vtkNew<vtkHeliosSurveyPlayer> player;
  reading.Log->Watch(player);
  player->SetSurvey(reading.Reader->GetSurvey());
  player->SetOutputDirectory((files / "out").c_str());
  REQUIRE(player->Run());
  CHECK(player->GetCount("points") > Pulses / 3);
  CHECK(reading.Log->Errors.empty());
}

TEST_CASE("SurveyPlayer: a damaged grid is an error with its position", "[SurveyVoxels]")
{
  for (const char* mode : { "transmittive", "fixed" })
  {
    const Files files;
    const Reading reading = ReadPart(files, Voxels({ { "intersectionMode", mode } }));
    REQUIRE(reading.Good);
    files.Replace("slab.vox", "1 0 0 0.4", "1 0 0 0,4");
    vtkNew<vtkHeliosSurveyPlayer> player;
    reading.Log->Watch(player);
    player->SetSurvey(reading.Reader->GetSurvey());
    player->SetOutputDirectory((files / "out").c_str());
    CHECK_FALSE(player->Run());
    CHECK(reading.Log->HasError("slab.vox:8: \"0,4\" in column PadBVTotal is not a number"));
  }
}

TEST_CASE("SurveyVoxels: grids are returned with the scene", "[SurveyVoxels]")
{
  const Files files;
  const Reading reading = ReadPart(files,
    Voxels({ { "matfile", "leaf.mtl" }, { "matname", "leaf" } }) +
      Filter("translate", { { "offset", "0;0;5" } }));
  INFO(reading.Log->Errors);
  REQUIRE(reading.Good);
  vtkNew<vtkHeliosSurveySource> source;
  source->SetSurvey(reading.Reader->GetSurvey());
  CHECK_FALSE(source->GetGrid(0)); // not loaded
  REQUIRE(source->Load());
  vtkNew<vtkHeliosPlannerReader> planner;
  planner->SetFileName((files / "scene.xml").c_str());
  planner->SetDefaultPlatform("assets.xml#tripod");
  planner->SetDefaultScanner("assets.xml#tls");
  planner->Update();
  CHECK_FALSE(planner->GetGrid(0)); // not requested
  planner->KeepGridsOn();
  planner->Update();
  for (vtkImageData* grid : { source->GetGrid(0), planner->GetGrid(0) })
  {
    REQUIRE(grid);
    double bounds[6];
    grid->GetBounds(bounds);
    CHECK(bounds[0] == -60.0);
    CHECK(bounds[4] == 15.0);
    CHECK(bounds[5] == 17.0);
    vtkDataArray* pad = grid->GetCellData()->GetArray(vtkHeliosArrayNames::PAD);
    REQUIRE(pad);
    CHECK(pad->GetNumberOfTuples() == 3600);
    CHECK(pad->GetComponent(1234, 0) == Pad);
    CHECK(helios::GetMaterials(grid).at(0).Classification == 4);
  }
  for (const int none : { -1, 1 })
  {
    CHECK_FALSE(source->GetGrid(none));
    CHECK_FALSE(planner->GetGrid(none));
  }
}
