// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHeliosEchoDetector.h"

//------------------------------------------------------------------------------
void vtkHeliosEchoDetector::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "DetectionThreshold: " << this->DetectionThreshold << " W\n";
}
