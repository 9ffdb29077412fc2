// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosRunOptions.h"

#include "heliosMessages.h"
#include "heliosStatus.h"
#include "heliosTolerances.h"
#include "heliosWeather.h"
#include "vtkHeliosBeamSampler.h"
#include "vtkHeliosEchoDetection.h"
#include "vtkHeliosGpsTime.h"

#include <json/value.h>

#include <algorithm>
#include <iterator>
#include <sstream>
#include <tuple>

namespace helios
{

namespace
{

constexpr double LargestBinSize = 1e6; // [ns]

auto Tie(const RunOptions& o)
{
  return std::tie(o.Epoch, o.Seed, o.Noise, o.RangeTolerance, o.EnergyTolerance, o.NumberOfSubRays,
    o.SubRayPattern, o.MaximumSubRays, o.BinSize, o.EchoDetector, o.RayCaster, o.Weather, o.Without,
    o.PulseStep, o.GpsStart);
}

std::vector<std::string> SplitWords(const std::string& text)
{
  std::istringstream stream(text);
  return { std::istream_iterator<std::string>(stream), {} };
}

Status CheckTolerance(const char* name, double value, bool isValid, double least, const char* unit)
{
  if (value == 0.0 || isValid)
  {
    return {};
  }
  Sentence fault;
  fault << name << " is " << value << "; give " << least << " to " << LargestTolerance << unit
        << ", or 0 for the survey's value";
  return Status::Error(fault.str());
}

Status CheckName(const char* name, const std::string& value, const std::vector<std::string>& known)
{
  const bool isKnown = value.empty() || std::find(known.begin(), known.end(), value) != known.end();
  return isKnown
    ? Status()
    : Status::Error(std::string(name) + " is \"" + value + "\"; give " + Enumerate(known));
}

} // namespace

//------------------------------------------------------------------------------
std::vector<std::string> GetEchoDetectorNames()
{
  std::vector<std::string> names;
  for (int i = 0; i < vtkHeliosEchoDetection::GetNumberOfDetectors(); ++i)
  {
    names.emplace_back(vtkHeliosEchoDetection::GetDetectorName(i));
  }
  return names;
}

//------------------------------------------------------------------------------
std::vector<std::string> GetModelPartNames()
{
  return { "divergence", "waveform", "specular", "spectra", "atmosphere", "voxels", "motion",
    "attitude" };
}

//------------------------------------------------------------------------------
std::vector<std::string> GetSubRayPatternNames()
{
  std::vector<std::string> names;
  while (const char* name = vtkHeliosBeamSampler::GetPatternName(static_cast<int>(names.size())))
  {
    names.emplace_back(name);
  }
  return names;
}

//------------------------------------------------------------------------------
bool RunOptions::IsWithout(const std::string& part) const
{
  const std::vector<std::string> words = SplitWords(this->Without);
  return std::find(words.begin(), words.end(), part) != words.end();
}

//------------------------------------------------------------------------------
int RunOptions::GetPattern() const
{
  using Sampler = vtkHeliosBeamSampler;
  const std::vector<std::string> names = GetSubRayPatternNames();
  const auto found = std::find(names.begin(), names.end(), this->SubRayPattern);
  if (found != names.end())
  {
    return static_cast<int>(found - names.begin());
  }
  const int circles = Sampler::FindPatternSize(Sampler::CIRCLES, this->NumberOfSubRays);
  const bool isExact = Sampler::CountSubRays(Sampler::CIRCLES, circles) == this->NumberOfSubRays;
  return isExact ? Sampler::CIRCLES : Sampler::VOGEL;
}

//------------------------------------------------------------------------------
bool RunOptions::operator==(const RunOptions& other) const
{
  return Tie(*this) == Tie(other);
}

//------------------------------------------------------------------------------
Status RunOptions::FindFault() const
{
  Status status = this->CheckSampling();
  status = status.IsOk() ? this->CheckPattern() : status;
  status = status.IsOk() ? this->CheckParts() : status;
  status = status.IsOk() ? this->CheckWeather() : status;
  status = status.IsOk() ? this->CheckGpsStart() : status;
  if (status.IsOk() && !(this->BinSize >= 0.0 && this->BinSize <= LargestBinSize))
  {
    Sentence text;
    text << "BinSize is " << this->BinSize << " ns; give 0 to " << LargestBinSize
         << " ns, 0 for the survey's value";
    status = Status::Error(text.str());
  }
  return status.IsOk() ? CheckName("EchoDetector", this->EchoDetector, GetEchoDetectorNames())
                       : status;
}

//------------------------------------------------------------------------------
/// Tolerances, or a fixed number.
Status RunOptions::CheckSampling() const
{
  Status status = CheckTolerance("RangeTolerance", this->RangeTolerance,
    IsRangeTolerance(this->RangeTolerance), LeastRangeTolerance, " m");
  if (status.IsOk())
  {
    status = CheckTolerance("EnergyTolerance", this->EnergyTolerance,
      IsEnergyTolerance(this->EnergyTolerance), LeastEnergyTolerance, "");
  }
  if (status.IsOk() && this->NumberOfSubRays > 0 &&
    (this->RangeTolerance > 0.0 || this->EnergyTolerance > 0.0))
  {
    status = Status::Error("NumberOfSubRays is " + std::to_string(this->NumberOfSubRays) +
      ", but a tolerance selects adaptive sampling; set one of them to 0");
  }
  if (status.IsOk() && this->MaximumSubRays != 0 && !IsMostSubRays(this->MaximumSubRays))
  {
    status = Status::Error("MaximumSubRays is " + std::to_string(this->MaximumSubRays) + "; give " +
      std::to_string(LeastMostSubRays) + " to " + std::to_string(LargestMostSubRays) +
      ", or 0 for " + std::to_string(DefaultMostSubRays));
  }
  return status;
}

//------------------------------------------------------------------------------
/// The pattern, and whether it has that number of sub-rays.
Status RunOptions::CheckPattern() const
{
  using Sampler = vtkHeliosBeamSampler;
  const std::string& name = this->SubRayPattern;
  const Status status = CheckName("SubRayPattern", name, GetSubRayPatternNames());
  if (!status.IsOk() || name.empty())
  {
    return status;
  }
  if (this->NumberOfSubRays == 0)
  {
    return Status::Error("SubRayPattern is \"" + name +
      "\", but NumberOfSubRays is 0; give a fixed number of sub-rays, too");
  }
  const int pattern = this->GetPattern();
  if (pattern == Sampler::VOGEL)
  {
    return {};
  }
  const int size = Sampler::FindPatternSize(pattern, this->NumberOfSubRays);
  const int count = Sampler::CountSubRays(pattern, size);
  if (count == this->NumberOfSubRays)
  {
    return {};
  }
  Sentence text;
  text << "NumberOfSubRays is " << this->NumberOfSubRays << ", which SubRayPattern \"" << name
       << "\" does not have; give ";
  if (size > 1)
  {
    text << Sampler::CountSubRays(pattern, size - 1) << " or ";
  }
  text << count << ", or the pattern Vogel";
  return Status::Error(text.str());
}

//------------------------------------------------------------------------------
/// What is left out of the model.
Status RunOptions::CheckParts() const
{
  for (const std::string& part : SplitWords(this->Without))
  {
    const Status status = CheckName("Without", part, GetModelPartNames());
    if (!status.IsOk())
    {
      return status;
    }
  }
  return {};
}

//------------------------------------------------------------------------------
Status RunOptions::CheckWeather() const
{
  const Status status = FindWeatherFault(this->Weather);
  return status.IsOk() ? status
                       : Status::Error("Weather is \"" + this->Weather + "\"; " + status.Message());
}

//------------------------------------------------------------------------------
Status RunOptions::CheckGpsStart() const
{
  const std::string fault =
    this->GpsStart.empty() ? std::string() : vtkHeliosGpsTime::GetFault(this->GpsStart);
  return fault.empty() ? Status() : Status::Error("GpsStart=\"" + this->GpsStart + "\" " + fault);
}

//------------------------------------------------------------------------------
void RunOptions::Describe(Json::Value& options) const
{
  options["seed"] = Json::Int64(this->Seed);
  options["noise"] = this->Noise;
  options["rangeTolerance_m"] = this->RangeTolerance;
  options["energyTolerance"] = this->EnergyTolerance;
  options["subRays"] = this->NumberOfSubRays;
  options["maximumSubRays"] = this->MaximumSubRays;
  options["subRayPattern"] = this->SubRayPattern;
  options["binSize_ns"] = this->BinSize;
  options["detector"] = this->EchoDetector;
  options["rayCaster"] = this->RayCaster;
  options["weather"] = this->Weather;
  options["without"] = this->Without;
  options["pulseStep"] = Json::Int64(this->PulseStep);
  if (!this->GpsStart.empty())
  {
    options["gpsStart"] = this->GpsStart;
  }
}

} // namespace helios
