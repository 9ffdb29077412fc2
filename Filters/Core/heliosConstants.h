// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Physical and mathematical constants, and factors of units.

#ifndef heliosConstants_h
#define heliosConstants_h

namespace helios
{

/// The speed of light in vacuum [m/ns].
constexpr double SpeedOfLight = 0.299792458;

/// The Planck constant [J s].
constexpr double PlanckConstant = 6.62607015e-34;

/// The standard acceleration of gravity [m/s^2].
constexpr double StandardGravity = 9.80665;

/// The full width at half maximum of a Gaussian in standard deviations, sqrt(8 ln 2).
constexpr double FwhmPerSigma = 2.3548200450309493;

/// Factors of units.
constexpr double NanowattsPerWatt = 1e9;
constexpr double NanosecondsPerSecond = 1e9;
constexpr double PicosecondsPerNanosecond = 1000.0;
constexpr double BytesPerKibibyte = 1024.0;

} // namespace helios

#endif
