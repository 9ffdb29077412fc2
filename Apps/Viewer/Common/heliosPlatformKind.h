// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Kinds of platforms, by names, and where they tell nothing by how they move.

#ifndef heliosPlatformKind_h
#define heliosPlatformKind_h

namespace helios
{
struct PlatformData;
}

namespace helios::viewer
{

enum class PlatformKind
{
  Unknown,
  Tripod,
  Person,
  Car,
  Tractor,
  Multicopter,
  Aircraft
};

/// Returns the kind by the words in a platform's id and name ("car_linearpath"), else by its type;
/// Unknown: it may be anything that moves.
PlatformKind FindPlatformKind(const PlatformData& platform);

/// Returns the kind by height above ground [m] and speed [m/s]; NaN: not known.
PlatformKind GuessPlatformKind(double height, double speed);

/// Returns whether it stands or drives on the ground.
bool IsOnGround(PlatformKind kind);

} // namespace helios::viewer

#endif
