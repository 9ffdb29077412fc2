// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHeliosFiberArray.h"

#include <vtkMath.h>
#include <vtkObjectFactory.h>

#include <cmath>

vtkStandardNewMacro(vtkHeliosFiberArray);

//------------------------------------------------------------------------------
void vtkHeliosFiberArray::SetScanAngle(double angle)
{
  this->SetClamped(this->ScanAngle, angle, 0.0, 180.0);
}

//------------------------------------------------------------------------------
double vtkHeliosFiberArray::GetScanAngle(vtkIdType pulse) const
{
  const vtkIdType last = this->NumberOfFibers - 1;
  const vtkIdType fiber = this->ComputeCount(pulse) % this->NumberOfFibers;
  // Outwards from the middle, in integers: symmetric to the last bit.
  return last == 0
    ? 0.0
    : this->ScanAngle * (static_cast<double>(2 * fiber - last) / static_cast<double>(last));
}

//------------------------------------------------------------------------------
bool vtkHeliosFiberArray::GetDirection(vtkIdType pulse, double direction[3]) const
{
  const double angle = vtkMath::RadiansFromDegrees(this->GetScanAngle(pulse));
  direction[0] = 0.0;
  direction[1] = std::cos(angle);
  direction[2] = std::sin(angle);
  return true;
}

//------------------------------------------------------------------------------
int vtkHeliosFiberArray::GetScanDirectionFlag(vtkIdType) const
{
  return this->NumberOfFibers > 1 ? 1 : 0;
}

//------------------------------------------------------------------------------
bool vtkHeliosFiberArray::IsEdgeOfFlightLine(vtkIdType pulse) const
{
  return this->NumberOfFibers > 1 && this->ComputeCount(pulse + 1) % this->NumberOfFibers == 0;
}

//------------------------------------------------------------------------------
void vtkHeliosFiberArray::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "NumberOfFibers: " << this->NumberOfFibers << "\n";
  os << indent << "ScanAngle: " << this->ScanAngle << "\n";
}
