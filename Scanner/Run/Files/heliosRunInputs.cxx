// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosRunInputs.h"

#include "heliosInputDigest.h"
#include "heliosMaterialTable.h"
#include "heliosReceiverSetup.h"
#include "heliosRunSettings.h"
#include "heliosSpectrum.h"
#include "heliosSurveyData.h"
#include "vtkHeliosEchoDetection.h"
#include "vtkHeliosRayCaster.h"

#include <vtkDataObject.h>
#include <vtkImageData.h>
#include <vtkPolyData.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <set>
#include <utility>

namespace helios
{

namespace
{

/// Returns all files that a survey names, each once.
std::set<std::string> GetNamedFiles(const SurveyData& survey, const RunSettings& settings)
{
  std::set<std::string> files(survey.Documents.begin(), survey.Documents.end());
  for (const PartData& part : survey.Scene.Parts)
  {
    files.insert(part.Files.begin(), part.Files.end());
    files.insert(part.Material.File);
    files.insert(part.Vegetation.LeafTable);
    files.insert(part.Motion.Track.File);
  }
  files.insert(survey.FileName);
  for (const ScannerData& scanner : survey.Scanners)
  {
    for (std::size_t k = 0; k < scanner.GetNumberOfChannels(); ++k)
    {
      const ReceiverData& receiver = scanner.GetChannel(k).Receiver;
      files.insert(
        vtkHeliosEchoDetection::GetDetectorFile(ChooseDetector(receiver, settings.Options)));
      files.insert(receiver.PulseFile);
      files.insert(scanner.GetChannel(k).BeamFile);
    }
  }
  for (const LegData& leg : survey.Legs)
  {
    files.insert(settings.Trajectories.empty() ? leg.Trajectory.File : "");
  }
  files.erase("");
  return files;
}

Json::Value Describe(const std::string& file, const InputDigest& digest)
{
  Json::Value input;
  input["file"] = file;
  input["sha256"] = digest.Sha256;
  input["bytes"] = Json::Int64(digest.Size);
  return input;
}

/// Inputs by name.
using InputMap = std::map<std::string, Json::Value>;

InputMap ToMap(const Json::Value& inputs)
{
  InputMap all;
  for (const Json::Value& input : inputs)
  {
    all[input["file"].asString()] = input;
  }
  return all;
}

Json::Value ToJson(const InputMap& all)
{
  Json::Value inputs = Json::arrayValue;
  for (const auto& input : all)
  {
    inputs.append(input.second);
  }
  return inputs;
}

/// An input of a run while it is compared.
struct Input
{
  std::string File;
  std::string Digest;

  std::string GetName() const { return std::filesystem::path(this->File).filename().string(); }
};

using Inputs = std::vector<Input>;

Inputs GetInputs(const Json::Value& values)
{
  Inputs inputs;
  for (const Json::Value& value : values)
  {
    inputs.push_back({ value["file"].asString(), value["sha256"].asString() });
  }
  return inputs;
}

bool HasSameFile(const Input& a, const Input& b)
{
  return a.File == b.File;
}

bool HasSameBytes(const Input& a, const Input& b)
{
  return a.Digest == b.Digest;
}

bool HasSameNameAndBytes(const Input& a, const Input& b)
{
  return HasSameBytes(a, b) && a.GetName() == b.GetName();
}

using Pairs = std::vector<std::pair<Input, Input>>;

/// Moves inputs that have a partner out of both lists.
Pairs MovePairs(Inputs& then, Inputs& now, bool (*isPair)(const Input&, const Input&))
{
  Pairs pairs;
  Inputs alone;
  for (const Input& input : now)
  {
    const auto partner = std::find_if(
      then.begin(), then.end(), [&](const Input& other) { return isPair(other, input); });
    if (partner == then.end())
    {
      alone.push_back(input);
      continue;
    }
    pairs.emplace_back(*partner, input);
    then.erase(partner);
  }
  now = alone;
  return pairs;
}

} // namespace

//------------------------------------------------------------------------------
Json::Value DescribeInputs(const SurveyData& survey, const RunSettings& settings)
{
  Json::Value inputs = Json::arrayValue;
  for (const std::string& file : GetNamedFiles(survey, settings))
  {
    inputs.append(Describe(file, ComputeInputDigest(file)));
  }
  return inputs;
}

//------------------------------------------------------------------------------
std::vector<std::string> FindMaterialFiles(vtkDataObject* scene,
  const std::vector<vtkSmartPointer<vtkImageData>>& grids, const SurveyData& survey,
  const RunSettings& settings)
{
  const bool hasSpectra = !settings.Options.IsWithout("spectra");
  std::vector<vtkDataObject*> all = { scene };
  all.insert(all.end(), grids.begin(), grids.end());
  std::vector<std::string> files;
  for (vtkDataObject* data : all)
  {
    for (const Material& material : GetMaterials(data))
    {
      const bool needsSpectrum = hasSpectra && NeedsSpectrum(material);
      const std::string spectrum =
        needsSpectrum ? FindSpectrum(material.Spectrum, survey.Scene.SpectraFolders) : "";
      files.insert(files.end(), { spectrum, settings.Wants.Colors ? material.Color.Texture : "" });
    }
  }
  const auto isMissing = [](const std::string& file) { return StampFile(file).empty(); };
  files.erase(std::remove_if(files.begin(), files.end(), isMissing), files.end());
  return files;
}

//------------------------------------------------------------------------------
Status AddInputs(const InputFiles& files, Json::Value& inputs)
{
  InputMap all = ToMap(inputs);
  for (const auto& [file, stamp] : files)
  {
    const InputDigest digest = ComputeInputDigest(file);
    if (digest.Stamp != stamp)
    {
      return Status::Error(file +
        " was changed while the survey was loaded; run the survey again when the file is complete");
    }
    all[file] = Describe(file, digest);
  }
  inputs = ToJson(all);
  return {};
}

//------------------------------------------------------------------------------
bool AddEarlierInputs(const Json::Value& thenValues, Json::Value& inputs)
{
  Inputs then = GetInputs(thenValues);
  Inputs now = GetInputs(inputs);
  MovePairs(then, now, HasSameFile);
  if (!MovePairs(then, now, HasSameBytes).empty())
  {
    return false; // in other folders, as the rest may be
  }
  InputMap all = ToMap(inputs);
  bool areThere = true;
  for (const Input& input : then)
  {
    const InputDigest digest = ComputeInputDigest(input.File);
    areThere = areThere && !digest.Sha256.empty();
    digest.Sha256.empty() ? void() : void(all[input.File] = Describe(input.File, digest));
  }
  inputs = ToJson(all);
  return areThere;
}

//------------------------------------------------------------------------------
std::vector<std::string> CompareInputs(
  const Json::Value& thenValues, const Json::Value& nowValues, bool areAllKnown)
{
  Inputs then = GetInputs(thenValues);
  Inputs now = GetInputs(nowValues);
  std::vector<std::string> differences;
  for (const auto& [before, after] : MovePairs(then, now, HasSameFile))
  {
    HasSameBytes(before, after) ? void() : differences.push_back(after.File + " has changed");
  }
  MovePairs(then, now, HasSameNameAndBytes);
  MovePairs(then, now, HasSameBytes);
  for (const Input& input : now)
  {
    const bool isOfOtherFolder = std::any_of(then.begin(), then.end(),
      [&input](const Input& other) { return other.GetName() == input.GetName(); });
    differences.push_back(input.File + (isOfOtherFolder ? " has changed" : " is new"));
  }
  for (const Input& input : then)
  {
    const bool isOfOtherFolder = std::any_of(now.begin(), now.end(),
      [&input](const Input& other) { return other.GetName() == input.GetName(); });
    if (areAllKnown && !isOfOtherFolder)
    {
      differences.push_back(input.File + " is no longer read");
    }
  }
  return differences;
}

} // namespace helios
