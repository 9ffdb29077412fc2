// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Test runs, and their output files.

#ifndef heliosBrokenRun_h
#define heliosBrokenRun_h

#include "heliosSurveyFiles.h"
#include "vtkHeliosSurveyPlayer.h"

#include <vtkCommand.h>

#include <catch2/catch.hpp>

#include <functional>
#include <map>
#include <string>
#include <vector>

namespace helios
{
namespace test
{

/// Calls a function after every block, and of slow ones within them.
class OnBlock : public vtkCommand
{
public:
  static OnBlock* New() { return new OnBlock; }

  void Execute(vtkObject* caller, unsigned long, void*) override
  {
    auto* player = static_cast<vtkHeliosSurveyPlayer*>(caller);
    if (player->GetCount("pulses") > 0)
    {
      this->Done.push_back(player->GetCount("pulses"));
      this->Action(player);
    }
  }

  std::vector<vtkIdType> Done;
  std::function<void(vtkHeliosSurveyPlayer*)> Action = [](vtkHeliosSurveyPlayer*) {};
};

/// A player of 8 blocks in 2 legs, into a folder.
struct BlockRun
{
  vtkNew<vtkHeliosSurveyPlayer> Player;
  vtkNew<OnBlock> Blocks;
  vtkSmartPointer<helios::ErrorObserver> Log = Observe(Player);

  BlockRun(const Files& files, const Reading& reading, const std::string& folder = "out")
  {
    INFO(reading.Log->Errors);
    REQUIRE(reading.Good);
    this->Player->SetSurvey(reading.Reader->GetSurvey());
    this->Player->SetOutputDirectory((files / folder).c_str());
    this->Player->SetPulsesPerBlock(10000);
    this->Player->SetWriteWaveforms(true);
    this->Player->AddObserver(vtkCommand::ProgressEvent, this->Blocks);
  }

  void AbortAfter(vtkIdType pulses)
  {
    this->Blocks->Action = [pulses](vtkHeliosSurveyPlayer* player)
    {
      if (player->GetCount("pulses") >= pulses)
      {
        player->Abort();
      }
    };
  }

  void CheckFails(const std::vector<std::string>& messages)
  {
    CHECK_FALSE(this->Player->Run());
    INFO(this->Log->Errors);
    for (const std::string& message : messages)
    {
      INFO("missing: " << message);
      CHECK(this->Log->HasError(message));
    }
  }
};

/// Every file of a folder except the summary, which has timings.
inline std::map<std::string, std::string> ReadAll(const std::string& folder)
{
  std::map<std::string, std::string> texts;
  for (const auto& entry : std::filesystem::directory_iterator(folder))
  {
    const std::string name = entry.path().filename().string();
    if (name != "run_summary.json")
    {
      texts[name] = ReadText(entry.path().string());
    }
  }
  return texts;
}

inline void BreakOff(const Files& files, const Reading& reading, vtkIdType pulses = 50000)
{
  BlockRun broken(files, reading);
  broken.AbortAfter(pulses);
  CHECK_FALSE(broken.Player->Run());
  CHECK(broken.Player->GetMessage().find("Resume (--resume) continues") != std::string::npos);
  REQUIRE(std::filesystem::exists(files / "out/test/run.journal"));
}

constexpr const char* Journal = "out/test/run.journal";

} // namespace test
} // namespace helios

#endif
