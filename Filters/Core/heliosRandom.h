// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Counter-based random numbers (Philox), byte-identical for any number of threads or pieces.

#ifndef heliosRandom_h
#define heliosRandom_h

#include "vtkHeliosFiltersCoreModule.h"

#include <array>
#include <cstdint>

namespace helios
{

/// Purpose of a random number; two streams never share a number.
enum class RandomStream : std::uint32_t
{
  RangeNoise = 1,
  Scene = 2,
  Platform = 3,
  AngleNoise = 4,
  DetectorNoise = 5,
  Navigation = 6,
  PhotonCounts = 7,
  LegOffset = 16,
  VoxelShift = 20,
  TurbidMedium = 21,
  RandomMaterial = 22,
  PartTable = 23,
  Droplets = 24,
  Waves = 25,
  Scattering = 26,
  ScanPositions = 40
};

/**
 * Returns a pair of independent standard normal numbers, a pure function of its key: the seed, the
 * stream, the item (a pulse, a point) and the draw index. Philox4x64-10 (Salmon et al. 2011), then
 * Box-Muller.
 */
VTKHELIOSFILTERSCORE_EXPORT std::array<double, 2> NormalPair(
  std::uint64_t seed, RandomStream stream, std::uint64_t item, std::uint32_t draw);

/// Returns four independent numbers, uniform in the open interval (0, 1), with the key of
/// NormalPair().
VTKHELIOSFILTERSCORE_EXPORT std::array<double, 4> Uniform4(
  std::uint64_t seed, RandomStream stream, std::uint64_t item, std::uint32_t draw);

} // namespace helios

#endif
