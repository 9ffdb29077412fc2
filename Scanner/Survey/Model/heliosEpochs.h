// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// The epochs of a survey with swapped parts: the same legs, other geometry.

#ifndef heliosEpochs_h
#define heliosEpochs_h

#include "heliosSurveyData.h"
#include "vtkHeliosScannerSurveyModule.h" // For export macro

namespace helios
{

/// Returns the number of epochs: one, or the longest total duration of the swaps of a part.
VTKHELIOSSCANNERSURVEY_EXPORT int CountEpochs(const SceneData& scene);

/**
 * Returns the part in an epoch, from 0: itself in the first, then one swap after the other, the
 * last to the end. Null if it is removed.
 */
VTKHELIOSSCANNERSURVEY_EXPORT const PartData* FindPart(const PartData& part, int epoch);

/// Returns the survey of one epoch: without swaps and removed parts. The other parts keep the names
/// that they have in the first epoch.
VTKHELIOSSCANNERSURVEY_EXPORT SurveyData MakeEpoch(const SurveyData& survey, int epoch);

} // namespace helios

#endif
