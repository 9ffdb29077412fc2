// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// A motion as a function of time, and the samples that stand for it.

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

/// A part of a motion without jumps: where it is after a time in [0, Duration].
struct MotionPiece
{
  vtkIdType Waypoint; // where its leg starts
  double Duration;    // [s]
  std::function<MotionState(double)> At;
};

struct MotionSample
{
  double Time; // [s], since the piece began
  MotionState State;
};

/// What is left of the motion between two samples [m], [rad].
constexpr double SampleTolerance = 1e-7;

/**
 * The samples of a piece, its ends among them: as few as keep the cubic in between (HermiteSegment)
 * and the attitude that turns at a constant rate within a tolerance of the motion [m] and [rad],
 * found by halving.
 */
VTKHELIOSSCANNERPLATFORMS_EXPORT std::vector<MotionSample> SamplePiece(
  const MotionPiece& piece, double tolerance = SampleTolerance);

} // namespace helios

#endif
