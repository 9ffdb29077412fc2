// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHeliosConicMirror.h"

#include <vtkMath.h>
#include <vtkObjectFactory.h>

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
  if (this->SetClamped(this->ScanAngle, angle, 0.0, 180.0))
  {
    this->SinScanAngle = std::sin(vtkMath::RadiansFromDegrees(this->ScanAngle));
    this->CosScanAngle = std::cos(vtkMath::RadiansFromDegrees(this->ScanAngle));
  }
}

//------------------------------------------------------------------------------
bool vtkHeliosConicMirror::GetDirection(vtkIdType pulse, double direction[3]) const
{
  const double phi = 2.0 * vtkMath::Pi() * this->ComputePhase(pulse, this->ScanFrequency);
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
