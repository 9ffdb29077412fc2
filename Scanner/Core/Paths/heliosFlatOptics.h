// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// A whole beam at a flat mirror or pane.

#ifndef heliosFlatOptics_h
#define heliosFlatOptics_h

#include "heliosFootprint.h"
#include "heliosMaterialTable.h"
#include "heliosPose.h"
#include "vtkHeliosScannerCoreModule.h" // For export macro

#include <vector>

namespace helios
{

/// A reflected or refracted beam, described by its virtual origin: the mirrored origin, or nearly
/// its own.
struct PassedBeam
{
  Vec3 Origin, Axis, Minor;
  bool IsReflected;
  double Excess; ///< optical length minus the distance from Origin [m]
  BeyondPlane Beyond;
};

/// A beam that meets a plane everywhere.
struct BeamOnPlane
{
  Vec3 Origin, Axis, Minor;
  double Range;   ///< to the plane, along the axis [m]
  Vec3 Normal;    ///< normal of the plane, against the beam
  double Tangent; ///< tangent of the half angle of the beam
};

/// Returns the share of the energy that a mirror or pane reflects or transmits, at a cosine of
/// incidence.
VTKHELIOSSCANNERCORE_EXPORT double GetShare(
  const MaterialOptics& optics, double cosine, bool isReflected);

/**
 * Computes the beams behind a mirror or pane: reflected, and transmitted through a pane. False for
 * others, at grazing incidence, and if the reflected beam may hit a receiver of a radius [m] at the
 * origin: these have to be sampled.
 */
VTKHELIOSSCANNERCORE_EXPORT bool PassFlatOptics(const BeamOnPlane& beam,
  const MaterialOptics& optics, double receiver, std::vector<PassedBeam>& passed);

} // namespace helios

#endif
