// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Time and errors of a run at several tolerances and numbers of sub-rays, from a sample of its pulses.

#ifndef heliosRunForecast_h
#define heliosRunForecast_h

#include "heliosEchoComparison.h"
#include "heliosLegRunner.h"
#include "heliosStatus.h"
#include "vtkHeliosScannerRunModule.h" // For export macro

#include <json/value.h>

#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace helios
{

/// Makes times fall with wider tolerances: neighbours in another order, which noise of the clock
/// explains, get their mean (isotonic regression by pooling).
VTKHELIOSSCANNERRUN_EXPORT void MakeFalling(std::vector<double>& times);

/**
 * Some pulses all over the run, one of each some hundred or thousand, are computed in several ways and by a reference,
 * adaptive sampling at 0.1 mm and 0.1 % in fine bins; noise and turbid voxels are left out. Their processor time gives
 * that of the run. There are as many of them as the time and the pulses allow, from equal parts of the run in an order
 * that spreads them if that time ends early.
 */
class VTKHELIOSSCANNERRUN_EXPORT RunForecast
{
public:
  using StepWatcher = std::function<bool(double share)>;

  /// How much is computed.
  struct Effort
  {
    bool IsFull = false;         ///< all ways, not only those of a line of text
    double Seconds = 1.0;        ///< the most, of processor time
    double ShareOfPulses = 0.02; ///< largest share of the pulses of the run, and of its time
    double ShortestRun = 2.0;    ///< no forecast of shorter ones [s]
  };
  static Effort MakeEffort(bool isFull);

  RunForecast(LegRunner& runner, const RunSettings& settings, Messages& log);

  /// Computes the sample. onStep gets the fraction done; false stops it.
  void Measure(const Effort& effort, const StepWatcher& onStep);

  /// Returns the sample's "pulses" and "pulsesComputed" in all ways, and "ways", each with its "options",
  /// "us_per_pulse", "run_s" and, as value and ends of its interval, the errors of EchoMeasures; the
  /// "reference". Or the "reason" why there is none. A wider tolerance does not cost more.
  Json::Value Describe() const;

private:
  struct Way
  {
    RunOptions Options;
    std::unique_ptr<LegScanner> Scanner;
    const LegPlan* Plan = nullptr; ///< leg that the scanner is set up for
    double Idle = 0.0;             ///< processor time of no pulse [s]
    double Seconds = 0.0;          ///< time of its windows without their heads [s]
    double Whole = 0.0;            ///< time of its windows [s]
    EchoComparison Errors;
  };
  struct Window
  {
    const LegPlan* Plan;
    vtkIdType First; ///< pulses of a channel, in the leg
    vtkIdType Last;
  };

  void AddWay(double rangeTolerance, int subRays);
  Window FindWindow(int index) const;
  void SetPulses(double pulses, Way& way);
  double TimePulse(double most);
  bool ChoosePulses(const Effort& effort);
  double FireWindow(Way& way, const Window& window);
  bool AddWindow(const Window& window);
  std::vector<double> FindTimes(bool isFixed) const;
  Status AddErrors(Way& way, const Window& window);
  bool IsLate() const;

  LegRunner& Runner;
  const RunSettings& Settings;
  Messages& Log;
  StepWatcher OnStep;
  std::vector<Way> Ways; // the last one is the reference
  vtkIdType Pulses = 0;  // pulses of all windows, computed or not
  vtkIdType Step = 1;    // one of that many pulses is computed
  vtkIdType PulsesFired = 0;
  vtkIdType PulsesTimed = 0; // those without the heads of windows
  vtkIdType PulsesComputed = 0;
  double Latest = 0.0; // processor time of the end [s]
  bool IsStopped = false;
  std::string Reason;
};

} // namespace helios

#endif
