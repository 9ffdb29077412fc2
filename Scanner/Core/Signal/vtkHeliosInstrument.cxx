// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHeliosInstrument.h"

#include "heliosPulseShape.h"
#include "heliosPulseTable.h"
#include "heliosRadiometry.h"
#include "heliosStatus.h"
#include "heliosWeather.h"

#include <vtkDataArray.h>
#include <vtkMath.h>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace
{

// The most samples of a waveform: 39 km in bins of 0.25 ns.
constexpr double LongestWaveform = 1 << 20;

} // namespace

//------------------------------------------------------------------------------
vtkHeliosInstrument::vtkHeliosInstrument() = default;

//------------------------------------------------------------------------------
vtkHeliosInstrument::~vtkHeliosInstrument()
{
  this->SetPulseFileName(nullptr);
}

//------------------------------------------------------------------------------
void vtkHeliosInstrument::SetPulseSamples(vtkDataArray* samples)
{
  if (this->PulseSamples != samples)
  {
    this->PulseSamples = samples;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
vtkDataArray* vtkHeliosInstrument::GetPulseSamples() const
{
  return this->PulseSamples;
}

//------------------------------------------------------------------------------
helios::Air vtkHeliosInstrument::ComputeAir() const
{
  const double extinction = this->AtmosphericExtinction >= 0.0
    ? this->AtmosphericExtinction
    : helios::AtmosphericExtinction(this->AtmosphericVisibility, this->Wavelength);
  helios::Air air;
  const bool hasWeather =
    helios::ParseWeather(this->Weather, this->Wavelength, air).IsOk() && air.LidarRatio > 0.0;
  return hasWeather ? air
                    : helios::Air{ extinction, this->AtmosphericLidarRatio, this->DropletDiameter };
}

//------------------------------------------------------------------------------
double vtkHeliosInstrument::ComputeBackground() const
{
  const double solidAngle = 0.25 * vtkMath::Pi() * this->FieldOfView * this->FieldOfView;
  const double aperture = 0.25 * vtkMath::Pi() * this->ReceiverDiameter * this->ReceiverDiameter;
  return this->SolarIrradiance / vtkMath::Pi() * solidAngle * aperture * this->FilterBandwidth *
    this->OpticalEfficiency;
}

//------------------------------------------------------------------------------
vtkIdType vtkHeliosInstrument::CountSamples() const
{
  double count = LongestWaveform;
  if (this->MaximumWaveformLength > 0.0)
  {
    count = std::min(count, std::floor(this->MaximumWaveformLength / this->BinSize) + 1.0);
  }
  if (this->NumberOfBins > 0)
  {
    count = std::min(count, static_cast<double>(this->NumberOfBins));
  }
  return static_cast<vtkIdType>(count);
}

//------------------------------------------------------------------------------
helios::Status vtkHeliosInstrument::MakePulseShape(helios::PulseShape& shape) const
{
  if (this->PulseShape == SAMPLED)
  {
    const bool isFile = this->PulseFileName && *this->PulseFileName;
    helios::Status status = isFile ? helios::ReadPulse(this->PulseFileName, shape)
                                   : helios::ReadPulse(this->PulseSamples, shape);
    if (!status.IsOk())
    {
      return status;
    }
  }
  else
  {
    shape = this->PulseShape == HELIOS ? helios::PulseShape::MakeHelios(this->PulseLength)
                                       : helios::PulseShape::MakeGaussian(this->PulseLength);
  }
  std::ostringstream text;
  const double window = static_cast<double>(this->CountSamples() - 1) * this->BinSize;
  if (this->BinSize > 0.5 * shape.GetLength())
  {
    text << "BinSize is " << this->BinSize << " ns, more than half of the pulse ("
         << shape.GetLength() << " ns): echoes would fall between the bins; use a quarter";
    return helios::Status::Error(text.str());
  }
  if (window < shape.GetLength())
  {
    text << "the waveform is limited to " << window
         << " ns (MaximumWaveformLength, NumberOfBins), less than the pulse (" << shape.GetLength()
         << " ns); raise the limit, or set 0 for none";
    return helios::Status::Error(text.str());
  }
  return {};
}

//------------------------------------------------------------------------------
bool vtkHeliosInstrument::CheckInstrument()
{
  constexpr double tiny = 1e-300; // for a range open at zero
  const struct
  {
    const char* Name;
    double Value, Low, High;
    const char* Unit;
    const char* Cure;
  } properties[] = {
    { "PulseLength", this->PulseLength, 1e-3, 1e6, " ns", "give the full width at half maximum" },
    { "BinSize", this->BinSize, 1e-4, 1e3, " ns", "use a sixteenth of the pulse length" },
    { "MaximumWaveformLength", this->MaximumWaveformLength, 0.0, 1e12, " ns", "0 for no limit" },
    { "NumberOfBins", static_cast<double>(this->NumberOfBins), 0.0, 1e8, "", "0 for no limit" },
    { "AveragePower", this->AveragePower, 0.0, 1e12, " W", "give the power of the pulse" },
    { "Wavelength", this->Wavelength, 200.0, 20000.0, " nm", "give it in nanometres" },
    { "OpticalEfficiency", this->OpticalEfficiency, tiny, 1.0, "",
      "give the fraction of the light that passes the optics, above 0" },
    { "ReceiverDiameter", this->ReceiverDiameter, tiny, 100.0, " m",
      "give the aperture in metres, above 0" },
    { "AtmosphericVisibility", this->AtmosphericVisibility, 1e-3, VTK_DOUBLE_MAX, " km",
      "give kilometres, or VTK_DOUBLE_MAX for no extinction" },
    { "AtmosphericExtinction", this->AtmosphericExtinction, -1.0, 1e3, " 1/m",
      "-1 derives it from AtmosphericVisibility" },
    { "AtmosphericLidarRatio", this->AtmosphericLidarRatio, 0.0, 1e6, " sr",
      "0 for air without backscatter" },
    { "DropletDiameter", this->DropletDiameter, 0.0, 0.05, " m", "0 for no single drops" },
    { "DetectorNoise", this->DetectorNoise, 0.0, 1e6, " W", "0 for none" },
    { "SaturationPower", this->SaturationPower, 0.0, 1e6, " W", "0 for none" },
    { "SolarIrradiance", this->SolarIrradiance, 0.0, 1e6, " W/m^2/nm", "0 for none" },
    { "FilterBandwidth", this->FilterBandwidth, 0.0, 1e6, " nm", "1 nm is usual" },
    { "FieldOfView", this->FieldOfView, 0.0, 1.0, " rad", "give the full angle" },
    { "RangeAccuracy", this->RangeAccuracy, 0.0, 1e3, " m", "0 for none" },
    { "RangeAccuracyPerMeter", this->RangeAccuracyPerMeter, 0.0, 1.0, " m/m", "0 for none" },
    { "RangeAccuracyAtThreshold", this->RangeAccuracyAtThreshold, 0.0, 1e3, " m", "0 for none" },
    { "AngleAccuracy", this->AngleAccuracy, 0.0, 0.1, " rad", "0 for none" },
    { "RangeMin", this->RangeMin, 0.0, VTK_DOUBLE_MAX, " m", "0 for no limit" },
    { "RangeMax", this->RangeMax, 0.0, VTK_DOUBLE_MAX, " m", "VTK_DOUBLE_MAX for no limit" },
  };
  for (const auto& p : properties)
  {
    if (!(p.Value >= p.Low && p.Value <= p.High)) // false for NaN, too
    {
      vtkErrorMacro(<< p.Name << " is " << p.Value << p.Unit << ", outside "
                    << (p.Low == tiny ? "(0" : "[") << (p.Low == tiny ? "" : std::to_string(p.Low))
                    << ", " << p.High << "]; " << p.Cure);
      return false;
    }
  }
  helios::Air air;
  const helios::Status weather = helios::ParseWeather(this->Weather, this->Wavelength, air);
  if (!weather.IsOk())
  {
    vtkErrorMacro(<< "Weather is \"" << this->Weather << "\"; " << weather.Message());
    return false;
  }
  if (this->RangeMax <= this->RangeMin)
  {
    vtkErrorMacro(<< "RangeMax (" << this->RangeMax << " m) is not greater than RangeMin ("
                  << this->RangeMin << " m)");
    return false;
  }
  if (this->PulseShape == SAMPLED && (!this->PulseFileName || !*this->PulseFileName) &&
    !this->PulseSamples)
  {
    vtkErrorMacro(<< "PulseShape is SAMPLED and PulseFileName is not set; give a file with a time "
                     "[ns] and a power per line, or such rows as PulseSamples");
    return false;
  }
  return true;
}

//------------------------------------------------------------------------------
void vtkHeliosInstrument::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "PulseLength: " << this->PulseLength << " ns\n"
     << indent << "PulseShape: " << this->PulseShape << "\n"
     << indent << "PulseFileName: " << (this->PulseFileName ? this->PulseFileName : "(none)")
     << "\n"
     << indent << "PulseSamples: " << (this->PulseSamples ? "set" : "(none)") << "\n"
     << indent << "BinSize: " << this->BinSize << " ns\n"
     << indent << "MaximumWaveformLength: " << this->MaximumWaveformLength << " ns\n"
     << indent << "NumberOfBins: " << this->NumberOfBins << "\n"
     << indent << "AveragePower: " << this->AveragePower << " W\n"
     << indent << "Wavelength: " << this->Wavelength << " nm\n"
     << indent << "OpticalEfficiency: " << this->OpticalEfficiency << "\n"
     << indent << "ReceiverDiameter: " << this->ReceiverDiameter << " m\n"
     << indent << "AtmosphericVisibility: " << this->AtmosphericVisibility << " km\n"
     << indent << "AtmosphericExtinction: " << this->AtmosphericExtinction << " 1/m\n"
     << indent << "AtmosphericLidarRatio: " << this->AtmosphericLidarRatio << " sr\n"
     << indent << "DropletDiameter: " << this->DropletDiameter << " m\n"
     << indent << "Weather: " << this->Weather << "\n"
     << indent << "DetectorNoise: " << this->DetectorNoise << " W\n"
     << indent << "SaturationPower: " << this->SaturationPower << " W\n"
     << indent << "SolarIrradiance: " << this->SolarIrradiance << " W/m^2/nm\n"
     << indent << "FilterBandwidth: " << this->FilterBandwidth << " nm\n"
     << indent << "FieldOfView: " << this->FieldOfView << " rad\n"
     << indent << "RangeAccuracy: " << this->RangeAccuracy << " m\n"
     << indent << "RangeAccuracyPerMeter: " << this->RangeAccuracyPerMeter << "\n"
     << indent << "RangeAccuracyAtThreshold: " << this->RangeAccuracyAtThreshold << " m\n"
     << indent << "AngleAccuracy: " << this->AngleAccuracy << " rad\n"
     << indent << "RangeMin: " << this->RangeMin << " m\n"
     << indent << "RangeMax: " << this->RangeMax << " m\n"
     << indent << "ReturnSelection: " << this->ReturnSelection << "\n"
     << indent << "MaximumNumberOfReturns: " << this->MaximumNumberOfReturns << "\n";
}
