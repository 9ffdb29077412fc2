// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// The accuracy that a run had, measured on a sample of its pulses.

#ifndef heliosRunAccuracy_h
#define heliosRunAccuracy_h

#include "heliosEchoComparison.h"
#include "heliosLegRunner.h"
#include "heliosTolerances.h"

#include <vtkSmartPointer.h>

#include <json/value.h>

#include <functional>
#include <string>
#include <vector>

class vtkPolyData;

namespace helios
{

/// Describes errors as value and ends of each measure.
Json::Value DescribeErrors(const EchoErrors& errors);

/// Returns the bins of a reference [ns]: for the shortest pulse, and no wider than the survey's.
double FindFinestBin(const SurveyData& survey);

/// Returns why the echoes of a run are random, so that two ways to compute them cannot be compared; empty: they are
/// not.
std::string ExplainRandomness(const LegRunner& runner, const RunSettings& settings);

/**
 * Some 200 to 1000 pulses of all legs that hit something, chosen by pulse id alone, are computed again: as in the run,
 * and by the reference, adaptive sampling at a tenth of the tolerances (of a run with fixed sub-rays, of the default
 * tolerances), in fine bins. Its own error is at most its difference from adaptive sampling at three tenths, with a
 * quarter of the sub-rays where beams are sampled. A few pulses are also computed with 32,768 fixed sub-rays, which
 * share no shortcut with it: a difference that their own error, told by half as many, does not explain, counts as its
 * error. Random noise and turbid voxels are left out of all of these, since they depend on the sub-rays.
 */
class RunAccuracy
{
public:
  using StepWatcher = std::function<bool(double share)>;

  RunAccuracy(LegRunner& runner, const RunSettings& settings, Messages& log);

  /// Computes the sample. onStep gets the fraction done; false stops it.
  void Measure(const StepWatcher& onStep);

  /// Returns the "accuracy" of a summary: counts, measures with their intervals, "reference" with
  /// its own error and its "check", "asked", "without"; or the "reason" why it was not measured.
  Json::Value Describe() const;

private:
  enum WayIndex
  {
    Run,
    Reference,
    Coarse,
    CheckedReference, // reference of few pulses
    Check,
    HalfCheck,
    NumberOfWays
  };
  struct Way
  {
    RunOptions Options;
    std::vector<vtkSmartPointer<vtkPolyData>> Echoes; ///< echoes of a leg: by piece and channel
    vtkIdType Fired = 0;
  };

  std::vector<Way> MakeWays() const;
  void SetReference(double factor, int maximumSubRays, RunOptions& options) const;
  Tolerances GetTolerances() const;
  void Fire(const LegPlan& plan, const StepWatcher& onStep, Way& way);
  void Compare(const LegPlan& plan, const std::vector<Way>& ways);
  Status AddErrors(const std::vector<Way>& ways, std::size_t echoes, const EchoMatching& matching);
  Status AddCheck(const std::vector<Way>& ways, std::size_t echoes, const EchoMatching& matching);
  vtkIdType CountSamples(const LegPlan& plan, vtkIdType step) const;
  EchoErrors GetReferenceErrors() const;
  Json::Value DescribeReference() const;

  LegRunner& Runner;
  const RunSettings& Settings;
  Messages& Log;
  vtkIdType Step = 1;
  vtkIdType CheckStep = 1;
  vtkIdType Pulses = 0;
  vtkIdType CheckedPulses = 0;
  EchoComparison Errors;
  EchoComparison CoarseErrors; // errors of the reference, at most
  EchoComparison CheckErrors;  // errors of the reference against many sub-rays
  EchoComparison OfCheck;      // bound of these errors
  std::string Reason;          // why nothing was measured
};

} // namespace helios

#endif
