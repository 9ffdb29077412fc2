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

/// A maximum: samples First to Last are equal (a plateau if more than one) and larger than their
/// neighbours.
struct Peak
{
  vtkIdType First;
  vtkIdType Last;
};

/**
 * Finds the maxima that reach a threshold [W]; of two nearer than separation [ns] the larger, of
 * two equal ones the first. Non-finite samples are no maxima.
 */
VTKHELIOSSCANNERCORE_EXPORT void FindPeaks(
  const vtkHeliosWaveform& waveform, double threshold, double separation, std::vector<Peak>& peaks);

/**
 * Finds all maxima that reach a threshold [W] in a range of bins; the waveform must rise at its
 * start and fall at its end, otherwise false.
 */
VTKHELIOSSCANNERCORE_EXPORT bool FindPeaks(const vtkHeliosWaveform& waveform, double threshold,
  const BinRange& bins, std::vector<Peak>& peaks);

/// Returns the Gaussian through the ends of a maximum and their neighbours; its amplitude is the
/// samples' if three or more are equal. If a neighbour is not positive, returns the maximum itself
/// with the width of the pulse.
VTKHELIOSSCANNERCORE_EXPORT vtkHeliosDetectedEcho FitPeak(
  const vtkHeliosWaveform& waveform, const Peak& peak);

/// Returns the best fit of a Gaussian to the samples within a reach [ns] of a maximum; the one
/// above if there is none.
VTKHELIOSSCANNERCORE_EXPORT vtkHeliosDetectedEcho FitPeak(
  const vtkHeliosWaveform& waveform, const Peak& peak, double reach);

} // namespace helios

#endif
