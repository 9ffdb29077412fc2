// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// The plays of a survey whose parts are swapped: the same legs, other geometry.

#ifndef heliosPlays_h
#define heliosPlays_h

#include "heliosSurveyData.h"
#include "vtkHeliosScannerSurveyModule.h" // For export macro

namespace helios
{

/// How often a survey is played: once, and as long as the longest swaps of a part last.
VTKHELIOSSCANNERSURVEY_EXPORT int CountPlays(const SceneData& scene);

/**
 * What a part is in a play, from 0: itself in the first one, then one swap after the other, and the
 * last to the end. Null where it is taken out.
 */
VTKHELIOSSCANNERSURVEY_EXPORT const PartData* FindPart(const PartData& part, int play);

/// The survey of one play: nothing is left to swap, parts that are taken out are not there, and the
/// others have the names that they have in the first play.
VTKHELIOSSCANNERSURVEY_EXPORT SurveyData MakePlay(const SurveyData& survey, int play);

} // namespace helios

#endif
