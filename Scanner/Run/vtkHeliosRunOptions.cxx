// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHeliosRunOptions.h"

#include "heliosRunOptions.h"
#include "heliosTolerances.h"

#include <vtkObjectFactory.h>

#include <algorithm>
#include <string>
#include <vector>

vtkStandardNewMacro(vtkHeliosRunOptions);

namespace
{

constexpr vtkIdType LargestSeed = vtkIdType(1) << 62;
constexpr vtkIdType LargestStep = vtkIdType(1) << 53;
constexpr int MostSubRays = 65536;

std::string JoinNames(const std::vector<std::string>& names)
{
  std::string joined;
  for (const std::string& name : names)
  {
    joined += (joined.empty() ? "" : " ") + name;
  }
  return joined;
}

} // namespace

//------------------------------------------------------------------------------
vtkHeliosRunOptions::vtkHeliosRunOptions()
  : Data(new helios::RunOptions)
{
}

//------------------------------------------------------------------------------
vtkHeliosRunOptions::~vtkHeliosRunOptions() = default;

//------------------------------------------------------------------------------
template <typename T>
void vtkHeliosRunOptions::Set(T& option, const T& value)
{
  if (option != value)
  {
    option = value;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkHeliosRunOptions::SetEpoch(int epoch)
{
  this->Set(this->Data->Epoch, std::max(0, epoch));
}

//------------------------------------------------------------------------------
int vtkHeliosRunOptions::GetEpoch() const
{
  return this->Data->Epoch;
}

//------------------------------------------------------------------------------
void vtkHeliosRunOptions::SetSeed(vtkIdType seed)
{
  this->Set(this->Data->Seed, std::clamp<vtkIdType>(seed, -1, LargestSeed));
}

//------------------------------------------------------------------------------
vtkIdType vtkHeliosRunOptions::GetSeed() const
{
  return this->Data->Seed;
}

//------------------------------------------------------------------------------
vtkIdType vtkHeliosRunOptions::GetSeedMaxValue() const
{
  return LargestSeed;
}

//------------------------------------------------------------------------------
void vtkHeliosRunOptions::SetNoise(bool noise)
{
  this->Set(this->Data->Noise, noise);
}

//------------------------------------------------------------------------------
bool vtkHeliosRunOptions::GetNoise() const
{
  return this->Data->Noise;
}

//------------------------------------------------------------------------------
void vtkHeliosRunOptions::SetRangeTolerance(double tolerance)
{
  this->Set(this->Data->RangeTolerance, tolerance);
}

//------------------------------------------------------------------------------
double vtkHeliosRunOptions::GetRangeTolerance() const
{
  return this->Data->RangeTolerance;
}

//------------------------------------------------------------------------------
double vtkHeliosRunOptions::GetRangeToleranceMinValue() const
{
  return helios::LeastRangeTolerance;
}

//------------------------------------------------------------------------------
double vtkHeliosRunOptions::GetRangeToleranceMaxValue() const
{
  return helios::LargestTolerance;
}

//------------------------------------------------------------------------------
void vtkHeliosRunOptions::SetEnergyTolerance(double tolerance)
{
  this->Set(this->Data->EnergyTolerance, tolerance);
}

//------------------------------------------------------------------------------
double vtkHeliosRunOptions::GetEnergyTolerance() const
{
  return this->Data->EnergyTolerance;
}

//------------------------------------------------------------------------------
double vtkHeliosRunOptions::GetEnergyToleranceMinValue() const
{
  return helios::LeastEnergyTolerance;
}

//------------------------------------------------------------------------------
double vtkHeliosRunOptions::GetEnergyToleranceMaxValue() const
{
  return helios::LargestTolerance;
}

//------------------------------------------------------------------------------
void vtkHeliosRunOptions::SetNumberOfSubRays(int count)
{
  this->Set(this->Data->NumberOfSubRays, std::clamp(count, 0, MostSubRays));
}

//------------------------------------------------------------------------------
int vtkHeliosRunOptions::GetNumberOfSubRays() const
{
  return this->Data->NumberOfSubRays;
}

//------------------------------------------------------------------------------
int vtkHeliosRunOptions::GetNumberOfSubRaysMaxValue() const
{
  return MostSubRays;
}

//------------------------------------------------------------------------------
void vtkHeliosRunOptions::SetSubRayPattern(const std::string& name)
{
  this->Set(this->Data->SubRayPattern, name);
}

//------------------------------------------------------------------------------
std::string vtkHeliosRunOptions::GetSubRayPattern() const
{
  return this->Data->SubRayPattern;
}

//------------------------------------------------------------------------------
std::string vtkHeliosRunOptions::GetSubRayPatternNames()
{
  return JoinNames(helios::GetSubRayPatternNames());
}

//------------------------------------------------------------------------------
void vtkHeliosRunOptions::SetMaximumSubRays(int count)
{
  this->Set(this->Data->MaximumSubRays, count);
}

//------------------------------------------------------------------------------
int vtkHeliosRunOptions::GetMaximumSubRays() const
{
  return this->Data->MaximumSubRays;
}

//------------------------------------------------------------------------------
int vtkHeliosRunOptions::GetMaximumSubRaysMinValue() const
{
  return helios::LeastMostSubRays;
}

//------------------------------------------------------------------------------
int vtkHeliosRunOptions::GetMaximumSubRaysMaxValue() const
{
  return helios::LargestMostSubRays;
}

//------------------------------------------------------------------------------
void vtkHeliosRunOptions::SetBinSize(double size)
{
  this->Set(this->Data->BinSize, size);
}

//------------------------------------------------------------------------------
double vtkHeliosRunOptions::GetBinSize() const
{
  return this->Data->BinSize;
}

//------------------------------------------------------------------------------
void vtkHeliosRunOptions::SetGpsStart(const std::string& start)
{
  this->Set(this->Data->GpsStart, start);
}

//------------------------------------------------------------------------------
std::string vtkHeliosRunOptions::GetGpsStart() const
{
  return this->Data->GpsStart;
}

//------------------------------------------------------------------------------
void vtkHeliosRunOptions::SetWeather(const std::string& weather)
{
  this->Set(this->Data->Weather, weather);
}

//------------------------------------------------------------------------------
std::string vtkHeliosRunOptions::GetWeather() const
{
  return this->Data->Weather;
}

//------------------------------------------------------------------------------
void vtkHeliosRunOptions::SetWithout(const std::string& parts)
{
  this->Set(this->Data->Without, parts);
}

//------------------------------------------------------------------------------
std::string vtkHeliosRunOptions::GetWithout() const
{
  return this->Data->Without;
}

//------------------------------------------------------------------------------
std::string vtkHeliosRunOptions::GetModelPartNames()
{
  return JoinNames(helios::GetModelPartNames());
}

//------------------------------------------------------------------------------
void vtkHeliosRunOptions::SetPulseStep(vtkIdType step)
{
  this->Set(this->Data->PulseStep, std::clamp<vtkIdType>(step, 1, LargestStep));
}

//------------------------------------------------------------------------------
vtkIdType vtkHeliosRunOptions::GetPulseStep() const
{
  return this->Data->PulseStep;
}

//------------------------------------------------------------------------------
void vtkHeliosRunOptions::SetAccuracyReport(bool report)
{
  this->Set(this->Data->AccuracyReport, report);
}

//------------------------------------------------------------------------------
bool vtkHeliosRunOptions::GetAccuracyReport() const
{
  return this->Data->AccuracyReport;
}

//------------------------------------------------------------------------------
void vtkHeliosRunOptions::SetEchoDetector(const std::string& name)
{
  this->Set(this->Data->EchoDetector, name);
}

//------------------------------------------------------------------------------
std::string vtkHeliosRunOptions::GetEchoDetector() const
{
  return this->Data->EchoDetector;
}

//------------------------------------------------------------------------------
std::string vtkHeliosRunOptions::GetEchoDetectorNames()
{
  return JoinNames(helios::GetEchoDetectorNames());
}

//------------------------------------------------------------------------------
void vtkHeliosRunOptions::SetRayCaster(const std::string& name)
{
  this->Set(this->Data->RayCaster, name);
}

//------------------------------------------------------------------------------
std::string vtkHeliosRunOptions::GetRayCaster() const
{
  return this->Data->RayCaster;
}

//------------------------------------------------------------------------------
void vtkHeliosRunOptions::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Epoch: " << this->Data->Epoch << "\n"
     << indent << "Seed: " << this->Data->Seed << "\n"
     << indent << "Noise: " << this->Data->Noise << "\n"
     << indent << "RangeTolerance: " << this->Data->RangeTolerance << "\n"
     << indent << "EnergyTolerance: " << this->Data->EnergyTolerance << "\n"
     << indent << "NumberOfSubRays: " << this->Data->NumberOfSubRays << "\n"
     << indent << "MaximumSubRays: " << this->Data->MaximumSubRays << "\n"
     << indent << "SubRayPattern: " << this->Data->SubRayPattern << "\n"
     << indent << "BinSize: " << this->Data->BinSize << "\n"
     << indent << "EchoDetector: " << this->Data->EchoDetector << "\n"
     << indent << "RayCaster: " << this->Data->RayCaster << "\n"
     << indent << "GpsStart: " << this->Data->GpsStart << "\n"
     << indent << "Weather: " << this->Data->Weather << "\n"
     << indent << "Without: " << this->Data->Without << "\n"
     << indent << "PulseStep: " << this->Data->PulseStep << "\n"
     << indent << "AccuracyReport: " << this->Data->AccuracyReport << "\n";
}
