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

/// Builds one scene.
class VTKHELIOSSCANNERSURVEY_EXPORT SceneBuilder
{
public:
  SceneBuilder(const SceneData& scene, Messages& log, vtkIdType seed = 0);
  ~SceneBuilder();

  /// All parts as one mesh, with parts on the ground placed there; null after an error, or if
  /// stopped.
  vtkSmartPointer<vtkPolyData> Build(const StepCallback& onStep);

  /// The turbid voxels of the built scene.
  std::vector<vtkSmartPointer<vtkImageData>> GetGrids();

private:
  bool PutOnGround();
  vtkSmartPointer<vtkPolyData> MakeGround();
  vtkSmartPointer<vtkPolyData> Compose(bool withPartsOnGround);

  const SceneData& Scene;
  Messages& Log;
  PartPipelines Pipelines;
  std::vector<vtkSmartPointer<vtkHeliosSceneTransform>> Parts;
};

} // namespace helios

#endif
