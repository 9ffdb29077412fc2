// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosWaveSpectrum.h"

#include "heliosConstants.h"
#include "heliosRandom.h"

#include <vtkMath.h>

#include <cmath>

namespace helios
{
namespace
{

constexpr int Frequencies = 40;
constexpr int Directions = 16;

double Square(double x)
{
  return x * x;
}

} // namespace

//------------------------------------------------------------------------------
double GetPeakFrequency(const Wind& wind)
{
  return 22.0 * std::cbrt(Square(StandardGravity) / (wind.Speed * wind.Fetch));
}

//------------------------------------------------------------------------------
double GetWaveEnergy(const Wind& wind, double frequency)
{
  const double w = frequency;
  const double w0 = GetPeakFrequency(wind);
  const double a = 0.076 * std::pow(Square(wind.Speed) / (wind.Fetch * StandardGravity), 0.22);
  const double s = w <= w0 ? 0.07 : 0.09;
  const double peak = std::pow(3.3, std::exp(-Square(w - w0) / (2.0 * Square(s * w0))));
  return a * Square(StandardGravity) / std::pow(w, 5) * std::exp(-1.25 * std::pow(w0 / w, 4)) *
    peak;
}

//------------------------------------------------------------------------------
/// Makes the waves. Frequencies are in equal steps of their logarithm, directions in equal steps of
/// the angle; each wave is at a random place in its step.
WaveField::WaveField(const Wind& wind, double shortest, std::uint64_t seed)
{
  const double last = std::sqrt(2.0 * vtkMath::Pi() * StandardGravity / shortest);
  const double first = 0.6 * GetPeakFrequency(wind);
  if (!(wind.Speed > 0.0) || !(first < last))
  {
    return; // only waves that are shorter
  }
  const double step = std::log(last / first) / Frequencies;
  for (int i = 0; i < Frequencies; ++i)
  {
    for (int j = 0; j < Directions; ++j)
    {
      const auto item = static_cast<std::uint64_t>(Directions * i + j);
      const auto u = Uniform4(seed, RandomStream::Waves, item, 0);
      const double w = first * std::exp(step * (i + u[0]));
      const double angle = vtkMath::Pi() * ((j + u[1]) / Directions - 0.5);
      const double spread = 2.0 / vtkMath::Pi() * Square(std::cos(angle));
      const double energy =
        GetWaveEnergy(wind, w) * spread * (w * step) * (vtkMath::Pi() / Directions);
      const double k = Square(w) / StandardGravity; // deep water
      const double heading = vtkMath::RadiansFromDegrees(wind.Direction) + angle;
      this->Waves.push_back({ k * std::cos(heading), k * std::sin(heading), w,
        2.0 * vtkMath::Pi() * u[2], std::sqrt(2.0 * energy) });
    }
  }
}

//------------------------------------------------------------------------------
double WaveField::GetHeight(double x, double y, double time) const
{
  double height = 0.0;
  for (const Wave& wave : this->Waves)
  {
    height +=
      wave.Amplitude * std::cos(wave.X * x + wave.Y * y - wave.Frequency * time + wave.Phase);
  }
  return height;
}

//------------------------------------------------------------------------------
double WaveField::GetVariance() const
{
  double sum = 0.0;
  for (const Wave& wave : this->Waves)
  {
    sum += 0.5 * Square(wave.Amplitude);
  }
  return sum;
}

//------------------------------------------------------------------------------
double WaveField::GetMeanSquareSlope() const
{
  double sum = 0.0;
  for (const Wave& wave : this->Waves)
  {
    sum += 0.5 * Square(wave.Amplitude) * (Square(wave.X) + Square(wave.Y));
  }
  return sum;
}

} // namespace helios
