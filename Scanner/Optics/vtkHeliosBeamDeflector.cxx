// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHeliosBeamDeflector.h"

#include "heliosPhase.h"
#include "heliosVectorLoops.h"

#include <vtkMath.h>

#include <algorithm>
#include <cmath>

//------------------------------------------------------------------------------
bool vtkHeliosBeamDeflector::SetClamped(double& property, double value, double low, double high)
{
  const double clamped = std::min(std::max(low, value), high); // in this order NaN gives low
  if (property == clamped)
  {
    return false;
  }
  property = clamped;
  this->Modified();
  return true;
}

//------------------------------------------------------------------------------
void vtkHeliosBeamDeflector::SetPulseFrequency(double frequency)
{
  this->SetClamped(this->PulseFrequency, frequency, 1e-9, 1e9);
}

//------------------------------------------------------------------------------
void vtkHeliosBeamDeflector::SetWarmUpTime(double time)
{
  this->SetClamped(this->WarmUpTime, time, 0.0, 1e6);
}

//------------------------------------------------------------------------------
double vtkHeliosBeamDeflector::GetScanAngle(vtkIdType pulse) const
{
  double d[3];
  if (!this->GetDirection(pulse, d))
  {
    return 0.0;
  }
  // |d x y| and d . y: exact for small angles, where acos is not.
  return vtkMath::DegreesFromRadians(std::atan2(std::hypot(d[0], d[2]), d[1]));
}

//------------------------------------------------------------------------------
int vtkHeliosBeamDeflector::GetChannel(vtkIdType) const
{
  return 0;
}

//------------------------------------------------------------------------------
double vtkHeliosBeamDeflector::GetDelay(vtkIdType) const
{
  return 0.0;
}

//------------------------------------------------------------------------------
double vtkHeliosBeamDeflector::GetElapsedTime(vtkIdType pulse) const
{
  return helios::PulseTime(0.0, pulse, this->PulseFrequency) + this->GetDelay(pulse);
}

//------------------------------------------------------------------------------
int vtkHeliosBeamDeflector::GetScanDirectionFlag(vtkIdType) const
{
  return 0;
}

//------------------------------------------------------------------------------
bool vtkHeliosBeamDeflector::IsEdgeOfFlightLine(vtkIdType) const
{
  return false;
}

//------------------------------------------------------------------------------
bool vtkHeliosBeamDeflector::GetOrigin(vtkIdType, double[3]) const
{
  return false;
}

//------------------------------------------------------------------------------
void vtkHeliosBeamDeflector::GetCrossAxis(double axis[3]) const
{
  axis[0] = 1.0;
  axis[1] = axis[2] = 0.0;
}

//------------------------------------------------------------------------------
vtkIdType vtkHeliosBeamDeflector::GetColumn(vtkIdType) const
{
  return 0;
}

//------------------------------------------------------------------------------
HELIOS_CLONES
double vtkHeliosBeamDeflector::ComputePhase(vtkIdType pulse, double frequency) const
{
  const double phase = helios::Phase(pulse, frequency, this->PulseFrequency);
  return this->WarmUpTime > 0.0
    ? helios::Fraction(phase + helios::Phase(this->WarmUpTime, frequency))
    : phase;
}

//------------------------------------------------------------------------------
vtkIdType vtkHeliosBeamDeflector::ComputeCount(vtkIdType pulse) const
{
  return pulse + std::llround(this->WarmUpTime * this->PulseFrequency);
}

//------------------------------------------------------------------------------
void vtkHeliosBeamDeflector::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "PulseFrequency: " << this->PulseFrequency << "\n";
  os << indent << "WarmUpTime: " << this->WarmUpTime << "\n";
}
