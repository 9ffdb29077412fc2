// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Estimates time and output of a run from samples of its legs.

#ifndef heliosRunEstimate_h
#define heliosRunEstimate_h

#include "heliosLegRunner.h"

#include <json/value.h>

#include <functional>
#include <utility>
#include <vector>

namespace helios
{

/**
 * Short time windows of every leg, one near the middle of each of its equal parts and each of whole
 * scan lines, are computed and formatted as in a run, and counted instead of written; a leg's sums
 * are scaled by its pulses over those sampled. A leg not much longer than its samples is computed
 * in full; if pulses are slow, samples are fewer, and finally shorter.
 */
class RunEstimate
{
public:
  RunEstimate(LegRunner& runner, double loadSeconds);

  /// Computes the samples. onStep gets the fraction done; false stops it. Returns false then and
  /// after an error.
  bool Make(const std::function<bool(double share)>& onStep);

  /// Describes the estimate: "legs" with pulses, points and bytes; "totals"; for this host
  /// "memory_bytes", "load_s", "run_s".
  Json::Value Describe() const;

private:
  struct Sums
  {
    double Pulses = 0.0;
    double Fired = 0.0;
    double Echoes = 0.0;
    double Bytes = 0.0;
    double Memory = 0.0; // memory of the outputs [bytes]
    double Seconds = 0.0;
  };
  using Window = std::pair<double, double>; // times [s]
  using Windows = std::vector<Window>;

  double GetWanted(const LegPlan& plan) const;
  Windows ChooseWindows(const LegPlan& plan, double affordable) const;
  bool Sample(const LegPlan& plan);
  double GetLongestSampling() const;
  double CountAffordable(const LegPlan& plan, LegScanner& scanner);
  bool SampleWindow(
    const Window& window, LegScanner& scanner, const LegRunner::Outputs& outputs, Sums& sums);
  double CountTrajectoryBytes(const LegPlan& plan) const;
  Sums Scale(const LegPlan& plan, const Sums& sampled) const;
  double GuessMemory(const Sums& totals) const;

  LegRunner& Runner;
  double LoadSeconds;
  std::vector<Sums> Samples; // sums of each leg
  std::vector<Sums> Legs;    // their extrapolations
};

} // namespace helios

#endif
