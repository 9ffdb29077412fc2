// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosDetectorOffset.h"

#include "heliosPulseShape.h"
#include "vtkHeliosEchoDetector.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace helios
{
namespace
{

constexpr std::size_t Positions = 8; // within a bin

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
Status ComputeDetectorOffset(
  const vtkHeliosEchoDetector& detector, const PulseShape& shape, double binSize, double& offset)
{
  offset = 0.0;
  const double amplitude = detector.GetCalibrationAmplitude();
  if (shape.IsGaussian() || !(amplitude > 0.0))
  {
    return {};
  }
  const double start = binSize - shape.GetStart();
  const double count = std::ceil((start + shape.GetEnd()) / binSize) + 2.0;
  std::vector<std::vector<float>> samples(
    Positions, std::vector<float>(static_cast<std::size_t>(count)));
  std::vector<vtkHeliosWaveform> waveforms;
  const auto getTime = [start, binSize](std::size_t k)
  { return start + binSize * static_cast<double>(k) / Positions; };
  for (std::size_t k = 0; k < Positions; ++k)
  {
    FillSamples(shape, amplitude, getTime(k), binSize, samples[k]);
    waveforms.push_back(
      { samples[k].data(), static_cast<vtkIdType>(samples[k].size()), binSize, shape.GetLength() });
  }
  std::vector<vtkHeliosEchoDetector::Echoes> echoes(Positions);
  std::string error;
  const bool isDone = detector.DetectAll(waveforms, echoes, error);
  double sum = 0.0;
  int found = 0;
  for (std::size_t k = 0; k < Positions; ++k)
  {
    const auto strongest = std::max_element(echoes[k].begin(), echoes[k].end(),
      [](const auto& a, const auto& b) { return a.Amplitude < b.Amplitude; });
    if (strongest != echoes[k].end())
    {
      sum += strongest->Time - getTime(k);
      ++found;
    }
  }
  offset = found > 0 ? sum / found : 0.0;
  return isDone ? Status() : Status::Error(error);
}

} // namespace helios
