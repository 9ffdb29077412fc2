// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// The echo of a Gaussian beam from one plane, in closed form.

#ifndef heliosPlaneEcho_h
#define heliosPlaneEcho_h

#include "heliosConstants.h"
#include "heliosReceiver.h"

#include <cmath>

namespace helios
{

/// The cross-section of a beam along one axis: angle variance [rad^2], and kurtosis - 3.
struct BeamMoments
{
  double Variance = 0.0;
  double Excess = 0.0;

  BeamMoments() = default;

  /**
   * Computes the moments of a beam of the full angle 2 w truncated at K w. With p = (g / w)^2 the
   * moments of the beam are E[p] = (1/2 - e (K^2 + 1/2)) / (1 - e) and E[p^2] = (1/2 - e (K^4 + K^2
   * + 1/2)) / (1 - e), e = exp(-2 K^2); along one axis E[x^2] = E[p] w^2 / 2, E[x^4] = 3 E[p^2] w^4
   * / 8.
   */
  BeamMoments(double divergence, double truncation)
  {
    const double w = 0.5 * divergence;
    const double k2 = truncation * truncation;
    const double e = std::exp(-2.0 * k2);
    const double p = (0.5 - e * (k2 + 0.5)) / (1.0 - e);
    const double p2 = (0.5 - e * (k2 * k2 + k2 + 0.5)) / (1.0 - e);
    this->Variance = 0.5 * w * w * p;
    this->Excess = 1.5 * p2 / (p * p) - 3.0;
  }
};

/**
 * The echo of a plane at range R on the axis with incidence theta: with s^2 the variance of the
 * beam's angle along an axis, the sub-rays' ranges have the mean R + R s^2 (1 - 2 tan^2) and the
 * standard deviation R s tan, their power the mean (1 + 3 s^2 (tan^2 - 1)) of the axis' own; a
 * Gaussian pulse returns with sigma'^2 = sigma^2 + (2 R s tan / c)^2 and the peak sigma / sigma'. The
 * curvature of equal ranges adds R^2 Var(g^2 / 2) = R^2 s^4 (1 + 2/3 excess) to the variance of ranges.
 *
 * An elliptical beam has s along its major axis and q s along the minor one. The tangent is then
 * sqrt(t1^2 + (q t2)^2), with t1 and t2 the slopes of the plane along these axes; the 1 of the mean
 * and of the power, which is E[g^2] / 2 s^2, is (1 + q^2) / 2, and Var(g^2 / 2) is
 * s^4 (q^2 (1 + 2/3 excess) + (1 - q^2)^2 (2 + excess) / 4).
 */
struct PlaneModel
{
  BeamMoments Beam;   // along the major axis
  double Sigma;       // sigma of the pulse [ns]
  double Ratio = 1.0; // q

  double GetRoundness() const { return 0.5 * (1.0 + this->Ratio * this->Ratio); }

  /// Returns Var(g^2 / 2) / s^4.
  double GetCurvature() const
  {
    const double q2 = this->Ratio * this->Ratio;
    const double flat = 1.0 - q2;
    return q2 * (1.0 + this->Beam.Excess / 1.5) + flat * flat * (0.5 + 0.25 * this->Beam.Excess);
  }

  /// Returns the widening of the echo, (sigma' / sigma)^2 - 1; reach is the range from the cone's
  /// apex.
  double GetWidening(double reach, double tanIncidence) const
  {
    const double unit = 2.0 * reach / (SpeedOfLight * this->Sigma);
    const double s2 = this->Beam.Variance;
    const double curvature = s2 * s2 * this->GetCurvature();
    return unit * unit * (s2 * tanIncidence * tanIncidence + curvature);
  }

  /// Returns the maximum distance of the peak from the range of GetEcho() [m]: half the third
  /// cumulant of the ranges, over the variance of the pulse; an upper bound for an elliptical beam.
  double GetShift(double reach, double tanIncidence) const
  {
    const double unit = 2.0 * reach / (SpeedOfLight * this->Sigma);
    const double s2 = this->Beam.Variance;
    const double curve = reach * s2 * (1.0 + tanIncidence * tanIncidence);
    const double slope = unit * tanIncidence;
    return curve * (3.0 * slope * slope * s2 + unit * unit * s2 * s2);
  }

  /// Computes the echo; power is the return of the axis alone.
  PlaneEcho GetEcho(double range, double reach, double tanIncidence, double power) const
  {
    const double tan2 = tanIncidence * tanIncidence;
    const double v = this->GetWidening(reach, tanIncidence);
    const double s2 = this->Beam.Variance;
    const double peak = 1.0 / std::sqrt(1.0 + v) + 0.125 * this->Beam.Excess * v * v;
    const double mean = this->GetRoundness();
    return { range * (1.0 + s2 * (mean - 2.0 * tan2)),
      power * (1.0 + 3.0 * s2 * (tan2 - mean)) * peak, this->Sigma * std::sqrt(1.0 + v) };
  }
};

} // namespace helios

#endif
