// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Overhead of playing a survey: the player, with its journal on the disk, against the bare scanner
// of the same legs and against that with the text writer and no journal. The output must be
// byte-identical. Also the peak memory for 1 and for 8 times the pulses.
// Usage: BenchPlayback [repetitions]

#include "heliosBenchClock.h"
#include "heliosBenchScenes.h"

#include "heliosLegRunner.h"
#include "heliosMessages.h"
#include "heliosSceneBuilder.h"
#include "vtkHeliosObjSceneWriter.h"
#include "vtkHeliosStreamWriter.h"
#include "vtkHeliosSurvey.h"
#include "vtkHeliosSurveyPlayer.h"
#include "vtkHeliosSurveyReader.h"

#include <vtkCommand.h>
#include <vtkSMPTools.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <memory>
#include <string>
#include <vector>

#include <sys/resource.h>

namespace fs = std::filesystem;
using helios::Median;

namespace
{

struct Seconds
{
  double Wall = 0.0;
  double Cpu = 0.0;
};

/// Since the first call, of this process.
Seconds Now()
{
  timespec t;
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
  const auto wall = std::chrono::steady_clock::now().time_since_epoch();
  return { std::chrono::duration<double>(wall).count(),
    static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec) };
}

double GetPeakMemory()
{
  rusage usage;
  getrusage(RUSAGE_SELF, &usage);
  return 1e-3 * static_cast<double>(usage.ru_maxrss);
}

std::string ReadText(const fs::path& path)
{
  std::ifstream file(path, std::ios::binary);
  return { std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>() };
}

/// A temporary folder, removed at the end.
struct Folder
{
  fs::path Path = fs::temp_directory_path() / "vtkHeliosBenchPlayback";
  Folder() { fs::create_directories(this->Path); }
  ~Folder() { fs::remove_all(this->Path); }
};

/// A tripod on hills, head rotation 20 deg/s by a given angle, 300,000 pulses/s.
void WriteSurvey(const fs::path& folder, double turn)
{
  const helios::Vec3 p =
    helios::BenchOffset + helios::Vec3(250, 250, helios::GetHillHeight(250, 250) + 2);
  std::ofstream survey(folder / "survey.xml");
  survey.precision(12);
  survey
    << "<document><scene id=\"s\"><part><filter type=\"objloader\"><param key=\"filepath\" "
       "value=\"hills.obj\"/></filter></part></scene>\n"
       "<platform id=\"tripod\" type=\"static\"/>\n"
       "<scanner id=\"tls\" optics=\"rotating\" accuracy_m=\"0.005\" pulseFreqs_Hz=\"300000\" "
       "beamDivergence_rad=\"0.0003\" scanAngleMax_deg=\"50\" scanAngleEffectiveMax_deg=\"50\" "
       "scanFreqMax_Hz=\"120\" headRotatePerSecMax_deg=\"60\"/>\n"
       "<survey name=\"bench\" scene=\"#s\" platform=\"#tripod\" scanner=\"#tls\"><leg>"
       "<platformSettings x=\""
    << p[0] << "\" y=\"" << p[1] << "\" z=\"" << p[2]
    << "\"/><scannerSettings pulseFreq_hz=\"300000\" scanFreq_hz=\"100\" "
       "headRotatePerSec_deg=\"20\" headRotateStop_deg=\""
    << turn << "\"/></leg></survey></document>\n";
}

void WriteScene(const fs::path& folder)
{
  helios::BenchScene scene;
  scene.AddHills(500, 500.0);
  vtkNew<vtkHeliosObjSceneWriter> writer;
  writer->SetInputData(scene.Finish());
  writer->SetFileName((folder / "hills.obj").c_str());
  writer->Update();
}

/// The legs of a survey, run without a player.
struct Bare
{
  vtkNew<vtkHeliosSurveyPlayer> Owner; // owner of the messages
  helios::Messages Log{ Owner };
  helios::RunSettings Settings;
  vtkSmartPointer<vtkPolyData> Scene;
  std::unique_ptr<helios::LegRunner> Runner;

  Bare(vtkHeliosSurvey* survey, const fs::path& folder)
  {
    this->Settings.Folder = folder.string();
    this->Settings.Format = "xyz";
    this->Settings.Options.Seed = 0;
    helios::SceneBuilder builder(survey->GetData().Scene, this->Log);
    this->Scene = builder.Build([](const std::string&) { return true; });
    this->Runner = std::make_unique<helios::LegRunner>(
      survey->GetData(), this->Scene, this->Settings, this->Log);
    this->Runner->Plan();
  }

  /// Runs all blocks, with or without text; the clock starts after the first, which builds the ray
  /// caster's tree.
  helios::ScanCounts Run(bool writes, Seconds& start)
  {
    const helios::LegPlan& plan = this->Runner->GetPlans().front();
    helios::LegScanner& scanner = this->Runner->Prepare(plan);
    const auto writer = this->Runner->MakeOutputs(plan).front().Writer;
    const bool isOpen = writes && writer->Open();
    const auto blocks = static_cast<int>(
      (plan.NumberOfPulses + this->Settings.PulsesPerBlock - 1) / this->Settings.PulsesPerBlock);
    helios::ScanCounts counts;
    for (int block = 0; block < blocks && scanner.Update(block, blocks); ++block)
    {
      scanner.Count(counts);
      if (isOpen)
      {
        writer->Write(scanner.GetOutput(0));
      }
      scanner.ReleaseOutput();
      start = block == 0 ? Now() : start;
    }
    if (isOpen)
    {
      writer->Abandon(); // without fsync
    }
    return counts;
  }
};

/// The times of repeated runs.
struct Times
{
  std::vector<double> Wall;
  std::vector<double> Cpu;

  template <typename WorkT>
  void Add(const WorkT& work)
  {
    Seconds start = Now();
    work(start);
    const Seconds end = Now();
    this->Wall.push_back(end.Wall - start.Wall);
    this->Cpu.push_back(end.Cpu - start.Cpu);
  }
};

/// Records when a player has finished its first block.
class OnFirstBlock : public vtkCommand
{
public:
  static OnFirstBlock* New() { return new OnFirstBlock; }
  void Execute(vtkObject* caller, unsigned long, void*) override
  {
    const vtkIdType done = static_cast<vtkHeliosSurveyPlayer*>(caller)->GetCount("pulses");
    if (done > 0 && !this->IsNoted)
    {
      this->Start = Now();
    }
    this->IsNoted = done > 0;
  }
  Seconds Start;
  bool IsNoted = false;
};

vtkSmartPointer<vtkHeliosSurveyPlayer> MakePlayer(vtkHeliosSurvey* survey, const fs::path& folder)
{
  auto player = vtkSmartPointer<vtkHeliosSurveyPlayer>::New();
  player->SetSurvey(survey);
  player->SetOutputDirectory(folder.c_str());
  player->OverwriteOn();
  return player;
}

vtkSmartPointer<vtkHeliosSurvey> ReadSurvey(const fs::path& folder, double turn)
{
  WriteSurvey(folder, turn);
  vtkNew<vtkHeliosSurveyReader> reader;
  reader->SetFileName((folder / "survey.xml").c_str());
  return reader->Read() ? reader->GetSurvey() : nullptr;
}

bool Measure(vtkHeliosSurvey* survey, const fs::path& folder, int repetitions)
{
  Bare bare(survey, folder / "bare");
  const auto player = MakePlayer(survey, folder / "out");
  Seconds ignored;
  const helios::ScanCounts counts = bare.Run(true, ignored);
  if (!player->Run() || player->GetCount("points") != counts.Echoes ||
    ReadText(folder / "out/bench/leg000_points.xyz") !=
      ReadText(folder / "bare/leg000_points.xyz.part"))
  {
    std::printf("the player writes other points than the scanner has\n");
    return false;
  }
  vtkNew<OnFirstBlock> onBlock;
  player->AddObserver(vtkCommand::ProgressEvent, onBlock);
  Times alone, text, played;
  for (int i = 0; i < repetitions; ++i)
  {
    alone.Add([&bare](Seconds& start) { bare.Run(false, start); });
    text.Add([&bare](Seconds& start) { bare.Run(true, start); });
    played.Add(
      [&player, &onBlock](Seconds& start)
      {
        player->Run();
        start = onBlock->Start;
      });
  }
  std::printf("%lld pulses, %lld points, %d threads, medians of %d\n",
    static_cast<long long>(counts.PulsesFired), static_cast<long long>(counts.Echoes),
    vtkSMPTools::GetEstimatedNumberOfThreads(), repetitions);
  std::printf("%-6s %10s %10s %10s %16s %16s\n", "[s]", "scanner", "+ text", "player",
    "player / scanner", "player / + text");
  for (const auto times : { &Times::Wall, &Times::Cpu })
  {
    const double a = Median(alone.*times), t = Median(text.*times), p = Median(played.*times);
    std::printf(
      "%-6s %10.3f %10.3f %10.3f %16.3f %16.3f; without text it costs %.1f %% of the scanner\n",
      times == &Times::Wall ? "wall" : "CPU", a, t, p, p / a, p / t, 100.0 * (p - t) / a);
  }
  return true;
}

} // namespace

int main(int argc, char* argv[])
{
  const int repetitions = argc > 1 ? std::max(1, std::atoi(argv[1])) : 5;
  const Folder folder;
  WriteScene(folder.Path);
  const auto survey = ReadSurvey(folder.Path, 90.0);
  if (!survey || !Measure(survey, folder.Path, repetitions))
  {
    return EXIT_FAILURE;
  }
  for (const double turn : { 45.0, 360.0 })
  {
    const auto player = MakePlayer(ReadSurvey(folder.Path, turn), folder.Path / "out");
    if (!player->Run())
    {
      return EXIT_FAILURE;
    }
    std::printf("%9lld pulse times: peak of memory so far %.1f MB\n",
      static_cast<long long>(player->GetNumberOfPulses()), GetPeakMemory());
  }
  return EXIT_SUCCESS;
}
