// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosPeaks.h"

#include "heliosConstants.h"

#include <algorithm>
#include <cmath>

namespace helios
{
namespace
{

double GetMiddle(const Peak& peak)
{
  return 0.5 * static_cast<double>(peak.First + peak.Last);
}

/// Returns whether another maximum within a distance [bins] replaces this one.
bool IsOutdone(
  const float* samples, const std::vector<Peak>& peaks, std::size_t index, double distance)
{
  const Peak& peak = peaks[index];
  const auto counts = [&](std::size_t other)
  {
    const float larger = samples[peaks[other].First];
    return larger > samples[peak.First] || (larger == samples[peak.First] && other < index);
  };
  const auto isNear = [&](std::size_t other)
  { return std::abs(GetMiddle(peaks[other]) - GetMiddle(peak)) < distance; };
  for (std::size_t i = index; i-- > 0 && isNear(i);)
  {
    if (counts(i))
    {
      return true;
    }
  }
  for (std::size_t i = index + 1; i < peaks.size() && isNear(i); ++i)
  {
    if (counts(i))
    {
      return true;
    }
  }
  return false;
}

/// Adds the maxima in a range of bins, regardless of their neighbours.
void AddPeaks(const vtkHeliosWaveform& waveform, double threshold, const BinRange& bins,
  std::vector<Peak>& peaks)
{
  const float* samples = waveform.Samples;
  for (vtkIdType i = bins.First; i < bins.Last;)
  {
    vtkIdType last = i;
    while (last + 1 < bins.Last && samples[last + 1] == samples[i])
    {
      ++last;
    }
    const bool rises = i == bins.First ? samples[i] > 0.0f : samples[i - 1] < samples[i];
    const bool falls = last + 1 == bins.Last || samples[last + 1] < samples[last];
    if (rises && falls && samples[i] > 0.0f && samples[i] >= threshold && std::isfinite(samples[i]))
    {
      peaks.push_back({ i, last });
    }
    i = last + 1;
  }
}

/// A parabola c[0] + c[1] x + c[2] x^2.
struct Parabola
{
  double C[3];
  double operator()(double x) const { return this->C[0] + x * (this->C[1] + x * this->C[2]); }
};

/// Sums for the weighted least squares of a parabola.
struct ParabolaSums
{
  double X[5] = {}; // sums of w x^k
  double Y[3] = {}; // sums of w x^k y

  void Add(double x, double y, double weight)
  {
    for (double& sum : this->X)
    {
      const auto k = &sum - this->X;
      if (k < 3)
      {
        this->Y[k] += weight * y;
      }
      sum += weight;
      weight *= x;
    }
  }

  /// Solves by Cramer's rule; not finite with too few samples.
  Parabola Solve() const
  {
    const double* s = this->X;
    const double* y = this->Y;
    const double m0 = s[2] * s[4] - s[3] * s[3];
    const double m1 = s[2] * s[3] - s[1] * s[4];
    const double m2 = s[1] * s[3] - s[2] * s[2];
    const double m11 = s[0] * s[4] - s[2] * s[2];
    const double m12 = s[1] * s[2] - s[0] * s[3];
    const double m22 = s[0] * s[2] - s[1] * s[1];
    const double det = s[0] * m0 + s[1] * m1 + s[2] * m2;
    return { { (m0 * y[0] + m1 * y[1] + m2 * y[2]) / det,
      (m1 * y[0] + m11 * y[1] + m12 * y[2]) / det, (m2 * y[0] + m12 * y[1] + m22 * y[2]) / det } };
  }
};

} // namespace

//------------------------------------------------------------------------------
void FindPeaks(
  const vtkHeliosWaveform& waveform, double threshold, double separation, std::vector<Peak>& peaks)
{
  const float* samples = waveform.Samples;
  peaks.clear();
  AddPeaks(waveform, threshold, { 0, waveform.Count }, peaks);
  if (separation > 0.0 && peaks.size() > 1)
  {
    static thread_local std::vector<Peak> all;
    all = peaks;
    peaks.clear();
    for (std::size_t i = 0; i < all.size(); ++i)
    {
      if (!IsOutdone(samples, all, i, separation / waveform.BinSize))
      {
        peaks.push_back(all[i]);
      }
    }
  }
}

//------------------------------------------------------------------------------
bool FindPeaks(const vtkHeliosWaveform& waveform, double threshold, const BinRange& bins,
  std::vector<Peak>& peaks)
{
  const float* samples = waveform.Samples;
  peaks.clear();
  if (!(bins.Last - bins.First > 2 && samples[bins.First] < samples[bins.First + 1] &&
        samples[bins.Last - 2] > samples[bins.Last - 1]))
  {
    return false;
  }
  AddPeaks(waveform, threshold, bins, peaks);
  return true;
}

//------------------------------------------------------------------------------
/**
 * Fits a peak in closed form. With n samples, half length r = (n - 1) / 2 and the logarithms a, b
 * of left and right neighbour over the peak, in bins: 1 / sigma^2 = -(a + b) / n, centre s = (b -
 * a) sigma^2 / (2 (r + 1)).
 */
vtkHeliosDetectedEcho FitPeak(const vtkHeliosWaveform& w, const Peak& p)
{
  const double middle = GetMiddle(p);
  const double r = middle - static_cast<double>(p.First);
  const double peak = w.Samples[p.First];
  const double left = p.First > 0 ? w.Samples[p.First - 1] : 0.0;
  const double right = p.Last + 1 < w.Count ? w.Samples[p.Last + 1] : 0.0;
  if (!(left > 0.0 && right > 0.0))
  {
    return { middle * w.BinSize, peak, w.PulseLength };
  }
  const double a = std::log(left / peak);
  const double b = std::log(right / peak);
  const double curvature = -(a + b) / (2.0 * r + 1.0);
  const double s = (b - a) / (2.0 * (r + 1.0) * curvature);
  const bool isFlat = r > 0.5; // no maximum between two samples: clipped at the samples' value
  return { (middle + s) * w.BinSize,
    isFlat ? peak : peak * std::exp(0.5 * curvature * (r * r + s * s)),
    FwhmPerSigma * w.BinSize / std::sqrt(curvature) };
}

//------------------------------------------------------------------------------
/**
 * Fits the parabola through the logarithms, weighted by the square of the amplitude, as for white
 * noise on the samples; then once more with the weights of the parabola found, since the weights of
 * the samples are noisy (Guo 2011, IEEE Signal Process. Mag. 28(5), 134-137).
 */
vtkHeliosDetectedEcho FitPeak(const vtkHeliosWaveform& w, const Peak& p, double reach)
{
  const double middle = GetMiddle(p);
  const double peak = w.Samples[p.First];
  const double bins = reach / w.BinSize;
  const auto first = static_cast<vtkIdType>(std::max(0.0, std::ceil(middle - bins)));
  const auto last =
    static_cast<vtkIdType>(std::min(static_cast<double>(w.Count - 1), std::floor(middle + bins)));
  Parabola parabola{};
  for (int pass = 0; pass < 2; ++pass)
  {
    ParabolaSums sums;
    for (vtkIdType i = first; i <= last; ++i)
    {
      const double sample = w.Samples[i] / peak;
      const double x = (static_cast<double>(i) - middle) / bins;
      if (sample > 0.0 && std::isfinite(sample))
      {
        const double logarithm = std::log(sample);
        sums.Add(x, logarithm, std::exp(2.0 * (pass == 0 ? logarithm : parabola(x))));
      }
    }
    parabola = sums.Solve();
  }
  const double curvature = -2.0 * parabola.C[2];
  const double centre = parabola.C[1] / curvature;
  const double amplitude = peak * std::exp(parabola(centre));
  if (!(curvature > 0.0 && std::abs(centre) <= 1.0 && std::isfinite(amplitude)))
  {
    return FitPeak(w, p);
  }
  return { middle * w.BinSize + centre * reach, amplitude,
    FwhmPerSigma * reach / std::sqrt(curvature) };
}

} // namespace helios
