// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// The path of a scan's pulses to their echoes, chosen once a scan.

#ifndef heliosScanPath_h
#define heliosScanPath_h

#include "vtkHeliosScannerCoreModule.h" // For export macro

namespace helios
{

/// The sampling of a beam.
enum class BeamPath
{
  SingleRay, ///< no divergence: one ray
  Fixed,     ///< equal sub-rays for every pulse
  Adaptive,  ///< the visible parts of surfaces; among too many of them, sub-rays as needed
  ConeFirst  ///< a cone probe: an empty beam and a planar footprint need no more; others Adaptive
};

/// The detection of echoes in the returns of a pulse.
enum class EchoPath
{
  /// maxima of the sum of Gaussians, by Newton's method; in bins where there may be several
  Maxima,
  BinnedMaxima, ///< byte-identical to Waveform; only the bins that may hold a maximum are filled
  Waveform,     ///< by the detector, in the whole waveform
  Mean          ///< one, of all returns: no waveform
};

/// Properties that the choice depends on.
struct ScanTraits
{
  bool HasDivergence = true;
  bool IsFixed = false;     ///< whether the sampling is fixed
  bool FindsPlanes = false; ///< whether cone probes of an adaptive beam are worth their time
  bool StoresWaveforms = false;
  bool HasGaussianSum = false; ///< whether echoes are the maxima of a sum of Gaussians, no more
  bool MergesReturns = false;  ///< whether all returns of a pulse are one echo

  bool IsAdaptive() const { return this->HasDivergence && !this->IsFixed; }
};

struct ScanPath
{
  BeamPath Beam = BeamPath::SingleRay;
  EchoPath Echo = EchoPath::Waveform;

  /// Returns whether the number of sub-rays of a beam adapts to the tolerances.
  bool IsAdaptive() const
  {
    return this->Beam == BeamPath::Adaptive || this->Beam == BeamPath::ConeFirst;
  }
};

VTKHELIOSSCANNERCORE_EXPORT ScanPath ChoosePath(const ScanTraits& traits);

} // namespace helios

#endif
