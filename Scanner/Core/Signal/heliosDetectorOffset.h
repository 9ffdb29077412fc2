// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// The calibration of an echo detector for a pulse.

#ifndef heliosDetectorOffset_h
#define heliosDetectorOffset_h

#include "heliosStatus.h"
#include "vtkHeliosScannerCoreModule.h" // For export macro

class vtkHeliosEchoDetector;

namespace helios
{

class PulseShape;

/**
 * Computes how late a detector finds the echo of a plane across the beam [ns], in bins of a size
 * [ns], at its calibration amplitude: the mean over eight positions within a bin. 0 for a Gaussian,
 * whose times detectors know in closed form. Returns the error of the detector, if any.
 */
VTKHELIOSSCANNERCORE_EXPORT Status ComputeDetectorOffset(
  const vtkHeliosEchoDetector& detector, const PulseShape& shape, double binSize, double& offset);

} // namespace helios

#endif
