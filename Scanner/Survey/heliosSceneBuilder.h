// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// The mesh of a scene from its parts: the pipeline of readers, transforms and composer.

#ifndef heliosSceneBuilder_h
#define heliosSceneBuilder_h

#include "heliosSurveyData.h"

#include <vtkSmartPointer.h>

#include <functional>
#include <map>
#include <string>
#include <utility>
#include <vector>

class vtkAlgorithm;
class vtkHeliosObjSceneReader;
class vtkHeliosSceneTransform;
class vtkPolyData;

namespace helios
{

class Messages;

/// Called before each step of something long with what it does; false stops it.
using StepCallback = std::function<bool(const std::string& step)>;

/// Builds one scene. A file that several parts name is read once.
class SceneBuilder
{
public:
  SceneBuilder(const SceneData& scene, Messages& log);
  ~SceneBuilder();

  /// All parts as one mesh, what is on the ground put there, spectra resolved at a wavelength [nm];
  /// null after an error, or where a step was stopped.
  vtkSmartPointer<vtkPolyData> Build(double wavelength, const StepCallback& onStep);

private:
  using FileKey = std::pair<std::string, bool>; // the name, whether y is up

  vtkHeliosObjSceneReader* GetReader(const std::string& file, bool upIsY);
  vtkSmartPointer<vtkAlgorithm> MakeSource(const PartData& part);
  void MakePart(const PartData& part);
  bool ReadFiles(const StepCallback& onStep);
  bool PutOnGround();
  vtkSmartPointer<vtkPolyData> MakeGround();
  vtkSmartPointer<vtkPolyData> Compose(bool withPartsOnGround);

  const SceneData& Scene;
  Messages& Log;
  std::map<FileKey, vtkSmartPointer<vtkHeliosObjSceneReader>> Readers;
  std::vector<vtkSmartPointer<vtkHeliosSceneTransform>> Parts;
};

} // namespace helios

#endif
