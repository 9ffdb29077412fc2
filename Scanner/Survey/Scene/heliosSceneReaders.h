// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// The readers of scene parts that are meshes.

#ifndef heliosSceneReaders_h
#define heliosSceneReaders_h

#include "heliosSurveyData.h"
#include "vtkHeliosScannerSurveyModule.h" // For export macro

#include <vtkSmartPointer.h>

#include <string>
#include <tuple>

class vtkPolyDataAlgorithm;

namespace helios
{

/// Values that a reader depends on: parts with equal values share it.
using SceneReaderKey = std::tuple<Loader, std::string, bool, std::string, std::string, bool>;
SceneReaderKey MakeSceneReaderKey(const PartData& part, const std::string& file);

/// Returns the reader of a file of a part; its loader is one of meshes. Colours are read of OBJ
/// files.
VTKHELIOSSCANNERSURVEY_EXPORT vtkSmartPointer<vtkPolyDataAlgorithm> MakeSceneReader(
  const PartData& part, const std::string& file, bool withColors = false);

/// Returns whether the file of a part has materials of its own, which the material file replaces by
/// name.
bool HasOwnMaterials(const PartData& part);

/// Returns whether the file of a part has objects that become parts of the scene.
bool HasObjects(const PartData& part);

} // namespace helios

#endif
