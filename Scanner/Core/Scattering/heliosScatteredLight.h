// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Samples the light that returns to the receiver after it was scattered more than once.

#ifndef heliosScatteredLight_h
#define heliosScatteredLight_h

#include "heliosLightScene.h"
#include "heliosRadiometry.h"
#include "heliosScatteredProfile.h"
#include "vtkHeliosRay.h"
#include "vtkHeliosScannerCoreModule.h" // For export macro

#include <cstdint>
#include <vector>

namespace helios
{

struct ScatteringSettings
{
  int Orders = 1;             ///< the most scatterings of a path; 1: none is computed
  int Paths = 0;              ///< paths of a pulse
  bool IsIsotropic = false;   ///< whether turbid voxels are
  int MaximumEvents = 8;      ///< mirrors, panes and leaves between two scatterings
  double HalfFieldOfView = 0; ///< half angle of the receiver's cone [rad]
  double Power = 0.0;         ///< power of the pulse [W]
  LidarEquation Equation{ 0.15, 1.0, 0.0 };
  double MinimumRange = 0.0; ///< the range gate [m]
  double MaximumRange = 0.0;
  double Step = 0.0; ///< largest difference of ranges in a return [m]
  std::uint64_t Seed = 0;
};

/**
 * Paths of light from the sub-rays of a beam, chosen by their energy, over points that scatter it,
 * to the receiver: bidirectional path tracing (Veach 1997, Robust Monte Carlo Methods for Light
 * Transport Simulation, chapters 8 to 10). Directions are drawn by the reflectance of the scatterer.
 * The last point of a path is either drawn so, too, and counts if it lies in the receiver's field of
 * view; or it is what a random ray of the receiver meets there, and is connected with each point of
 * the path. Of both ways each has the weight that the balance heuristic gives it, so that neither a
 * narrow field of view nor points next to each other are drawn badly. Every order is unbiased.
 *
 * Light that is scattered for the last time at a distance d, after a path of the length L, returns
 * as by the lidar equation: with the share of the energy that arrives, f of that direction in place
 * of rho cos(theta), D^2 / (4 d^2), and the extinction and range of half of L. One per thread.
 */
class VTKHELIOSSCANNERCORE_EXPORT ScatteredLight
{
public:
  ScatteredLight(const ScatteringSettings& settings, const LightScene& scene);

  /// The beam of a pulse: sub-rays in the world, with the same weights for all pulses.
  struct Beam
  {
    vtkIdType PulseId;
    Vec3 Receiver;
    Vec3 Axis;
    const std::vector<vtkHeliosRay>& SubRays;
  };

  /// Sets the weights of the sub-rays.
  void SetWeights(const std::vector<double>& weights);

  /// Samples the light of a pulse.
  void Sample(const Beam& beam);

  /// Returns the light sampled last.
  const ScatteredProfile& GetProfile() const { return this->Profile; }
  ScatteredProfile& GetProfile() { return this->Profile; }

private:
  void ChooseSubRays(const Beam& beam, PulseRandom& random);
  void TracePath(const Beam& beam, std::size_t path, PulseRandom& random);
  void TraceView(const Beam& beam, PulseRandom& random);
  void TraceTogether(const std::vector<vtkHeliosRay>& rays, std::vector<vtkHeliosHit>& hits) const;
  void AddConnection(const Beam& beam, const LightPath& path, const Scatterer& from,
    const Scatterer& seen, double survival);
  void AddArrival(const Beam& beam, const LightPath& path, const Scatterer& at, double fromDensity,
    const Vec3& from);
  void AddReturn(
    const Scatterer& at, double length, double share, double distance, const Vec3& out);

  ScatteringSettings Settings;
  LightScene Scene;
  double Versine;    // 1 - cos of the half angle of the field of view
  double SolidAngle; // solid angle of the field of view [sr]
  ScatteredProfile Profile;
  std::vector<double> Sums;       // sums of the weights of the sub-rays
  std::size_t Batch = 0;          // batch of the current path
  std::vector<vtkHeliosRay> Rays; // first ones of the paths
  std::vector<vtkHeliosHit> Hits;
  std::vector<vtkHeliosRay> ViewRays; // rays of the receiver
  std::vector<vtkHeliosHit> ViewHits;
};

} // namespace helios

#endif
