// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHeliosPhotonCountingDetector.h"

#include "heliosConstants.h"
#include "heliosPhotonProcess.h"
#include "heliosRandom.h"

#include <vtkMath.h>
#include <vtkObjectFactory.h>

#include <algorithm>
#include <cmath>
#include <limits>

vtkStandardNewMacro(vtkHeliosPhotonCountingDetector);

namespace
{

constexpr std::uint32_t MaximumCounts = 255; // ReturnNumber has 8 bits

/// Returns the energy of a photon [J] of a wavelength [nm].
double GetPhotonEnergy(double wavelength)
{
  return helios::PlanckConstant * helios::SpeedOfLight / (1e-9 * wavelength) *
    helios::NanosecondsPerSecond;
}

} // namespace

//------------------------------------------------------------------------------
void vtkHeliosPhotonCountingDetector::SetInstrument(const vtkHeliosInstrumentData& instrument)
{
  this->Superclass::SetInstrument(instrument);
  this->SetWavelength(instrument.Wavelength);
  this->SetDetectionEfficiency(instrument.PhotonEfficiency);
  this->SetDarkCountRate(instrument.DarkCountRate);
  this->SetTimeJitter(instrument.TimeJitter);
}

//------------------------------------------------------------------------------
void vtkHeliosPhotonCountingDetector::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "DetectionEfficiency: " << this->DetectionEfficiency << "\n"
     << indent << "Wavelength: " << this->Wavelength << " nm\n"
     << indent << "DarkCountRate: " << this->DarkCountRate << " Hz\n"
     << indent << "TimeJitter: " << this->TimeJitter << " ns\n";
}

//------------------------------------------------------------------------------
/**
 * Draws the detections. The counts between two of them are exponentially distributed with the mean
 * 1: the next one is where the integral of the rate, from the end of the dead time, has grown by
 * such a number.
 */
void vtkHeliosPhotonCountingDetector::Detect(
  const vtkHeliosWaveform& w, std::vector<vtkHeliosDetectedEcho>& echoes) const
{
  const double perJoule = this->DetectionEfficiency / GetPhotonEnergy(this->Wavelength);
  const double perWatt = perJoule / helios::NanosecondsPerSecond; // in a nanosecond
  const double dark = this->DarkCountRate / helios::NanosecondsPerSecond;
  const helios::PhotonProcess process(w, perWatt, dark);
  const double amplitude = perWatt > 0.0 ? 1.0 / (perWatt * w.PulseLength) : 0.0;
  const std::size_t before = echoes.size();
  double time = process.GetStart();
  for (std::uint32_t count = 0; count < MaximumCounts; ++count)
  {
    const auto random =
      helios::Uniform4(w.Seed, helios::RandomStream::PhotonCounts, w.PulseId, count);
    time = process.Advance(time, -std::log(random[0]));
    if (!(time < std::numeric_limits<double>::infinity()))
    {
      break;
    }
    const double signal = process.GetSignal(time);
    const double jitter = this->TimeJitter * std::sqrt(-2.0 * std::log(random[2])) *
      std::cos(2.0 * vtkMath::Pi() * random[3]); // Box and Muller
    vtkHeliosDetectedEcho echo{ time + jitter, amplitude, w.PulseLength };
    echo.IsDark = random[1] * (signal + dark) >= signal;
    echoes.push_back(echo);
    time += this->DeadTime;
  }
  std::stable_sort(echoes.begin() + static_cast<std::ptrdiff_t>(before), echoes.end(),
    [](const vtkHeliosDetectedEcho& a, const vtkHeliosDetectedEcho& b) { return a.Time < b.Time; });
}
