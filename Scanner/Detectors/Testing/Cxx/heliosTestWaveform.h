// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Waveforms in closed form.

#ifndef heliosTestWaveform_h
#define heliosTestWaveform_h

#include "heliosConstants.h"
#include "heliosRandom.h"
#include "vtkHeliosEchoDetector.h"

#include <cmath>
#include <vector>

namespace helios
{
namespace testing
{

constexpr double PulseLength = 4.0; // [ns]
constexpr double PulseSigma = PulseLength / FwhmPerSigma;

struct Gaussian
{
  double Amplitude; // [W]
  double Centre;    // [ns]
  double Sigma = PulseSigma;
};

/// Gaussians in bins, over a background and with white noise.
inline std::vector<float> MakeSamples(const std::vector<Gaussian>& echoes, double bin,
  double length = 60.0, double noise = 0.0, std::uint64_t item = 0, double background = 0.0)
{
  std::vector<float> samples;
  for (std::uint32_t i = 0; i * bin < length; ++i)
  {
    double sum = background;
    for (const Gaussian& g : echoes)
    {
      const double u = (i * bin - g.Centre) / g.Sigma;
      sum += g.Amplitude * std::exp(-0.5 * u * u);
    }
    if (noise > 0.0)
    {
      sum += noise * NormalPair(7, RandomStream::DetectorNoise, item, i)[0];
    }
    samples.push_back(static_cast<float>(sum));
  }
  return samples;
}

inline std::vector<vtkHeliosDetectedEcho> Detect(
  const vtkHeliosEchoDetector* detector, const std::vector<float>& samples, double bin)
{
  std::vector<vtkHeliosDetectedEcho> echoes;
  detector->Detect(
    { samples.data(), static_cast<vtkIdType>(samples.size()), bin, PulseLength }, echoes);
  return echoes;
}

inline bool IsFinite(const vtkHeliosDetectedEcho& echo)
{
  return std::isfinite(echo.Time) && std::isfinite(echo.Amplitude) && std::isfinite(echo.Width);
}

/// Mean and root mean square of errors.
struct ErrorSums
{
  double First = 0.0, Second = 0.0;
  int Count = 0;

  void Add(double error)
  {
    this->First += error;
    this->Second += error * error;
    ++this->Count;
  }
  double GetMean() const { return this->First / this->Count; }
  double GetRms() const { return std::sqrt(this->Second / this->Count); }
};

/// The Cramer-Rao bound for the time of a Gaussian of the pulse's width, SNR = A / noise [ns].
inline double GetTimeBound(double snr, double bin)
{
  return std::sqrt(2.0 * PulseSigma * bin / std::sqrt(std::acos(-1.0))) / snr;
}

} // namespace testing
} // namespace helios

#endif
