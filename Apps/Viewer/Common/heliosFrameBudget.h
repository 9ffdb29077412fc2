// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Limits the frame rate, to leave the processor to the simulation.

#ifndef heliosFrameBudget_h
#define heliosFrameBudget_h

#include <algorithm>

namespace helios::viewer
{

/// During user input every frame is drawn; otherwise drawing gets a fraction of the time.
class FrameBudget
{
public:
  static constexpr double Share = 0.04;     ///< share of the time for drawing while computing
  static constexpr double Longest = 5.0;    ///< between two frames [s]
  static constexpr double AfterInput = 0.4; ///< input counts as ongoing [s]

  /// Records user input at a time [s].
  void RecordInput(double now) { this->LastInput = now; }

  bool IsBusy(double now) const { return now - this->LastInput < AfterInput; }

  /// Records a drawn frame and its duration [s].
  void RecordFrame(double now, double seconds)
  {
    this->LastFrame = now;
    this->Cost = seconds;
  }

  /// Returns whether to draw now; isComputing: a computation is running.
  bool IsDue(double now, bool isComputing) const
  {
    const double pause = std::min(Longest, this->Cost / Share);
    return !isComputing || this->IsBusy(now) || now - this->LastFrame >= pause;
  }

private:
  double LastInput = -1e9;
  double LastFrame = -1e9;
  double Cost = 0.0;
};

} // namespace helios::viewer

#endif
