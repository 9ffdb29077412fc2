// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// A stationary first-order Gauss-Markov process as a function of time.

#ifndef heliosGaussMarkov_h
#define heliosGaussMarkov_h

#include <cstdint>
#include <limits>

namespace helios
{

/**
 * A zero-mean Gaussian process with the autocovariance
 *
 *   E[e(t) e(t + s)] = rms^2 exp(-|s| / T)
 *
 * (Gelb 1974, Applied Optimal Estimation, section 3.8), a pure function of seed, component and
 * time: no state is carried from pulse to pulse. Knots 32 T apart are independent (their
 * correlation is 1e-14); between them the process is bisected exactly,
 *
 *   e((a + b) / 2) ~ N((e(a) + e(b)) / (2 cosh h), rms^2 tanh h),   h = (b - a) / 2 T,
 *
 * down to steps of T / 256, which are linear: there the RMS is up to 0.1 % too small.
 */
struct GaussMarkov
{
  double Rms = 0.0;             // 0: off
  double CorrelationTime = 1.0; // T [s]

  /// The last step, whose ends are used again by following pulses.
  struct Cursor
  {
    std::int64_t Step = std::numeric_limits<std::int64_t>::min();
    double Begin = 0.0;
    double End = 0.0;
  };

  double GetValue(std::uint64_t seed, std::uint32_t component, double time, Cursor& cursor) const;
};

} // namespace helios

#endif
