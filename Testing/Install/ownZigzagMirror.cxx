// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ownZigzagMirror.h"

#include <vtkMath.h>
#include <vtkObjectFactory.h>

#include <cmath>

vtkStandardNewMacro(ownZigzagMirror);

bool ownZigzagMirror::GetDirection(vtkIdType pulse, double direction[3]) const
{
  const double angle = vtkMath::RadiansFromDegrees(this->GetScanAngle(pulse));
  direction[0] = std::sin(angle);
  direction[1] = 0.0;
  direction[2] = -std::cos(angle);
  return true;
}

double ownZigzagMirror::GetScanAngle(vtkIdType pulse) const
{
  const double phase = static_cast<double>(pulse % PulsesPerPeriod) / PulsesPerPeriod;
  return this->ScanAngle * (1.0 - std::abs(4.0 * phase - 2.0));
}
