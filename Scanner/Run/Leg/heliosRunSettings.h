// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// How a survey is run: its options and what is computed and written.

#ifndef heliosRunSettings_h
#define heliosRunSettings_h

#include "heliosRunPart.h"
#include "heliosShapePath.h"
#include "vtkHeliosEchoAlgorithm.h"
#include "vtkHeliosRunOptions.h"

#include <vtkSmartPointer.h>
#include <vtkType.h>

#include <memory>
#include <string>
#include <vector>

class vtkHeliosRayCaster;
class vtkImageData;
class vtkPolyData;

namespace helios
{

class TextureStore;

struct RunSettings
{
  RunOptions Options;     ///< with the seed of the survey if it has none
  bool HasEpochs = false; ///< whether the survey has several epochs
  vtkHeliosEchoAlgorithm::Outputs Wants;

  std::string Folder; ///< folder of the files
  std::string Format; ///< xyz, las, vtp
  vtkIdType PulsesPerBlock = 262144;
  RunPart Part; ///< part that is run

  vtkSmartPointer<vtkHeliosRayCaster> RayCaster;    ///< null: the scanner's default
  std::vector<vtkSmartPointer<vtkImageData>> Grids; ///< turbid voxels of the scene
  SceneFrames Frames;                               ///< frames of its parts that deform
  /// textures of the scene; null: none are loaded
  std::shared_ptr<TextureStore> Textures;
  vtkSmartPointer<vtkPolyData> Mesh; ///< mesh that beams hit in place of the scene; null: none

  /// Trajectories that platforms follow, in place of files; empty: none.
  std::vector<vtkSmartPointer<vtkPolyData>> Trajectories;
};

} // namespace helios

#endif
