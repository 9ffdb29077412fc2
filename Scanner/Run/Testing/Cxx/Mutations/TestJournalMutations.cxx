// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// A run resumed with a damaged journal or damaged parts is byte-identical, or fails with an error.
#include "heliosMutation.h"
#include "heliosSurveyFiles.h"
#include "vtkHeliosSurveyPlayer.h"

#include <vtkCommand.h>

#include <catch2/catch.hpp>

#include <map>

namespace fs = std::filesystem;
using namespace helios::test;

namespace
{

constexpr const char* Legs = R"(
<leg><platformSettings z="2"/><scannerSettings pulseFreq_hz="100000" scanFreq_hz="100"
 headRotatePerSec_deg="60" headRotateStart_deg="0" headRotateStop_deg="0.7"/></leg>
<leg><platformSettings x="4" z="2"/><scannerSettings pulseFreq_hz="100000" scanFreq_hz="100"
 headRotatePerSec_deg="60" headRotateStart_deg="0" headRotateStop_deg="0.7"/></leg>)";

/// Stops a run in its second leg.
class Stop : public vtkCommand
{
public:
  static Stop* New() { return new Stop; }

  void Execute(vtkObject* caller, unsigned long, void*) override
  {
    auto* player = static_cast<vtkHeliosSurveyPlayer*>(caller);
    if (player->GetCount("pulses") >= 1800)
    {
      player->Abort();
    }
  }
};

struct Outcome
{
  bool Good = false;
  std::string Errors;
  std::string Message;
};

Outcome Run(
  const Files& files, vtkHeliosSurvey* survey, const char* format, bool resumes, bool stops)
{
  vtkNew<vtkHeliosSurveyPlayer> player;
  const auto log = Observe(player);
  player->SetSurvey(survey);
  player->SetOutputDirectory((files / "out").c_str());
  player->SetFormat(format);
  player->SetPulsesPerBlock(300);
  player->SetResume(resumes);
  vtkNew<Stop> stop;
  if (stops)
  {
    player->AddObserver(vtkCommand::ProgressEvent, stop);
  }
  Outcome outcome;
  outcome.Good = player->Run();
  outcome.Errors = log->Errors;
  outcome.Message = player->GetMessage();
  return outcome;
}

using Bytes = std::map<std::string, std::string>;

/// The files of the run's folder.
Bytes ReadAll(const Files& files)
{
  Bytes bytes;
  for (const auto& entry : fs::directory_iterator(files / "out/test"))
  {
    bytes[entry.path().filename().string()] = ReadText(entry.path().string());
  }
  return bytes;
}

void WriteAll(const Files& files, const Bytes& bytes)
{
  fs::remove_all(files / "out");
  for (const auto& [name, text] : bytes)
  {
    files.Write("out/test/" + name, text);
  }
}

/// A text in brackets, so deep that a recursive reader overflows the stack.
std::string Nest(const std::string& text, int depth)
{
  const auto n = static_cast<std::size_t>(depth);
  return std::string(n, '[') + text + std::string(n, ']');
}

} // namespace

TEST_CASE("JournalMutations: damaged journals and parts give the same bytes or an error",
  "[JournalMutations][mutation]")
{
  const Files files;
  const Reading reading(files, Tripod, Legs);
  REQUIRE(reading.Good);
  vtkHeliosSurvey* survey = reading.Reader->GetSurvey();
  const char* const format = GENERATE("xyz", "las", "vtp");
  REQUIRE(Run(files, survey, format, false, false).Good);
  Bytes whole = ReadAll(files);
  whole.erase("run_summary.json"); // it has timings
  fs::remove_all(files / "out");
  REQUIRE_FALSE(Run(files, survey, format, false, true).Good);
  const Bytes broken = ReadAll(files);
  REQUIRE(broken.count("run.journal") == 1);

  helios::Mutator mutate(20206);
  int errorCount = 0;
  for (int i = 0; i < helios::GetNumberOfMutations(); ++i)
  {
    Bytes damaged = broken;
    auto file = damaged.find("run.journal");
    if (i % 4 == 3)
    {
      file = std::next(damaged.begin(), i / 4 % static_cast<int>(damaged.size()));
    }
    file->second = i % 50 == 48 ? Nest(file->second, 20 * i)
      : i % 3 == 0              ? mutate.ChangeNumber(file->second)
                                : mutate(file->second);
    WriteAll(files, damaged);
    INFO("case " << i << ", " << file->first);
    const Outcome outcome = Run(files, survey, format, true, false);
    INFO(outcome.Message << "\n" << outcome.Errors);
    if (!outcome.Good)
    {
      ++errorCount;
      REQUIRE_FALSE(outcome.Errors.empty());
      continue;
    }
    const Bytes found = ReadAll(files);
    for (const auto& [name, text] : whole)
    {
      INFO(name);
      REQUIRE(found.count(name) == 1);
      REQUIRE((found.at(name) == text)); // too long to print
    }
  }
  CHECK(errorCount > 10);
}
