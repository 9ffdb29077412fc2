// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosDetectorOffset.h"

#include "heliosPulseShape.h"
#include "vtkHeliosEchoDetector.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace helios
{
namespace
{

constexpr int Positions = 8; // within a bin

/// Fills samples of the pulse with its peak at a time [ns].
void FillSamples(const PulseShape& shape, double amplitude, double time, double binSize,
  std::vector<float>& samples)
{
  for (std::size_t i = 0; i < samples.size(); ++i)
  {
    const double power = amplitude * shape(static_cast<double>(i) * binSize - time);
    samples[i] = static_cast<float>(power);
  }
}

} // namespace

//------------------------------------------------------------------------------
double ComputeDetectorOffset(
  const vtkHeliosEchoDetector& detector, const PulseShape& shape, double binSize)
{
  const double amplitude = detector.GetCalibrationAmplitude();
  if (shape.IsGaussian() || !(amplitude > 0.0))
  {
    return 0.0;
  }
  const double start = binSize - shape.GetStart();
  const double count = std::ceil((start + shape.GetEnd()) / binSize) + 2.0;
  std::vector<float> samples(static_cast<std::size_t>(count));
  std::vector<vtkHeliosDetectedEcho> echoes;
  double sum = 0.0;
  int found = 0;
  for (int k = 0; k < Positions; ++k)
  {
    const double time = start + binSize * k / Positions;
    FillSamples(shape, amplitude, time, binSize, samples);
    echoes.clear();
    detector.Detect(
      { samples.data(), static_cast<vtkIdType>(samples.size()), binSize, shape.GetLength() },
      echoes);
    const auto strongest = std::max_element(echoes.begin(), echoes.end(),
      [](const auto& a, const auto& b) { return a.Amplitude < b.Amplitude; });
    if (strongest != echoes.end())
    {
      sum += strongest->Time - time;
      ++found;
    }
  }
  return found > 0 ? sum / found : 0.0;
}

} // namespace helios
