// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosSurveyLoader.h"

#include "heliosEpochs.h"
#include "heliosLegSettings.h"
#include "heliosMessages.h"
#include "heliosSceneInput.h"
#include "heliosStatus.h"
#include "heliosTexture.h"
#include "heliosTrajectoryInput.h"
#include "vtkHeliosRayCaster.h"
#include "vtkHeliosRayCasterFactory.h"
#include "vtkHeliosScanner.h"
#include "vtkHeliosScene.h"

#include <vtkImageData.h>
#include <vtkPolyData.h>

#include <algorithm>
#include <tuple>

namespace helios
{

namespace
{

/// Adds the files of a part in all epochs.
void AddFiles(const PartData& part, InputFiles& files)
{
  const auto add = [&files](const std::string& file)
  {
    if (const auto [place, isNew] = files.emplace(file, ""); isNew) // parts of a table share files
    {
      place->second = StampFile(file);
    }
  };
  std::for_each(part.Files.begin(), part.Files.end(), add);
  add(part.Material.File);
  add(part.Vegetation.LeafTable);
  add(part.Motion.Track.File);
  for (const SwapData& swap : part.Swaps)
  {
    AddFiles(swap.Part, files);
  }
}

std::vector<std::string> GetRayCasterNames()
{
  std::vector<std::string> names;
  for (int i = 0; i < vtkHeliosRayCasterFactory::GetNumberOfBackends(); ++i)
  {
    names.emplace_back(vtkHeliosRayCasterFactory::GetBackendName(i));
  }
  return names;
}

vtkMTimeType FindTime(const RunInputs& inputs)
{
  vtkMTimeType time = inputs.Scene ? inputs.Scene->GetMTime() : 0;
  for (vtkImageData* grid : inputs.Grids)
  {
    time = std::max(time, grid->GetMTime());
  }
  return time;
}

} // namespace

//------------------------------------------------------------------------------
bool SurveyLoader::Origin::operator==(const Origin& other) const
{
  const auto tie = [](const Origin& o)
  {
    return std::tie(o.Survey, o.SurveyTime, o.Epoch, o.Seed, o.Instances, o.Colors, o.Scene,
      o.SceneTime, o.Files);
  };
  return tie(*this) == tie(other);
}

//------------------------------------------------------------------------------
SurveyLoader::SurveyLoader(Messages& log)
  : Log(log)
{
}

//------------------------------------------------------------------------------
SurveyLoader::~SurveyLoader() = default;

//------------------------------------------------------------------------------
bool SurveyLoader::Check(const RunInputs& inputs, RunSettings& settings)
{
  this->Inputs = inputs;
  if (!inputs.Survey || inputs.Survey->Legs.empty())
  {
    this->Log.Error(
      "Survey is not set or has no legs; give the survey of a vtkHeliosSurveyReader.");
    return false;
  }
  const Status status = this->SetOptions(settings);
  if (!status.IsOk())
  {
    this->Log.Error(status.Message());
    return false;
  }
  this->Inputs.Options = settings.Options;
  if (!this->SetTrajectories(settings) || !this->SetMesh(settings))
  {
    return false;
  }
  if (!this->IsLoaded())
  {
    this->Survey = MakeEpoch(*inputs.Survey, settings.Options.Epoch);
    if (this->HasGivenScene())
    {
      this->Survey.Scene.Parts.clear();
    }
  }
  return true;
}

//------------------------------------------------------------------------------
/// Sets the options, with values of the survey where they have none.
Status SurveyLoader::SetOptions(RunSettings& settings)
{
  const SurveyData& survey = *this->Inputs.Survey;
  RunOptions options = this->Inputs.Options;
  const int epochs = CountEpochs(survey.Scene);
  if (options.Epoch >= epochs)
  {
    MessageBuilder fault;
    fault << "Epoch is " << options.Epoch << ", but the survey has " << epochs
          << (epochs > 1 ? " epochs" : " epoch") << "; give 0 to " << epochs - 1;
    return Status::Error(fault.str());
  }
  const Status status = options.FindFault();
  if (!status.IsOk())
  {
    return status;
  }
  const std::vector<std::string> names = GetRayCasterNames();
  const bool isOwn = options.RayCaster.empty();
  const std::string name = isOwn ? survey.RayCaster : options.RayCaster;
  if (!name.empty() && std::find(names.begin(), names.end(), name) == names.end())
  {
    return Status::Error((isOwn ? survey.FileName + ": rayCaster" : "RayCaster") + "=\"" + name +
      "\" is not in this build; give one of " + JoinChoices(names));
  }
  options.RayCaster = name;
  options.Seed = std::max<vtkIdType>(0, options.Seed >= 0 ? options.Seed : survey.Seed);
  options.GpsStart = options.GpsStart.empty() ? survey.GpsStart : options.GpsStart;
  settings.Options = options;
  settings.HasEpochs = epochs > 1;
  return {};
}

//------------------------------------------------------------------------------
/// Takes the trajectories of the inputs; false after an error. Those that have not changed are the
/// same objects as before.
bool SurveyLoader::SetTrajectories(RunSettings& settings)
{
  const SurveyData& survey = *this->Inputs.Survey;
  const bool isGiven = !this->Inputs.Trajectories.empty();
  bool isUsed = false;
  for (std::size_t leg = 0; leg < survey.Legs.size(); ++leg)
  {
    isUsed = isUsed || survey.GetPlatform(leg).Type == PlatformType::Interpolated;
    if (!isGiven && NeedsTrajectory(survey, leg))
    {
      this->Log.Error(survey.Legs[leg].Where + ": platform " + survey.GetPlatform(leg).Name +
        " needs a trajectory; set the leg's attribute trajectory to a file, or connect one to "
        "input "
        "2 of the vtkHeliosSurveySource");
      return false;
    }
  }
  if (isGiven && !isUsed)
  {
    this->Log.Error("the input trajectory is not used: no platform of survey " + survey.Name +
      " follows a trajectory; set the type of a platform to interpolated, or disconnect the input");
    return false;
  }
  decltype(this->Taken) now;
  for (vtkPolyData* input : this->Inputs.Trajectories)
  {
    now.emplace_back(input, input->GetMTime());
  }
  if (now != this->Taken)
  {
    this->Taken.clear();
    this->Trajectories.clear();
    for (vtkPolyData* input : this->Inputs.Trajectories)
    {
      const std::string name = "input trajectory " + std::to_string(this->Trajectories.size());
      if (!CheckTrajectoryInput(input, name, this->Log))
      {
        return false;
      }
      this->Trajectories.push_back(vtkSmartPointer<vtkPolyData>::New());
      this->Trajectories.back()->ShallowCopy(input);
    }
    this->Taken = now;
  }
  settings.Trajectories = this->Trajectories;
  return true;
}

//------------------------------------------------------------------------------
/// Takes the mesh of the inputs; false after an error. If it has not changed it is the same object
/// as before.
bool SurveyLoader::SetMesh(RunSettings& settings)
{
  vtkPolyData* input = this->Inputs.Mesh;
  const std::pair<vtkPolyData*, vtkMTimeType> now(input, input ? input->GetMTime() : 0);
  if (now != this->TakenMesh)
  {
    this->TakenMesh = {};
    this->Mesh = input ? MakeTriangles(input, "the input mesh", this->Log) : nullptr;
    const bool isEmpty = !this->Mesh ||
      (this->Mesh->GetNumberOfPolys() == 0 && !vtkHeliosScene::HasInstances(this->Mesh));
    if (input && isEmpty)
    {
      this->Log.Error("the input mesh has no polygons; give one that stands in for the scene, such "
                      "as a simplified GetScene(), or disconnect the input");
      return false;
    }
    this->TakenMesh = now;
  }
  settings.Mesh = this->Mesh;
  return true;
}

//------------------------------------------------------------------------------
SurveyLoader::Origin SurveyLoader::FindOrigin() const
{
  const RunInputs& inputs = this->Inputs;
  Origin origin{ inputs.Survey, inputs.SurveyTime, inputs.Options.Epoch, inputs.Options.Seed,
    inputs.Instances, inputs.Colors, inputs.Scene, FindTime(inputs), {} };
  if (!this->HasGivenScene())
  {
    for (const PartData& part : inputs.Survey->Scene.Parts)
    {
      AddFiles(part, origin.Files);
    }
  }
  return origin;
}

//------------------------------------------------------------------------------
bool SurveyLoader::IsLoaded() const
{
  return this->Scene && this->Loaded == this->FindOrigin() && AreUnchanged(this->SceneFiles);
}

//------------------------------------------------------------------------------
bool SurveyLoader::Load(const StepCallback& onStep, RunSettings& settings)
{
  const Origin origin = this->FindOrigin();
  const bool hasChanged = !AreUnchanged(this->SceneFiles);
  if (!this->Scene || !(this->Loaded == origin) || hasChanged)
  {
    Origin before = this->Loaded;
    before.Epoch = origin.Epoch;
    if (!(before == origin) || hasChanged)
    {
      this->Builder.reset();
      this->Textures.reset();
    }
    this->Scene = nullptr;
    this->SceneFiles.clear();
    this->Loaded = origin;
    this->LoadTime.Modified();
    if (!(this->HasGivenScene() ? this->UseGivenScene() : this->BuildScene(onStep)) ||
      !this->LoadTextures(onStep))
    {
      this->Scene = nullptr;
      this->Builder.reset();
      return false;
    }
  }
  this->SetRayCaster(settings);
  settings.Grids = this->Grids;
  settings.Frames =
    this->Mesh ? SceneFrames() : this->Frames; // a mesh in place of the scene is rigid
  settings.Textures = this->Textures;
  return true;
}

//------------------------------------------------------------------------------
bool SurveyLoader::BuildScene(const StepCallback& onStep)
{
  if (!this->Builder)
  {
    this->Builder = std::make_unique<SceneBuilder>(
      this->Inputs.Survey->Scene, this->Log, this->Inputs.Options.Seed);
    this->Builder->SetInstances(this->Inputs.Instances);
    this->Builder->SetColors(this->Inputs.Colors);
  }
  this->Scene = this->Builder->Build(onStep, this->Inputs.Options.Epoch);
  this->Grids = this->Scene ? this->Builder->GetGrids() : decltype(this->Grids)();
  this->Frames = this->Scene ? this->Builder->GetFrames() : SceneFrames();
  this->SceneFiles = this->Builder->GetInputs();
  if (CountEpochs(this->Inputs.Survey->Scene) == 1)
  {
    this->Builder.reset(); // not needed again
  }
  return this->Scene != nullptr;
}

//------------------------------------------------------------------------------
/// Reads the images on surfaces, for all scanners of a run; false after an error.
bool SurveyLoader::LoadTextures(const StepCallback& onStep)
{
  if (!this->Inputs.Colors)
  {
    return true;
  }
  if (!onStep("reading textures"))
  {
    return false;
  }
  if (!this->Textures)
  {
    this->Textures = std::make_shared<TextureStore>();
  }
  std::vector<vtkDataObject*> data(this->Grids.begin(), this->Grids.end());
  data.push_back(this->Scene);
  std::vector<std::string> warnings;
  const Status status = this->Textures->Load(data, warnings);
  for (const std::string& warning : warnings)
  {
    this->Log.Warning(warning);
  }
  if (!status.IsOk())
  {
    this->Log.Error(status.Message());
  }
  return status.IsOk();
}

//------------------------------------------------------------------------------
/// Takes the scene of the inputs in place of the survey's.
bool SurveyLoader::UseGivenScene()
{
  this->Scene = this->Inputs.Scene ? MakeTriangles(this->Inputs.Scene, "the input scene", this->Log)
                                   : vtkSmartPointer<vtkPolyData>::New();
  this->Grids.assign(this->Inputs.Grids.begin(), this->Inputs.Grids.end());
  this->Frames.clear();
  if (!this->Scene ||
    (this->Scene->GetNumberOfPolys() == 0 && !vtkHeliosScene::HasInstances(this->Scene) &&
      this->Grids.empty()))
  {
    this->Log.Error(std::string("the input scene, a ") + this->Inputs.Scene->GetClassName() +
      ", has no polygons; give a vtkPolyData, or another data set that has a surface");
    return false;
  }
  return true;
}

//------------------------------------------------------------------------------
/// Keeps the ray caster and its tree, unless another kind is requested.
void SurveyLoader::SetRayCaster(RunSettings& settings)
{
  const std::string& name = settings.Options.RayCaster;
  if (!this->Caster || name != this->CasterName)
  {
    this->CasterName = name;
    this->Caster = name.empty()
      ? vtkNew<vtkHeliosScanner>()->GetRayCaster()
      : vtkSmartPointer<vtkHeliosRayCaster>::Take(vtkHeliosRayCasterFactory::Create(name.c_str()))
          .Get();
  }
  settings.RayCaster = this->Caster;
}

} // namespace helios
