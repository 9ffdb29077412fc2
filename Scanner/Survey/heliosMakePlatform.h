// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// The platform filter of a journey, as its data say.

#ifndef heliosMakePlatform_h
#define heliosMakePlatform_h

#include "heliosSurveyData.h"

#include <vtkSmartPointer.h>

class vtkHeliosPlatform;

namespace helios
{

/// What moves on the journey that starts with a leg; its waypoints are still to be given.
vtkSmartPointer<vtkHeliosPlatform> MakePlatform(const SurveyData& survey, std::size_t leg);

} // namespace helios

#endif
