// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Builds the mesh of a scene from its parts: the pipeline of readers, transforms and composer.

#ifndef heliosSceneBuilder_h
#define heliosSceneBuilder_h

#include "heliosPartPipelines.h"
#include "vtkHeliosScannerSurveyModule.h" // For export macro

#include <vtkSmartPointer.h>

#include <string>
#include <vector>

class vtkHeliosSceneTransform;
class vtkImageData;
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

  /// All parts of an epoch as one mesh, with parts on the ground placed there; null after an error,
  /// or if stopped.
  vtkSmartPointer<vtkPolyData> Build(const StepCallback& onStep, int epoch = 0);

  /// The turbid voxels of the built scene.
  std::vector<vtkSmartPointer<vtkImageData>> GetGrids();

private:
  /// A part of the epoch and its last filter.
  struct Part
  {
    const PartData* Data;
    const std::string* Name;
    vtkSmartPointer<vtkHeliosSceneTransform> Place;
  };

  void MakeParts(int epoch);
  bool PlaceOnGround();
  vtkSmartPointer<vtkPolyData> MakeGround();
  vtkSmartPointer<vtkPolyData> Compose(bool withPartsOnGround);

  const SceneData& Scene;
  Messages& Log;
  PartPipelines Pipelines;
  std::vector<Part> Parts;
};

} // namespace helios

#endif
