// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Parts of a run, joined: the files equal the files of one process.
#include "heliosBrokenRun.h"
#include "heliosFormerRun.h"
#include "vtkHeliosRunFiles.h"
#include "vtkHeliosRunOptions.h"

#include <catch2/catch.hpp>

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace fs = std::filesystem;
using namespace helios::test;

namespace
{

using Texts = std::map<std::string, std::string>;

struct Settings
{
  std::string Format;
  bool IsSplit = false;
  bool IsInPoints = false; // the waveforms of LAS
  bool HasHits = false;
  vtkIdType Block = 10000; // pulses
};

/// A player of parts, or of all.
struct PartRun : BlockRun
{
  PartRun(const Files& files, const Reading& reading, const Settings& settings,
    const std::string& folder = "parts")
    : BlockRun(files, reading, folder)
  {
    this->Player->SetFormat(settings.Format.c_str());
    this->Player->SetSplitByChannel(settings.IsSplit);
    this->Player->SetWaveformsInPoints(settings.IsInPoints);
    this->Player->SetWritePulses(true);
    this->Player->SetWriteHits(settings.HasHits);
    this->Player->SetPulsesPerBlock(settings.Block);
  }

  void SetPart(int part, int parts)
  {
    this->Player->SetPart(part);
    this->Player->SetNumberOfParts(parts);
  }

  void AddFolders(const Files& files, int parts)
  {
    for (int part = parts; part > 0; --part) // in any order
    {
      this->Player->AddPartFolder(
        files / ("parts/test/" + vtkHeliosRunFiles::GetPartName(part, parts)));
    }
  }

  void Run()
  {
    const bool isRun = this->Player->Run();
    INFO(this->Log->Errors);
    REQUIRE(isRun);
  }
};

void RunParts(const Files& files, const Reading& reading, const Settings& settings, int parts)
{
  PartRun run(files, reading, settings);
  for (int part = 1; part <= parts; ++part)
  {
    run.SetPart(part, parts);
    run.Run();
  }
}

/// The summary without what depends on the host.
std::string ReadSummary(const std::string& folder)
{
  const std::string text = ReadText(folder + "/run_summary.json");
  return text.substr(0, text.find("\"timings\"")) + text.substr(text.find("\"totals\""));
}

/// A number of the timings of a summary; 0: not there.
double ReadTiming(const std::string& folder, const std::string& name)
{
  const std::string text = ReadText(folder + "/run_summary.json");
  const std::size_t at = text.find("\"" + name + "\" : ");
  return at == std::string::npos ? 0.0 : std::stod(text.substr(at + name.size() + 5));
}

/// Reports the files that differ.
void CheckSame(const std::string& found, const std::string& expected)
{
  const Texts are = ReadAll(found);
  const Texts should = ReadAll(expected);
  for (const auto& [name, text] : should)
  {
    INFO(name);
    REQUIRE(are.count(name) == 1);
    CHECK((are.at(name) == text)); // too long to print
  }
  CHECK(are.size() == should.size());
  CHECK(ReadSummary(found) == ReadSummary(expected));
}

void Join(const Files& files, const Reading& reading, const Settings& settings, int parts)
{
  PartRun joined(files, reading, settings, "joined");
  joined.Player->SetOverwrite(true);
  joined.AddFolders(files, parts);
  joined.Run();
}

/// Parts of any number are the whole.
void CheckJoin(const Files& files, const Reading& reading, const Settings& settings)
{
  PartRun(files, reading, settings, "whole").Run();
  for (const int parts : { 1, 2, 3, 4, 7 })
  {
    INFO(parts << " parts");
    RunParts(files, reading, settings, parts);
    Join(files, reading, settings, parts);
    CheckSame(files / "joined/test", files / "whole/test");
  }
}

std::string MakeStrip()
{
  std::string legs = ThreeLegs;
  for (std::size_t at = legs.find("<leg>"); at != std::string::npos; at = legs.find("<leg>"))
  {
    legs.replace(at, 5, "<leg stripId=\"7\">");
  }
  return legs;
}

} // namespace

TEST_CASE("SurveyJoin: legs", "[SurveyJoin]")
{
  const Files files;
  const Reading reading(files, Flight, ThreeLegs);
  CheckJoin(files, reading, { GENERATE("las", "laz", "copc", "xyz", "vtp") });
}

TEST_CASE("SurveyJoin: parts of an epoch, written by an earlier version", "[SurveyJoin]")
{
  const Files files;
  files.Write("scene.xml",
    "<document><scene id=\"s\"><part><filter type=\"objloader\"><param key=\"filepath\" "
    "value=\"plane.obj\"/></filter><swap><filter type=\"translate\"><param key=\"offset\" "
    "value=\"0;0;1\"/></filter></swap></part></scene></document>");
  const Reading reading(files, Flight, ThreeLegs);
  PartRun whole(files, reading, { "xyz" }, "whole");
  whole.Player->GetOptions()->SetEpoch(1);
  whole.Run();
  PartRun joined(files, reading, { "xyz" }, "joined");
  joined.Player->GetOptions()->SetEpoch(1);
  for (const int part : { 1, 2 })
  {
    PartRun run(files, reading, { "xyz" });
    run.Player->GetOptions()->SetEpoch(1);
    run.SetPart(part, 2);
    run.Run();
  }
  fs::rename(files / "parts/test/epoch001", files / "parts/test/play001");
  for (const int part : { 1, 2 })
  {
    const std::string former =
      files / ("parts/test/play001/" + vtkHeliosRunFiles::GetPartName(part, 2));
    fs::remove(former + "/run_summary.json"); // it is not needed
    MakeFormer(former);
    joined.Player->AddPartFolder(former);
  }
  joined.Run();
  CheckSame(files / "joined/test/epoch001", files / "whole/test/epoch001");
}

TEST_CASE("SurveyJoin: hits of blocks larger than pieces of text", "[SurveyJoin]")
{
  const Files files;
  const Reading reading(files, Flight, ThreeLegs);
  CheckJoin(files, reading, { GENERATE("las", "xyz", "vtp"), false, false, true, 35000 });
}

TEST_CASE("SurveyJoin: the time of the parts is in the summary", "[SurveyJoin]")
{
  const Files files;
  const Reading reading(files, Flight, ThreeLegs);
  RunParts(files, reading, { "xyz" }, 2);
  double seconds = 0.0;
  for (int part = 1; part <= 2; ++part)
  {
    const std::string folder = "parts/test/" + vtkHeliosRunFiles::GetPartName(part, 2);
    seconds += ReadTiming(files / folder, "run_s");
  }
  Join(files, reading, { "xyz" }, 2);
  CHECK(seconds > 0.0);
  CHECK(ReadTiming(files / "joined/test", "parts_s") == Approx(seconds));
}

TEST_CASE("SurveyJoin: LAS points with their waveforms", "[SurveyJoin]")
{
  const Files files;
  const Reading reading(files, Flight, ThreeLegs);
  CheckJoin(files, reading, { "las", false, true });
}

TEST_CASE("SurveyJoin: legs that share files", "[SurveyJoin]")
{
  const Files files;
  const Reading reading(files, Flight, MakeStrip());
  CheckJoin(files, reading, { GENERATE("las", "xyz", "vtp") });
}

TEST_CASE("SurveyJoin: channels, the first pulses without hits", "[SurveyJoin]")
{
  const Files files;
  files.Replace("assets.xml", "<FWFSettings beamSampleQuality=\"2\"/>",
    R"(<FWFSettings beamSampleQuality="1"/><channels>
<channel id="left"><beamOrigin x="-0.5"><rot axis="z" angle_deg="5"/></beamOrigin></channel>
<channel id="right"><beamOrigin x="0.5"/></channel></channels>)");
  const Reading reading(files, Tripod, R"(<leg><platformSettings z="2"/>
<scannerSettings scanFreq_hz="100" headRotatePerSec_deg="20" headRotateStop_deg="4"/></leg>)");
  CheckJoin(files, reading, { GENERATE("las", "xyz", "vtp"), GENERATE(true, false) });
}

TEST_CASE("SurveyJoin: more parts than blocks", "[SurveyJoin]")
{
  const Files files;
  const Reading reading(files, Flight, ThreeLegs); // 8 blocks
  PartRun(files, reading, { "las" }, "whole").Run();
  RunParts(files, reading, { "las" }, 11);
  PartRun empty(files, reading, { "las" });
  empty.SetPart(1, 11);
  empty.Player->SetResume(true);
  empty.Run();
  CHECK(empty.Player->GetWasFinished());
  CHECK(empty.Player->GetCount("pulses") == 0);
  Join(files, reading, { "las" }, 11);
  CheckSame(files / "joined/test", files / "whole/test");
}

TEST_CASE("SurveyJoin: a part is resumed", "[SurveyJoin]")
{
  const Files files;
  const Reading reading(files, Flight, ThreeLegs);
  const Settings settings = { GENERATE("xyz", "las", "vtp") };
  PartRun(files, reading, settings, "whole").Run();
  PartRun run(files, reading, settings);
  run.SetPart(2, 2);
  run.AbortAfter(20000);
  REQUIRE_FALSE(run.Player->Run());
  CHECK(run.Player->GetProgress() == Approx(0.5));
  PartRun joined(files, reading, settings, "joined");
  joined.Player->AddPartFolder(files / "parts/test/part002of002");
  joined.CheckFails({ "part 1/2 is missing; give all folders of the run, or run what is missing" });
  run.Blocks->Action = [](vtkHeliosSurveyPlayer*) {};
  run.Player->SetResume(true);
  run.SetPart(1, 2); // has not started
  run.Run();
  joined.Player->AddPartFolder(files / "parts/test/part001of002");
  joined.CheckFails({ "part002of002: part 2/2 is not finished: it has 2 of 4 blocks; run it with "
                      "--part 2/2 --resume" });
  run.SetPart(2, 2);
  run.Blocks->Done.clear();
  run.Run();
  CHECK(run.Blocks->Done.front() >= 20000); // no block is repeated
  joined.Run();
  CheckSame(files / "joined/test", files / "whole/test");
}

TEST_CASE("SurveyJoin: a join is resumed", "[SurveyJoin]")
{
  const Files files;
  const Reading reading(files, Flight, MakeStrip());
  const Settings settings = { GENERATE("xyz", "las", "vtp") };
  PartRun(files, reading, settings, "whole").Run();
  RunParts(files, reading, settings, 3);
  PartRun joined(files, reading, settings, "joined");
  joined.AddFolders(files, 3);
  joined.AbortAfter(50000);
  REQUIRE_FALSE(joined.Player->Run());
  joined.Blocks->Action = [](vtkHeliosSurveyPlayer*) {};
  joined.Player->SetResume(true);
  joined.Blocks->Done.clear();
  joined.Run();
  CHECK(joined.Blocks->Done.front() >= 50000);
  CheckSame(files / "joined/test", files / "whole/test");
}

TEST_CASE("SurveyJoin: folders that cannot be joined", "[SurveyJoin]")
{
  const Files files;
  const Reading reading(files, Flight, ThreeLegs);
  const Settings settings = { "xyz" };
  RunParts(files, reading, settings, 2);
  PartRun joined(files, reading, settings, "joined");
  SECTION("no part")
  {
    joined.Player->AddPartFolder(files / "nowhere");
    joined.CheckFails(
      { "nowhere is no part of a run: it has no run.journal; give folders that were "
        "run with --part" });
  }
  SECTION("a whole run")
  {
    BreakOff(files, reading);
    joined.Player->AddPartFolder(files / "out/test");
    joined.CheckFails({ "out/test is no part of a run: its run.journal is that of a whole run" });
  }
  SECTION("a part twice")
  {
    joined.AddFolders(files, 2);
    joined.Player->AddPartFolder(files / "parts/test/part002of002");
    joined.CheckFails({ "part002of002: part 2/2 is given twice, also by " });
  }
  SECTION("several parts are missing")
  {
    RunParts(files, reading, settings, 4);
    joined.Player->AddPartFolder(files / "parts/test/part003of004");
    joined.CheckFails({ "parts 1/4, 2/4 and 4/4 are missing" });
  }
  SECTION("parts of another division")
  {
    PartRun run(files, reading, settings);
    run.SetPart(3, 4);
    run.Run();
    joined.AddFolders(files, 2);
    joined.Player->AddPartFolder(files / "parts/test/part003of004");
    joined.CheckFails(
      { "part003of004: part 3/4 cannot be joined with ", "part 1/2; give the parts" });
  }
  SECTION("other options")
  {
    joined.AddFolders(files, 2);
    joined.Player->GetOptions()->SetSeed(7);
    joined.CheckFails(
      { "part001of002: part 1/2 cannot be joined, since seed was 0 and is 7; join and "
        "run all parts with the same inputs, options and version" });
  }
  SECTION("another scene")
  {
    files.Write("plane.obj", "v -50 -50 0\nv 50 -50 0\nv 50 50 1\nv -50 50 0\nf 1 2 3 4\n");
    joined.AddFolders(files, 2);
    joined.CheckFails({ "part 1/2 cannot be joined, since", "plane.obj has changed" });
  }
  SECTION("a damaged summary")
  {
    const std::string name = "parts/test/part001of002/run_summary.json";
    const std::string text = ReadText(files / name);
    joined.AddFolders(files, 2);
    files.Replace(name, "\"points\" : ", "\"points\" : 1");
    joined.CheckFails({ "part001of002/run_summary.json is damaged: it does not match its checksum",
      "; run it with --part 1/2 --overwrite" });
    files.Write(name, text.substr(0, text.size() / 2));
    joined.CheckFails({ "part001of002/run_summary.json is damaged; run it with --part 1/2" });
    fs::copy_file(files / "parts/test/part002of002/run_summary.json", files / name,
      fs::copy_options::overwrite_existing);
    joined.CheckFails(
      { "part001of002/run_summary.json: \"part\" is not that of run.journal; run it "
        "with --part 1/2 --overwrite" });
    fs::remove(files / name); // it is not needed
    CHECK(joined.Player->Run());
  }
  SECTION("a damaged journal")
  {
    const std::string name = "parts/test/part001of002/run.journal";
    files.Replace(name, "\"blocks\":1", "\"blocks\":2");
    joined.AddFolders(files, 2);
    joined.CheckFails({ "has a damaged line", "run this part again with --overwrite" });
  }
}

TEST_CASE("SurveyJoin: damaged files of parts", "[SurveyJoin]")
{
  const Files files;
  const Reading reading(files, Flight, ThreeLegs);
  const Settings settings = { GENERATE("xyz", "las") };
  RunParts(files, reading, settings, 2);
  PartRun joined(files, reading, settings, "joined");
  joined.AddFolders(files, 2);
  const std::string name = std::string("parts/test/part002of002/") +
    (settings.Format == "xyz" ? "leg001_points.xyz" : "leg001_points_0002.vtp");
  const std::string text = ReadText(files / name);
  SECTION("other bytes")
  {
    std::string damaged = text;
    damaged[text.size() / 2] ^= 1;
    files.Write(name, damaged);
    joined.CheckFails({ name.substr(6), "do not match their checksum in run.journal",
      "; run it with --part 2/2 --overwrite" });
  }
  SECTION("too short")
  {
    files.Write(name, text.substr(0, text.size() / 2));
    joined.CheckFails({ name.substr(6), "bytes and has", "; run it with --part 2/2 --overwrite" });
  }
  SECTION("missing")
  {
    fs::remove(files / name);
    joined.CheckFails({ name.substr(6), "cannot be read", "; run it with --part 2/2 --overwrite" });
  }
}

TEST_CASE("SurveyJoin: parts that do not exist", "[SurveyJoin]")
{
  const Files files;
  const Reading reading(files, Flight, ThreeLegs);
  PartRun run(files, reading, { "xyz" });
  run.SetPart(3, 2);
  SECTION("a number above that of parts")
  {
    run.CheckFails({ "Part is 3, but NumberOfParts is 2; give 1 to 2" });
  }
  SECTION("a part that joins parts")
  {
    run.SetPart(1, 2);
    run.Player->AddPartFolder("x");
    run.CheckFails({ "NumberOfParts is 2, but there are folders of parts to join; set it to 0" });
    run.Player->ClearPartFolders();
    CHECK(run.Player->GetNumberOfPartFolders() == 0);
    CHECK(run.Player->Run());
  }
  SECTION("the folder of another part")
  {
    run.SetPart(1, 2);
    run.Run();
    fs::rename(files / "parts/test/part001of002", files / "parts/test/part002of002");
    run.SetPart(2, 2);
    run.Player->SetResume(true);
    run.CheckFails({ "cannot be resumed, since it is part 1/2 and not 2/2" });
  }
}
