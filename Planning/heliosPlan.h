// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Selection of scan positions: the methods, composed of their steps.

#ifndef heliosPlan_h
#define heliosPlan_h

#include "heliosCoverOverlap.h"
#include "heliosIncidence.h"

#include <string>

namespace helios
{

enum class PlanMethod
{
  ViewshedSize = 0,
  MeanIncidenceAngle = 1,
  Greedy = 2,
  Best = 3,
  Optimal = 4
};

struct PlanSettings
{
  PlanMethod Method = PlanMethod::Best;
  bool IsAscending = true;            // order of removal
  std::vector<double> MeanAngles;     // mean angles of candidates, for MeanIncidenceAngle [deg]
  int NumberOfStarts = 4;             // starts of local searches
  double TimeLimit = 300.0;           // wall time of Optimal [s]
  double MinimumOverlap = 0.0;        // 0: need not be connected
  std::function<void(double)> Report; // progress in [0, 1]; may be empty
  StopTest Stop;
};

struct PlanResult
{
  std::string Fault;          // error message; empty: none
  Choice Selected;            // in order of decreasing gain
  double LinearBound = 0.0;   // scans: of the linear relaxation, or a valid bound below it
  int Bound = 0;              // no plan has fewer scans
  bool IsWorstProved = false; // no plan of as many scans has a better worst incidence
  bool IsMeanProved = false;  // nor, with that one, a better mean
};

VTKHELIOSPLANNING_EXPORT PlanResult MakePlan(
  const CoverProblem& problem, const Incidence& incidence, const PlanSettings& settings);

} // namespace helios

#endif
