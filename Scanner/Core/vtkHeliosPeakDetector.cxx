// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHeliosPeakDetector.h"

#include <vtkObjectFactory.h>

#include <cmath>

vtkStandardNewMacro(vtkHeliosPeakDetector);

namespace
{

constexpr double FwhmPerSigma = 2.3548200450309493;

/**
 * The echo of a maximum that holds samples first to last (more than one: a plateau): the Gaussian
 * through the plateau's ends and its neighbours. With n samples, half length r = (n - 1) / 2 and
 * the logarithms a, b of left and right neighbour over the peak, in bins:
 * 1 / sigma^2 = -(a + b) / n, centre s = (b - a) sigma^2 / (2 (r + 1)).
 */
vtkHeliosDetectedEcho FitPeak(const vtkHeliosWaveform& w, vtkIdType first, vtkIdType last)
{
  const double middle = 0.5 * static_cast<double>(first + last);
  const double r = middle - static_cast<double>(first);
  const double peak = w.Samples[first];
  const double left = first > 0 ? w.Samples[first - 1] : 0.0;
  const double right = last + 1 < w.Count ? w.Samples[last + 1] : 0.0;
  if (!(left > 0.0 && right > 0.0))
  {
    return { middle * w.BinSize, peak, w.PulseLength };
  }
  const double a = std::log(left / peak);
  const double b = std::log(right / peak);
  const double curvature = -(a + b) / (2.0 * r + 1.0);
  const double s = (b - a) / (2.0 * (r + 1.0) * curvature);
  return { (middle + s) * w.BinSize, peak * std::exp(0.5 * curvature * (r * r + s * s)),
    FwhmPerSigma * w.BinSize / std::sqrt(curvature) };
}

} // namespace

//------------------------------------------------------------------------------
void vtkHeliosPeakDetector::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
}

//------------------------------------------------------------------------------
void vtkHeliosPeakDetector::Detect(
  const vtkHeliosWaveform& waveform, std::vector<vtkHeliosDetectedEcho>& echoes) const
{
  const float* samples = waveform.Samples;
  for (vtkIdType i = 0; i < waveform.Count;)
  {
    vtkIdType last = i;
    while (last + 1 < waveform.Count && samples[last + 1] == samples[i])
    {
      ++last;
    }
    const bool rises = i == 0 ? samples[i] > 0.0f : samples[i - 1] < samples[i];
    const bool falls = last + 1 == waveform.Count || samples[last + 1] < samples[last];
    if (rises && falls && samples[i] > 0.0f && samples[i] >= this->DetectionThreshold)
    {
      echoes.push_back(FitPeak(waveform, i, last));
    }
    i = last + 1;
  }
}
