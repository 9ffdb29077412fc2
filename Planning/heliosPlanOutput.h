// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// A plan as arrays of candidates and test points.

#ifndef heliosPlanOutput_h
#define heliosPlanOutput_h

#include "heliosIncidence.h"

#include <vtkType.h>

class vtkPolyData;

namespace helios
{

class PlanOutput
{
public:
  PlanOutput(const CoverProblem& problem, const Incidence& incidence, const Choice& selected);

  vtkIdType GetCoveredCount() const;
  double GetCoveredWeight() const { return this->Counts.GetCoveredWeight(); }
  Quality GetQuality() const { return Incidence::ComputeQuality(this->Problem, this->Best); }

  void WriteCandidates(
    vtkPolyData* input, const std::vector<double>& meanAngles, vtkPolyData* output) const;
  void WriteTestPoints(vtkPolyData* input, vtkPolyData* output) const;

  /// Takes the output of WriteCandidates.
  void WriteSelected(vtkPolyData* candidates, vtkPolyData* output) const;

private:
  const CoverProblem& Problem;
  const Choice& Selected;
  CoverCounts Counts;
  std::vector<double> Best;
};

} // namespace helios

#endif
