// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosScanPath.h"

namespace helios
{
namespace
{

BeamPath ChooseBeamPath(const ScanTraits& traits)
{
  if (!traits.HasDivergence)
  {
    return BeamPath::SingleRay;
  }
  if (traits.IsFixed)
  {
    return BeamPath::Fixed;
  }
  return traits.FindsPlanes ? BeamPath::ConeFirst : BeamPath::Adaptive;
}

} // namespace

ScanPath ChoosePath(const ScanTraits& traits)
{
  const BeamPath beam = ChooseBeamPath(traits);
  if (traits.MergesReturns)
  {
    return { beam, EchoPath::Mean };
  }
  if (!traits.HasGaussianSum)
  {
    return { beam, EchoPath::Waveform };
  }
  if (beam != BeamPath::Fixed)
  {
    return { beam, EchoPath::Maxima };
  }
  // Fixed sampling has the echoes of the samples that would be stored.
  return { beam, traits.StoresWaveforms ? EchoPath::Waveform : EchoPath::BinnedMaxima };
}

} // namespace helios
