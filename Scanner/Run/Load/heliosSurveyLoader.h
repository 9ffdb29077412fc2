// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Loads what a run is made of: options, epoch, scene and ray caster.

#ifndef heliosSurveyLoader_h
#define heliosSurveyLoader_h

#include "heliosInputFile.h"
#include "heliosRunSettings.h"
#include "heliosSceneBuilder.h"
#include "heliosStatus.h"
#include "heliosSurveyData.h"

#include <vtkSmartPointer.h>
#include <vtkTimeStamp.h>

#include <memory>
#include <string>
#include <utility>
#include <vector>

class vtkDataObject;
class vtkHeliosRayCaster;
class vtkImageData;
class vtkPolyData;

namespace helios
{

class Messages;
class TextureStore;

/// Inputs that a run is made from.
struct RunInputs
{
  const SurveyData* Survey = nullptr;
  vtkMTimeType SurveyTime = 0; ///< its last change
  RunOptions Options;
  vtkDataObject* Scene = nullptr;         ///< replaces the survey's scene; null: none
  std::vector<vtkImageData*> Grids;       ///< turbid voxels, with that scene
  vtkPolyData* Mesh = nullptr;            ///< mesh that beams hit in place of the scene; null: none
  std::vector<vtkPolyData*> Trajectories; ///< replace the files of platforms; empty: none
  bool Instances = false;                 ///< whether the scene may have them
  bool Colors = false;                    ///< whether meshes are read with their colours
};

/**
 * Keeps its loaded data, and loads again only data that depend on a change: another survey, epoch,
 * seed or scene, or a file of the scene that was written since.
 */
class SurveyLoader
{
public:
  explicit SurveyLoader(Messages& log);
  ~SurveyLoader();

  /// Checks the options of a run and sets them; reports an error and returns false if they are not
  /// valid. Before Load().
  bool Check(const RunInputs& inputs, RunSettings& settings);

  /// Returns whether Load() has nothing to do.
  bool IsLoaded() const;

  /// Loads the scene and sets ray caster and grids; false after an error, or if a step returns
  /// false.
  bool Load(const StepCallback& onStep, RunSettings& settings);

  /// Returns when the scene was loaded: grows with every change.
  vtkMTimeType GetLoadTime() const { return this->LoadTime; }

  /// Returns whether the scene is an input, in place of the survey's; after Check().
  bool HasGivenScene() const { return this->Inputs.Scene || !this->Inputs.Grids.empty(); }

  /// Returns the survey of the epoch, after Check().
  const SurveyData& GetSurvey() const { return this->Survey; }

  /// Returns the scene; null before Load().
  vtkPolyData* GetScene() const { return this->Scene; }
  const std::vector<vtkSmartPointer<vtkImageData>>& GetGrids() const { return this->Grids; }
  const SceneFrames& GetFrames() const { return this->Frames; } ///< frames of parts that deform

  /// Returns the files that the scene was read from, also files that only other files name.
  const InputFiles& GetInputs() const { return this->SceneFiles; }

private:
  /// Values that the scene depends on.
  struct Origin
  {
    const SurveyData* Survey = nullptr;
    vtkMTimeType SurveyTime = 0;
    int Epoch = 0;
    vtkIdType Seed = 0;
    bool Instances = false;
    bool Colors = false;
    vtkDataObject* Scene = nullptr;
    vtkMTimeType SceneTime = 0;
    InputFiles Files; ///< files that the survey names

    bool operator==(const Origin& other) const;
  };

  Origin FindOrigin() const;
  Status SetOptions(RunSettings& settings);
  bool SetTrajectories(RunSettings& settings);
  bool SetMesh(RunSettings& settings);
  void SetRayCaster(RunSettings& settings);
  bool BuildScene(const StepCallback& onStep);
  bool UseGivenScene();
  bool LoadTextures(const StepCallback& onStep);

  Messages& Log;
  RunInputs Inputs;
  SurveyData Survey; // survey of the epoch
  Origin Loaded;
  vtkTimeStamp LoadTime;
  std::unique_ptr<SceneBuilder> Builder; // builder of a survey with several epochs
  vtkSmartPointer<vtkPolyData> Scene;
  std::vector<vtkSmartPointer<vtkImageData>> Grids;
  SceneFrames Frames;
  std::shared_ptr<TextureStore> Textures; // textures of the scene, of all epochs
  InputFiles SceneFiles;
  vtkSmartPointer<vtkHeliosRayCaster> Caster;               // with its tree
  std::string CasterName;                                   // requested name
  std::pair<vtkPolyData*, vtkMTimeType> TakenMesh;          // mesh of the inputs
  vtkSmartPointer<vtkPolyData> Mesh;                        // and its triangles
  std::vector<std::pair<vtkPolyData*, vtkMTimeType>> Taken; // trajectories of the inputs
  std::vector<vtkSmartPointer<vtkPolyData>> Trajectories;   // trajectories of the inputs
};

} // namespace helios

#endif
