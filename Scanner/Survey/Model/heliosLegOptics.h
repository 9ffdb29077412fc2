// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// The beam deflector of a leg.

#ifndef heliosLegOptics_h
#define heliosLegOptics_h

#include "heliosSurveyData.h"
#include "vtkHeliosScannerSurveyModule.h" // For export macro

#include <vtkSmartPointer.h>

#include <string>

class vtkHeliosBeamDeflector;

namespace helios
{

/// Returns the name of optics in files.
std::string GetOpticsName(Optics type);

VTKHELIOSSCANNERSURVEY_EXPORT vtkSmartPointer<vtkHeliosBeamDeflector> MakeDeflector(
  const ScannerData& scanner, const ScanData& scan);

} // namespace helios

#endif
