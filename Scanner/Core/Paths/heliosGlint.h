// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Light that retroreflectors and rough mirrors, panes or water surfaces return.

#ifndef heliosGlint_h
#define heliosGlint_h

#include <vtkMath.h>

#include <cmath>

namespace helios
{

/**
 * Returns pi times the bidirectional reflectance times cos(theta) in the backscatter direction, of
 * facets whose slopes are Gaussian, with the mean square slope s2 and the reflectance rho across a
 * facet: rho / (4 s2 cos^5) exp(-tan^2 / s2) (Cox and Munk 1954; Menzies, Tratt and Hunt 1998,
 * Applied Optics 37, 5550-5559). Facets do not hide each other: for cosines well above s.
 */
inline double GetGlint(double reflectance, double meanSquareSlope, double cosine)
{
  const double cos2 = cosine * cosine;
  const double tan2 = 1.0 / cos2 - 1.0;
  return reflectance / (4.0 * meanSquareSlope * cos2 * cos2 * cosine) *
    std::exp(-tan2 / meanSquareSlope);
}

/**
 * Returns pi times the bidirectional reflectance times cos(theta) of retroreflective sheeting, with
 * its coefficient of retroreflection R_A [cd/(lx m2)], for all entrance angles: its luminous
 * intensity, per illuminance across the light, and per area (ASTM E808).
 */
inline double GetRetroreflection(double coefficient, double cosine)
{
  return vtkMath::Pi() * coefficient / cosine;
}

} // namespace helios

#endif
