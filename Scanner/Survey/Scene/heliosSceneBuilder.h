// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Builds the mesh of a scene from its parts: the pipeline of readers, transforms and composer.

#ifndef heliosSceneBuilder_h
#define heliosSceneBuilder_h

#include "heliosLowestCorners.h"
#include "heliosPartPipelines.h"
#include "heliosShapePath.h"
#include "vtkHeliosScannerSurveyModule.h" // For export macro

#include <vtkSmartPointer.h>

#include <string>
#include <vector>

class vtkHeliosSceneTransform;
class vtkImageData;
class vtkAlgorithm;
class vtkHeliosSceneComposer;
class vtkPoints;
class vtkPolyData;

namespace helios
{

class Messages;

/// Builds the scene of one epoch after the other. What an epoch shares with the one before is not
/// read again.
class VTKHELIOSSCANNERSURVEY_EXPORT SceneBuilder
{
public:
  SceneBuilder(const SceneData& scene, Messages& log, vtkIdType seed = 0);
  ~SceneBuilder();

  /// Sets whether meshes of several parts become instances of a vtkHeliosScene, and rasters of
  /// heights its rasters; but not of parts that move. Default: false.
  void SetInstances(bool areMade) { this->MakesInstances = areMade; }

  /// Sets whether the parts have their colours. Before Build(). Default: false.
  void SetColors(bool areRead);

  /// Returns all parts of an epoch as one scene, with parts on the ground placed there; null after
  /// an error, or if stopped.
  vtkSmartPointer<vtkPolyData> Build(const StepCallback& onStep, int epoch = 0);

  /// Returns the turbid voxels of the built scene.
  std::vector<vtkSmartPointer<vtkImageData>> GetGrids();

  /// Returns the frames of the parts of the built scene that deform.
  SceneFrames GetFrames() const;

  /// Returns the files that were opened for the built scene and its voxels, also in an epoch
  /// before.
  InputFiles GetInputs() const { return this->Pipelines.GetInputs(); }

private:
  /// A part of the epoch. Instances have no filter that places them: many of one source are slow.
  struct Part
  {
    const PartData* Data;
    const std::string* Name;
    vtkAlgorithm* Source; ///< the filter before the part is placed
    Vec3 Translation;     ///< [m]
    vtkSmartPointer<vtkHeliosSceneTransform> Place;

    bool IsInstance() const { return this->Place == nullptr; }
  };

  bool ReadParts(const StepCallback& onStep, int epoch);
  void MakeParts(int epoch);
  void AddParts(vtkHeliosSceneComposer* composer, bool withPartsOnGround) const;
  bool FindLowest(const Part& part, Vec3& lowest);
  bool FindGround(
    const std::vector<std::size_t>& parts, vtkPoints* lowest, std::vector<double>& heights);
  bool PlaceOnGround();
  vtkSmartPointer<vtkPolyData> MakeGround();
  vtkSmartPointer<vtkPolyData> Compose(bool withPartsOnGround);
  bool AddTreesTo(vtkPolyData* scene) const;
  void AddFramesTo(vtkPolyData* scene) const;

  const SceneData& Scene;
  Messages& Log;
  PartPipelines Pipelines;
  std::vector<Part> Parts;
  bool MakesInstances = false;
  bool HasColors = false;
  LowestCorners Lowest;
};

} // namespace helios

#endif
