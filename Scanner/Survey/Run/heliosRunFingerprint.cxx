// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosRunFingerprint.h"

#include "heliosMessages.h"
#include "heliosRunJournal.h"
#include "heliosRunSettings.h"
#include "heliosSha256.h"
#include "heliosSurveyData.h"
#include "vtkHeliosScene.h"
#include "vtkHeliosVersion.h"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkImageData.h>
#include <vtkMatrix3x3.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkStringArray.h>
#include <vtkVersion.h>

#include <filesystem>
#include <set>
#include <utility>

namespace helios
{

namespace
{

/// All files that a survey names, each once. New kinds of files must be added here.
std::set<std::string> GetInputFiles(const SurveyData& survey, const RunSettings& settings)
{
  std::set<std::string> files(survey.Documents.begin(), survey.Documents.end());
  for (const PartData& part : survey.Scene.Parts)
  {
    files.insert(part.Files.begin(), part.Files.end());
    files.insert(part.Material.File);
    files.insert(part.Vegetation.LeafTable);
  }
  files.insert(survey.FileName);
  for (const ScannerData& scanner : survey.Scanners)
  {
    for (std::size_t k = 0; k < scanner.GetNumberOfChannels(); ++k)
    {
      files.insert(scanner.GetChannel(k).Receiver.PulseFile);
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

Json::Value DescribeInputs(const SurveyData& survey, const RunSettings& settings)
{
  Json::Value inputs = Json::arrayValue;
  for (const std::string& file : GetInputFiles(survey, settings))
  {
    std::error_code error;
    const auto size = std::filesystem::file_size(file, error);
    Json::Value& input = inputs.append(Json::objectValue);
    input["file"] = file;
    input["sha256"] = HashFile(file);
    input["bytes"] = error ? Json::Int64(0) : Json::Int64(size);
  }
  return inputs;
}

Json::Value DescribePart(const RunPart& part)
{
  Json::Value described;
  described["number"] = part.Number;
  described["count"] = part.Count;
  described["command"] = part.Command;
  return described;
}

Json::Value DescribeOptions(const RunSettings& settings)
{
  const WantedOutputs& wants = settings.Wants;
  Json::Value options;
  settings.Options.Describe(options);
  options["format"] = settings.Format;
  options["waveforms"] = wants.Waveforms;
  options["waveformsInPoints"] = settings.WaveformsInPoints;
  options["scanFlags"] = wants.ScanFlags;
  options["pulses"] = wants.Pulses;
  const std::pair<const char*, bool> others[] = { { "hits", wants.SubRays },
    { "truth", wants.Truth }, { "columns", wants.Columns }, { "decibels", wants.Decibels },
    { "colors", wants.Colors } };
  for (const auto& [name, isWanted] : others)
  {
    if (isWanted)
    {
      options[name] = true;
    }
  }
  options["splitByChannel"] = settings.SplitByChannel;
  options["pulsesPerBlock"] = Json::Int64(settings.PulsesPerBlock);
  if (settings.HasEpochs)
  {
    options["play"] = settings.Options.Epoch;
  }
  return options;
}

void AddArray(vtkAbstractArray* array, Sha256& hash)
{
  if (!array)
  {
    return;
  }
  hash.Add(array->GetName() ? array->GetName() : "");
  hash.Add(array->GetDataTypeAsString());
  if (auto* texts = vtkStringArray::SafeDownCast(array))
  {
    for (vtkIdType i = 0; i < texts->GetNumberOfValues(); ++i)
    {
      hash.Add(texts->GetValue(i) + '\n');
    }
  }
  else if (vtkDataArray::SafeDownCast(array) && array->GetNumberOfValues() > 0)
  {
    const auto size = array->GetNumberOfValues() * array->GetDataTypeSize();
    hash.Add(array->GetVoidPointer(0), static_cast<std::size_t>(size));
  }
}

void AddArrays(vtkFieldData* data, Sha256& hash)
{
  for (int i = 0; i < data->GetNumberOfArrays(); ++i)
  {
    AddArray(data->GetAbstractArray(i), hash);
  }
}

/// The digest of the trajectories of inputs.
std::string HashTrajectories(const std::vector<vtkSmartPointer<vtkPolyData>>& trajectories)
{
  Sha256 hash;
  for (vtkPolyData* trajectory : trajectories)
  {
    AddArray(trajectory->GetPoints()->GetData(), hash);
    AddArrays(trajectory->GetPointData(), hash);
    AddArrays(trajectory->GetFieldData(), hash);
  }
  return hash.Finish();
}

/// The digests of the inputs of a fingerprint with the names of their files.
std::map<std::string, std::string> GetDigests(const Json::Value& fingerprint)
{
  std::map<std::string, std::string> digests;
  for (const Json::Value& input : fingerprint["inputs"])
  {
    digests[input["sha256"].asString()] = input["file"].asString();
  }
  return digests;
}

/// The part of a fingerprint: "2/4"; empty: the whole run.
std::string DescribePart(const Json::Value& fingerprint)
{
  const Json::Value& part = fingerprint["part"];
  return part.isObject() ? part["number"].asString() + "/" + part["count"].asString()
                         : std::string();
}

/// A value as a user would type it.
std::string Quote(const Json::Value& value)
{
  return value.isNull() ? "unknown" : ToLine(value);
}

void CompareMembers(
  const Json::Value& then, const Json::Value& now, std::vector<std::string>& differences)
{
  for (const std::string& name : now.getMemberNames())
  {
    // doubles are compared as they are written
    if (Quote(then[name]) != Quote(now[name]))
    {
      differences.push_back(name + " was " + Quote(then[name]) + " and is " + Quote(now[name]));
    }
  }
  for (const std::string& name : then.getMemberNames())
  {
    if (!now.isMember(name)) // options that are off are not listed
    {
      differences.push_back(name + " was " + Quote(then[name]) + " and is not given");
    }
  }
}

} // namespace

//------------------------------------------------------------------------------
Json::Value MakeFingerprint(const SurveyData& survey, const RunSettings& settings)
{
  Json::Value fingerprint;
  fingerprint["versions"]["vtkHelios"] = vtkHeliosVersion::GetVersion();
  fingerprint["versions"]["VTK"] = vtkVersion::GetVTKVersion();
  fingerprint["survey"] = survey.Name;
  fingerprint["inputs"] = DescribeInputs(survey, settings);
  fingerprint["options"] = DescribeOptions(settings);
  fingerprint["scene"] = "";
  if (settings.Part.IsSet())
  {
    fingerprint["part"] = DescribePart(settings.Part);
  }
  if (!settings.Trajectories.empty())
  {
    fingerprint["trajectory"] = HashTrajectories(settings.Trajectories);
  }
  if (settings.Mesh)
  {
    fingerprint["mesh"] = HashScene(settings.Mesh);
  }
  return fingerprint;
}

//------------------------------------------------------------------------------
namespace
{

void AddGrid(vtkImageData* grid, Sha256& hash)
{
  hash.Add(grid->GetOrigin(), 3 * sizeof(double));
  hash.Add(grid->GetSpacing(), 3 * sizeof(double));
  hash.Add(grid->GetDimensions(), 3 * sizeof(int));
  hash.Add(grid->GetDirectionMatrix()->GetData(), 9 * sizeof(double));
}

/// A mesh, or a raster of heights.
void AddTriangles(vtkDataSet* data, Sha256& hash)
{
  if (auto* mesh = vtkPolyData::SafeDownCast(data))
  {
    AddArray(mesh->GetPoints() ? mesh->GetPoints()->GetData() : nullptr, hash);
    AddArray(mesh->GetPolys()->GetOffsetsArray(), hash);
    AddArray(mesh->GetPolys()->GetConnectivityArray(), hash);
  }
  else if (auto* raster = vtkImageData::SafeDownCast(data))
  {
    AddGrid(raster, hash);
  }
  AddArrays(data->GetPointData(), hash);
  AddArrays(data->GetCellData(), hash);
  AddArrays(data->GetFieldData(), hash);
}

} // namespace

std::string HashScene(vtkPolyData* scene, const std::vector<vtkSmartPointer<vtkImageData>>& grids)
{
  Sha256 hash;
  AddTriangles(scene, hash);
  if (vtkHeliosScene::HasInstances(scene))
  {
    auto* whole = vtkHeliosScene::SafeDownCast(scene);
    AddTriangles(whole->GetInstances(), hash);
    for (int i = 0; i < whole->GetNumberOfPrototypes(); ++i)
    {
      AddTriangles(whole->GetPrototype(i), hash);
    }
  }
  for (vtkImageData* grid : grids)
  {
    AddGrid(grid, hash);
    AddArrays(grid->GetCellData(), hash);
    AddArrays(grid->GetFieldData(), hash);
  }
  return hash.Finish();
}

//------------------------------------------------------------------------------
std::string CompareFingerprints(const Json::Value& then, const Json::Value& now)
{
  std::vector<std::string> differences;
  const auto before = GetDigests(then);
  const auto after = GetDigests(now);
  for (const auto& input : after)
  {
    if (before.count(input.first) == 0)
    {
      differences.push_back(input.second + " has changed or is new");
    }
  }
  for (const auto& input : before)
  {
    if (after.count(input.first) == 0 && after.size() < before.size())
    {
      differences.push_back(input.second + " is no longer read");
    }
  }
  CompareMembers(then["versions"], now["versions"], differences);
  CompareMembers(then["options"], now["options"], differences);
  const std::string part = DescribePart(now);
  if (!part.empty() && part != DescribePart(then)) // those who join parts read all of them
  {
    differences.push_back("it is part " + DescribePart(then) + " and not " + part);
  }
  if (Quote(then["trajectory"]) != Quote(now["trajectory"]))
  {
    differences.emplace_back("the input trajectory has changed");
  }
  if (Quote(then["mesh"]) != Quote(now["mesh"]))
  {
    differences.emplace_back("the input mesh has changed");
  }
  const std::string scene = now["scene"].asString();
  if (differences.empty() && !scene.empty() && then["scene"].asString() != scene)
  {
    differences.emplace_back(
      "the scene has changed: its input, or a file that its files refer to (materials, spectra)");
  }
  return Enumerate(differences);
}

} // namespace helios
