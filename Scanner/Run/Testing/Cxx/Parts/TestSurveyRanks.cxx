// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Ranks that share a run, as threads: the files equal the files of one process.
#include "heliosBrokenRun.h"
#include "heliosRankMessage.h"
#include "vtkHeliosRanks.h"
#include "vtkHeliosRunOptions.h"

#include <vtkCallbackCommand.h>
#include <vtkCommand.h>

#include <catch2/catch.hpp>

#include <deque>
#include <memory>
#include <mutex>
#include <string>
#include <thread>
#include <tuple>
#include <utility>
#include <vector>

using namespace helios::test;

namespace
{

/// The messages between the ranks of a process.
struct PostOffice
{
  explicit PostOffice(int ranks)
    : Boxes(static_cast<std::size_t>(ranks))
  {
  }

  using Letter = std::pair<int, std::string>; // rank of the sender, and message

  std::mutex Mutex;
  std::vector<std::deque<Letter>> Boxes;
};

class ThreadRanks : public vtkHeliosRanks
{
public:
  static ThreadRanks* New() { return new ThreadRanks; }
  vtkTypeMacro(ThreadRanks, vtkHeliosRanks);

  int GetNumberOfRanks() const override { return static_cast<int>(this->Office->Boxes.size()); }
  int GetRank() const override { return this->Rank; }
  std::string Send(int rank, const std::string& message) override
  {
    const std::lock_guard<std::mutex> lock(this->Office->Mutex);
    this->Office->Boxes[static_cast<std::size_t>(rank)].emplace_back(this->Rank, message);
    return this->Fault;
  }

  PostOffice* Office = nullptr;
  int Rank = 0;
  std::string Fault; ///< fault of sending

protected:
  bool ReceiveNext(int& rank, std::string& message) override
  {
    const std::lock_guard<std::mutex> lock(this->Office->Mutex);
    auto& box = this->Office->Boxes[static_cast<std::size_t>(this->Rank)];
    if (box.empty())
    {
      return false;
    }
    std::tie(rank, message) = std::move(box.front());
    box.pop_front();
    return true;
  }
};

struct Settings
{
  std::string Format;
  bool IsSplit = false;
  bool IsInPoints = false; // the waveforms of LAS
};

/// A rank with its own survey.
struct RankRun : BlockRun
{
  vtkNew<ThreadRanks> Ranks;

  RankRun(const Files& files, const Reading& reading, const Settings& settings,
    const std::string& folder = "out")
    : BlockRun(files, reading, folder)
  {
    this->Player->SetFormat(settings.Format.c_str());
    this->Player->SetSplitByChannel(settings.IsSplit);
    this->Player->SetWaveformsInPoints(settings.IsInPoints);
    this->Player->SetWritePulses(true);
  }

  void Join(PostOffice& office, int rank)
  {
    this->Ranks->Office = &office;
    this->Ranks->Rank = rank;
    this->Player->SetRanks(this->Ranks);
  }
};

/// Rank 0, and threads that serve it until they are dismissed.
struct Cluster
{
  PostOffice Office;
  RankRun Main;
  std::vector<std::unique_ptr<Reading>> Readings;
  std::vector<std::unique_ptr<RankRun>> Others;
  std::vector<std::thread> Threads;

  Cluster(const Files& files, const Reading& reading, const Settings& settings, int ranks)
    : Office(ranks)
    , Main(files, reading, settings)
  {
    this->Main.Join(this->Office, 0);
    for (int rank = 1; rank < ranks; ++rank)
    {
      this->Readings.push_back(std::make_unique<Reading>(files));
      this->Others.push_back(
        std::make_unique<RankRun>(files, *this->Readings.back(), settings, "nowhere"));
      this->Others.back()->Join(this->Office, rank);
    }
  }

  void Start()
  {
    for (const auto& other : this->Others)
    {
      this->Threads.emplace_back([&other] { other->Player->Serve(); });
    }
  }

  ~Cluster()
  {
    this->Main.Ranks->Dismiss();
    for (std::thread& thread : this->Threads)
    {
      thread.join();
    }
  }
};

/// The summary without what depends on the host.
std::string ReadSummary(const std::string& folder)
{
  const std::string text = ReadText(folder + "/run_summary.json");
  return text.substr(0, text.find("\"timings\"")) + text.substr(text.find("\"totals\""));
}

/// Reports the files that differ.
void CheckSame(const std::string& found, const std::string& expected)
{
  const auto are = ReadAll(found);
  const auto should = ReadAll(expected);
  for (const auto& [name, text] : should)
  {
    INFO(name);
    REQUIRE(are.count(name) == 1);
    CHECK((are.at(name) == text)); // too long to print
  }
  CHECK(are.size() == should.size());
  CHECK(ReadSummary(found) == ReadSummary(expected));
}

/// Any number of ranks writes the files of one process.
void CheckRanks(const Files& files, const Reading& reading, const Settings& settings)
{
  RankRun whole(files, reading, settings, "whole");
  REQUIRE(whole.Player->Run());
  for (const int ranks : { 1, 2, 3, 4 })
  {
    INFO(ranks << " ranks");
    Cluster cluster(files, reading, settings, ranks);
    cluster.Start();
    cluster.Main.Player->SetOverwrite(true);
    const bool isRun = cluster.Main.Player->Run();
    INFO(cluster.Main.Log->Errors);
    REQUIRE(isRun);
    CHECK(cluster.Main.Ranks->GetNumberOfMessages() == (ranks > 1 ? ranks - 1 + 8 : 0));
    CheckSame(files / "out/test", files / "whole/test");
  }
}

} // namespace

TEST_CASE("SurveyRanks: legs", "[SurveyRanks]")
{
  const Files files;
  const Reading reading(files, Flight, ThreeLegs);
  CheckRanks(files, reading, { GENERATE("las", "xyz", "vtp") });
}

TEST_CASE("SurveyRanks: LAS points with their waveforms", "[SurveyRanks]")
{
  const Files files;
  const Reading reading(files, Flight, ThreeLegs);
  CheckRanks(files, reading, { "las", false, true });
}

TEST_CASE("SurveyRanks: channels with files of their own", "[SurveyRanks]")
{
  const Files files;
  files.Replace("assets.xml", "<FWFSettings beamSampleQuality=\"2\"/>",
    R"(<FWFSettings beamSampleQuality="1"/><channels>
<channel id="left"><beamOrigin x="-0.5"><rot axis="z" angle_deg="5"/></beamOrigin></channel>
<channel id="right"><beamOrigin x="0.5"/></channel></channels>)");
  const Reading reading(files, Tripod, R"(<leg><platformSettings z="2"/>
<scannerSettings scanFreq_hz="100" headRotatePerSec_deg="20" headRotateStop_deg="3"/></leg>)");
  const Settings settings = { GENERATE("las", "xyz", "vtp"), true };
  RankRun whole(files, reading, settings, "whole");
  REQUIRE(whole.Player->Run());
  Cluster cluster(files, reading, settings, 3);
  cluster.Start();
  REQUIRE(cluster.Main.Player->Run());
  CheckSame(files / "out/test", files / "whole/test");
}

TEST_CASE("SurveyRanks: a run is resumed by another number of ranks", "[SurveyRanks]")
{
  const Files files;
  const Reading reading(files, Flight, ThreeLegs);
  const Settings settings = { GENERATE("las", "xyz", "vtp") };
  RankRun whole(files, reading, settings, "whole");
  REQUIRE(whole.Player->Run());
  {
    Cluster cluster(files, reading, settings, 3);
    cluster.Start();
    cluster.Main.AbortAfter(30000);
    REQUIRE_FALSE(cluster.Main.Player->Run());
    CHECK(
      cluster.Main.Player->GetMessage().find("Resume (--resume) continues") != std::string::npos);
  }
  {
    Cluster cluster(files, reading, settings, 2);
    cluster.Start();
    cluster.Main.Player->SetResume(true);
    cluster.Main.AbortAfter(60000);
    REQUIRE_FALSE(cluster.Main.Player->Run());
    CHECK(cluster.Main.Blocks->Done.front() >= 30000); // no block is repeated
    // Runs ranks which have blocks of the previous run.
    cluster.Main.Blocks->Action = [](vtkHeliosSurveyPlayer*) {};
    REQUIRE(cluster.Main.Player->Run());
  }
  CheckSame(files / "out/test", files / "whole/test");
}

TEST_CASE("SurveyRanks: an abort while no block arrives", "[SurveyRanks]")
{
  const Files files;
  const Reading reading(files, Flight, ThreeLegs);
  Cluster cluster(files, reading, { "xyz" }, 2);
  int calls = 0;
  vtkNew<vtkCallbackCommand> abort;
  abort->SetClientData(&calls);
  abort->SetCallback(
    [](vtkObject* caller, unsigned long, void* count, void*)
    {
      auto* player = static_cast<vtkHeliosSurveyPlayer*>(caller);
      if (player->GetNumberOfPulses() > 0 && ++*static_cast<int*>(count) == 3)
      {
        player->Abort();
      }
    });
  vtkHeliosSurveyPlayer* player = cluster.Main.Player;
  player->AddObserver(vtkCommand::ProgressEvent, abort);
  CHECK_FALSE(player->Run()); // nobody serves
  CHECK(cluster.Main.Log->Errors.empty());
  CHECK(player->GetMessage().find("Stopped after 0 of 80000 pulses") == 0);
  cluster.Start();
}

TEST_CASE("SurveyRanks: messages of an earlier run are ignored", "[SurveyRanks]")
{
  const Files files;
  const Reading reading(files, Flight, ThreeLegs);
  Cluster cluster(files, reading, { "xyz" }, 2);
  helios::RankMessage late(helios::RankMessage::Fault);
  late.Run = -1;
  late.Error = "late";
  cluster.Office.Boxes[0].emplace_back(1, late.Encode());
  cluster.Start();
  CHECK(cluster.Main.Player->Run());
  CHECK(cluster.Main.Log->Errors.empty());
}

TEST_CASE("SurveyRanks: errors name the rank", "[SurveyRanks]")
{
  const Files files;
  const Reading reading(files, Flight, ThreeLegs);
  Cluster cluster(files, reading, { "xyz" }, 3);
  SECTION("other options")
  {
    cluster.Others[1]->Player->GetOptions()->SetSeed(7);
    cluster.Start();
    cluster.Main.CheckFails({ "rank 2: cannot share the run of rank 0, since seed was 0 and is 7; "
                              "give all ranks the same files, options and version" });
  }
  SECTION("no survey")
  {
    cluster.Others[0]->Player->SetSurvey(nullptr);
    cluster.Start();
    cluster.Main.CheckFails({ "rank 1: Survey is not set or has no legs" });
  }
  SECTION("a message that is damaged")
  {
    cluster.Office.Boxes[0].emplace_back(2, "x");
    cluster.Start();
    cluster.Main.CheckFails({ "rank 2: has sent a message that cannot be read; start all ranks "
                              "with the same version" });
  }
  SECTION("messages cannot be sent")
  {
    cluster.Start();
    cluster.Main.Ranks->Fault = "the network is down";
    cluster.Main.CheckFails({ "rank 1: the network is down" });
    cluster.Main.Ranks->Fault.clear();
  }
  SECTION("rank 0 does not serve")
  {
    cluster.Start();
    CHECK_FALSE(cluster.Main.Player->Serve());
    CHECK(cluster.Main.Log->HasError("Serve() is for ranks above 0: set Ranks, and call Run()"));
  }
}

TEST_CASE("SurveyRanks: a message is decoded as it was encoded", "[SurveyRanks]")
{
  helios::RankMessage message(helios::RankMessage::Block);
  message.Run = 2;
  message.Leg = 3;
  message.Index = 5000000000;
  message.Counts.Echoes = 7;
  message.Counts.LargestAmplitude = 0.1;
  message.Error = "a\nb";
  message.Records = { { 2, std::string("x\n\0y", 4) }, {}, { 1, "z" } };
  const std::string text = message.Encode();
  helios::RankMessage copy;
  REQUIRE(copy.Decode(text));
  CHECK(copy.Encode() == text);
  CHECK(copy.Counts.LargestAmplitude == 0.1);
  CHECK(copy.Records[0].Bytes == message.Records[0].Bytes);
  CHECK_FALSE(copy.Decode(text.substr(0, text.size() - 1)));
  CHECK_FALSE(copy.Decode(text + "x"));
  CHECK_FALSE(copy.Decode("{}"));
}
