// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// The accuracy that a run had, measured on a sample of its pulses.

#ifndef heliosRunAccuracy_h
#define heliosRunAccuracy_h

#include "heliosEchoComparison.h"
#include "heliosLegRunner.h"

#include <vtkSmartPointer.h>

#include <json/value.h>

#include <functional>
#include <string>
#include <vector>

class vtkPolyData;

namespace helios
{

/**
 * Some 200 to 1000 pulses of all legs that hit something, chosen by pulse id alone, are computed again: as in the run,
 * and with many fixed sub-rays in fine bins, the reference; its own error is at most its difference
 * from half as many. Random noise and turbid voxels are left out of all of these, since they depend
 * on the sub-rays.
 */
class RunAccuracy
{
public:
  using StepWatcher = std::function<bool(double share)>;

  RunAccuracy(LegRunner& runner, const RunSettings& settings, Messages& log);

  /// Computes the sample. onStep gets the fraction done; false stops it.
  void Measure(const StepWatcher& onStep);

  /// The "accuracy" of a summary: counts, measures with their intervals, "reference" with its own
  /// error, "asked", "without"; or the "reason" why it was not measured.
  Json::Value Describe() const;

private:
  struct Way
  {
    RunOptions Options;
    std::vector<vtkSmartPointer<vtkPolyData>> Echoes; ///< of a leg: by piece and channel
    vtkIdType Fired = 0;
  };

  std::vector<Way> MakeWays() const;
  double GetFinestBin() const;
  bool CountsPhotons() const;
  void Fire(const LegPlan& plan, const StepWatcher& onStep, Way& way);
  void Compare(const LegPlan& plan, const std::vector<Way>& ways);
  vtkIdType CountSamples(const LegPlan& plan) const;

  LegRunner& Runner;
  const RunSettings& Settings;
  Messages& Log;
  vtkIdType Step = 1;
  vtkIdType Pulses = 0;
  EchoComparison Errors;
  EchoComparison ReferenceErrors;
  std::string Reason; // why nothing was measured
};

} // namespace helios

#endif
