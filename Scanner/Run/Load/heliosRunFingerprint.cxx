// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosRunFingerprint.h"

#include "heliosInputDigest.h"
#include "heliosLegRunner.h"
#include "heliosMessages.h"
#include "heliosRunInputs.h"
#include "heliosRunJournal.h"
#include "heliosRunSettings.h"
#include "heliosSha256.h"
#include "heliosSurveyData.h"
#include "heliosSurveyLoader.h"
#include "vtkHeliosArrayNames.h"
#include "vtkHeliosRayCaster.h"
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

#include <utility>

namespace helios
{

namespace
{

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
  Json::Value options;
  settings.Options.Describe(options);
  options["format"] = settings.Format;
  for (const auto& row : vtkHeliosEchoAlgorithm::GetOutputRows())
  {
    if (row.IsListedIfOff || settings.Wants.*row.Flag)
    {
      options[row.Key] = settings.Wants.*row.Flag;
    }
  }
  options["pulsesPerBlock"] = Json::Int64(settings.PulsesPerBlock);
  if (settings.HasEpochs)
  {
    options["epoch"] = settings.Options.Epoch;
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
    vtkAbstractArray* array = data->GetAbstractArray(i);
    const bool isOfPaths =
      array->GetName() && array->GetName() == std::string(vtkHeliosArrayNames::MaterialTexture);
    AddArray(isOfPaths ? nullptr : array, hash); // the images count, wherever they are
  }
}

/// Returns the digest of the trajectories of inputs.
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

/// Returns the part of a fingerprint: "2/4"; empty: the whole run.
std::string DescribePart(const Json::Value& fingerprint)
{
  const Json::Value& part = fingerprint["part"];
  return part.isObject() ? part["number"].asString() + "/" + part["count"].asString()
                         : std::string();
}

/// Returns a value as a user would type it.
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
bool IsOfLoadedSurvey(const Json::Value& fingerprint)
{
  return !fingerprint["scene"].asString().empty();
}

//------------------------------------------------------------------------------
Json::Value MakeFingerprint(const SurveyData& survey, const RunSettings& settings)
{
  Json::Value fingerprint;
  fingerprint["versions"]["vtkHelios"] = vtkHeliosVersion::GetVersion();
  fingerprint["versions"]["VTK"] = vtkVersion::GetVTKVersion();
  fingerprint["versions"]["summary"] = SummaryVersion;
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

/// Adds a mesh, or a raster of heights.
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

std::string HashScene(vtkPolyData* scene, const std::vector<vtkSmartPointer<vtkImageData>>& grids,
  const std::vector<std::string>& files)
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
  for (const std::string& file : files)
  {
    hash.Add(ComputeInputDigest(file).Sha256 + '\n');
  }
  return hash.Finish();
}

//------------------------------------------------------------------------------
Status AddLoadedSurvey(const SurveyLoader& loader, const LegRunner& legs,
  const RunSettings& settings, Json::Value& fingerprint, InputFiles& inputs)
{
  using Grids = std::vector<vtkSmartPointer<vtkImageData>>;
  const Grids& grids = loader.GetGrids();
  const std::vector<std::string> materials = FindMaterialFiles(
    settings.Mesh ? settings.Mesh.Get() : loader.GetScene(), grids, loader.GetSurvey(), settings);
  inputs = loader.GetInputs();
  inputs.insert(legs.GetInputs().begin(), legs.GetInputs().end());
  for (const std::string& file : materials)
  {
    inputs.emplace(file, StampFile(file));
  }
  const bool isGiven = loader.HasGivenScene();
  fingerprint["scene"] = HashScene(loader.GetScene(), isGiven ? grids : Grids(), materials);
  return AddInputs(inputs, fingerprint["inputs"]);
}

//------------------------------------------------------------------------------
std::string CompareFingerprints(const Json::Value& then, const Json::Value& now)
{
  const bool areLoaded = IsOfLoadedSurvey(now) == IsOfLoadedSurvey(then);
  std::vector<std::string> differences = CompareInputs(then["inputs"], now["inputs"], areLoaded);
  CompareMembers(then["versions"], now["versions"], differences);
  CompareMembers(then["options"], now["options"], differences);
  const std::string part = DescribePart(now);
  if (!part.empty() && part != DescribePart(then)) // readers of parts read all of them
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
  if (differences.empty() && IsOfLoadedSurvey(now) && Quote(then["scene"]) != Quote(now["scene"]))
  {
    differences.emplace_back(
      "the scene has changed: its input, or a file of PROJ that its coordinate systems need");
  }
  return JoinChoices(differences);
}

} // namespace helios
