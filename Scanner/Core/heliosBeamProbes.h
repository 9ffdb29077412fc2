// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// The sub-rays that a beam is made of, or looked at with.

#ifndef heliosBeamProbes_h
#define heliosBeamProbes_h

#include "heliosScanModel.h"

#include <utility>
#include <vector>

class vtkHeliosBeamSampler;

namespace helios
{

/// All sub-rays of a sampler.
std::vector<SubRay> GetSubRays(vtkHeliosBeamSampler* sampler);

/// Gauss-Legendre rings of a beam, and eight sub-rays without weight near its rim, to see edges there.
std::vector<SubRay> MakeProbes(vtkHeliosBeamSampler* beam, int rings, double setback);

/// Each sub-ray with the three nearest to it.
std::vector<std::pair<int, int>> PairNeighbours(const std::vector<SubRay>& subRays);

/**
 * Whether it pays to ask each beam for one plane, or for nothing, before sub-rays are cast: it costs as
 * much as the first sixteen. Asked of pulses spread over all of the scan, so that every piece of it gets
 * the same answer.
 */
bool FindsPlanes(const ScanModel& model, vtkIdType numberOfPulses);

} // namespace helios

#endif
