// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// The cross-section of a beam.

#ifndef heliosBeamProjection_h
#define heliosBeamProjection_h

#include <cmath>

namespace helios
{

/**
 * A beam in the frame of its axis z: its radius at depth z is Tangent sqrt(z^2 + ApexOffset^2), and
 * its energy spreads along hyperbolas, on which the point (x, y) of its cross-section is constant.
 * The apex offset is the Rayleigh range of the waist, which lies at depth 0; without a waist it is 0
 * and the beam is a cone. The frame of a ConeView starts by that before the waist.
 */
struct BeamProjection
{
  double Tangent = 0.0;
  double ApexOffset = 0.0; ///< [m]

  double GetRadius(double depth) const
  {
    return this->Tangent * std::sqrt(depth * depth + this->ApexOffset * this->ApexOffset);
  }
};

} // namespace helios

#endif
