// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Moving parts: their settings, and flights over them compared with closed forms.
#include "vtkHeliosSurveyPlayer.h"

#include "heliosPulseClock.h"
#include "heliosSurveyChanges.h"
#include "heliosSurveyPlaying.h"

#include <vtkCommand.h>

#include <catch2/catch.hpp>

#include <cmath>
#include <map>

namespace fs = std::filesystem;
using namespace helios::test;
using helios::MotionData;
using helios::MotionKind;
using helios::PulseClock;
using helios::Vec3;

namespace
{

constexpr double Radians = 0.017453292519943295;
constexpr int Pulses = 80000; // pulses of ThreeLegs, at 200 kHz

/// One motion, repeated forever.
std::string Endless(const std::string& motion)
{
  return "<dmotion id=\"all\" loop=\"0\"><motion " + motion + "/></dmotion>";
}

/// Makes the floor move, and sets single-ray beams.
void Move(const Files& files, const std::string& motions, const std::string& scene = "",
  const std::string& part = "")
{
  files.Replace("scene.xml", "</part>", "\n" + motions + "</part>");
  files.Replace("scene.xml", "<scene id=\"s\"", "<scene id=\"s\" " + scene);
  files.Replace("scene.xml", "<part id=\"floor\"", "<part id=\"floor\" " + part);
  files.Replace("assets.xml", "optics=\"conic\"", "optics=\"conic\" beamDivergence_rad=\"0\"");
}

/// Runs a survey; returns the files in the folder, without timings.
std::map<std::string, std::string> Run(Playing& playing, const std::string& folder)
{
  const bool isGood = playing.Player->Run();
  INFO(playing.Player->GetMessage());
  REQUIRE(isGood);
  CHECK(playing.Log->Warnings.empty());
  std::map<std::string, std::string> texts;
  for (const auto& entry : fs::directory_iterator(folder + "/test"))
  {
    const std::string name = entry.path().filename().string();
    if (name != "run_summary.json")
    {
      texts[name] = ReadText(entry.path().string());
    }
  }
  return texts;
}

/// The points of all legs of a flight.
std::vector<Point> Fly(const Files& files, const char* legs = ThreeLegs)
{
  const Reading reading(files, Flight, legs);
  INFO(reading.Log->Errors);
  REQUIRE(reading.Good);
  Playing playing(files, reading);
  playing.Player->SetPulsesPerBlock(7001);
  Run(playing, files / "out");
  std::vector<Point> points;
  for (const char* leg : { "leg000", "leg001" })
  {
    const auto more = ReadPoints(files / ("out/test/" + std::string(leg) + "_points.xyz"));
    points.insert(points.end(), more.begin(), more.end());
  }
  return points;
}

/// Checks that every pulse has one point, at the height of its step.
void CheckHeights(const std::vector<Point>& points, double (*getHeight)(const Point&))
{
  REQUIRE(points.size() == Pulses);
  int wrong = 0;
  for (const Point& p : points)
  {
    wrong += std::abs(p.Z - getHeight(p)) < 1e-3 ? 0 : 1;
  }
  CHECK(wrong == 0);
}

const helios::MotionData& ReadMotion(const Reading& reading)
{
  INFO(reading.Log->Errors);
  REQUIRE(reading.Good);
  return reading.Data().Scene.Parts.at(0).Motion;
}

class AbortLater : public vtkCommand
{
public:
  static AbortLater* New() { return new AbortLater; }
  void Execute(vtkObject* caller, unsigned long, void*) override
  {
    auto* player = static_cast<vtkHeliosSurveyPlayer*>(caller);
    if (player->GetCount("pulses") >= 30000)
    {
      player->Abort();
    }
  }
};

} // namespace

TEST_CASE("SurveyMotion: attributes of moving parts", "[SurveyMotion]")
{
  const Files files;
  SECTION("all of it")
  {
    Move(files, R"(<dmotion id="a" loop="3" next="b">
<motion type="translation" vec="1;2;3"/>
<motion type="Rotation" axis="0;0;2" angle="-5" center="4;5;6" selfMode="true" autoCRS="1"/></dmotion>
<dmotion id="b" loop="0"><motion type="identity"/><motion type="reflection" ortho="1;0;0"/>
<motion type="glideplane" ortho="0;1;0" shift="1;0;1"/>
<motion type="helical" axis="1;0;0" angle="7" glide="0.5"/>
<motion type="rotsym" axis="0;1;0" angle="8" center="1;1;1"/></dmotion>)");
    const Reading reading(files, Flight, ThreeLegs);
    const MotionData& motion = ReadMotion(reading);
    CHECK(reading.Log->Warnings.empty());
    REQUIRE(motion.Sequences.size() == 2);
    CHECK(motion.Sequences[0].Loop == 3);
    CHECK(motion.Sequences[0].Next == 1);
    REQUIRE(motion.Sequences[0].Motions.size() == 2);
    CHECK(motion.Sequences[0].Motions[0].Kind == MotionKind::Translation);
    CHECK(motion.Sequences[0].Motions[0].Vector == Vec3(1, 2, 3));
    const helios::Motion& turn = motion.Sequences[0].Motions[1];
    CHECK(turn.Kind == MotionKind::Rotation);
    CHECK(turn.Vector == Vec3(0, 0, 2));
    CHECK(turn.Angle == -5);
    CHECK(turn.Center == Vec3(4, 5, 6));
    CHECK(turn.IsSelf);
    CHECK(motion.Sequences[1].Loop == 0);
    CHECK(motion.Sequences[1].Next == helios::MotionSequence::None);
    const auto& others = motion.Sequences[1].Motions;
    REQUIRE(others.size() == 5);
    CHECK(others[0].Kind == MotionKind::Identity);
    CHECK(others[1].Kind == MotionKind::Reflection);
    CHECK(others[2].Kind == MotionKind::GlidePlane);
    CHECK(others[2].Shift == Vec3(1, 0, 1));
    CHECK(others[3].Kind == MotionKind::Helical);
    CHECK(others[3].Glide == 0.5);
    CHECK(others[4].Kind == MotionKind::RotaryReflection);
    CHECK(motion.Pulses == 1);
    CHECK(motion.Seconds == 0);
    CHECK(motion.Every == 1);
  }
  struct Row
  {
    const char* Scene;
    const char* Part;
    vtkIdType Pulses;
    double Seconds;
    int Every;
  };
  const Row row = GENERATE(Row{ R"(dynStep="20")", R"(dynStep="3" kdtDynStep="2")", 60, 0, 2 },
    Row{ R"(dynTimeStep="0.01")", "", 1, 0.01, 1 },
    Row{ R"(dynTimeStep="0.01")", R"(dynStep="5")", 5, 0.05, 1 },
    Row{ R"(dynTimeStep="0.01")", R"(dynTimeStep="0.03" kdtDynTimeStep="0.07")", 1, 0.03, 2 },
    Row{ R"(dynTimeStep="0.01")", R"(dynTimeStep="0.002")", 1, 0.01, 1 },
    Row{ R"(dynStep="20")", R"(dynTimeStep="0.25")", 20, 0.25, 1 });
  DYNAMIC_SECTION(row.Scene << " " << row.Part)
  {
    Move(files, Endless(R"(type="translation" vec="0;0;1")"), row.Scene, row.Part);
    const Reading reading(files, Flight, ThreeLegs);
    const MotionData& motion = ReadMotion(reading);
    CHECK(motion.Pulses == row.Pulses);
    CHECK(motion.Seconds == Approx(row.Seconds).epsilon(1e-15));
    CHECK(motion.Every == row.Every);
  }
}

TEST_CASE("SurveyMotion: bad motions are errors", "[SurveyMotion]")
{
  const std::string file = "scene.xml";
  const std::string end = "</part>";
  const auto add = [&file, &end](const std::string& text, const std::string& message) {
    return Change{ file, end, "\n" + text + end, { "scene.xml:4: " + message } };
  };
  const auto motion = [&add](const std::string& text, const std::string& message)
  { return add(Endless(text), message); };
  const std::string up = R"(<motion type="translation" vec="0;0;1"/>)";
  CheckAllRefused(Flight, ThreeLegs,
    { motion(R"(type="rotaton" axis="0;0;1")",
        "<motion> type=\"rotaton\" is unknown; did you mean rotation? Types are identity, "),
      motion("", "<motion> type=\"\" is unknown; Types are identity, translation, rotation"),
      motion(R"(type="translation")",
        "<motion type=\"translation\"> has no vec; give three numbers with semicolons"),
      motion(R"(type="rotation" axis="0;0;0" angle="1")",
        "<motion type=\"rotation\"> has axis=\"0;0;0\", which has no direction; give one that is"),
      motion(R"(type="reflection")", "<motion type=\"reflection\"> has no ortho"),
      motion(R"(type="translation" vec="1,2,3")", "vec=\"1,2,3\" is not a vector"),
      motion(R"(type="rotation" axis="0;0;1" angle="much")", "angle=\"much\" is not a number"),
      motion(R"(type="glideplane" ortho="0;0;1" shift="1;0;0.1")",
        "shift=\"1;0;0.1\" is not in the plane normal to ortho=\"0;0;1\"; give one perpendicular"),
      add("<dmotion id=\"a\">" + up + "</dmotion>",
        "<dmotion id=\"a\"> has no loop; give the number of steps that it lasts"),
      add("<dmotion id=\"a\" loop=\"-1\">" + up + "</dmotion>", "loop=\"-1\" is out of range"),
      add("<dmotion id=\"a\" loop=\"1\"/>",
        "<dmotion id=\"a\"> has no <motion>; add one, <motion type=\"identity\"/> for no motion"),
      add("<dmotion id=\"a\" loop=\"1\" next=\"b\">" + up + "</dmotion>",
        "next=\"b\" is not a <dmotion> of this <part>; its ids are \"a\""),
      { file, end,
        "\n<dmotion id=\"a\" loop=\"1\">" + up + "</dmotion><dmotion id=\"a\" loop=\"1\">" + up +
          "</dmotion>" + end,
        { "scene.xml:4:76: a second <dmotion id=\"a\"> in one <part>; give each an id of its "
          "own" } },
      { file, end,
        "\n" + Endless(R"(type="reflection" ortho="1;0;0")") +
          "</part><part id=\"b\" "
          "motion=\"continuous\"><filter type=\"objloader\"><param type=\"string\" "
          "key=\"filepath\" value=\"plane.obj\"/></filter>" +
          Endless(R"(type="rotsym" axis="1;0;0" angle="1")") + end,
        { "scene.xml:4:",
          "<motion> type=\"rotsym\" mirrors the part, so there is nothing between "
          "two steps; set motion=\"steps\" of its <part>" } },
      { file, "<scene ", "<scene motion=\"smooth\" ", { "motion=\"smooth\" is not valid" } },
      { file, "<scene ", "<scene dynStep=\"0\" ", { "dynStep=\"0\" is out of range" } },
      { file, "<scene ", "<scene dynTimeStep=\"1.5\" ",
        { "dynTimeStep=\"1.5\" is out of range; give a number from 1e-09 to 1 [s]" } },
      { file, "<part ", "<part dynStep=\"-3\" ", { "dynStep=\"-3\" is out of range" } },
      { file, "<part ", "<part kdtDynStep=\"0\" ", { "kdtDynStep=\"0\" is out of range" } },
      { file, "<part ", "<part kdtDynTimeStep=\"2\" ", { "kdtDynTimeStep=\"2\" is out of" } } });
}

TEST_CASE("SurveyMotion: bad mounts and trajectories are errors", "[SurveyMotion]")
{
  const std::string end = "</part>";
  const std::string other = "<filter type=\"objloader\"><param type=\"string\" key=\"filepath\" "
                            "value=\"plane.obj\"/></filter></part>";
  CheckAllRefused(Flight, ThreeLegs,
    { { "scene.xml", "<part ", "<part mount=\"car\" ",
        { "scene.xml:1", "mount=\"car\" is no part of the scene; give the id of one" } },
      { "scene.xml", end,
        end + "<part id=\"a\" mount=\"b\">" + other + "<part id=\"b\" mount=\"a\">" + other,
        { "scene.xml:3",
          "mount=\"b\" carries itself: a on b on a; remove the mount of one of them" } },
      { "scene.xml", end, "<trajectory/>" + end,
        { "<trajectory> has no file; give the one with the path of the part" } },
      { "scene.xml", end, "<trajectory file=\"none.csv\"/>" + end,
        { "file=\"none.csv\": no such file" } } });
}

TEST_CASE("SurveyMotion: a trajectory that ends before the survey is an error", "[SurveyMotion]")
{
  const Files files;
  files.Write("short.csv", "3,0,0,0,0,0,0\n3.1,0,0,0,1,0,0\n");
  files.Replace("scene.xml", "</part>", "<trajectory file=\"short.csv\"/></part>");
  const Reading reading(files, Flight, ThreeLegs);
  INFO(reading.Log->Errors);
  REQUIRE(reading.Good);
  Playing playing(files, reading);
  playing.CheckFails({ "part floor: ",
    "short.csv has times of the survey from 0 s to 0.1 s, but a leg "
    "lasts from 0 s to 0.2 s; give a longer trajectory, or another "
    "tStart" });
}

TEST_CASE("SurveyMotion: a damaged trajectory is one error, which names the part", "[SurveyMotion]")
{
  const Files files;
  files.Write("path.csv", "3,0,0,0,0,0,0\n4,0,0,0,1,0,nan\n");
  files.Replace("scene.xml", "</part>", "\n<trajectory file=\"path.csv\"/></part>");
  const Reading reading(files, Flight, ThreeLegs);
  REQUIRE(reading.Good);
  Playing playing(files, reading);
  playing.CheckFails(
    { "scene.xml:4: part floor: ", "path.csv:2: \"nan\" in column 6 is not finite" });
  CHECK(playing.Log->Errors.find("cannot follow this trajectory") == std::string::npos);
}

TEST_CASE("SurveyMotion: turbid voxels do not move", "[SurveyMotion]")
{
  const Files files;
  files.Write("slab.vox", "VOXEL SPACE\n");
  files.Replace("scene.xml", "</scene>",
    "<part id=\"leaves\"><filter type=\"detailedvoxels\"><param key=\"filepath\" "
    "value=\"slab.vox\"/></filter>\n" +
      Endless(R"(type="translation" vec="0;0;1")") + "</part></scene>");
  const Reading reading(files, Flight, ThreeLegs);
  INFO(reading.Log->Errors);
  CHECK_FALSE(reading.Good);
  CHECK(reading.Log->HasError("scene.xml:4: <dmotion> does not move transmittive voxels; give "
                              "intersectionMode=\"scaled\" or \"fixed\", or remove it"));
}

TEST_CASE("SurveyMotion: warnings about motions", "[SurveyMotion]")
{
  const std::string end = "</part>";
  const std::string up = R"(<motion type="translation" vec="0;0;1"/>)";
  CheckAllWarned(Flight, ThreeLegs,
    { { "scene.xml", end, "\n" + Endless("type=\"identity\"") + end,
        { "scene.xml:4: the <dmotion> of this <part> never move it; give other motions" } },
      { "scene.xml", end, "\n<dmotion id=\"a\" loop=\"0\" next=\"a\">" + up + "</dmotion>" + end,
        { "scene.xml:4: <dmotion id=\"a\"> never ends (loop=\"0\"), so next=\"a\" is never "
          "reached" } },
      { "scene.xml", "<part ", "<part kdtDynTimeStep=\"0.5\" ",
        { "kdtDynTimeStep=\"0.5\" is not used: the part steps by pulses; give it a "
          "dynTimeStep" } } });
}

TEST_CASE("SurveyMotion: steps and the pulses that they affect", "[SurveyMotion]")
{
  MotionData motion;
  SECTION("by pulses, over all legs")
  {
    motion.Pulses = 10;
    const PulseClock clock{ 25, 3.0, 1000.0 };
    CHECK(helios::FindSeenStep(motion, clock, 4) == 2);
    CHECK(helios::FindSeenStep(motion, clock, 5) == 3);
    CHECK(helios::FindPulseOfStep(motion, clock, 2) == 0);
    CHECK(helios::FindPulseOfStep(motion, clock, 4) == 15);
    motion.Every = 3;
    CHECK(helios::FindSeenStep(motion, clock, 34) == 3);
    CHECK(helios::FindSeenStep(motion, clock, 35) == 6);
  }
  SECTION("by time: each pulse is on one side of each step")
  {
    motion.Seconds = GENERATE(0.1, 1.0 / 3.0, 0.0003, 1e-5);
    const PulseClock clock{ 0, GENERATE(0.0, 0.7, 100000.3), GENERATE(3e3, 1e4, 300000.0) };
    for (vtkIdType pulse = 0; pulse < 5000; ++pulse)
    {
      const vtkIdType step = helios::FindSeenStep(motion, clock, pulse);
      REQUIRE(helios::FindPulseOfStep(motion, clock, step) <= pulse);
      REQUIRE(helios::FindPulseOfStep(motion, clock, step + 1) > pulse);
      const double time = clock.StartTime + static_cast<double>(pulse) / clock.Rate;
      REQUIRE(std::abs(time / motion.Seconds - static_cast<double>(step) - 0.5) < 0.5 + 1e-4);
    }
  }
}

TEST_CASE("SurveyMotion: a plate rises under a flight, pulse by pulse", "[SurveyMotion]")
{
  const Files files;
  const std::string rise = Endless(R"(type="translation" vec="0;0;0.01")");
  SECTION("a step every 100 pulses, continued from leg to leg")
  {
    Move(files, rise, "dynStep=\"100\"");
    CheckHeights(Fly(files), [](const Point& p) { return 0.01 * double(p.Pulse / 100); });
  }
  SECTION("only every sixth update is visible")
  {
    Move(files, rise, "dynStep=\"100\"", "dynStep=\"2\" kdtDynStep=\"3\"");
    CheckHeights(Fly(files), [](const Point& p) { return 0.03 * double(p.Pulse / 600); });
  }
  SECTION("by time")
  {
    Move(files, rise, "dynTimeStep=\"0.001\"");
    CheckHeights(Fly(files), [](const Point& p) { return 0.01 * double(p.Pulse / 200); });
  }
  SECTION("between the steps")
  {
    Move(files, rise, "dynStep=\"100\" motion=\"continuous\"");
    CheckHeights(Fly(files), [](const Point& p) { return 0.0001 * double(p.Pulse); });
  }
  SECTION("a part of its own")
  {
    Move(files, rise, "dynStep=\"100\" motion=\"continuous\"", "motion=\"steps\"");
    CheckHeights(Fly(files), [](const Point& p) { return 0.01 * double(p.Pulse / 100); });
  }
  SECTION("then rests, falls, repeats")
  {
    Move(files,
      R"(<dmotion id="up" loop="10" next="rest"><motion type="translation" vec="0;0;1"/></dmotion>
<dmotion id="rest" loop="5" next="down"><motion type="identity"/></dmotion>
<dmotion id="down" loop="10" next="up"><motion type="translation" vec="0;0;-1"/></dmotion>)",
      "dynStep=\"500\"");
    CheckHeights(Fly(files),
      [](const Point& p)
      {
        const double step = double(p.Pulse / 500 % 25);
        return step <= 10 ? step : (step <= 15 ? 10 : 25 - step);
      });
  }
}

TEST_CASE("SurveyMotion: a rotating plate is a plane of known slope", "[SurveyMotion]")
{
  const Files files;
  Move(files, Endless(R"(type="rotation" axis="0;1;0" angle="0.05")"), "dynStep=\"1000\"");
  CheckHeights(Fly(files),
    [](const Point& p) { return -p.X * std::tan(0.05 * double(p.Pulse / 1000) * Radians); });
}

TEST_CASE("SurveyMotion: other parts do not move", "[SurveyMotion]")
{
  const Files files;
  files.Write("low.obj", "v -60 -60 -5\nv 60 -60 -5\nv 60 0 -5\nv -60 0 -5\nf 1 2 3 4\n");
  files.Replace("scene.xml", "</scene>",
    "<part id=\"low\"><filter type=\"objloader\"><param key=\"filepath\" "
    "value=\"low.obj\"/></filter></part></scene>");
  // the floor moves aside at once; below it is a static part
  Move(files, Endless(R"(type="translation" vec="0;1000;0")"), "dynStep=\"40000\"");
  const auto points = Fly(files);
  REQUIRE(points.size() > 50000);
  for (const Point& p : points)
  {
    REQUIRE(p.Part == (p.Pulse < 40000 ? "floor" : "low"));
    REQUIRE(std::abs(p.Z - (p.Pulse < 40000 ? 0.0 : -5.0)) < 1e-3);
  }
}

TEST_CASE("SurveyMotion: a part without triangles does not move", "[SurveyMotion]")
{
  const Files files;
  files.Write("none.obj", "v 0 0 0\n");
  files.Replace("scene.xml", "</scene>",
    "<part id=\"none\"><filter type=\"objloader\"><param key=\"filepath\" "
    "value=\"none.obj\"/></filter>" +
      Endless(R"(type="translation" vec="0;0;1")") + "</part></scene>");
  const Reading reading(files, Flight, ThreeLegs);
  Playing playing(files, reading);
  CHECK(playing.Player->Run());
  CHECK(playing.Log->HasWarning("Part 1 (none) has no triangles; it is left out"));
  CHECK(playing.Player->GetCount("points") == Pulses);
}

TEST_CASE("SurveyMotion: all channels have the same scene", "[SurveyMotion]")
{
  const Files files;
  files.Replace("assets.xml", "scanFreqMax_Hz=\"80\"/>",
    "scanFreqMax_Hz=\"80\"><channels><channel id=\"a\"/><channel id=\"b\" wavelength_nm=\"532\"/>"
    "</channels></scanner>");
  Move(files, Endless(R"(type="translation" vec="0;0;0.01")"), "dynStep=\"100\"");
  const auto points = Fly(files);
  REQUIRE(points.size() == 2 * Pulses);
  for (const Point& p : points)
  {
    REQUIRE(std::abs(p.Z - 0.01 * double(p.Pulse / 2 / 100)) < 1e-3);
  }
}

TEST_CASE("SurveyMotion: byte-identical for any blocks, also when resumed", "[SurveyMotion]")
{
  const Files files;
  const std::string kind = GENERATE("steps", "continuous");
  Move(files, Endless(R"(type="rotation" axis="1;2;0" angle="0.03" selfMode="true")"),
    "dynStep=\"777\" motion=\"" + kind + "\"");
  files.Replace("assets.xml", "beamDivergence_rad=\"0\"", "beamDivergence_rad=\"0.001\"");
  const Reading reading(files, Flight, ThreeLegs);
  const auto setUp = [&files](Playing& playing, const std::string& folder, vtkIdType size)
  {
    playing.Player->SetOutputDirectory((files / folder).c_str());
    playing.Player->SetPulsesPerBlock(size);
    playing.Player->SetWriteWaveforms(true);
    playing.Player->SetWritePulses(true);
  };
  Playing whole(files, reading);
  setUp(whole, "whole", 1000000);
  const auto texts = Run(whole, files / "whole");
  CHECK(texts.size() == 8); // points, waveforms, pulses, trajectory
  CHECK(whole.Player->GetCount("points") == Pulses);

  Playing small(files, reading);
  setUp(small, "small", 3001);
  CHECK((Run(small, files / "small") == texts));
  CHECK(small.Player->GetCount("points") == Pulses);

  Playing broken(files, reading);
  setUp(broken, "broken", 10000);
  vtkNew<AbortLater> abort;
  const unsigned long tag = broken.Player->AddObserver(vtkCommand::ProgressEvent, abort);
  CHECK_FALSE(broken.Player->Run());
  broken.Player->RemoveObserver(tag);
  broken.Player->SetResume(true);
  CHECK((Run(broken, files / "broken") == texts));
}

TEST_CASE("SurveyMotion: a dry run estimates it", "[SurveyMotion]")
{
  const Files files;
  Move(files, Endless(R"(type="translation" vec="0;0;0.01")"), "dynStep=\"100\"");
  const Reading reading(files, Flight, ThreeLegs);
  Playing playing(files, reading);
  REQUIRE(playing.Player->Estimate());
  CHECK(playing.Log->Errors.empty());
  CHECK(playing.Log->Warnings.empty());
}
