// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHeliosRunOptions.h"

#include "heliosRunOptions.h"
#include "heliosTolerances.h"

#include <vtkObjectFactory.h>

#include <algorithm>

vtkStandardNewMacro(vtkHeliosRunOptions);

namespace
{

constexpr vtkIdType LargestSeed = vtkIdType(1) << 62;
constexpr int MostSubRays = 65536;

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
  std::string names;
  for (const std::string& name : helios::GetEchoDetectorNames())
  {
    names += (names.empty() ? "" : " ") + name;
  }
  return names;
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
     << indent << "EchoDetector: " << this->Data->EchoDetector << "\n"
     << indent << "RayCaster: " << this->Data->RayCaster << "\n";
}
