// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// The calibration of an echo detector for a pulse.

#ifndef heliosDetectorOffset_h
#define heliosDetectorOffset_h

#include "vtkHeliosScannerCoreModule.h" // For export macro

class vtkHeliosEchoDetector;

namespace helios
{

class PulseShape;

/**
 * Returns how late a detector finds the echo of a plane across the beam [ns], in bins of a size
 * [ns], at its calibration amplitude: the mean over eight positions within a bin. 0 for a Gaussian,
 * whose times detectors know in closed form.
 */
VTKHELIOSSCANNERCORE_EXPORT double ComputeDetectorOffset(
  const vtkHeliosEchoDetector& detector, const PulseShape& shape, double binSize);

} // namespace helios

#endif
