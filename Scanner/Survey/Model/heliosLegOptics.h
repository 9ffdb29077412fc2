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

/// Names of optics in files.
struct OpticsName
{
  const char* Name;
  Optics Type;
};

constexpr OpticsName OpticsNames[] = { { "rotating", Optics::RotatingMirror },
  { "oscillating", Optics::OscillatingMirror }, { "line", Optics::FiberArray },
  { "conic", Optics::ConicMirror }, { "palmer", Optics::PalmerMirror },
  { "risley", Optics::RisleyPrisms } };

const char* GetOpticsName(Optics type);

VTKHELIOSSCANNERSURVEY_EXPORT vtkSmartPointer<vtkHeliosBeamDeflector> MakeDeflector(
  const ScannerData& scanner, const ScanData& scan);

} // namespace helios

#endif
