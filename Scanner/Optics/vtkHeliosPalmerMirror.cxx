// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHeliosPalmerMirror.h"

#include <vtkMath.h>
#include <vtkObjectFactory.h>

#include <cmath>

vtkStandardNewMacro(vtkHeliosPalmerMirror);

//------------------------------------------------------------------------------
vtkHeliosPalmerMirror::vtkHeliosPalmerMirror()
{
  this->ComputeTilt();
}

//------------------------------------------------------------------------------
void vtkHeliosPalmerMirror::ComputeTilt()
{
  this->SinWobble = std::sin(vtkMath::RadiansFromDegrees(this->WobbleAngle));
  this->CosWobble = std::cos(vtkMath::RadiansFromDegrees(this->WobbleAngle));
}

//------------------------------------------------------------------------------
void vtkHeliosPalmerMirror::SetWobbleAngle(double angle)
{
  if (this->SetClamped(this->WobbleAngle, angle, 0.0, 45.0))
  {
    this->ComputeTilt();
  }
}

//------------------------------------------------------------------------------
bool vtkHeliosPalmerMirror::GetDirection(vtkIdType pulse, double direction[3]) const
{
  const double phi = 2.0 * vtkMath::Pi() * this->ComputePhase(pulse, this->ScanFrequency);
  const double along = this->SinWobble * std::sin(phi);
  const double across = this->SinWobble * std::cos(phi);
  direction[0] = 2.0 * this->CosWobble * along - across * across;
  direction[1] = (this->CosWobble + along) * (this->CosWobble - along);
  direction[2] = std::sqrt(2.0) * across * (this->CosWobble + along);
  return true;
}

//------------------------------------------------------------------------------
void vtkHeliosPalmerMirror::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "ScanFrequency: " << this->ScanFrequency << "\n";
  os << indent << "WobbleAngle: " << this->WobbleAngle << "\n";
}
