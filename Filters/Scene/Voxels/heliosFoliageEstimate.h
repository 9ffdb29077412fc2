// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Estimators of the plant area density of a cell from the beams that pass it.

#ifndef heliosFoliageEstimate_h
#define heliosFoliageEstimate_h

namespace helios
{

/// Estimators; the formulas, sources and biases are in vtkHeliosPlantAreaDensity.h.
enum class FoliageEstimator : char
{
  ContactFrequency,
  BeerLambert,
  BeerLambertCorrected,
  MaximumLikelihood,
  MaximumLikelihoodCorrected
};

/**
 * Sums over the beams of a cell. Energies are in pulses; paths are lengths times G [m]. A beam
 * enters with the energy e and would pass a chord; a plant element intercepts w of it after z.
 */
struct FoliageSums
{
  double Beams = 0.0;               // with e > 0
  double ShadowedBeams = 0.0;       // with e = 0
  double Entering = 0.0;            // e
  double Intercepted = 0.0;         // w
  double InterceptedSquare = 0.0;   // square of the w of each beam
  double PathLength = 0.0;          // energy times its free path, without G
  double FreePath = 0.0;            // energy times its free path
  double HitPath = 0.0;             // w^2 z
  double PotentialPath = 0.0;       // e times the chord
  double PotentialPathSquare = 0.0; // e times the square of the chord
};

/// Value and standard error; IsSaturated: nothing passes the cell, the density has no upper bound.
struct FoliageDensity
{
  double Value;
  double Error;
  bool IsSaturated = false;
};

/**
 * Returns the density of a cell [m2/m3]; NaN if no beam enters. overdispersion is the ratio of the
 * variance of the intercepted energy to that of independent beams: 1 for small elements.
 */
FoliageDensity EstimateDensity(
  FoliageEstimator estimator, const FoliageSums& sums, double overdispersion);

} // namespace helios

#endif
