// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Playback time: play, pause, step and seek.

#ifndef heliosPlayClock_h
#define heliosPlayClock_h

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace helios::viewer
{

/// Runs within a span; at full speed it follows the computed time.
class PlayClock
{
public:
  static constexpr double AsFastAsItComputes = std::numeric_limits<double>::infinity();

  void SetSpan(double start, double end)
  {
    this->Start = start;
    this->End = end;
    this->Time = std::clamp(this->Time, start, end);
  }
  double GetStart() const { return this->Start; }
  double GetEnd() const { return this->End; }

  double GetTime() const { return this->Time; }

  /// Shows another time within the span [s].
  void Seek(double time) { this->Time = std::clamp(time, this->Start, this->End); }

  /// Returns survey seconds per second; 1 is real time.
  double GetSpeed() const { return this->Speed; }
  void SetSpeed(double speed) { this->Speed = speed > 0.0 ? speed : this->Speed; }

  /// Changes to the next of the speeds 0.01, 0.02, 0.05 ... 1000 and full speed; down: a step of
  /// -1.
  void ChangeSpeed(int steps);

  bool IsPlaying() const { return this->Playing; }
  void SetPlaying(bool playing) { this->Playing = playing; }

  /// Returns the time that the simulation must reach now, slightly ahead of the shown time [s].
  double GetTarget() const
  {
    return this->Playing ? this->Time + this->Speed * Lookahead : this->Time;
  }

  /// Advances wall time [s]; echoes exist up to a time [s], nothing later is shown.
  void Advance(double seconds, double available);

private:
  static constexpr double Lookahead = 0.2; // wall time [s]

  double Start = 0.0;
  double End = 0.0;
  double Time = 0.0;
  double Speed = AsFastAsItComputes;
  bool Playing = true;
};

//------------------------------------------------------------------------------
inline void PlayClock::ChangeSpeed(int steps)
{
  constexpr std::array<double, 17> speeds{ 0.01, 0.02, 0.05, 0.1, 0.2, 0.5, 1.0, 2.0, 5.0, 10.0,
    20.0, 50.0, 100.0, 200.0, 500.0, 1000.0, AsFastAsItComputes };
  const auto found = std::lower_bound(speeds.begin(), speeds.end(), this->Speed);
  const auto at = static_cast<int>(found - speeds.begin());
  const int next = std::clamp(at + steps, 0, static_cast<int>(speeds.size()) - 1);
  this->Speed = speeds[static_cast<std::size_t>(next)];
}

//------------------------------------------------------------------------------
inline void PlayClock::Advance(double seconds, double available)
{
  if (!this->Playing)
  {
    return;
  }
  const double wish = std::isinf(this->Speed) ? available : this->Time + this->Speed * seconds;
  // A time sought beyond the available time is kept.
  const double latest = std::max(available, this->Time);
  this->Time = std::clamp(std::min(wish, latest), this->Start, this->End);
}

} // namespace helios::viewer

#endif
