// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// The arrays of planning, beside those of vtkHeliosArrayNames.h.

#ifndef heliosPlanningArrays_h
#define heliosPlanningArrays_h

#include "vtkHeliosArrayNames.h"

namespace vtkHeliosArrayNames
{

///@{
/** Planning: point data of candidates (Visibility to Selected) and of visibility test points. */
inline constexpr const char* Slope = "Slope";               // [deg], from the horizontal
inline constexpr const char* Visibility = "Visibility";     // a bit a test point, in 64-bit words
inline constexpr const char* ViewshedSize = "ViewshedSize"; // test points seen
inline constexpr const char* Exclusivity = "Exclusivity"; // test points no other selected one sees
inline constexpr const char* MeanIncidenceAngle = "MeanIncidenceAngle"; // [deg]
inline constexpr const char* Selected = "Selected";                     // 1: scan from here
inline constexpr const char* NewlyCovered = "NewlyCovered";   // test points a selected one adds
inline constexpr const char* Area = "Area";                   // [m2] a test point stands for
inline constexpr const char* Coverable = "Coverable";         // 1: some candidate sees it
inline constexpr const char* NumberOfScans = "NumberOfScans"; // selected candidates that see it
inline constexpr const char* BestIncidenceAngle =
  "BestIncidenceAngle"; // [deg], of those; NaN: none
///@}

///@{
/** Field data of planned candidates: one value each. */
inline constexpr const char* PlanNumberOfSelected = "Plan.NumberOfSelected";
inline constexpr const char* PlanNumberCovered = "Plan.NumberCovered";         // test points
inline constexpr const char* PlanNumberCoverable = "Plan.NumberCoverable";     // test points
inline constexpr const char* PlanCoverage = "Plan.Coverage";                   // [%] of all
inline constexpr const char* PlanCoverableCoverage = "Plan.CoverableCoverage"; // [%]
inline constexpr const char* PlanLowerBound = "Plan.LowerBound";               // scans
inline constexpr const char* PlanBestBound = "Plan.BestBound";                 // whole scans
inline constexpr const char* PlanGap = "Plan.Gap";                             // [%]
inline constexpr const char* PlanIsProvedOptimal = "Plan.IsProvedOptimal";
inline constexpr const char* PlanWorstIncidenceAngle = "Plan.WorstIncidenceAngle";       // [deg]
inline constexpr const char* PlanMeanBestIncidenceAngle = "Plan.MeanBestIncidenceAngle"; // [deg]
///@}

} // namespace vtkHeliosArrayNames

#endif
