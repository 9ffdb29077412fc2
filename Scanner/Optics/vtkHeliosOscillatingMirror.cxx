// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHeliosOscillatingMirror.h"

#include <vtkMath.h>
#include <vtkObjectFactory.h>

#include <algorithm>
#include <cmath>

vtkStandardNewMacro(vtkHeliosOscillatingMirror);

//------------------------------------------------------------------------------
void vtkHeliosOscillatingMirror::SetScanAngle(double angle)
{
  this->SetClamped(this->ScanAngle, angle, 0.0, 180.0);
}

//------------------------------------------------------------------------------
// The fraction of a line completed after a fraction of its time, both from 0 to 1.
double vtkHeliosOscillatingMirror::ComputeTravel(double time) const
{
  // T / 2 of the PulseFrequency / (2 ScanFrequency) pulses of a line
  const double turn =
    std::min(0.5, this->TurningPulses * this->ScanFrequency / this->PulseFrequency);
  const double end = std::min(time, 1.0 - time);
  if (end >= turn)
  {
    return (time - 0.5 * turn) / (1.0 - turn);
  }
  const double travel = 0.5 * end * end / (turn * (1.0 - turn)); // constant acceleration
  return time < 0.5 ? travel : 1.0 - travel;
}

//------------------------------------------------------------------------------
double vtkHeliosOscillatingMirror::GetScanAngle(vtkIdType pulse) const
{
  const double phase = this->ComputePhase(pulse, this->ScanFrequency);
  if (this->Pattern == SINUSOIDAL)
  {
    return -this->ScanAngle * std::cos(2.0 * vtkMath::Pi() * phase);
  }
  const double time = 2.0 * (phase <= 0.5 ? phase : 1.0 - phase);
  return this->ScanAngle * (2.0 * this->ComputeTravel(time) - 1.0);
}

//------------------------------------------------------------------------------
bool vtkHeliosOscillatingMirror::GetDirection(vtkIdType pulse, double direction[3]) const
{
  const double beta = vtkMath::RadiansFromDegrees(this->GetScanAngle(pulse));
  direction[0] = 0.0;
  direction[1] = std::cos(beta);
  direction[2] = std::sin(beta);
  return true;
}

//------------------------------------------------------------------------------
int vtkHeliosOscillatingMirror::GetScanDirectionFlag(vtkIdType pulse) const
{
  return this->ScanFrequency > 0.0 && this->ComputePhase(pulse, this->ScanFrequency) < 0.5 ? 1 : 0;
}

//------------------------------------------------------------------------------
bool vtkHeliosOscillatingMirror::IsEdgeOfFlightLine(vtkIdType pulse) const
{
  const bool skipsLines = 2.0 * this->ScanFrequency >= this->PulseFrequency;
  return skipsLines || this->GetScanDirectionFlag(pulse) != this->GetScanDirectionFlag(pulse + 1);
}

//------------------------------------------------------------------------------
void vtkHeliosOscillatingMirror::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Pattern: " << (this->Pattern == SINUSOIDAL ? "sinusoidal" : "triangular")
     << "\n";
  os << indent << "ScanFrequency: " << this->ScanFrequency << "\n";
  os << indent << "ScanAngle: " << this->ScanAngle << "\n";
  os << indent << "TurningPulses: " << this->TurningPulses << "\n";
}
