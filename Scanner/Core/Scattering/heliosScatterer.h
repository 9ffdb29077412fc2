// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// A point that scatters light: on a surface, or a leaf in a turbid voxel.

#ifndef heliosScatterer_h
#define heliosScatterer_h

#include "heliosMaterialTable.h"
#include "heliosPose.h"
#include "heliosRadiometry.h"

#include <vtkMath.h>
#include <vtkType.h>

#include <algorithm>
#include <cmath>

namespace helios
{

/// Returns a unit vector at an angle to a unit axis, and about it.
inline Vec3 GetAround(const Vec3& axis, double cosine, double sine, double azimuth)
{
  const Vec3 other = std::abs(axis[0]) < 0.6 ? Vec3(1.0, 0.0, 0.0) : Vec3(0.0, 1.0, 0.0);
  const Vec3 u = axis.Cross(other).Normalized();
  return cosine * axis + sine * std::cos(azimuth) * u + sine * std::sin(azimuth) * axis.Cross(u);
}

/**
 * Returns pi times the share per solid angle that Lambertian leaves of all orientations reflect at an
 * angle from the light's direction whose cosine is given, of reflectance 1: 2 / (3 pi) (sin - angle
 * cos). They transmit into the opposite directions (Ross 1981, The Radiation Regime and Architecture
 * of Plant Stands).
 */
inline double GetLeafPhase(double cosine)
{
  const double c = std::max(-1.0, std::min(1.0, cosine));
  return 2.0 / (3.0 * vtkMath::Pi()) * (std::sqrt((1.0 - c) * (1.0 + c)) - std::acos(c) * c);
}

/**
 * Scatters the light that arrives along Incoming. A surface has the reflectance of the lidar
 * equation, a leaf in a voxel any orientation. An isotropic voxel scatters into all directions as it
 * does back to the scanner by that equation, so that its albedo is 4 times its reflectance.
 */
struct Scatterer
{
  enum Kinds
  {
    Surface,
    Leaf,
    Isotropic
  };

  Kinds Kind = Surface;
  vtkIdType Cell = -1;
  Vec3 Point{ 0.0, 0.0, 0.0 };
  Vec3 Incoming{ 0.0, 0.0, 0.0 };
  Vec3 Plane{ 0.0, 0.0, 0.0 };  ///< unit normal of the triangle, towards the light
  Vec3 Normal{ 0.0, 0.0, 0.0 }; ///< likewise: the one from which incidence is measured
  SurfaceReflection Reflection{ 0.0, 0.0, 0.0 };
  double Transmittance = 0.0; ///< share that a leaf transmits
  double Step = 0.0;          ///< along Plane, past the rounding errors of the point [m]
  /// The probability that a path that meets the surface is scattered by it, not passed on.
  double Probability = 1.0;

  /// Returns pi times the scattered share per solid angle: replaces rho cos(theta) in the lidar
  /// equation.
  double GetResponse(const Vec3& out) const
  {
    if (this->Kind == Isotropic)
    {
      return this->Reflection.Reflectance;
    }
    if (this->Kind == Leaf)
    {
      const double along = this->Incoming.Dot(out);
      return this->Reflection.Reflectance * GetLeafPhase(along) +
        this->Transmittance * GetLeafPhase(-along);
    }
    const double cosine = this->Normal.Dot(out);
    return cosine > 0.0 && this->Plane.Dot(out) > 0.0
      ? helios::GetResponse(this->Reflection, cosine, this->GetMirrored().Dot(out))
      : 0.0;
  }

  /// Returns the probability per solid angle with which Sample() chooses a direction.
  double GetDensity(const Vec3& out) const
  {
    if (this->Kind == Isotropic)
    {
      return 0.25 / vtkMath::Pi();
    }
    if (this->Kind == Leaf)
    {
      return this->GetResponse(out) /
        (vtkMath::Pi() * (this->Reflection.Reflectance + this->Transmittance));
    }
    const double specular = this->Reflection.Specularity;
    const double n = this->Reflection.SpecularExponent;
    const double lobe = specular > 0.0
      ? specular * 0.5 * (n + 1.0) * std::pow(std::max(0.0, this->GetMirrored().Dot(out)), n)
      : 0.0;
    return ((1.0 - specular) * std::max(0.0, this->Normal.Dot(out)) + lobe) / vtkMath::Pi();
  }

  /// Chooses a direction by random numbers in (0, 1); draw() returns more of them.
  template <typename NumbersT, typename DrawT>
  Vec3 Sample(const NumbersT& numbers, DrawT draw) const
  {
    const double u = numbers[1];
    const double azimuth = 2.0 * vtkMath::Pi() * numbers[2];
    if (this->Kind == Isotropic)
    {
      return GetAround(this->Normal, 2.0 * u - 1.0, 2.0 * std::sqrt(u * (1.0 - u)), azimuth);
    }
    if (this->Kind == Leaf) // one that the light meets, then a direction from it
    {
      const Vec3 leaf = GetAround(this->Normal, std::sqrt(u), std::sqrt(1.0 - u), azimuth);
      const double sum = this->Reflection.Reflectance + this->Transmittance;
      const auto more = draw();
      return GetAround(numbers[0] * sum < this->Transmittance ? -1.0 * leaf : leaf,
        std::sqrt(more[0]), std::sqrt(1.0 - more[0]), 2.0 * vtkMath::Pi() * more[1]);
    }
    if (numbers[0] < this->Reflection.Specularity)
    {
      const double cosine = std::pow(u, 1.0 / (this->Reflection.SpecularExponent + 1.0));
      const double sine = std::sqrt((1.0 - cosine) * (1.0 + cosine));
      return GetAround(this->GetMirrored(), cosine, sine, azimuth);
    }
    return GetAround(this->Normal, std::sqrt(u), std::sqrt(1.0 - u), azimuth);
  }

  /// Returns where a path starts that leaves the point.
  Vec3 GetStart(const Vec3& out) const
  {
    return this->Point + (this->Plane.Dot(out) < 0.0 ? -this->Step : this->Step) * this->Plane;
  }

private:
  Vec3 GetMirrored() const
  {
    return this->Incoming - (2.0 * this->Incoming.Dot(this->Normal)) * this->Normal;
  }
};

} // namespace helios

#endif
