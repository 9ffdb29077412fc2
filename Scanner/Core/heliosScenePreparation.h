// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// The targets of a model's beams: the triangles of a scene, and turbid voxels.

#ifndef heliosScenePreparation_h
#define heliosScenePreparation_h

#include "heliosStatus.h"

#include <string>
#include <vector>

class vtkHeliosRayCaster;
class vtkImageData;
class vtkPolyData;

namespace helios
{

struct ScanModel;

/// Sets caster, surfaces and medium of a model. A scene with grids may have no triangles; isotropic
/// ones reflect no more than a quarter of the light.
Status PrepareScene(vtkPolyData* scene, const std::vector<vtkImageData*>& grids,
  vtkHeliosRayCaster* caster, bool isIsotropic, ScanModel& model);

} // namespace helios

#endif
