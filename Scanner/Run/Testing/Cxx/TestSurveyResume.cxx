// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Interrupted and resumed runs; run summaries; estimates.
#include "heliosBrokenRun.h"
#include "vtkHeliosRunFiles.h"
#include "vtkHeliosRunOptions.h"

#include <algorithm>

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

namespace fs = std::filesystem;
using namespace helios::test;

TEST_CASE("SurveyResume: a resumed run is byte-identical to an uninterrupted one", "[SurveyResume]")
{
  const Files files;
  const Reading reading(files, Flight, ThreeLegs);
  const std::string format = GENERATE("xyz", "las", "laz", "copc", "vtp");
  const vtkIdType pulses = GENERATE(10000, 40000, 70000);
  BlockRun whole(files, reading, "whole");
  whole.Player->SetFormat(format.c_str());
  REQUIRE(whole.Player->Run());
  BlockRun broken(files, reading);
  broken.Player->SetFormat(format.c_str());
  broken.AbortAfter(pulses);
  REQUIRE_FALSE(broken.Player->Run());
  broken.Player->SetResume(true);
  broken.Blocks->Done.clear();
  broken.Blocks->Action = [](vtkHeliosSurveyPlayer*) {};
  REQUIRE(broken.Player->Run());
  CHECK_FALSE(broken.Player->GetWasFinished());
  // no block is repeated
  CHECK(*std::min_element(broken.Blocks->Done.begin(), broken.Blocks->Done.end()) >= pulses);
  CHECK(broken.Player->GetCount("points") == 80000);
  const auto a = ReadAll(files / "whole/test");
  const auto b = ReadAll(files / "out/test");
  CHECK(a.size() >= 6);
  CHECK((a == b)); // too long to print
}

TEST_CASE("SurveyResume: a run that is stopped within a block keeps its pieces", "[SurveyResume]")
{
  const Files files;
  const Reading reading(files, Flight, ThreeLegs);
  const std::string format = GENERATE("xyz", "las", "laz", "copc", "vtp");
  const auto prepare = [&format](BlockRun& run)
  {
    run.Player->SetFormat(format.c_str());
    run.Player->SetPulsesPerBlock(100000); // 4 pieces of 10,000 pulses of each leg
    run.Player->SetWriteWaveforms(false);
    run.Player->GetOptions()->SetNumberOfSubRays(400); // several reports a piece
    run.Player->GetOptions()->SetAccuracyReport(false);
  };
  BlockRun whole(files, reading, "whole");
  prepare(whole);
  REQUIRE(whole.Player->Run());
  BlockRun broken(files, reading);
  prepare(broken);
  broken.AbortAfter(20001);
  REQUIRE_FALSE(broken.Player->Run());
  CHECK(broken.Log->Errors.empty());
  const bool isWhole =
    format == "vtp" || vtkHeliosRunFiles::IsCompressed(format); // a block is a file, or chunks
  const vtkIdType safe = broken.Player->GetCount("pulses");
  const std::string pieces = "\"pieces\":" + std::to_string(safe / 10000) + ",";
  // a busy machine may give the thread that reports nothing of the third piece
  CHECK((isWhole ? safe == 0 : safe == 20000 || safe == 30000));
  CHECK((ReadText(files / Journal).find("\"blocks\":0,") != std::string::npos) == !isWhole);
  CHECK((ReadText(files / Journal).find(pieces) != std::string::npos) == !isWhole);
  broken.Player->SetResume(true);
  broken.Blocks->Action = [](vtkHeliosSurveyPlayer*) {};
  REQUIRE(broken.Player->Run());
  CHECK((ReadAll(files / "whole/test") == ReadAll(files / "out/test")));
}

TEST_CASE("SurveyResume: legs that share files", "[SurveyResume]")
{
  const Files files;
  std::string legs = ThreeLegs;
  for (std::size_t at = legs.find("<leg>"); at != std::string::npos; at = legs.find("<leg>"))
  {
    legs.replace(at, 5, "<leg stripId=\"7\">");
  }
  const Reading reading(files, Flight, legs);
  const std::string format = GENERATE("xyz", "las", "laz", "copc", "vtp");
  const vtkIdType pulses = GENERATE(20000, 40000, 60000);
  BlockRun whole(files, reading, "whole");
  whole.Player->SetFormat(format.c_str());
  whole.Player->SetWriteWaveforms(vtkHeliosRunFiles::IsLas(format));
  REQUIRE(whole.Player->Run());
  BlockRun broken(files, reading);
  broken.Player->SetFormat(format.c_str());
  broken.Player->SetWriteWaveforms(vtkHeliosRunFiles::IsLas(format));
  broken.AbortAfter(pulses);
  REQUIRE_FALSE(broken.Player->Run());
  broken.Player->SetResume(true);
  broken.Blocks->Action = [](vtkHeliosSurveyPlayer*) {};
  REQUIRE(broken.Player->Run());
  CHECK((ReadAll(files / "whole/test") == ReadAll(files / "out/test")));
  CHECK(fs::exists(files / "out/test/strip007_fullwave.wdp") == vtkHeliosRunFiles::IsLas(format));
  if (format == "vtp")
  {
    const std::string index = ReadText(files / "out/test/strip007_points.pvtp");
    CHECK(index.find("_0007.vtp") != std::string::npos);  // 8 blocks
    CHECK(index.find("</VTKFile>") == index.size() - 11); // and one end
  }
}

TEST_CASE("SurveyResume: a truncated or damaged journal", "[SurveyResume]")
{
  const Files files;
  const Reading reading(files, Flight, ThreeLegs);
  BreakOff(files, reading);
  const std::string text = ReadText(files / Journal);
  BlockRun playing(files, reading);
  playing.Player->SetResume(true);
  SECTION("an incomplete last line: the block is computed again")
  {
    files.Write(Journal, text.substr(0, text.size() - 40));
    CHECK(playing.Player->Run());
    CHECK(playing.Blocks->Done.front() >= 40000);
    CHECK_FALSE(fs::exists(files / Journal));
  }
  SECTION("the last line has no line end")
  {
    files.Write(Journal, text.substr(0, text.size() - 1));
    CHECK(playing.Player->Run());
    CHECK(playing.Blocks->Done.front() >= 40000);
  }
  SECTION("zeros where the last line was")
  {
    files.Write(Journal, text.substr(0, text.size() - 40) + std::string(39, '\0') + "\n");
    CHECK(playing.Player->Run());
    CHECK(playing.Blocks->Done.front() >= 40000);
  }
  SECTION("another line is damaged")
  {
    std::string damaged = text;
    damaged[damaged.find("\"blocks\"")] = ' ';
    files.Write(Journal, damaged);
    playing.CheckFails({ "run.journal has a damaged line", "set Overwrite (--overwrite)" });
  }
  SECTION("it is empty")
  {
    files.Write(Journal, "");
    playing.CheckFails({ "run.journal does not state which run it belongs to" });
  }
  SECTION("another process writes it")
  {
    const int other = ::open((files / Journal).c_str(), O_RDONLY);
    REQUIRE(::flock(other, LOCK_EX) == 0);
    playing.CheckFails(
      { "run.journal is being written by another process; wait for the other run to end" });
    playing.Player->SetResume(false);
    playing.Player->SetOverwrite(true);
    playing.CheckFails({ "run.journal is being written by another process; wait for it to end" });
    CHECK(ReadText(files / Journal) == text);
    ::close(other);
  }
}

TEST_CASE("SurveyResume: runs that cannot be resumed", "[SurveyResume]")
{
  const Files files;
  const Reading reading(files, Flight, ThreeLegs);
  BreakOff(files, reading);
  BlockRun playing(files, reading);
  vtkHeliosSurveyPlayer* player = playing.Player;
  SECTION("neither requested nor replaced")
  {
    playing.CheckFails(
      { "the run is not finished: set Resume (--resume) to continue it, set Overwrite" });
  }
  SECTION("both")
  {
    player->SetResume(true);
    player->SetOverwrite(true);
    playing.CheckFails({ "Resume and Overwrite are both on", "set one of them" });
  }
  player->SetResume(true);
  SECTION("other settings")
  {
    player->GetOptions()->SetSeed(7);
    player->GetOptions()->SetNoise(false);
    player->SetPulsesPerBlock(20000);
    playing.CheckFails({ "seed was 0 and is 7", "noise was true and is false",
      "pulsesPerBlock was 10000 and is 20000", "use the same inputs and options" });
  }
  SECTION("another input")
  {
    files.Replace("plane.obj", "-50", "-51");
    playing.CheckFails({ "plane.obj has changed", "set Overwrite (--overwrite)" });
  }
  SECTION("another survey")
  {
    files.Replace("assets.xml", "200000", "200001");
    playing.CheckFails({ "assets.xml has changed" });
  }
  SECTION("a finished file is missing or changed")
  {
    files.Write("out/test/leg000_points.xyz", "short");
    playing.CheckFails({ "leg000_points.xyz: was complete with", "has 5;", "to start again" });
    fs::remove(files / "out/test/leg000_points.xyz");
    playing.CheckFails({ "leg000_points.xyz: was complete with", "cannot be read: No such file" });
  }
  SECTION("an unfinished file is shorter")
  {
    files.Write("out/test/leg001_points.xyz.part", "short");
    playing.CheckFails({ "leg001_points.xyz.part cannot be resumed: it has 5 bytes of" });
  }
}

TEST_CASE("SurveyResume: the folder is removed during a run", "[SurveyResume]")
{
  const Files files;
  const Reading reading(files, Flight, ThreeLegs);
  BlockRun playing(files, reading);
  playing.Blocks->Action = [&files](vtkHeliosSurveyPlayer*) { fs::remove_all(files / "out"); };
  playing.CheckFails({ "was removed while it was written; check that the output folder exists",
    "nothing is kept, since the folder", "out/test is gone." });
  CHECK_FALSE(fs::exists(files / "out"));
}

TEST_CASE("SurveyResume: existing files with the names of the run", "[SurveyResume]")
{
  const Files files;
  const Reading reading(files, Flight, ThreeLegs);
  BlockRun playing(files, reading);
  playing.Player->SetOverwrite(true);
  SECTION("a folder of the name of the journal appears")
  {
    files.Write("out/test/run.journal/mine", "");
    playing.CheckFails({ "run.journal" });
  }
  SECTION("a folder of the name of the summary appears")
  {
    playing.Blocks->Action = [&files](vtkHeliosSurveyPlayer*)
    { files.Write("out/test/run_summary.json/mine", ""); };
    playing.CheckFails(
      { "run_summary.json is a folder, not a file; all points are written", "Resume (--resume)" });
    fs::remove_all(files / "out/test/run_summary.json");
    playing.Blocks->Action = [](vtkHeliosSurveyPlayer*) {};
    playing.Player->SetOverwrite(false);
    playing.Player->SetResume(true);
    playing.Blocks->Done.clear();
    CHECK(playing.Player->Run());
    CHECK(playing.Player->GetCount("points") == 80000);
  }
}

TEST_CASE("SurveyResume: a finished run is not changed", "[SurveyResume]")
{
  const Files files;
  const Reading reading(files, Flight, ThreeLegs);
  BlockRun playing(files, reading);
  REQUIRE(playing.Player->Run());
  CHECK_FALSE(fs::exists(files / Journal));
  const std::string report = playing.Player->GetReport();
  CHECK(report == ReadText(files / "out/test/run_summary.json"));
  for (const char* part : { "\"vtkHelios\" : \"", "\"sha256\" : \"", "\"file\" : \"", "plane.obj",
         "assets.xml", "survey.xml", "\"seed\" : 0", "\"points\" : 80000", "\"points\" : 40000",
         "leg001_trajectory.txt", "\"threads\" : ", "\"rayCaster\" : \"beam\"" })
  {
    INFO(part);
    CHECK(report.find(part) != std::string::npos);
  }
  playing.Player->SetResume(true);
  playing.Blocks->Done.clear();
  REQUIRE(playing.Player->Run());
  CHECK(playing.Player->GetWasFinished());
  CHECK(playing.Blocks->Done.empty());
  CHECK(playing.Player->GetCount("points") == 80000);
  CHECK(playing.Player->GetReport() == report);
  CHECK(playing.Player->GetMessage().find("Nothing is left to do: the run in") == 0);
  playing.Player->GetOptions()->SetSeed(2);
  playing.CheckFails({ "seed was 0 and is 2" });
  playing.Player->GetOptions()->SetSeed(0);
  files.Write("out/test/run_summary.json", "{ \"surv");
  playing.CheckFails({ "run_summary.json is damaged" });
  fs::remove(files / "out/test/run_summary.json");
  playing.CheckFails({ "has no run.journal, so its contents cannot be resumed" });
  fs::remove_all(files / "out");
  playing.CheckFails({ "so there is nothing to resume; run it without Resume (--resume)" });
}

TEST_CASE("SurveyEstimate: close to the results of the run", "[SurveyEstimate]")
{
  const Files files;
  // 120 m across a plane of 100 m; a leg beside the plane
  const Reading reading(files, Flight, R"(<platformSettings id="p" z="100" movePerSec_m="20"/>
<scannerSettings id="c" pulseFreq_hz="200000" scanFreq_hz="50" scanAngle_deg="15"/>
<leg><platformSettings template="p" x="-60"/><scannerSettings template="c"/></leg>
<leg><platformSettings template="p" x="60"/><scannerSettings template="c"/></leg>
<leg><platformSettings template="p" x="70"/><scannerSettings template="c"/></leg>)");
  BlockRun playing(files, reading);
  const std::string format = GENERATE("xyz", "las", "vtp");
  playing.Player->SetFormat(format.c_str());
  playing.Player->SetPulsesPerBlock(262144);
  playing.Player->SetWriteWaveforms(false);
  REQUIRE(playing.Player->Estimate());
  CHECK_FALSE(fs::exists(files / "out"));
  CHECK(playing.Player->GetMessage() == "Estimated; nothing was written.");
  const auto number = [](const std::string& report, const char* name)
  {
    const std::size_t totals = report.find("\"totals\"");
    const std::size_t at = report.find(std::string("\"") + name + "\" : ", totals);
    REQUIRE(at != std::string::npos);
    return std::stod(report.substr(report.find(':', at) + 1));
  };
  const std::string estimate = playing.Player->GetReport();
  CHECK(number(estimate, "pulsesSampled") < 0.4 * number(estimate, "pulses"));  // not all pulses
                                                                                // were sampled
  CHECK(number(estimate, "pulsesSampled") > 0.19 * number(estimate, "pulses")); // whole lines
  REQUIRE(playing.Player->Run());
  double bytes = 0.0;
  for (const auto& file : ReadAll(files / "out/test"))
  {
    bytes += static_cast<double>(file.second.size());
  }
  CHECK(number(estimate, "pulses") == 1300000.0);
  CHECK(number(estimate, "pulsesFired") == Approx(1300000.0));
  CHECK(number(estimate, "points") ==
    Approx(static_cast<double>(playing.Player->GetCount("points"))).epsilon(0.05));
  CHECK(number(estimate, "bytes") == Approx(bytes).epsilon(0.05));
}

TEST_CASE("SurveyEstimate: computes fewer slow pulses", "[SurveyEstimate]")
{
  const Files files;
  const Reading reading(files, Flight, R"(<platformSettings id="p" z="100" movePerSec_m="20"/>
<scannerSettings id="c" pulseFreq_hz="200000" scanFreq_hz="50" scanAngle_deg="15"/>
<leg><platformSettings template="p" x="-60"/><scannerSettings template="c"/></leg>
<leg><platformSettings template="p" x="60"/><scannerSettings template="c"/></leg>
<FWFSettings beamSampleQuality="64" binSize_ns="0.01"/>)");
  BlockRun playing(files, reading);
  playing.Player->SetWriteWaveforms(false);
  REQUIRE(playing.Player->Estimate());
  const std::string report = playing.Player->GetReport();
  const std::string name = "\"pulsesSampled\" : ";
  const double sampled = std::stod(report.substr(report.rfind(name) + name.size()));
  CHECK(sampled < 200000.0); // else 262144
  CHECK(sampled >= 8.0);
}

TEST_CASE(
  "SurveyEstimate: short legs are computed completely, and it can be aborted", "[SurveyEstimate]")
{
  const Files files;
  const Reading reading(files, Flight, ThreeLegs);
  BlockRun playing(files, reading);
  REQUIRE(playing.Player->Estimate());
  CHECK(playing.Player->GetReport().find("\"points\" : 80000") != std::string::npos);
  playing.Player->RemoveAllObservers();
  class Stop : public vtkCommand
  {
  public:
    static Stop* New() { return new Stop; }
    void Execute(vtkObject* caller, unsigned long, void*) override
    {
      static_cast<vtkHeliosSurveyPlayer*>(caller)->Abort();
    }
  };
  vtkNew<Stop> stop;
  playing.Player->AddObserver(vtkCommand::ProgressEvent, stop);
  CHECK_FALSE(playing.Player->Estimate());
  CHECK(playing.Player->GetReport().empty());
  playing.Player->RemoveAllObservers();
  files.Write("plane.obj", "");
  CHECK_FALSE(playing.Player->Estimate());
  CHECK_FALSE(playing.Player->GetMessage().empty());
}
