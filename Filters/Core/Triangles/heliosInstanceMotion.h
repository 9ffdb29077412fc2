// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// The places of instances that move, as functions of the pulse.

#ifndef heliosInstanceMotion_h
#define heliosInstanceMotion_h

#include "heliosMeshFrames.h"
#include "heliosPose.h"
#include "heliosSimilarity.h"

#include <vtkType.h>

#include <memory>

namespace helios
{

/// A pulse of a leg, and when it is emitted [s].
struct SceneMoment
{
  vtkIdType Pulse = 0;
  double Time = 0.0;
};

/// Pulses [First, Last] of a leg, and a span of time that has their times [s].
struct MomentSpan
{
  vtkIdType First = 0;
  vtkIdType Last = -1;
  double Start = 0.0;
  double End = 0.0;

  bool Has(const SceneMoment& moment) const
  {
    return moment.Pulse >= this->First && moment.Pulse <= this->Last &&
      moment.Time >= this->Start && moment.Time <= this->End;
  }
};

/// The place of one instance over time. One per thread: it keeps the last place.
class InstanceTrack
{
public:
  InstanceTrack() = default;
  virtual ~InstanceTrack() = default;
  InstanceTrack(const InstanceTrack&) = delete;
  void operator=(const InstanceTrack&) = delete;

  /// Sets the place at a moment; the place is the one that the last call has set.
  virtual void Move(const SceneMoment& moment, Similarity& place) = 0;

  /// Computes a box that contains the instance at all moments of a span; own: the box of its
  /// prototype.
  virtual void ComputeBounds(const MomentSpan& span, const double own[6], double bounds[6]) = 0;

  /// Finds the shape at a moment, if it has frames.
  virtual void FindShape(const SceneMoment& /*moment*/, MeshShape& /*shape*/) {}

  /// Returns the velocity of its point that is at a place of the scene [m/s], as of a rigid body.
  virtual Vec3 GetVelocity(const SceneMoment& moment, const Vec3& point) = 0;

  /// Computes the displacement of the centroid from its place at rest, and the rotation since.
  virtual Pose GetPose(const SceneMoment& moment) = 0;
};

/// The motions of the instances of a scene, by MotionIds. Thread-safe.
class InstanceMotions
{
public:
  InstanceMotions() = default;
  virtual ~InstanceMotions() = default;
  InstanceMotions(const InstanceMotions&) = delete;
  void operator=(const InstanceMotions&) = delete;

  virtual int GetNumberOfTracks() const = 0;
  virtual std::unique_ptr<InstanceTrack> MakeTrack(int motion) const = 0;

  /// Returns the frames of a mesh that deforms in the frame of its prototype; null: it is rigid.
  virtual const MeshFrames* GetFrames(int /*motion*/) const { return nullptr; }

  /// Returns a span of a number of pulses with a moment.
  virtual MomentSpan GetSpan(const SceneMoment& moment, vtkIdType pulses) const = 0;

  /// Returns whether all instances are at the same places at all moments of a span; false if that
  /// is not known.
  virtual bool AreAtRest(const MomentSpan& span) const = 0;
};

} // namespace helios

#endif
