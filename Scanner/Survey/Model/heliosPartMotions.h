// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Which parts of a scene move, and how, in words.

#ifndef heliosPartMotions_h
#define heliosPartMotions_h

#include "heliosSurveyData.h"
#include "vtkHeliosScannerSurveyModule.h" // For export macro

#include <cstddef>
#include <set>
#include <string>
#include <vector>

namespace helios
{

/// Returns the numbers of the parts that move, by themselves or carried, or deform.
VTKHELIOSSCANNERSURVEY_EXPORT std::set<std::size_t> FindMoving(const std::vector<PartData>& parts);

/// Describes how a part moves, and whether it deforms: "along car.csv"; "continuous, deforms, on car".
VTKHELIOSSCANNERSURVEY_EXPORT std::string DescribeMotion(const MotionData& motion, bool doesDeform);

} // namespace helios

#endif
