// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosRunOptions.h"

#include "heliosMessages.h"
#include "heliosStatus.h"
#include "heliosTolerances.h"
#include "vtkHeliosEchoDetection.h"

#include <json/value.h>

#include <algorithm>
#include <tuple>

namespace helios
{

namespace
{

auto Tie(const RunOptions& o)
{
  return std::tie(o.Epoch, o.Seed, o.Noise, o.RangeTolerance, o.EnergyTolerance, o.NumberOfSubRays,
    o.EchoDetector, o.RayCaster);
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
bool RunOptions::operator==(const RunOptions& other) const
{
  return Tie(*this) == Tie(other);
}

//------------------------------------------------------------------------------
Status RunOptions::FindFault() const
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
  return status.IsOk() ? CheckName("EchoDetector", this->EchoDetector, GetEchoDetectorNames())
                       : status;
}

//------------------------------------------------------------------------------
void RunOptions::Describe(Json::Value& options) const
{
  options["seed"] = Json::Int64(this->Seed);
  options["noise"] = this->Noise;
  options["rangeTolerance_m"] = this->RangeTolerance;
  options["energyTolerance"] = this->EnergyTolerance;
  options["subRays"] = this->NumberOfSubRays;
  options["detector"] = this->EchoDetector;
  options["rayCaster"] = this->RayCaster;
}

} // namespace helios
