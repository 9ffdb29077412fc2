// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosFlatOptics.h"

#include "heliosFresnel.h"

#include <algorithm>
#include <cmath>

namespace helios
{
namespace
{

constexpr double MinimumCosine = 0.05; // cosine of incidence

/// Returns the half space on the side of a normal of the plane that a beam hits.
BeyondPlane GetBeyond(const BeamOnPlane& beam, const Vec3& normal, const Vec3& from)
{
  const Vec3 point = beam.Origin + beam.Range * beam.Axis;
  const double cosine = -beam.Normal.Dot(beam.Axis);
  const double range = std::abs((from - point).Dot(beam.Normal)) / cosine;
  const double slope = beam.Tangent * std::sqrt(std::max(0.0, 1.0 - cosine * cosine)) / cosine;
  BeyondPlane beyond;
  beyond.Nearest = (1.0 + 1e-9) * range / (1.0 + slope);
  std::copy_n(normal.GetData(), 3, beyond.Normal);
  beyond.Constant = normal.Dot(point);
  return beyond;
}

PassedBeam Reflect(const BeamOnPlane& beam)
{
  const Vec3 point = beam.Origin + beam.Range * beam.Axis;
  const Vec3 origin = point + GetMirrored(beam.Origin - point, beam.Normal);
  return { origin, GetMirrored(beam.Axis, beam.Normal), GetMirrored(beam.Minor, beam.Normal), true,
    0.0, GetBeyond(beam, beam.Normal, origin) };
}

PassedBeam Transmit(const BeamOnPlane& beam, const MaterialOptics& pane)
{
  const double n = pane.RefractiveIndex;
  const double cosine = -beam.Normal.Dot(beam.Axis);
  const double refracted = GetRefractedCosine(cosine, 1.0, n);
  const Vec3 within = GetRefracted(beam.Axis, beam.Normal, 1.0, n, refracted);
  const double length = pane.Thickness / refracted;
  // The pane looks as thick as length / n.
  const Vec3 origin = beam.Origin + length * within - (length / n) * beam.Axis;
  return { origin, beam.Axis, beam.Minor, false, (pane.GroupIndex - 1.0 / n) * length,
    GetBeyond(beam, -1.0 * beam.Normal, origin) };
}

/// Returns whether a reflected beam comes back to the receiver.
bool MayReturn(const BeamOnPlane& beam, const PassedBeam& reflected, double receiver)
{
  const Vec3 toReceiver = beam.Origin - reflected.Origin;
  const double along = toReceiver.Dot(reflected.Axis);
  const double aside = (toReceiver - along * reflected.Axis).Norm();
  return along > 0.0 && aside < receiver + beam.Tangent * along;
}

} // namespace

//------------------------------------------------------------------------------
double GetShare(const MaterialOptics& optics, double cosine, bool isReflected)
{
  if (optics.Kind == OpticsKind::Mirror)
  {
    return isReflected ? optics.MirrorReflectance : 0.0;
  }
  const double within = optics.Thickness / GetRefractedCosine(cosine, 1.0, optics.RefractiveIndex);
  const PaneShares shares =
    GetPaneShares(cosine, optics.RefractiveIndex, std::exp(-optics.Attenuation * within));
  return isReflected ? shares.Reflected : shares.Transmitted;
}

//------------------------------------------------------------------------------
bool PassFlatOptics(const BeamOnPlane& beam, const MaterialOptics& optics, double receiver,
  std::vector<PassedBeam>& passed)
{
  passed.clear();
  const double cosine = -beam.Normal.Dot(beam.Axis);
  if (!(cosine >= MinimumCosine) ||
    (optics.Kind != OpticsKind::Mirror && optics.Kind != OpticsKind::Pane))
  {
    return false;
  }
  if (optics.Kind == OpticsKind::Pane)
  {
    passed.push_back(Transmit(beam, optics));
  }
  passed.push_back(Reflect(beam));
  return !MayReturn(beam, passed.back(), receiver);
}

} // namespace helios
