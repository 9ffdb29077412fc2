// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Where a part is at a pulse: by steps, continuously, along a trajectory, or on another part.

#ifndef heliosPartPath_h
#define heliosPartPath_h

#include "heliosInstanceMotion.h"
#include "heliosMotionData.h"
#include "heliosPartMotion.h"
#include "heliosPulseClock.h"
#include "heliosTrajectory.h"

#include <memory>

namespace helios
{

/// Where a part is within a span.
struct PathBound
{
  MotionMap Map;      ///< at one moment of the span
  double Shift = 0.0; ///< the farthest that the image of Map.Center is from there [m]
  double Angle = 0.0; ///< the largest rotation from there [rad]; infinite: it may be mirrored

  /// Returns the farthest that a point moves at a distance from Map.Center.
  double GetReach(double distance) const;
};

/// How a part moves: as a rigid body, one of whose points has a velocity [m/s, rad/s].
struct PathRates
{
  Vec3 Point{ 0.0, 0.0, 0.0 };
  Vec3 Velocity{ 0.0, 0.0, 0.0 };
  Vec3 Rotation{ 0.0, 0.0, 0.0 };

  Vec3 GetVelocity(const Vec3& at) const
  {
    return this->Velocity + this->Rotation.Cross(at - this->Point);
  }
};

/// One per thread: it keeps what it found last.
class PartPath
{
public:
  PartPath() = default;
  virtual ~PartPath() = default;
  PartPath(const PartPath&) = delete;
  void operator=(const PartPath&) = delete;

  /// Sets the map from the part at rest to where it is; false if the last call set the same.
  virtual bool Move(const SceneMoment& moment, MotionMap& map) = 0;
  virtual PathBound GetBound(const MomentSpan& span) = 0;
  virtual PathRates GetRates(const SceneMoment& moment) = 0;
};

/// A part that steps; its velocity is that of the screw to the next step.
class StepPath : public PartPath
{
public:
  StepPath(
    const MotionData& data, std::shared_ptr<const PartMotion> motion, const PulseClock& clock);
  bool Move(const SceneMoment& moment, MotionMap& map) override;
  PathBound GetBound(const MomentSpan& span) override;
  PathRates GetRates(const SceneMoment& moment) override;

protected:
  const MotionSection& FindSection(vtkIdType step);
  PathRates GetRatesAt(double step);

  MotionData Data;
  std::shared_ptr<const PartMotion> Motion;
  PulseClock Clock;

private:
  vtkIdType Step = -1; ///< step of the last map
  bool HasSection = false;
  MotionSection Section;
};

/// A part that is between two steps at every time.
class ContinuousPath : public StepPath
{
public:
  using StepPath::StepPath;
  bool Move(const SceneMoment& moment, MotionMap& map) override;
  PathBound GetBound(const MomentSpan& span) override;
  PathRates GetRates(const SceneMoment& moment) override;

private:
  double GetStep(const SceneMoment& moment) const;
};

/// A part whose frame follows a trajectory.
class TrajectoryPath : public PartPath
{
public:
  explicit TrajectoryPath(std::shared_ptr<const Trajectory> trajectory);
  bool Move(const SceneMoment& moment, MotionMap& map) override;
  PathBound GetBound(const MomentSpan& span) override;
  PathRates GetRates(const SceneMoment& moment) override;

private:
  std::shared_ptr<const Trajectory> Track;
  Trajectory::Cursor Cursor;
};

/// A part that another one carries; its own path, in the frame of the other at rest, may be null.
class MountedPath : public PartPath
{
public:
  MountedPath(std::unique_ptr<PartPath> carrier, std::unique_ptr<PartPath> own);
  bool Move(const SceneMoment& moment, MotionMap& map) override;
  PathBound GetBound(const MomentSpan& span) override;
  PathRates GetRates(const SceneMoment& moment) override;

private:
  std::unique_ptr<PartPath> Carrier;
  std::unique_ptr<PartPath> Own;
  MotionMap OfCarrier;
  MotionMap OfOwn;
};

} // namespace helios

#endif
