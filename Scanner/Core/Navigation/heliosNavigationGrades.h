// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// RMS errors of classes of GNSS/IMU solutions; Docs/trajectories.md has the table with the sources.

#ifndef heliosNavigationGrades_h
#define heliosNavigationGrades_h

namespace helios
{

struct NavigationGrade
{
  const char* Name;
  double RMS[6]; ///< east, north, up [m]; about x, y, z of the body [deg]
};

inline constexpr NavigationGrade NavigationGrades[] = {
  // DJI Zenmuse L1 with RTK in real time, specifications
  { "consumer", { 0.010, 0.010, 0.015, 0.05, 0.05, 0.30 } },
  // Applanix APX-15 UAV after post-processing, data sheet; positions: the upper end
  { "tactical", { 0.05, 0.05, 0.05, 0.025, 0.025, 0.080 } },
  // SBG Systems Apogee, PPK, airborne, hardware manual 1.5, section 2.3.4, without the part per km
  { "survey", { 0.010, 0.010, 0.020, 0.005, 0.005, 0.010 } },
  // An Applanix solution: medians of its error report (smrmsg.txt of PDAL)
  { "navigation", { 0.038, 0.041, 0.047, 0.0022, 0.0022, 0.0173 } },
};

} // namespace helios

#endif
