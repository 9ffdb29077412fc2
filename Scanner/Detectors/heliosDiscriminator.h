// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Common functions of the discriminators: a waveform as a function of time.

#ifndef heliosDiscriminator_h
#define heliosDiscriminator_h

#include "vtkHeliosEchoDetector.h"

#include <cmath>

namespace helios
{

/// Returns a sample; 0 if it does not exist or is not finite.
inline double GetSample(const vtkHeliosWaveform& w, vtkIdType i)
{
  const double sample = i >= 0 && i < w.Count ? w.Samples[i] : 0.0;
  return std::isfinite(sample) ? sample : 0.0;
}

/// Returns the waveform at a time [ns], linear between the samples and 0 outside.
inline double Interpolate(const vtkHeliosWaveform& w, double time)
{
  const double bin = std::floor(time / w.BinSize);
  const double share = time / w.BinSize - bin;
  const auto i = static_cast<vtkIdType>(bin);
  return (1.0 - share) * GetSample(w, i) + share * GetSample(w, i + 1);
}

/// Returns the index of the largest of the samples [first, last]; the first of equal ones, -1 if
/// none exists.
inline vtkIdType FindLargest(const vtkHeliosWaveform& w, vtkIdType first, vtkIdType last)
{
  vtkIdType largest = -1;
  for (vtkIdType i = first < 0 ? 0 : first; i <= last && i < w.Count; ++i)
  {
    if (largest < 0 || GetSample(w, i) > GetSample(w, largest))
    {
      largest = i;
    }
  }
  return largest;
}

/// Returns the bins from sample i, in direction step, to where the waveform falls to a level below
/// the sample.
inline double GetDistanceTo(const vtkHeliosWaveform& w, vtkIdType i, int step, double level)
{
  vtkIdType end = i + step;
  while (GetSample(w, end) > level)
  {
    end += step;
  }
  const double above = GetSample(w, end - step);
  const double rest = (above - level) / (above - GetSample(w, end));
  return static_cast<double>(std::abs(end - step - i)) + rest;
}

/// Returns the full width at half the amplitude of a positive sample [ns].
inline double GetFullWidth(const vtkHeliosWaveform& w, vtkIdType i)
{
  const double half = 0.5 * GetSample(w, i);
  return w.BinSize * (GetDistanceTo(w, i, -1, half) + GetDistanceTo(w, i, 1, half));
}

} // namespace helios

#endif
