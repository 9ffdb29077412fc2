// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosRangeZones.h"

#include "heliosConstants.h"
#include "vtkHeliosBeamDeflector.h"

#include <algorithm>
#include <cmath>

namespace helios
{
namespace
{

constexpr double MetersPerSecond = 1e9 * SpeedOfLight; // unit of c in m/ns
constexpr vtkIdType MaximumChannels = 100000;

/// Returns the pulses from one to the next of its channel.
vtkIdType FindStride(const vtkHeliosBeamDeflector& deflector)
{
  const int channel = deflector.GetChannel(0);
  vtkIdType stride = 1;
  while (stride < MaximumChannels && deflector.GetChannel(stride) != channel)
  {
    ++stride;
  }
  return stride;
}

} // namespace

//------------------------------------------------------------------------------
vtkIdType RangeZones::GetStep(double range) const
{
  return static_cast<vtkIdType>(std::floor(std::max(0.0, range) / this->Depth)) - (this->Zone - 1);
}

//------------------------------------------------------------------------------
RangeZones MakeRangeZones(vtkHeliosBeamDeflector& deflector, int zone, vtkIdType numberOfPulses)
{
  RangeZones zones;
  if (zone > 0)
  {
    zones.Zone = zone;
    zones.Stride = FindStride(deflector);
    zones.Depth =
      0.5 * MetersPerSecond * static_cast<double>(zones.Stride) / deflector.GetPulseFrequency();
    zones.NumberOfPulses = numberOfPulses;
  }
  return zones;
}

} // namespace helios
