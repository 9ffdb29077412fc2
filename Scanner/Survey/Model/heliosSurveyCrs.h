// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// The coordinate system of a survey: the scene's, in metres, to which legs are transformed.

#ifndef heliosSurveyCrs_h
#define heliosSurveyCrs_h

#include "heliosSurveyData.h"
#include "vtkHeliosScannerSurveyModule.h" // For export macro

class vtkPolyData;

namespace helios
{

class Messages;

/**
 * Assigns the survey's system to a composed scene whose parts have none. False, after an error, if
 * the two differ, or its unit is not the metre.
 */
bool SetSceneCrs(vtkPolyData* scene, const SceneData& data, Messages& log);

/// Transforms the position of a leg to the scene's system. False, after an error, without a
/// transformation.
VTKHELIOSSCANNERSURVEY_EXPORT bool TransformPosition(
  const LegData& leg, vtkPolyData* scene, Messages& log, Vec3& position);

} // namespace helios

#endif
