// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHeliosBeamDeflector.h"

#include <vtkMath.h>

#include <cmath>

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
void vtkHeliosBeamDeflector::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "PulseFrequency: " << this->PulseFrequency << "\n";
}
