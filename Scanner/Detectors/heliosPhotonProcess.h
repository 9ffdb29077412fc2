// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// The rate of detections over time, and the time of the next one.

#ifndef heliosPhotonProcess_h
#define heliosPhotonProcess_h

#include "vtkHeliosEchoDetector.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace helios
{

/// A Poisson process whose rate is constant within each bin about its sample.
class PhotonProcess
{
public:
  /// Sets the rates. signalRate: mean counts of a sample of 1 W; darkRate: counts without signal
  /// [1/ns].
  PhotonProcess(const vtkHeliosWaveform& waveform, double signalRate, double darkRate)
    : Waveform(waveform)
    , SignalRate(signalRate)
    , DarkRate(darkRate)
    , Start(waveform.GateStart)
    , Stop(waveform.GateStop)
  {
    if (!(this->Stop > this->Start))
    {
      this->Start = -0.5 * waveform.BinSize;
      this->Stop = (static_cast<double>(waveform.Count) - 0.5) * waveform.BinSize;
    }
  }

  /// Returns the time from which the receiver is armed [ns].
  double GetStart() const { return this->Start; }

  /// Returns the rate of detected photons at a time [1/ns].
  double GetSignal(double time) const
  {
    const double bin = std::floor(time / this->Waveform.BinSize + 0.5);
    return bin >= 0.0 && bin < static_cast<double>(this->Waveform.Count)
      ? this->GetSignal(static_cast<vtkIdType>(bin))
      : 0.0;
  }

  /// Returns the time after a given time by which the mean number of counts grows by a number [ns];
  /// infinite: after the end of the gate.
  double Advance(double time, double counts) const
  {
    const double binSize = this->Waveform.BinSize;
    while (time < this->Stop)
    {
      const auto bin = static_cast<vtkIdType>(std::clamp(
        std::floor(time / binSize + 0.5), -1.0, static_cast<double>(this->Waveform.Count)));
      const bool isIn = bin >= 0 && bin < this->Waveform.Count;
      const double rate = this->DarkRate + (isIn ? this->GetSignal(bin) : 0.0);
      const double next = bin >= this->Waveform.Count
        ? this->Stop
        : std::min(this->Stop, (static_cast<double>(bin) + 0.5) * binSize);
      if (counts <= rate * (next - time))
      {
        return time + counts / rate;
      }
      counts -= rate * std::max(0.0, next - time);
      time = next > time ? next : std::nextafter(time, this->Stop);
    }
    return std::numeric_limits<double>::infinity();
  }

private:
  /// Returns the signal of a bin. Noise may be negative; samples that are not finite count as 0.
  double GetSignal(vtkIdType bin) const
  {
    const double sample = this->Waveform.Samples[bin];
    return std::isfinite(sample) ? this->SignalRate * std::max(0.0, sample) : 0.0;
  }

  const vtkHeliosWaveform& Waveform;
  double SignalRate;
  double DarkRate;
  double Start;
  double Stop;
};

} // namespace helios

#endif
