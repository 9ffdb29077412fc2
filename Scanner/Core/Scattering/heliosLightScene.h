// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// A scene as light meets it that is scattered more than once.

#ifndef heliosLightScene_h
#define heliosLightScene_h

#include "heliosRandom.h"
#include "heliosScatterer.h"
#include "heliosSceneSurfaces.h"
#include "heliosTurbidMedium.h"
#include "vtkHeliosRayCaster.h"
#include "vtkHeliosScannerCoreModule.h" // For export macro

#include <array>
#include <cstdint>

namespace helios
{

/// The random numbers of a pulse, in the order in which they are drawn.
class PulseRandom
{
public:
  PulseRandom(std::uint64_t seed, vtkIdType pulse)
    : Seed(seed)
    , Pulse(static_cast<std::uint64_t>(pulse))
  {
  }
  std::array<double, 4> Draw()
  {
    return Uniform4(this->Seed, RandomStream::Scattering, this->Pulse, this->Next++);
  }

private:
  std::uint64_t Seed;
  std::uint64_t Pulse;
  std::uint32_t Next = 0;
};

/// The light on its way.
struct LightPath
{
  vtkHeliosRay Ray;
  double Share = 1.0;     ///< share of the energy of the pulse, for the probability of the path
  double Length = 0.0;    ///< since the emission [m]
  bool IsStraight = true; ///< whether no mirror or glass was met since the last scatterer
};

/// A straight line between two points.
struct LightLeg
{
  double Transmission;
  bool IsClear; ///< whether no glass or leaf is on it
};

struct VTKHELIOSSCANNERCORE_EXPORT LightScene
{
  const vtkHeliosRayCaster* Caster; ///< null: no surfaces
  const SceneSurfaces& Surfaces;
  const TurbidMedium& Medium;
  bool IsIsotropic;  ///< whether voxels are
  int MaximumEvents; ///< the most mirrors, panes and leaves between two scatterers

  /**
   * Follows light to the next point that scatters it, of which there is the first hit of a ray;
   * mirrors reflect it on the way, panes and leaves of triangles pass it straight on. Returns
   * whether there is such a point.
   */
  bool Follow(LightPath& path, vtkHeliosHit hit, PulseRandom& random, Scatterer& found) const;

  /// Finds the first hit of a surface.
  vtkHeliosHit Trace(const vtkHeliosRay& ray) const;

  /// Finds the point that a ray of the receiver meets first, of which there is the first hit of a
  /// surface; its path is not passed on.
  bool Meet(const vtkHeliosRay& ray, vtkHeliosHit hit, PulseRandom& random, Scatterer& found) const;

  /// Returns how much light passes from a scatterer to a point straight on, also through panes and
  /// leaves.
  LightLeg Connect(const Scatterer& from, const Vec3& to) const;

  /// Returns the transmission of turbid voxels between two points.
  double GetTransmission(const Vec3& from, const Vec3& to) const;

  /// Returns the probability that a path that meets a scatterer is scattered by it, not passed on.
  double GetProbability(const Scatterer& at) const;

  /// Returns the area that a scatterer has across a direction, relative to its own.
  double GetProjection(const Scatterer& scatterer, const Vec3& direction) const;

private:
  /// Shares of the light that a surface scatters, passes straight on and mirrors.
  struct Shares
  {
    double Scattered;
    double Passed;
    double Mirrored;
    double GetSum() const { return this->Scattered + this->Passed + this->Mirrored; }
  };

  void Stop(const vtkHeliosRay& ray, PulseRandom& random, vtkHeliosHit& hit) const;
  void Describe(const vtkHeliosRay& ray, const vtkHeliosHit& hit, Scatterer& found) const;
  Shares GetShares(const MaterialOptics& optics, const Scatterer& at) const;
};

} // namespace helios

#endif
