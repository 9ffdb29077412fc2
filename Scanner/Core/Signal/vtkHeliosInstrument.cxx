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
#include <type_traits>
#include <variant>

namespace
{

// The most samples of a waveform: 39 km in bins of 0.25 ns.
constexpr double LongestWaveform = 1 << 20;

using Data = vtkHeliosInstrumentData;

constexpr double Tiny = 1e-300; // for a range open at zero

/// A value that is printed and, if it is a number with a range, checked.
struct InstrumentRow
{
  const char* Name;
  std::variant<double Data::*, int Data::*, std::string Data::*> Member;
  double Low = -VTK_DOUBLE_MAX;
  double High = VTK_DOUBLE_MAX;
  const char* Unit = "";
  const char* Cure = "";
};

// clang-format off
const InstrumentRow Rows[] = {
  { "PulseLength", &Data::PulseLength, 1e-3, 1e6, " ns", "give the full width at half maximum" },
  { "PulseShape", &Data::PulseShape },
  { "PulseFileName", &Data::PulseFile },
  { "BinSize", &Data::BinSize, 1e-4, 1e3, " ns", "use a sixteenth of the pulse length" },
  { "MaximumWaveformLength", &Data::MaximumWaveformLength, 0.0, 1e12, " ns", "0 for no limit" },
  { "NumberOfBins", &Data::NumberOfBins, 0.0, 1e8, "", "0 for no limit" },
  { "AveragePower", &Data::AveragePower, 0.0, 1e12, " W", "give the power of the pulse" },
  { "Wavelength", &Data::Wavelength, 200.0, 20000.0, " nm", "give it in nanometres" },
  { "OpticalEfficiency", &Data::OpticalEfficiency, Tiny, 1.0, "", "give the fraction of the light that passes the optics, above 0" },
  { "ReceiverDiameter", &Data::ReceiverDiameter, Tiny, 100.0, " m", "give the aperture in metres, above 0" },
  { "AtmosphericVisibility", &Data::AtmosphericVisibility, 1e-3, VTK_DOUBLE_MAX, " km", "give kilometres, or VTK_DOUBLE_MAX for no extinction" },
  { "AtmosphericExtinction", &Data::AtmosphericExtinction, -1.0, 1e3, " 1/m", "-1 derives it from AtmosphericVisibility" },
  { "AtmosphericLidarRatio", &Data::AtmosphericLidarRatio, 0.0, 1e6, " sr", "0 for air without backscatter" },
  { "DropletDiameter", &Data::DropletDiameter, 0.0, 0.05, " m", "0 for no single drops" },
  { "Weather", &Data::Weather },
  { "DetectorNoise", &Data::DetectorNoise, 0.0, 1e6, " W", "0 for none" },
  { "SaturationPower", &Data::SaturationPower, 0.0, 1e6, " W", "0 for none" },
  { "SolarIrradiance", &Data::SolarIrradiance, 0.0, 1e6, " W/m^2/nm", "0 for none" },
  { "FilterBandwidth", &Data::FilterBandwidth, 0.0, 1e6, " nm", "1 nm is usual" },
  { "FieldOfView", &Data::FieldOfView, 0.0, 1.0, " rad", "give the full angle" },
  { "RangeAccuracy", &Data::RangeAccuracy, 0.0, 1e3, " m", "0 for none" },
  { "RangeAccuracyPerMeter", &Data::RangeAccuracyPerMeter, 0.0, 1.0, " m/m", "0 for none" },
  { "RangeAccuracyAtThreshold", &Data::RangeAccuracyAtThreshold, 0.0, 1e3, " m", "0 for none" },
  { "AngleAccuracy", &Data::AngleAccuracy, 0.0, 0.1, " rad", "0 for none" },
  { "RangeMin", &Data::RangeMin, 0.0, VTK_DOUBLE_MAX, " m", "0 for no limit" },
  { "RangeMax", &Data::RangeMax, 0.0, VTK_DOUBLE_MAX, " m", "VTK_DOUBLE_MAX for no limit" },
  { "ReturnSelection", &Data::ReturnSelection },
  { "MaximumNumberOfReturns", &Data::MaximumNumberOfReturns },
  { "MTAZone", &Data::MTAZone },
  { "MaximumSpecularEvents", &Data::MaximumSpecularEvents },
  { "LeastSpecularShare", &Data::LeastSpecularShare },
};
// clang-format on

} // namespace

//------------------------------------------------------------------------------
vtkHeliosInstrument::vtkHeliosInstrument() = default;

//------------------------------------------------------------------------------
vtkHeliosInstrument::~vtkHeliosInstrument() = default;

//------------------------------------------------------------------------------
void vtkHeliosInstrument::SetInstrument(const vtkHeliosInstrumentData& values)
{
  static_cast<vtkHeliosInstrumentData&>(*this) = values;
  this->Modified();
}

//------------------------------------------------------------------------------
void vtkHeliosInstrument::SetPulseFileName(const char* fileName)
{
  const std::string name = fileName ? fileName : "";
  if (this->PulseFile != name)
  {
    this->PulseFile = name;
    this->Modified();
  }
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
    helios::Status status = this->PulseFile.empty()
      ? helios::ReadPulse(this->PulseSamples, shape)
      : helios::ReadPulse(this->PulseFile.c_str(), shape);
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
  for (const InstrumentRow& row : Rows)
  {
    const auto toNumber = [this](auto member) -> double
    {
      using ValueT = std::decay_t<decltype(this->*member)>;
      if constexpr (std::is_same_v<ValueT, std::string>)
      {
        return 0.0;
      }
      else
      {
        return this->*member;
      }
    };
    const double value = std::visit(toNumber, row.Member);
    if (!(value >= row.Low && value <= row.High)) // false for NaN, too
    {
      vtkErrorMacro(<< row.Name << " is " << value << row.Unit << ", outside "
                    << (row.Low == Tiny ? "(0" : "[")
                    << (row.Low == Tiny ? "" : std::to_string(row.Low)) << ", " << row.High << "]; "
                    << row.Cure);
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
  if (this->PulseShape == SAMPLED && this->PulseFile.empty() && !this->PulseSamples)
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
  for (const InstrumentRow& row : Rows)
  {
    std::visit([this, &os, indent, &row](auto member)
      { os << indent << row.Name << ": " << this->*member << row.Unit << "\n"; },
      row.Member);
  }
  os << indent << "PulseSamples: " << (this->PulseSamples ? "set" : "(none)") << "\n";
}
