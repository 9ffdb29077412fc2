// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosFoliageEstimate.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace helios
{

namespace
{

constexpr double NaN = std::numeric_limits<double>::quiet_NaN();

/// An intercepted share of all but rounding errors.
constexpr double Opaque = 1.0 - 1e-7;

/// Returns the standard error of a sum over a path; with nothing intercepted that of one pulse.
double GetError(double variance, double path)
{
  return (variance > 0.0 ? std::sqrt(variance) : 1.0) / path;
}

/// Solves the mean of exp(-u x), to second order in the deviation of x, for u.
double InvertPaths(double depth, double mean, double variance)
{
  const double root = std::max(mean * mean - 2.0 * variance * depth, 0.0);
  return 2.0 * depth / (mean + std::sqrt(root));
}

FoliageDensity EstimateByAttenuation(
  const FoliageSums& sums, bool isCorrected, double overdispersion)
{
  const double share = sums.Intercepted / sums.Entering;
  const double mean = sums.PotentialPath / sums.Entering;
  if (share >= Opaque)
  {
    // Pimont et al. 2018: the density that lets half a beam pass.
    const double value = std::log(2.0 * sums.Entering + 2.0) / mean;
    return { isCorrected ? value : NaN, isCorrected ? value : NaN, true };
  }
  const double variance = sums.InterceptedSquare / (1.0 - share);
  const double error = GetError(overdispersion * variance, sums.PotentialPath);
  double depth = -std::log1p(-share);
  if (!isCorrected)
  {
    return { depth / mean, error };
  }
  // The mean of the logarithm of a share with a variance is below the logarithm of the mean.
  depth = std::max(depth - 0.5 * variance / (sums.Entering * sums.Entering), 0.0);
  const double spread = sums.PotentialPathSquare / sums.Entering - mean * mean;
  return { InvertPaths(depth, mean, std::max(spread, 0.0)), error };
}

} // namespace

//------------------------------------------------------------------------------
FoliageDensity EstimateDensity(
  FoliageEstimator estimator, const FoliageSums& sums, double overdispersion)
{
  if (!(sums.FreePath > 0.0) || !(sums.PotentialPath > 0.0))
  {
    return { NaN, NaN };
  }
  const double variance = overdispersion * sums.InterceptedSquare;
  switch (estimator)
  {
    case FoliageEstimator::ContactFrequency:
    {
      const double passing = std::max(1.0 - sums.Intercepted / sums.Entering, 0.0);
      const double error = passing > 0.0 ? GetError(variance * passing, sums.PotentialPath) : NaN;
      return { sums.Intercepted / sums.PotentialPath, error };
    }
    case FoliageEstimator::BeerLambert:
      return EstimateByAttenuation(sums, false, overdispersion);
    case FoliageEstimator::BeerLambertCorrected:
      return EstimateByAttenuation(sums, true, overdispersion);
    case FoliageEstimator::MaximumLikelihood:
      return { sums.Intercepted / sums.FreePath, GetError(variance, sums.FreePath) };
    default:
    {
      const double intercepted = sums.Intercepted - sums.HitPath / sums.FreePath;
      return { std::max(intercepted, 0.0) / sums.FreePath, GetError(variance, sums.FreePath) };
    }
  }
}

} // namespace helios
