// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Flight lines over the rectangle of a survey that is edited.

#ifndef heliosEditArea_h
#define heliosEditArea_h

#include "heliosStatus.h"
#include "heliosSurveyEdit.h"

namespace helios::viewer
{

/**
 * Replaces the legs by flight lines over the area of an edit, if it has one: those of
 * vtkHeliosFlightLines along its longer side, at Height above its higher corner, for the swath of the
 * scan angle and the overlap. An area without a surface, or for more than 1000 lines, is an error.
 */
Status FlyArea(SurveyEdit& edit);

} // namespace helios::viewer

#endif
