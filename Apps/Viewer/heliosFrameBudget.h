// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// How often to draw, so that drawing leaves the processor to the simulation.

#ifndef heliosFrameBudget_h
#define heliosFrameBudget_h

#include <algorithm>

namespace helios
{

/// While the user does something every frame is drawn; else so few that they take a share of the time.
class FrameBudget
{
public:
  static constexpr double Share = 0.04;     ///< of the time, for drawing while it computes
  static constexpr double Longest = 5.0;    ///< between two frames [s]
  static constexpr double AfterInput = 0.4; ///< that the user is taken to be busy [s]

  /// The user has done something at a time [s].
  void NoteInput(double now) { this->LastInput = now; }

  bool IsBusy(double now) const { return now - this->LastInput < AfterInput; }

  /// A frame was drawn, and took some seconds.
  void NoteFrame(double now, double seconds)
  {
    this->LastFrame = now;
    this->Cost = seconds;
  }

  /// Whether to draw now; is something computed beside?
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

} // namespace helios

#endif
