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

/// Vogel's spiral of a beam: no pattern of fixed sub-rays does better where surfaces have edges.
std::vector<SubRay> MakeSpiral(vtkHeliosBeamSampler* beam, int count);

/// Gauss-Legendre rings of a beam: nothing does better on a smooth surface.
std::vector<SubRay> MakeRings(vtkHeliosBeamSampler* beam, int rings);

/// Such rings, and eight sub-rays without weight near its rim, to see edges there.
std::vector<SubRay> MakeProbes(vtkHeliosBeamSampler* beam, int rings, double setback);

/// Puts neighbours next to each other (Morton's order): rays that are tested together meet the same.
void SortInSpace(std::vector<SubRay>& subRays);

/// The pairs of neighbours that join all sub-rays in the shortest way.
std::vector<std::pair<std::size_t, std::size_t>> JoinNeighbours(const std::vector<SubRay>& subRays);

/**
 * Whether it pays to ask each beam for one plane, or for nothing, before sub-rays are cast: it costs as
 * much as the first sixteen. Asked of pulses spread over all of the scan, so that every piece of it gets
 * the same answer.
 */
bool FindsPlanes(const ScanModel& model, vtkIdType numberOfPulses);

} // namespace helios

#endif
