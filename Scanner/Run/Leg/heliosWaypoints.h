// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// The positions of the legs of a survey in the scene's coordinate system.

#ifndef heliosWaypoints_h
#define heliosWaypoints_h

#include "heliosSurveyData.h"

#include <vtkSmartPointer.h>

#include <vector>

class vtkPolyData;

namespace helios
{

class Messages;

/// Whether leg offset noise is enabled, and its seed.
struct LegOffsetNoise
{
  bool IsOn = true;
  vtkIdType Seed = 0;
};

/**
 * Finds the positions of all legs, with leg offset noise if the survey has it, and with legs on the
 * ground placed on the ground of the scene; false after an error.
 */
bool FindPositions(const SurveyData& survey, vtkPolyData* scene, const LegOffsetNoise& offsets,
  Messages& log, std::vector<Vec3>& positions);

/// Returns the legs [first, last) as waypoints.
vtkSmartPointer<vtkPolyData> MakeWaypoints(const SurveyData& survey,
  const std::vector<Vec3>& positions, std::size_t first, std::size_t last);

} // namespace helios

#endif
