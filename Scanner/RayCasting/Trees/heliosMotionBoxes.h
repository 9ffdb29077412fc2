// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// The boxes of the instances that move, over pieces of time, for all threads.

#ifndef heliosMotionBoxes_h
#define heliosMotionBoxes_h

#include "heliosBoxTree.h"
#include "heliosInstanceMotion.h"

#include <array>
#include <cstddef>
#include <memory>
#include <mutex>
#include <vector>

namespace helios
{

class SceneGeometry;

/// The boxes in which the instances that move are over a span.
struct MovingBoxes
{
  MomentSpan Span;
  BoxTree Boxes;
};

/// Boxes for the motions of a scene. Thread-safe: the first thread at a moment of a span makes its
/// boxes; a span has more pulses the less the instances move. Results do not depend on them.
class MotionBoxes
{
public:
  explicit MotionBoxes(const SceneGeometry& moving);

  /// Returns whether they are those of the motions of a scene.
  bool IsOf(const SceneGeometry& moving) const;

  /// Returns whether the motions do not exist any more.
  bool IsOver() const { return this->Motions.expired(); }

  /// Returns boxes with a moment, of the same scene, whose motions must be the same.
  std::shared_ptr<const MovingBoxes> Get(const SceneGeometry& moving, const SceneMoment& moment);

private:
  using Bounds = std::vector<std::array<double, 6>>;

  void MakeTracks(const SceneGeometry& moving);
  double ComputeBounds(const SceneGeometry& moving, const MomentSpan& span, Bounds& bounds);
  MomentSpan ChooseSpan(const SceneGeometry& moving, const SceneMoment& moment, Bounds& bounds);

  std::weak_ptr<const InstanceMotions> Motions;
  std::mutex Mutex;
  std::vector<int> Instances;                             ///< numbers of those that move
  std::vector<std::unique_ptr<InstanceTrack>> Tracks;     ///< their tracks; empty: not made yet
  vtkIdType Pulses = 1024;                                ///< pulses of the last span
  std::array<std::shared_ptr<const MovingBoxes>, 8> Last; ///< the last ones made
  std::size_t Next = 0;                                   ///< the oldest one
};

} // namespace helios

#endif
