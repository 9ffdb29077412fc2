// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHeliosConicMirror.h"

#include "heliosPhase.h"

#include <vtkMath.h>
#include <vtkObjectFactory.h>

#include <algorithm>
#include <cmath>

vtkStandardNewMacro(vtkHeliosConicMirror);

//------------------------------------------------------------------------------
vtkHeliosConicMirror::vtkHeliosConicMirror()
{
  this->SinScanAngle = std::sin(vtkMath::RadiansFromDegrees(this->ScanAngle));
  this->CosScanAngle = std::cos(vtkMath::RadiansFromDegrees(this->ScanAngle));
}

//------------------------------------------------------------------------------
void vtkHeliosConicMirror::SetScanAngle(double angle)
{
  const double clamped = std::min(std::max(0.0, angle), 180.0); // in this order NaN gives 0
  if (this->ScanAngle != clamped)
  {
    this->ScanAngle = clamped;
    this->SinScanAngle = std::sin(vtkMath::RadiansFromDegrees(clamped));
    this->CosScanAngle = std::cos(vtkMath::RadiansFromDegrees(clamped));
    this->Modified();
  }
}

//------------------------------------------------------------------------------
bool vtkHeliosConicMirror::GetDirection(vtkIdType pulse, double direction[3]) const
{
  const double phi =
    2.0 * vtkMath::Pi() * helios::Phase(pulse, this->ScanFrequency, this->PulseFrequency);
  direction[0] = this->SinScanAngle * std::sin(phi);
  direction[1] = this->CosScanAngle;
  direction[2] = this->SinScanAngle * std::cos(phi);
  return true;
}

//------------------------------------------------------------------------------
double vtkHeliosConicMirror::GetScanAngle(vtkIdType) const
{
  return this->ScanAngle;
}

//------------------------------------------------------------------------------
void vtkHeliosConicMirror::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "ScanFrequency: " << this->ScanFrequency << "\n";
  os << indent << "ScanAngle: " << this->ScanAngle << "\n";
}
