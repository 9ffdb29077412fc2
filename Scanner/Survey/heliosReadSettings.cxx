// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosReadSettings.h"

#include "heliosMessages.h"
#include "heliosSurveyData.h"
#include "vtkHeliosRayCaster.h"
#include "vtkHeliosSurvey.h"
#include "vtkHeliosSurveyPlayer.h"
#include "vtkHeliosSurveySource.h"

#include <algorithm>
#include <filesystem>

namespace helios
{

namespace
{

std::string TextOf(const char* text)
{
  return text ? text : "";
}

bool IsToleranceOrZero(double tolerance, double least)
{
  return tolerance == 0.0 || (tolerance >= least && tolerance <= 1.0);
}

//------------------------------------------------------------------------------
/// Reads the receiver options of a player or a source; returns an error message, or an empty string.
template <typename Runner>
std::string ReadReceiver(Runner* runner, ReceiverChoice& choice)
{
  choice.Noise = runner->GetNoise();
  choice.RangeTolerance = runner->GetRangeTolerance();
  choice.EnergyTolerance = runner->GetEnergyTolerance();
  choice.NumberOfSubRays = runner->GetNumberOfSubRays();
  choice.EchoDetector = TextOf(runner->GetEchoDetector());
  Sentence fault;
  if (!IsToleranceOrZero(choice.RangeTolerance, 1e-6))
  {
    fault << "RangeTolerance is " << choice.RangeTolerance
          << "; give 0.000001 to 1 m, or 0 for the survey's value";
  }
  else if (!IsToleranceOrZero(choice.EnergyTolerance, 1e-4))
  {
    fault << "EnergyTolerance is " << choice.EnergyTolerance
          << "; give 0.0001 to 1, or 0 for the survey's value";
  }
  else if (choice.NumberOfSubRays > 0 &&
    (choice.RangeTolerance > 0.0 || choice.EnergyTolerance > 0.0))
  {
    fault << "NumberOfSubRays is " << choice.NumberOfSubRays
          << ", but a tolerance selects adaptive sampling; set one of them to 0";
  }
  const std::vector<std::string> known = GetEchoDetectorNames();
  if (!choice.EchoDetector.empty() &&
    std::find(known.begin(), known.end(), choice.EchoDetector) == known.end())
  {
    fault << "EchoDetector is \"" << choice.EchoDetector << "\"; give " << Enumerate(known);
  }
  return fault.str();
}

//------------------------------------------------------------------------------
template <typename Runner>
std::string ReadRayCaster(Runner* runner, RunSettings& settings)
{
  const SurveyData& survey = runner->GetSurvey()->GetData();
  const std::string given = TextOf(runner->GetRayCaster());
  const std::string name = given.empty() ? survey.RayCaster : given;
  if (name.empty())
  {
    return {};
  }
  std::vector<std::string> names;
  for (int i = 0; i < vtkHeliosRayCaster::GetNumberOfBackends(); ++i)
  {
    names.emplace_back(vtkHeliosRayCaster::GetBackendName(i));
  }
  if (std::find(names.begin(), names.end(), name) == names.end())
  {
    return (given.empty() ? survey.FileName + ": rayCaster" : "RayCaster") + "=\"" + name +
      "\" is not in this build; give one of " + Enumerate(names);
  }
  settings.RayCaster =
    vtkSmartPointer<vtkHeliosRayCaster>::Take(vtkHeliosRayCaster::Create(name.c_str()));
  return {};
}

//------------------------------------------------------------------------------
/// Reads the settings common to player and source.
template <typename Runner>
std::string ReadCommon(Runner* runner, RunSettings& settings)
{
  const int plays = runner->GetSurvey()->GetNumberOfPlays();
  if (runner->GetPlay() >= plays)
  {
    Sentence fault;
    fault << "Play is " << runner->GetPlay() << ", but the survey has " << plays
          << (plays > 1 ? " epochs" : " epoch") << "; give 0 to " << plays - 1;
    return fault.str();
  }
  settings.Play = plays > 1 ? runner->GetPlay() : -1;
  const vtkIdType own = runner->GetSurvey()->GetData().Seed;
  settings.Seed = std::max<vtkIdType>(0, runner->GetSeed() >= 0 ? runner->GetSeed() : own);
  const std::string fault = ReadReceiver(runner, settings.Receiver);
  return fault.empty() ? ReadRayCaster(runner, settings) : fault;
}

} // namespace

//------------------------------------------------------------------------------
std::string MakeRunFolder(vtkHeliosSurveyPlayer* player)
{
  std::filesystem::path folder = TextOf(player->GetOutputDirectory());
  folder /= player->GetSurvey()->GetName();
  if (player->GetSurvey()->GetNumberOfPlays() > 1)
  {
    const std::string play = std::to_string(player->GetPlay());
    const std::size_t zeros = play.size() < 3 ? 3 - play.size() : 0;
    folder /= "play" + std::string(zeros, '0') + play;
  }
  return folder.string();
}

//------------------------------------------------------------------------------
std::string ReadSettings(vtkHeliosSurveyPlayer* player, RunSettings& settings)
{
  settings.Format = TextOf(player->GetFormat());
  if (settings.Format != "xyz" && settings.Format != "las" && settings.Format != "vtp")
  {
    return "Format is \"" + settings.Format + "\"; give xyz, las or vtp.";
  }
  settings.Folder = MakeRunFolder(player);
  settings.Waveforms = player->GetWriteWaveforms();
  settings.Pulses = player->GetWritePulses();
  settings.SplitByChannel = player->GetSplitByChannel();
  settings.PulsesPerBlock = player->GetPulsesPerBlock();
  return ReadCommon(player, settings);
}

//------------------------------------------------------------------------------
std::string ReadSettings(vtkHeliosSurveySource* source, RunSettings& settings)
{
  settings.Waveforms = source->GetGenerateWaveforms();
  settings.Pulses = source->GetGeneratePulses();
  settings.SubRays = source->GetGenerateSubRays();
  settings.Truth = source->GetGenerateTruth();
  return ReadCommon(source, settings);
}

} // namespace helios
