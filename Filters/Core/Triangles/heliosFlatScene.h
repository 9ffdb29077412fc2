// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// The triangles of a scene with instances as one mesh.

#ifndef heliosFlatScene_h
#define heliosFlatScene_h

#include "heliosStatus.h"
#include "vtkHeliosFiltersCoreModule.h" // For export macro

#include <vtkSmartPointer.h>

class vtkHeliosScene;
class vtkPolyData;

namespace helios
{

/// Makes one mesh of a scene, see vtkHeliosSceneFlatten.
VTKHELIOSFILTERSCORE_EXPORT Status FlattenScene(vtkHeliosScene* scene, vtkPolyData* mesh);

/// Returns a scene without instances unchanged, and another one as a mesh, after a check of the
/// memory.
VTKHELIOSFILTERSCORE_EXPORT Status GetFlatScene(
  vtkPolyData* scene, vtkSmartPointer<vtkPolyData>& mesh);

} // namespace helios

#endif
