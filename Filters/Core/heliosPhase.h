// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Phases of periodic motion from an integer index, without drift.

#ifndef heliosPhase_h
#define heliosPhase_h

#include <cmath>
#include <cstdint>

namespace helios
{

/// Returns x - floor(x), guaranteed to be in [0, 1), also for rounding errors and NaN.
inline double Fraction(double x)
{
  const double fraction = x - std::floor(x);
  return fraction < 1.0 ? fraction : 0.0;
}

/**
 * Returns frac(index * frequency / rate), in [0, 1), exact to a few ulps for any index below 2^53
 * and any number of turns; a negative frequency reverses the direction. index * frequency is the
 * exact sum of a product and its rounding error (Dekker's two-product); whole turns are subtracted
 * by a fused multiply-add, so there is no cancellation.
 */
inline double Phase(std::int64_t index, double frequency, double rate)
{
  const double i = static_cast<double>(index);
  const double product = i * frequency;
  const double error = std::fma(i, frequency, -product);
  const double turns = std::floor(product / rate);
  const double rest = std::fma(-turns, rate, product) + error; // in (-rate, 2 rate)
  return Fraction(rest / rate);
}

/// Returns frac(time * frequency), in [0, 1), exact to a few ulps for any number of turns.
inline double Phase(double time, double frequency)
{
  const double product = time * frequency;
  const double error = std::fma(time, frequency, -product);
  return Fraction(product - std::floor(product) + error);
}

/// Returns the time of a pulse [s], computed from its index, not accumulated.
inline double PulseTime(double start, std::int64_t index, double pulseFrequency)
{
  return start + static_cast<double>(index) / pulseFrequency;
}

} // namespace helios

#endif
