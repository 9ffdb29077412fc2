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

/// A beam as it goes on, as if it came straight from a point: the mirrored origin, or nearly its own.
struct PassedBeam
{
  Vec3 Origin, Axis, Minor;
  bool IsReflected;
  double Excess; ///< of the optical length over the distance from Origin [m]
  BeyondPlane Beyond;
};

/// A beam that meets a plane everywhere.
struct BeamOnPlane
{
  Vec3 Origin, Axis, Minor;
  double Range;   ///< to the plane, along the axis [m]
  Vec3 Normal;    ///< of the plane, against the beam
  double Tangent; ///< of the half angle of the beam
};

/// The share of the energy that a mirror or pane reflects or transmits, at a cosine of incidence.
VTKHELIOSSCANNERCORE_EXPORT double GetShare(
  const MaterialOptics& optics, double cosine, bool isReflected);

/**
 * The beams behind a mirror or pane: reflected, and transmitted through a pane. False for others, at grazing incidence, and if the reflected beam may hit a receiver of a
 * radius [m] at the origin: these have to be sampled.
 */
VTKHELIOSSCANNERCORE_EXPORT bool PassFlatOptics(const BeamOnPlane& beam,
  const MaterialOptics& optics, double receiver, std::vector<PassedBeam>& passed);

} // namespace helios

#endif
