// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// The coordinate system of a survey: one for the scene, in metres, that legs come into.

#ifndef heliosSurveyCrs_h
#define heliosSurveyCrs_h

#include "heliosSurveyData.h"

class vtkPolyData;

namespace helios
{

class Messages;

/**
 * Gives a composed scene the system that the survey names, where it has none of its parts. False,
 * after an error, where the two are not the same, or distances in it are no metres.
 */
bool SetSceneCrs(vtkPolyData* scene, const SceneData& data, Messages& log);

/// The position of a leg in the scene's system. False, after an error, where there is no way.
bool TransformPosition(const LegData& leg, vtkPolyData* scene, Messages& log, Vec3& position);

} // namespace helios

#endif
