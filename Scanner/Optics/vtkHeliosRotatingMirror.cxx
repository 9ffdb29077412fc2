// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHeliosRotatingMirror.h"

#include <vtkMath.h>
#include <vtkObjectFactory.h>

#include <cmath>

vtkStandardNewMacro(vtkHeliosRotatingMirror);

//------------------------------------------------------------------------------
double vtkHeliosRotatingMirror::ComputeBeta(vtkIdType pulse) const
{
  const double phase = this->ComputePhase(pulse, this->ScanFrequency);
  return 2.0 * this->MirrorAngle * (phase > 0.5 ? phase - 1.0 : phase);
}

//------------------------------------------------------------------------------
double vtkHeliosRotatingMirror::GetScanAngle(vtkIdType pulse) const
{
  return this->ComputeBeta(pulse);
}

//------------------------------------------------------------------------------
bool vtkHeliosRotatingMirror::IsInWindow(double beta) const
{
  return this->VerticalAngleMin < beta && beta <= this->VerticalAngleMax;
}

//------------------------------------------------------------------------------
int vtkHeliosRotatingMirror::GetScanDirectionFlag(vtkIdType) const
{
  return this->ScanFrequency > 0.0 ? 1 : 0;
}

//------------------------------------------------------------------------------
bool vtkHeliosRotatingMirror::IsEdgeOfFlightLine(vtkIdType pulse) const
{
  const double beta = this->ComputeBeta(pulse);
  if (!(this->ScanFrequency > 0.0) || !this->IsInWindow(beta))
  {
    return false;
  }
  const double next = this->ComputeBeta(pulse + 1);
  const bool skipsLines = this->ScanFrequency >= this->PulseFrequency;
  return skipsLines || next < beta || next > this->VerticalAngleMax;
}

//------------------------------------------------------------------------------
bool vtkHeliosRotatingMirror::GetDirection(vtkIdType pulse, double direction[3]) const
{
  const double angle = this->ComputeBeta(pulse);
  if (!this->IsInWindow(angle))
  {
    return false;
  }
  const double beta = vtkMath::RadiansFromDegrees(angle);
  direction[0] = 0.0;
  direction[1] = std::cos(beta);
  direction[2] = std::sin(beta);
  return true;
}

//------------------------------------------------------------------------------
void vtkHeliosRotatingMirror::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "ScanFrequency: " << this->ScanFrequency << "\n";
  os << indent << "MirrorAngle: " << this->MirrorAngle << "\n";
  os << indent << "VerticalAngleMin: " << this->VerticalAngleMin << "\n";
  os << indent << "VerticalAngleMax: " << this->VerticalAngleMax << "\n";
}
