// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// The files of a run do not depend on its division into blocks of pulses.
#include "heliosSurveyPlaying.h"

#include <vtkCallbackCommand.h>
#include <vtkSMPTools.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <map>

namespace fs = std::filesystem;
using namespace helios::test;

namespace
{

using Texts = std::map<std::string, std::string>;

/// Every file of a run except the summary, which has timings.
Texts ReadAll(const std::string& folder)
{
  Texts texts;
  for (const auto& entry : fs::directory_iterator(folder))
  {
    const std::string name = entry.path().filename().string();
    if (name != "run_summary.json")
    {
      texts[name] = ReadText(entry.path().string());
    }
  }
  return texts;
}

void AbortHalfway(vtkObject* caller, unsigned long, void*, void*)
{
  auto* player = static_cast<vtkHeliosSurveyPlayer*>(caller);
  const vtkIdType done = player->GetCount("pulses");
  if (done > 0 && done >= player->GetNumberOfPulses() / 2)
  {
    player->Abort();
  }
}

struct Settings
{
  std::string Format;
  bool IsSplit = false;
  bool IsInPoints = false; // the waveforms of LAS
};

Texts RunBlocks(const Files& files, const Reading& reading, const Settings& settings,
  vtkIdType pulsesPerBlock, bool isInterrupted = false)
{
  Playing playing(files, reading);
  vtkHeliosSurveyPlayer* player = playing.Player;
  player->SetFormat(settings.Format.c_str());
  player->SetSplitByChannel(settings.IsSplit);
  player->SetWriteWaveforms(true);
  player->SetWaveformsInPoints(settings.IsInPoints);
  player->SetWritePulses(true);
  player->SetOverwrite(true);
  player->SetPulsesPerBlock(pulsesPerBlock);
  if (isInterrupted)
  {
    vtkNew<vtkCallbackCommand> abort;
    abort->SetCallback(AbortHalfway);
    const unsigned long tag = player->AddObserver(vtkCommand::ProgressEvent, abort);
    REQUIRE_FALSE(player->Run());
    player->RemoveObserver(tag);
    player->SetOverwrite(false);
    player->SetResume(true);
  }
  const bool isRun = player->Run();
  INFO(playing.Log->Errors);
  REQUIRE(isRun);
  return ReadAll(files / "out/test");
}

/// Reports the files that differ.
void CheckSame(const Texts& found, const Texts& expected)
{
  REQUIRE(found.size() == expected.size());
  for (const auto& [name, text] : expected)
  {
    INFO(name);
    REQUIRE(found.count(name) == 1);
    CHECK((found.at(name) == text)); // too long to print
  }
}

void CheckBlocks(const Files& files, const Reading& reading, const Settings& settings)
{
  INFO(reading.Log->Errors);
  REQUIRE(reading.Good);
  const Texts whole = RunBlocks(files, reading, settings, 262144);
  const std::string waves = settings.Format == "las" ? ".wdp" : "_fullwave";
  CHECK(std::any_of(whole.begin(), whole.end(),
    [&waves](const auto& file)
    { return file.first.find(waves) != std::string::npos && file.second.size() > 10000; }));
  for (const vtkIdType pulsesPerBlock : { 20011, 7001, 2503 })
  {
    INFO(pulsesPerBlock << " pulses a block");
    CheckSame(RunBlocks(files, reading, settings, pulsesPerBlock), whole);
  }
  INFO("interrupted and resumed");
  CheckSame(RunBlocks(files, reading, settings, 7001, true), whole);
  INFO("by one thread");
  vtkSMPTools::Initialize(1);
  CheckSame(RunBlocks(files, reading, settings, 9000), whole);
  vtkSMPTools::Initialize();
}

} // namespace

TEST_CASE("SurveyBlocks: legs", "[SurveyBlocks]")
{
  const Files files;
  const Reading reading(files, Flight, ThreeLegs);
  CheckBlocks(files, reading, { GENERATE("las", "xyz") });
}

TEST_CASE("SurveyBlocks: LAS points with their waveforms", "[SurveyBlocks]")
{
  const Files files;
  files.Replace("assets.xml", "optics=\"conic\"", "optics=\"oscillating\"");
  const Reading reading(files, Flight, ThreeLegs);
  CheckBlocks(files, reading, { "las", false, true });
}

TEST_CASE("SurveyBlocks: legs that share files", "[SurveyBlocks]")
{
  const Files files;
  std::string legs = ThreeLegs;
  for (std::size_t at = legs.find("<leg>"); at != std::string::npos; at = legs.find("<leg>"))
  {
    legs.replace(at, 5, "<leg stripId=\"7\">");
  }
  const Reading reading(files, Flight, legs);
  CheckBlocks(files, reading, { GENERATE("las", "xyz") });
}

TEST_CASE("SurveyBlocks: channels, the first pulses without hits", "[SurveyBlocks]")
{
  const Files files;
  files.Replace("assets.xml", "<FWFSettings beamSampleQuality=\"2\"/>",
    R"(<FWFSettings beamSampleQuality="1"/><channels>
<channel id="left"><beamOrigin x="-0.5"><rot axis="z" angle_deg="5"/></beamOrigin></channel>
<channel id="right"><beamOrigin x="0.5"/></channel></channels>)");
  const Reading reading(files, Tripod, R"(<leg><platformSettings z="2"/>
<scannerSettings scanFreq_hz="100" headRotatePerSec_deg="20" headRotateStop_deg="4"/></leg>)");
  CheckBlocks(files, reading, { GENERATE("las", "xyz"), GENERATE(true, false) });
}
