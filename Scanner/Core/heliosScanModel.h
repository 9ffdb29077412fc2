// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// The data needed for every pulse; constant while the scanner runs.

#ifndef heliosScanModel_h
#define heliosScanModel_h

#include "heliosAirColumn.h"
#include "heliosConeProbe.h"
#include "heliosDroplets.h"
#include "heliosFootprint.h"
#include "heliosPlaneEcho.h"
#include "heliosPulse.h"
#include "heliosPulseSubset.h"
#include "heliosRadiometry.h"
#include "heliosRangeZones.h"
#include "heliosReceiver.h"
#include "heliosSamplingPlan.h"
#include "heliosScanPath.h"
#include "heliosScatteredLight.h"
#include "heliosSceneGeometry.h"
#include "heliosSceneSurfaces.h"
#include "heliosSubRays.h"
#include "heliosSurfaceColors.h"
#include "heliosTurbidMedium.h"
#include "vtkHeliosEchoAlgorithm.h"
#include "vtkHeliosRayCaster.h"

#include <cmath>
#include <memory>
#include <utility>
#include <vector>

namespace helios
{

/// The standard deviation of the range noise; contributions add in quadrature.
struct RangeNoise
{
  double Constant = 0.0;    // [m]
  double PerMeter = 0.0;    // [m/m]
  double AtThreshold = 0.0; // [m], of an amplitude at the detection threshold
  double Threshold = 0.0;   // [W]

  bool IsOn() const
  {
    return this->Constant > 0.0 || this->PerMeter > 0.0 || this->AtThreshold > 0.0;
  }
  double GetDeviation(double range, double amplitude) const
  {
    return std::hypot(this->Constant, this->PerMeter * range,
      this->AtThreshold > 0.0 ? this->AtThreshold * this->Threshold / amplitude : 0.0);
  }
};

/// The range gate.
struct RangeGate
{
  double Minimum = 0.0;            // [m]
  double Maximum = VTK_DOUBLE_MAX; // [m]

  /// Returns whether a sub-ray returns nothing: no hit, or a hit outside the range gate.
  bool IsOutsideGate(const vtkHeliosHit& hit) const
  {
    return this->IsOutsideGate(hit.CellId, hit.Range);
  }
  bool IsOutsideGate(vtkIdType cell, double range) const
  {
    return cell < 0 || range < this->Minimum || range > this->Maximum;
  }
};

/// Limits of paths behind mirrors and glass.
struct PathLimits
{
  int MaximumEvents = 8;    // reflections and refractions
  double LeastShare = 1e-4; // share of the energy of a sub-ray, out and back
};

struct ScanModel
{
  PulseSource Source;
  PulseSubset Sample;                             // pulses that are fired
  const vtkHeliosRayCaster* Caster = nullptr;     // null: no surfaces
  std::shared_ptr<const InstanceMotions> Motions; // null: no instance moves
  // probe of the caster, for adaptive sampling; may be null
  const ConeProbe* Cones = nullptr;
  SceneSurfaces Surfaces;
  SurfaceColors Colors; // if they are requested
  PathLimits Optics;    // limits, for scenes whose surfaces have any optics
  TurbidMedium Medium;
  ScatteringSettings Scattering;    // settings of light that is scattered more than once
  std::vector<SubRay> LightSubRays; // its sub-rays, the same for all samplings of a beam
  ReceiverSettings Receiver;

  ScanPath Path;
  std::vector<SubRay> SubRays; // sub-rays of fixed sampling; of adaptive sampling, among leaves
  bool HasOffsets = false;
  SamplingPlan Plan; // plan of adaptive sampling
  // adaptive sampling: sub-rays of beams that one surface fills
  std::vector<SubRay> LayerSubRays;
  // adaptive sampling: sub-rays of beams with too many surfaces, by level
  std::vector<std::shared_ptr<LazySubRays>> RayLevels;
  std::vector<SubRay> CoarseSubRays; // before those levels: of beams on mirrors and glass
  FootprintSettings Footprints;      // settings of adaptive sampling
  bool UsesRays = false;             // whether beams that no cone test resolves are sampled by rays
  PlaneModel Plane;
  // tangent of the half angle of all sub-rays together, along the major axis
  double ConeTangent = 0.0;
  /// Rayleigh range of the waist [m]: from the origin back to the cone's apex.
  double ApexOffset = 0.0;

  double Power = 0.0;
  LidarEquation Equation{ 0.15, 1.0, 0.0 };
  AirColumn Air;           // backscatter of the weather
  Droplets Drops;          // single drops of the weather, in addition to Air
  double Background = 0.0; // sunlight from a white surface without extinction [W]
  RangeGate Gate;
  RangeZones Zones;
  RangeNoise Noise;
  int ReturnSelection = 0;
  int MaximumNumberOfReturns = 0; // 0: all
  std::uint64_t Seed = 0;
  vtkHeliosEchoAlgorithm::Outputs Wants;

  /// Returns the energy that a surface returns along an axis, relative to a white surface.
  double GetBackscatter(vtkIdType cell, const Vec3& axis) const
  {
    Vec3 normal = this->Caster->GetGeometry().GetNormal(cell);
    this->Surfaces.GetNormal(cell, normal);
    return helios::GetBackscatter(
      this->Surfaces.GetReflection(this->Surfaces.GetMaterialId(cell)), std::abs(normal.Dot(axis)));
  }

  /// Returns the amplitude of a plane of reflectance 0.5 across a whole beam [W].
  double GetFullAmplitude(double range) const
  {
    return this->Power * this->Equation(range, 0.5, 1.0);
  }

  /// Returns the amplitude of a white diffuse plane across a whole beam [W].
  double GetWhiteAmplitude(double range) const
  {
    return this->Power * this->Equation(range, 1.0, 1.0);
  }

  /// Returns where the edges of a pulse's beam meet, behind its origin if it has a waist.
  Vec3 GetApex(const Pulse& pulse) const
  {
    return pulse.Origin - this->ApexOffset * pulse.GetDirection();
  }

  /// Probes all of a pulse's beam; the range is from the pulse's origin. Sets the layer that fills
  /// it, if there is one that can be sampled.
  vtkHeliosConeHit ProbeCone(
    const Pulse& pulse, ConeLayer& layer, const ConeGroup* group = nullptr) const
  {
    const Vec3 axis = pulse.GetDirection();
    const Vec3 apex = this->GetApex(pulse);
    PlaneLimits limits(this->Plan.PlaneDistance);
    limits.OfPlane.Contrast = this->Plan.PlaneContrast;
    limits.Overlap = this->Plan.Overlap;
    limits.GetResponse = [this, &axis](vtkIdType cell) { return this->GetBackscatter(cell, axis); };
    if (this->HasLayers())
    {
      limits.OfLayer = { this->Plan.LayerDistance, this->Plan.LayerContrast };
    }
    layer.Size = 0;
    ConeLayer* const wanted = this->HasLayers() ? &layer : nullptr;
    const double* o = apex.GetData();
    const double* d = axis.GetData();
    vtkHeliosConeHit hit = group
      ? this->Cones->ProbeGroup(o, d, this->ConeTangent, limits, wanted, *group)
      : this->Cones->Probe(o, d, this->ConeTangent, limits, wanted);
    hit.Range -= this->ApexOffset;
    return hit;
  }

  /// Returns whether layers are sampled: sub-rays that start at one point.
  bool HasLayers() const { return !this->LayerSubRays.empty(); }

  /// Returns whether the beam of a pulse may hit leaves: if so, it takes all its sub-rays.
  bool MayHitTurbidVoxels(const Pulse& pulse) const
  {
    return !this->Medium.IsEmpty() &&
      this->Medium.MayMeet(pulse.Origin, pulse.GetDirection(), this->ConeTangent, this->ApexOffset);
  }

  /// Returns whether echoes are the maxima of a sum of Gaussians.
  bool HasGaussianSum() const
  {
    return !(this->Receiver.Noise > 0.0) && !(this->Background > 0.0) &&
      std::isinf(this->Receiver.Saturation) && this->Receiver.Shape.IsGaussian() &&
      this->Receiver.Detector->FindsMaxima();
  }
};

} // namespace helios

#endif
