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
#include <string>
#include <type_traits>
#include <variant>

namespace
{

// The most samples of a waveform: 39 km in bins of 0.25 ns.
constexpr double LongestWaveform = 1 << 20;

using Data = vtkHeliosInstrumentData;
namespace ranges = vtkHeliosInstrumentRanges;

/// A value that is printed and, if it is a number with a range, checked.
struct InstrumentRow
{
  const char* Name;
  std::variant<double Data::*, int Data::*, std::string Data::*> Member;
  vtkHeliosValueRange Range = { -VTK_DOUBLE_MAX, VTK_DOUBLE_MAX };
  const char* Unit = "";
  const char* Cure = "";
};

// clang-format off
const InstrumentRow Rows[] = {
  { "PulseLength", &Data::PulseLength, ranges::PulseLength, " ns", "give the full width at half maximum" },
  { "PulseShape", &Data::PulseShape },
  { "PulseFileName", &Data::PulseFile },
  { "BinSize", &Data::BinSize, ranges::BinSize, " ns", "use a sixteenth of the pulse length" },
  { "MaximumWaveformLength", &Data::MaximumWaveformLength, ranges::MaximumWaveformLength, " ns", "0 for no limit" },
  { "NumberOfBins", &Data::NumberOfBins, ranges::NumberOfBins, "", "0 for no limit" },
  { "AveragePower", &Data::AveragePower, ranges::AveragePower, " W", "give the power of the pulse" },
  { "Wavelength", &Data::Wavelength, ranges::Wavelength, " nm", "give it in nanometres" },
  { "OpticalEfficiency", &Data::OpticalEfficiency, ranges::OpticalEfficiency, "", "give the fraction of the light that passes the optics, above 0" },
  { "ReceiverDiameter", &Data::ReceiverDiameter, ranges::ReceiverDiameter, " m", "give the aperture in metres, above 0" },
  { "AtmosphericVisibility", &Data::AtmosphericVisibility, ranges::AtmosphericVisibility, " km", "give kilometres, or VTK_DOUBLE_MAX for no extinction" },
  { "AtmosphericExtinction", &Data::AtmosphericExtinction, ranges::AtmosphericExtinction, " 1/m", "-1 derives it from AtmosphericVisibility" },
  { "AtmosphericLidarRatio", &Data::AtmosphericLidarRatio, ranges::AtmosphericLidarRatio, " sr", "0 for air without backscatter" },
  { "DropletDiameter", &Data::DropletDiameter, ranges::DropletDiameter, " m", "0 for no single drops" },
  { "Weather", &Data::Weather },
  { "ScatteringOrders", &Data::ScatteringOrders, ranges::ScatteringOrders, "", "1 for light that is scattered once" },
  { "ScatteringPaths", &Data::ScatteringPaths, ranges::ScatteringPaths, "", "more have a smaller standard error" },
  { "ScatteringPhase", &Data::ScatteringPhase },
  { "DetectorNoise", &Data::DetectorNoise, ranges::DetectorNoise, " W", "0 for none" },
  { "SaturationPower", &Data::SaturationPower, ranges::SaturationPower, " W", "0 for none" },
  { "SolarIrradiance", &Data::SolarIrradiance, ranges::SolarIrradiance, " W/m^2/nm", "0 for none" },
  { "FilterBandwidth", &Data::FilterBandwidth, ranges::FilterBandwidth, " nm", "1 nm is usual" },
  { "FieldOfView", &Data::FieldOfView, ranges::FieldOfView, " rad", "give the full angle" },
  { "RangeAccuracy", &Data::RangeAccuracy, ranges::RangeAccuracy, " m", "0 for none" },
  { "RangeAccuracyPerMeter", &Data::RangeAccuracyPerMeter, ranges::RangeAccuracyPerMeter, " m/m", "0 for none" },
  { "RangeAccuracyAtThreshold", &Data::RangeAccuracyAtThreshold, ranges::RangeAccuracyAtThreshold, " m", "0 for none" },
  { "AngleAccuracy", &Data::AngleAccuracy, ranges::AngleAccuracy, " rad", "0 for none" },
  { "RangeMin", &Data::RangeMin, ranges::Range, " m", "0 for no limit" },
  { "RangeMax", &Data::RangeMax, ranges::Range, " m", "VTK_DOUBLE_MAX for no limit" },
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
    const auto [low, high] = row.Range;
    if (!(value >= low && value <= high)) // false for NaN, too
    {
      const bool isOpen = low == ranges::AboveZero;
      vtkErrorMacro(<< row.Name << " is " << value << row.Unit << ", outside "
                    << (isOpen ? "(0" : "[" + std::to_string(low)) << ", " << high << "]; "
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
