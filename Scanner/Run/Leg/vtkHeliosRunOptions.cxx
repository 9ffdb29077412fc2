// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHeliosRunOptions.h"

#include "heliosMessages.h"
#include "heliosStatus.h"
#include "heliosTolerances.h"
#include "heliosWeather.h"
#include "vtkHeliosBeamSampler.h"
#include "vtkHeliosEchoDetection.h"
#include "vtkHeliosGpsTime.h"
#include "vtkHeliosInstrumentData.h"
#include "vtkHeliosRayCasterFactory.h"

#include <json/value.h>
#include <vtkObjectFactory.h>

#include <algorithm>
#include <iterator>
#include <sstream>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

namespace helios
{

namespace
{

constexpr double LargestBinSize = 1e6; // [ns]

std::vector<std::string> SplitWords(const std::string& text)
{
  std::istringstream stream(text);
  return { std::istream_iterator<std::string>(stream), {} };
}

Status CheckTolerance(
  const char* name, double value, bool isValid, double minimum, const char* unit)
{
  if (value == 0.0 || isValid)
  {
    return {};
  }
  MessageBuilder fault;
  fault << name << " is " << value << "; give " << minimum << " to " << LargestTolerance << unit
        << ", or 0 for the survey's value";
  return Status::Error(fault.str());
}

/// Checks a number of which 0 is that of the survey.
Status CheckCount(const char* name, int value, const vtkHeliosValueRange& range)
{
  if (value == 0 || (value >= range.Low && value <= range.High))
  {
    return {};
  }
  MessageBuilder fault;
  fault << name << " is " << value << "; give " << range.Low << " to " << range.High
        << ", or 0 for the survey's value";
  return Status::Error(fault.str());
}

Status CheckName(const char* name, const std::string& value, const std::vector<std::string>& known)
{
  const bool isKnown = value.empty() || std::find(known.begin(), known.end(), value) != known.end();
  return isKnown
    ? Status()
    : Status::Error(std::string(name) + " is \"" + value + "\"; give " + JoinChoices(known));
}

std::vector<std::string> GetEchoDetectorNames()
{
  std::vector<std::string> names;
  for (int i = 0; i < vtkHeliosEchoDetection::GetNumberOfDetectors(); ++i)
  {
    names.emplace_back(vtkHeliosEchoDetection::GetDetectorName(i));
  }
  return names;
}

std::vector<std::string> GetModelPartNames()
{
  return { "divergence", "waveform", "specular", "spectra", "atmosphere", "voxels", "motion",
    "attitude", "scattering", "partMotion" };
}

std::vector<std::string> GetAccuracyNames()
{
  return { InstrumentAccuracy };
}

std::vector<std::string> GetSubRayPatternNames()
{
  std::vector<std::string> names;
  while (const char* name = vtkHeliosBeamSampler::GetPatternName(static_cast<int>(names.size())))
  {
    names.emplace_back(name);
  }
  return names;
}

std::vector<std::string> GetRayCasterNames()
{
  std::vector<std::string> names;
  for (int i = 0; i < vtkHeliosRayCasterFactory::GetNumberOfBackends(); ++i)
  {
    names.emplace_back(vtkHeliosRayCasterFactory::GetBackendName(i));
  }
  return names;
}

std::string JoinNames(const std::vector<std::string>& names)
{
  std::string joined;
  for (const std::string& name : names)
  {
    joined += (joined.empty() ? "" : " ") + name;
  }
  return joined;
}

/// In run_summary.json.
enum class Listing
{
  Always,
  IfGiven,
  Elsewhere ///< "epoch", in surveys of several epochs, and nothing that changes no echo
};

struct OptionRow
{
  std::variant<int RunOptions::*, vtkIdType RunOptions::*, bool RunOptions::*, double RunOptions::*,
    std::string RunOptions::*>
    Member;
  const char* Property;
  const char* Name;
  const char* Key;
  Listing Listed;
  const char* Title;
  const char* Words;
  const char* Scale;
  const char* Argument;
  const char* Metavar;
  const char* Help;
  std::vector<std::string> (*GetChoices)() = nullptr;
};

/// In the order of the command line's help.
const std::vector<OptionRow>& GetOptionRows()
{
  // clang-format off
  static const std::vector<OptionRow> rows = {
  { &RunOptions::RangeTolerance, "RangeTolerance", "tolerance", "rangeTolerance_m", Listing::Always,
    "range tolerance", "{} mm", "1000", "--range-tolerance", "M",
    "adaptive beam sampling: 95th percentile of the range error [m] (default: the survey's, else 0.001)" },
  { &RunOptions::EnergyTolerance, "EnergyTolerance", "energy_tolerance", "energyTolerance", Listing::Always,
    "energy tolerance", "{} %", "100", "--energy-tolerance", "F",
    "adaptive beam sampling: RMS of the amplitude error, relative to a full footprint, and missed and invented "
    "echoes (default: the survey's, else 0.01)" },
  { &RunOptions::Accuracy, "Accuracy", "accuracy", "accuracy", Listing::IfGiven,
    "accuracy asked for", "{}", "1", "--accuracy", "NAME",
    "adaptive beam sampling: instrument, range errors within a tenth of the range noise of each scanner, "
    "amplitudes within a tenth of its detector noise, at least 1 %%; a tolerance above overrides it; without range "
    "noise the survey's tolerance holds (default: the survey's tolerances)", GetAccuracyNames },
  { &RunOptions::MaximumSubRays, "MaximumSubRays", "max_sub_rays", "maximumSubRays", Listing::Always,
    "maximum of sub-rays per pulse", "{}", "1", "--max-sub-rays", "N",
    "adaptive beam sampling: the most sub-rays of a beam with too many surfaces for visible areas; the end of "
    "a run tells for how many pulses it is not enough (default: 65536)" },
  { &RunOptions::NumberOfSubRays, "NumberOfSubRays", "sub_rays", "subRays", Listing::Always,
    "sub-rays per pulse", "{} (fixed sampling)", "1", "--sub-rays", "N",
    "a fixed number of sub-rays instead: 1, 7, 19, 37, 62 ... on circles, as with beamSampleQuality, other "
    "numbers on a spiral" },
  { &RunOptions::SubRayPattern, "SubRayPattern", "sub_ray_pattern", "subRayPattern", Listing::Always,
    "pattern of sub-rays", "{}", "1", "", "", "", GetSubRayPatternNames },
  { &RunOptions::ScatteringOrders, "ScatteringOrders", "scattering_orders", "scatteringOrders", Listing::IfGiven,
    "scatterings of light", "up to {}", "1", "--scattering-orders", "N",
    "the most scatterings of light on its way back to the receiver: 1, from what the beam meets; 2 and more, over "
    "further surfaces and voxels, drawn at random (default: the survey's, else 1)" },
  { &RunOptions::ScatteringPaths, "ScatteringPaths", "scattering_paths", "scatteringPaths", Listing::IfGiven,
    "paths of scattered light per pulse", "{}", "1", "--scattering-paths", "N",
    "paths of light drawn for each pulse that is scattered more than once; four times as many halve the standard "
    "error (default: the survey's, else 128)" },
  { &RunOptions::BinSize, "BinSize", "bin_size", "binSize_ns", Listing::Always,
    "waveform bins", "{} ns", "1", "", "", "" },
  { &RunOptions::EchoDetector, "EchoDetector", "detector", "detector", Listing::Always,
    "echo detector", "{}", "1", "--detector", "NAME",
    "echo detector: peak (log-parabola), gaussian (decomposition), cfd (constant fraction), leadingEdge, "
    "photonCounting (default: the survey's, else peak)", GetEchoDetectorNames },
  { &RunOptions::GpsStart, "GpsStart", "gps_start", "gpsStart", Listing::IfGiven,
    "start of the survey", "{}", "1", "--gps-start", "TIME",
    "when the survey starts: YYYY-MM-DD hh:mm:ss of UTC, or with a zone (2026-07-01T12:00:00+02:00), Unix "
    "seconds, or GPS seconds as gps:1467000000; LAS then has adjusted standard time (default: the survey's "
    "gpsStartTime, else not known)" },
  { &RunOptions::Weather, "Weather", "weather", "weather", Listing::Always,
    "weather", "{}", "1", "--weather", "TEXT",
    "fog, smoke or dust and the visibility [km], or rain, snow or sleet [mm/h], such as \"fog 0.2\": light is "
    "lost and scattered back (default: the survey's, else none)" },
  { &RunOptions::Seed, "Seed", "seed", "seed", Listing::Always,
    "seed of random numbers", "{}", "", "--seed", "N",
    "seed of all random numbers: the same seed gives byte-identical files, for any number of threads (default: "
    "the survey's, else 0)" },
  { &RunOptions::Noise, "Noise", "noise", "noise", Listing::Always,
    "noise", "on off", "", "--no-noise", "",
    "no noise of ranges, directions, detector, platform and legs" },
  { &RunOptions::AccuracyReport, "AccuracyReport", "accuracy_report", "", Listing::Elsewhere,
    "", "", "", "--no-accuracy-report", "",
    "do not compute 200 to 1000 of the pulses again to measure the accuracy of the run" },
  { &RunOptions::RayCaster, "RayCaster", "ray_caster", "rayCaster", Listing::Always,
    "ray caster asked for", "{}", "1", "--ray-caster", "NAME",
    "ray caster: %(choices)s (default: the survey's rayCaster, else the first); the points are the same "
    "(obbtree: nearly); Docs/ray-casters.md compares their cost", GetRayCasterNames },
  { &RunOptions::Epoch, "Epoch", "epoch", "epoch", Listing::Elsewhere,
    "epoch", "{}", "", "", "", "" },
  { &RunOptions::Without, "Without", "without", "without", Listing::Always,
    "parts of the model left out", "{}", "1", "", "", "" },
  { &RunOptions::PulseStep, "PulseStep", "pulse_step", "pulseStep", Listing::Always,
    "pulses computed", "one of {}", "1", "", "", "" },
  };
  // clang-format on
  return rows;
}

constexpr std::pair<const char*, const char * OptionRow::*> Fields[] = {
  { "property", &OptionRow::Property }, { "name", &OptionRow::Name }, { "key", &OptionRow::Key },
  { "title", &OptionRow::Title }, { "words", &OptionRow::Words }, { "scale", &OptionRow::Scale },
  { "argument", &OptionRow::Argument }, { "metavar", &OptionRow::Metavar },
  { "help", &OptionRow::Help }
};

/// Calls function(member) with the member of a row.
template <typename Function>
auto Visit(const OptionRow& row, Function function)
{
  return std::visit(function, row.Member);
}

} // namespace

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
Status RunOptions::FindFault() const
{
  Status status = this->CheckSampling();
  status = status.IsOk() ? this->CheckAccuracy() : status;
  status = status.IsOk() ? this->CheckPattern() : status;
  status = status.IsOk() ? this->CheckScattering() : status;
  status = status.IsOk() ? this->CheckParts() : status;
  status = status.IsOk() ? this->CheckWeather() : status;
  status = status.IsOk() ? this->CheckGpsStart() : status;
  if (status.IsOk() && !(this->BinSize >= 0.0 && this->BinSize <= LargestBinSize))
  {
    MessageBuilder text;
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
    IsRangeTolerance(this->RangeTolerance), MinimumRangeTolerance, " m");
  if (status.IsOk())
  {
    status = CheckTolerance("EnergyTolerance", this->EnergyTolerance,
      IsEnergyTolerance(this->EnergyTolerance), MinimumEnergyTolerance, "");
  }
  if (status.IsOk() && this->NumberOfSubRays > 0 &&
    (this->RangeTolerance > 0.0 || this->EnergyTolerance > 0.0))
  {
    status = Status::Error("NumberOfSubRays is " + std::to_string(this->NumberOfSubRays) +
      ", but a tolerance selects adaptive sampling; set one of them to 0");
  }
  if (status.IsOk() && this->MaximumSubRays != 0 && !IsSubRayLimit(this->MaximumSubRays))
  {
    status = Status::Error("MaximumSubRays is " + std::to_string(this->MaximumSubRays) + "; give " +
      std::to_string(SmallestSubRayLimit) + " to " + std::to_string(LargestSubRayLimit) +
      ", or 0 for " + std::to_string(DefaultSubRayLimit));
  }
  return status;
}

//------------------------------------------------------------------------------
Status RunOptions::CheckAccuracy() const
{
  if (!this->Accuracy.empty() && this->NumberOfSubRays > 0)
  {
    return Status::Error("NumberOfSubRays is " + std::to_string(this->NumberOfSubRays) +
      ", but Accuracy selects adaptive sampling; leave one of them out");
  }
  return CheckName("Accuracy", this->Accuracy, GetAccuracyNames());
}

//------------------------------------------------------------------------------
Status RunOptions::CheckScattering() const
{
  Status status = CheckCount(
    "ScatteringOrders", this->ScatteringOrders, vtkHeliosInstrumentRanges::ScatteringOrders);
  return status.IsOk() ? CheckCount("ScatteringPaths", this->ScatteringPaths,
                           vtkHeliosInstrumentRanges::ScatteringPaths)
                       : status;
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
  MessageBuilder text;
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
/// Checks the parts of the model that are left out.
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
bool RunOptions::operator==(const RunOptions& other) const
{
  const std::vector<OptionRow>& rows = GetOptionRows();
  return std::all_of(rows.begin(), rows.end(),
    [this, &other](const OptionRow& row)
    {
      return !*row.Key ||
        Visit(row, [this, &other](auto member) { return this->*member == other.*member; });
    });
}

//------------------------------------------------------------------------------
void RunOptions::Describe(Json::Value& options) const
{
  const RunOptions defaults;
  const auto describe = [this](auto member) -> Json::Value
  {
    if constexpr (std::is_same_v<decltype(member), vtkIdType RunOptions::*>)
    {
      return Json::Int64(this->*member);
    }
    else
    {
      return this->*member;
    }
  };
  for (const OptionRow& row : GetOptionRows())
  {
    const bool isGiven =
      Visit(row, [this, &defaults](auto member) { return this->*member != defaults.*member; });
    if (row.Listed == Listing::Always || (row.Listed == Listing::IfGiven && isGiven))
    {
      options[row.Key] = Visit(row, describe);
    }
  }
}

} // namespace helios

vtkStandardNewMacro(vtkHeliosRunOptions);

//------------------------------------------------------------------------------
vtkHeliosRunOptions::vtkHeliosRunOptions() = default;

//------------------------------------------------------------------------------
vtkHeliosRunOptions::~vtkHeliosRunOptions() = default;

//------------------------------------------------------------------------------
int vtkHeliosRunOptions::GetNumberOfOptions()
{
  return static_cast<int>(helios::GetOptionRows().size());
}

//------------------------------------------------------------------------------
std::string vtkHeliosRunOptions::GetOptionText(int option, const std::string& field)
{
  if (option < 0 || option >= GetNumberOfOptions())
  {
    return {};
  }
  const helios::OptionRow& row = helios::GetOptionRows()[static_cast<std::size_t>(option)];
  if (field == "choices" && row.GetChoices)
  {
    return helios::JoinNames(row.GetChoices());
  }
  const auto* found = std::find_if(std::begin(helios::Fields), std::end(helios::Fields),
    [&field](const auto& each) { return each.first == field; });
  return found == std::end(helios::Fields) ? "" : row.*(found->second);
}

//------------------------------------------------------------------------------
double vtkHeliosRunOptions::GetRangeToleranceMinValue() const
{
  return helios::MinimumRangeTolerance;
}

//------------------------------------------------------------------------------
double vtkHeliosRunOptions::GetRangeToleranceMaxValue() const
{
  return helios::LargestTolerance;
}

//------------------------------------------------------------------------------
double vtkHeliosRunOptions::GetEnergyToleranceMinValue() const
{
  return helios::MinimumEnergyTolerance;
}

//------------------------------------------------------------------------------
double vtkHeliosRunOptions::GetEnergyToleranceMaxValue() const
{
  return helios::LargestTolerance;
}

//------------------------------------------------------------------------------
int vtkHeliosRunOptions::GetMaximumSubRaysMinValue() const
{
  return helios::SmallestSubRayLimit;
}

//------------------------------------------------------------------------------
int vtkHeliosRunOptions::GetMaximumSubRaysMaxValue() const
{
  return helios::LargestSubRayLimit;
}

//------------------------------------------------------------------------------
int vtkHeliosRunOptions::GetScatteringOrdersMinValue() const
{
  return static_cast<int>(vtkHeliosInstrumentRanges::ScatteringOrders.Low);
}

//------------------------------------------------------------------------------
int vtkHeliosRunOptions::GetScatteringOrdersMaxValue() const
{
  return static_cast<int>(vtkHeliosInstrumentRanges::ScatteringOrders.High);
}

//------------------------------------------------------------------------------
int vtkHeliosRunOptions::GetScatteringPathsMinValue() const
{
  return static_cast<int>(vtkHeliosInstrumentRanges::ScatteringPaths.Low);
}

//------------------------------------------------------------------------------
int vtkHeliosRunOptions::GetScatteringPathsMaxValue() const
{
  return static_cast<int>(vtkHeliosInstrumentRanges::ScatteringPaths.High);
}

//------------------------------------------------------------------------------
std::string vtkHeliosRunOptions::GetSubRayPatternNames()
{
  return helios::JoinNames(helios::GetSubRayPatternNames());
}

//------------------------------------------------------------------------------
std::string vtkHeliosRunOptions::GetEchoDetectorNames()
{
  return helios::JoinNames(helios::GetEchoDetectorNames());
}

//------------------------------------------------------------------------------
std::string vtkHeliosRunOptions::GetModelPartNames()
{
  return helios::JoinNames(helios::GetModelPartNames());
}

//------------------------------------------------------------------------------
void vtkHeliosRunOptions::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  for (const helios::OptionRow& row : helios::GetOptionRows())
  {
    helios::Visit(row,
      [this, &os, indent, &row](auto member)
      { os << indent << row.Property << ": " << this->*member << "\n"; });
  }
}
