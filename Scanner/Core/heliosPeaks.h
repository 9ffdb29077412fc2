// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// The maxima of a waveform, and the Gaussians through them.

#ifndef heliosPeaks_h
#define heliosPeaks_h

#include "heliosPulseShape.h"
#include "vtkHeliosEchoDetector.h"
#include "vtkHeliosScannerCoreModule.h"

#include <vector>

namespace helios
{

/// A maximum: samples First to Last are equal (a plateau where they are more than one) and larger
/// than those beside them.
struct Peak
{
  vtkIdType First;
  vtkIdType Last;
};

/**
 * The maxima that reach a threshold [W]; of two nearer than separation [ns] the larger, of two equal
 * ones the first. What is no finite number is no maximum.
 */
VTKHELIOSSCANNERCORE_EXPORT void FindPeaks(
  const vtkHeliosWaveform& waveform, double threshold, double separation, std::vector<Peak>& peaks);

/**
 * All maxima that reach a threshold [W] in a range of bins at whose ends the waveform rises and falls.
 * False where it does not, or is level there.
 */
VTKHELIOSSCANNERCORE_EXPORT bool FindPeaks(const vtkHeliosWaveform& waveform, double threshold,
  const BinRange& bins, std::vector<Peak>& peaks);

/// The Gaussian through the ends of a maximum and the samples beside them; where one of these is not
/// positive, the maximum itself with the width of the pulse.
VTKHELIOSSCANNERCORE_EXPORT vtkHeliosDetectedEcho FitPeak(
  const vtkHeliosWaveform& waveform, const Peak& peak);

/// The Gaussian that fits the samples within a reach [ns] of a maximum best; the one above where none
/// does.
VTKHELIOSSCANNERCORE_EXPORT vtkHeliosDetectedEcho FitPeak(
  const vtkHeliosWaveform& waveform, const Peak& peak, double reach);

} // namespace helios

#endif
