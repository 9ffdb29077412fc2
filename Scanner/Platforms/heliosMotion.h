// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// A motion as a function of time, and its samples.

#ifndef heliosMotion_h
#define heliosMotion_h

#include "heliosPose.h"
#include "vtkHeliosScannerPlatformsModule.h" // For export macro

#include <vtkType.h>

#include <functional>
#include <vector>

namespace helios
{

struct MotionState
{
  Vec3 Position;
  Vec3 Velocity;
  Quaternion Orientation;
};

/// A part of a motion without jumps: the state after a time in [0, Duration].
struct MotionPiece
{
  vtkIdType Waypoint; // start of its leg
  double Duration;    // [s]
  std::function<MotionState(double)> At;
};

struct MotionSample
{
  double Time; // [s], since the start of the piece
  MotionState State;
};

/// The interpolation errors between two samples [m], [rad].
constexpr double SampleTolerance = 1e-7;

/**
 * Returns the samples of a piece, including its ends: the fewest for which the cubic in between
 * (HermiteSegment) and the attitude rotating at a constant rate are within a tolerance of the
 * motion [m] and [rad], found by halving.
 */
VTKHELIOSSCANNERPLATFORMS_EXPORT std::vector<MotionSample> SamplePiece(
  const MotionPiece& piece, double tolerance = SampleTolerance);

} // namespace helios

#endif
