// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Fresnel's equations and Snell's law, for unpolarised light at smooth surfaces.

#ifndef heliosFresnel_h
#define heliosFresnel_h

#include "heliosPose.h"

#include <algorithm>
#include <cmath>

namespace helios
{

/// The shares of two polarisations.
struct PolarisedShares
{
  double S;
  double P;
  double GetMean() const { return 0.5 * (this->S + this->P); }
};

/**
 * Returns the cosine of the angle of refraction from a medium of index n1 to one of n2, by Snell's
 * law; 0 from the angle of total reflection on.
 */
inline double GetRefractedCosine(double cosine, double n1, double n2)
{
  const double ratio = n1 / n2;
  return std::sqrt(std::max(0.0, 1.0 - ratio * ratio * (1.0 - cosine) * (1.0 + cosine)));
}

/// Returns the reflectance of the boundary of two media (Born and Wolf, Principles of Optics, 1.5).
inline PolarisedShares GetFresnelReflectance(double cosine, double n1, double n2)
{
  const double refracted = GetRefractedCosine(cosine, n1, n2);
  if (!(refracted > 0.0))
  {
    return { 1.0, 1.0 };
  }
  const double s = (n1 * cosine - n2 * refracted) / (n1 * cosine + n2 * refracted);
  const double p = (n2 * cosine - n1 * refracted) / (n2 * cosine + n1 * refracted);
  return { s * s, p * p };
}

/// Shares that a pane reflects and transmits; the rest is absorbed.
struct PaneShares
{
  double Reflected;
  double Transmitted;
};

/**
 * Returns all light reflected back and forth between the two faces of a plate of index n in air,
 * added as energy: for the reflectance R of a face and the transmission a of one crossing, T = (1 -
 * R)^2 a / (1 - R^2 a^2), and R + R a T reflected.
 */
inline PaneShares GetPaneShares(double cosine, double n, double crossing)
{
  const PolarisedShares face = GetFresnelReflectance(cosine, 1.0, n);
  const auto transmit = [crossing](double r)
  {
    const double within = r * crossing;
    return within < 1.0 ? (1.0 - r) * (1.0 - r) * crossing / ((1.0 - within) * (1.0 + within))
                        : 0.0;
  };
  const PolarisedShares through{ transmit(face.S), transmit(face.P) };
  const PolarisedShares back{ face.S * (1.0 + crossing * through.S),
    face.P * (1.0 + crossing * through.P) };
  return { back.GetMean(), through.GetMean() };
}

/// Returns a unit vector mirrored at a surface with a unit normal.
inline Vec3 GetMirrored(const Vec3& direction, const Vec3& normal)
{
  return direction - (2.0 * direction.Dot(normal)) * normal;
}

/**
 * Returns a unit vector refracted from n1 to n2 at a surface whose unit normal is against the
 * vector; refracted: the cosine by GetRefractedCosine().
 */
inline Vec3 GetRefracted(
  const Vec3& direction, const Vec3& normal, double n1, double n2, double refracted)
{
  const double ratio = n1 / n2;
  Vec3 turned = ratio * direction - (ratio * direction.Dot(normal) + refracted) * normal;
  turned.Normalize();
  return turned;
}

} // namespace helios

#endif
