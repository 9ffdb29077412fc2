// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Estimates from samples, with their 95 % confidence intervals.

#ifndef heliosConfidence_h
#define heliosConfidence_h

#include "vtkHeliosScannerCoreModule.h" // For export macro

#include <vtkType.h>

#include <vector>

namespace helios
{

/// A value, and the ends of its 95 % confidence interval.
struct Estimate
{
  double Value = 0.0;
  double Lower = 0.0;
  double Upper = 0.0;
};

/// Returns a fraction, hits of a number of trials: the score interval of Wilson (1927). Without a
/// trial [0, 1].
VTKHELIOSSCANNERCORE_EXPORT Estimate EstimateFraction(vtkIdType hits, vtkIdType trials);

/**
 * Returns a quantile of a distribution from its sorted sample: the interval of order statistics
 * (David and Nagaraja 2003), which assumes nothing of the distribution. Where the sample is too
 * small for an end, it is the least or the largest value.
 */
VTKHELIOSSCANNERCORE_EXPORT Estimate EstimateQuantile(
  const std::vector<double>& sorted, double quantile);

/// Returns a root mean square, from the deviations: the normal interval of the mean square.
VTKHELIOSSCANNERCORE_EXPORT Estimate EstimateRms(const std::vector<double>& deviations);

} // namespace helios

#endif
