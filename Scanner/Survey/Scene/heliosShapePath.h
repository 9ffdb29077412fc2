// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// The shape of a part at a pulse, from its frames.

#ifndef heliosShapePath_h
#define heliosShapePath_h

#include "heliosFramesData.h"
#include "heliosInstanceMotion.h"
#include "heliosMeshFrames.h"
#include "heliosMotionData.h"
#include "heliosPulseClock.h"
#include "heliosSimilarity.h"
#include "heliosStatus.h"

#include <array>
#include <map>
#include <memory>
#include <string>
#include <utility>

namespace helios
{

/// The frames of a part, and their rate.
struct PartFrames
{
  std::shared_ptr<const MeshFrames> Frames; ///< null: it does not deform
  FramesData Data;
  std::string First; ///< names of the first and the last frame
  std::string Last;
  Similarity Place;      ///< where the filters of the part place it
  double Rate = 0.0;     ///< frames per second
  bool IsClosed = false; ///< whether a loop goes from the last frame to the first, else it jumps

  /// Returns the place among the frames at a time of the survey [s], before loops.
  double GetPlace(double time) const { return (time + this->Data.Start) * this->Rate; }

  /// Returns an error for a part with a name if the frames end before a span of the survey [s] does.
  Status CheckSpan(const std::string& part, double start, double end) const;

  /// Returns the frames at both ends of an interval, given by the frame before it; the same one where
  /// the mesh stands still.
  std::pair<std::size_t, std::size_t> FindEnds(double interval) const;

  /// Describes it: "deforms: 3 frames of 10 vertices ...".
  std::string Describe() const;

  /// Returns the places after which the frames repeat; 0: never.
  double GetPeriod() const;
};

/// The frames of the parts of a scene that deform, by their ids.
using SceneFrames = std::map<int, std::shared_ptr<const PartFrames>>;

/// One per thread.
class ShapePath
{
public:
  ShapePath(
    const MotionData& motion, std::shared_ptr<const PartFrames> frames, const PulseClock& clock);

  const MeshFrames& GetFrames() const { return *this->Frames->Frames; }

  /// Finds the shape that a pulse sees: at its time, or at the time of its step.
  void Find(const SceneMoment& moment, MeshShape& shape) const;

  /// Returns a box that contains the mesh at all moments of a span.
  std::array<double, 6> GetBounds(const MomentSpan& span) const;

private:
  double GetSeenPlace(const SceneMoment& moment) const;

  MotionData Motion;
  std::shared_ptr<const PartFrames> Frames;
  PulseClock Clock;
};

} // namespace helios

#endif
