// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Makes the platforms of a survey from its data.

#ifndef heliosMakePlatform_h
#define heliosMakePlatform_h

#include "heliosSurveyData.h"
#include "vtkHeliosScannerRunModule.h" // For export macro

#include <vtkSmartPointer.h>

#include <string>
#include <vector>

class vtkHeliosPlatform;
class vtkHeliosPlatformNoise;
class vtkPolyData;

namespace helios
{

class Messages;

/// The trajectories from a pipeline, in place of files; empty: none.
using TrajectoryInputs = std::vector<vtkSmartPointer<vtkPolyData>>;

/// Where the platforms of a survey go.
struct LegPath
{
  std::vector<Vec3> Positions; ///< positions of the legs
  TrajectoryInputs Inputs;
  std::string Crs; ///< system of the scene, to which trajectory files are transformed; empty: none
};

/// Returns the platform of the legs [first, last), with its waypoints or its recorded trajectory.
vtkSmartPointer<vtkHeliosPlatform> MakePlatform(const SurveyData& survey, const LegPath& path,
  std::size_t first, std::size_t last, Messages& log);

/// Returns the noise of a platform, each value valid for a number of pulses of all channels; null:
/// none.
VTKHELIOSSCANNERRUN_EXPORT vtkSmartPointer<vtkHeliosPlatformNoise> MakePlatformNoise(
  const PlatformData& platform, std::size_t channels);

} // namespace helios

#endif
