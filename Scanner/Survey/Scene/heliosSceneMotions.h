// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// The motions of the parts of a scene during a leg.

#ifndef heliosSceneMotions_h
#define heliosSceneMotions_h

#include "heliosInstanceMotion.h"
#include "heliosPartPath.h"
#include "heliosShapePath.h"

#include <memory>
#include <string>
#include <vector>

namespace helios
{

/// A part that moves.
struct MovingPartData
{
  static constexpr std::size_t None = static_cast<std::size_t>(-1);

  int Id = 0; ///< its PartIds
  std::string Name;
  MotionData Data;
  std::shared_ptr<const PartMotion> Motion; ///< null: none of its own
  std::shared_ptr<const Trajectory> Track;  ///< null: it follows none
  std::shared_ptr<const PartFrames> Frames; ///< null: it does not deform
  std::size_t Carrier = None;               ///< number of the part that carries it
  Vec3 Centroid{ 0.0, 0.0, 0.0 };           ///< centroid of its area, at rest
};

/// The motions of instances: each belongs to a part, at its place at rest.
class SceneMotions : public InstanceMotions
{
public:
  struct Instance
  {
    std::size_t Part;
    Similarity AtRest;
    std::shared_ptr<const PartFrames> Frames; ///< in the frame of its prototype; null: it is rigid
  };
  /// The part of a motion that does not depend on the leg.
  struct Content
  {
    std::vector<MovingPartData> Parts;
    std::vector<Instance> Instances; ///< by MotionIds
  };

  SceneMotions(std::shared_ptr<const Content> content, const PulseClock& clock);

  int GetNumberOfTracks() const override;
  std::unique_ptr<InstanceTrack> MakeTrack(int motion) const override;
  const MeshFrames* GetFrames(int motion) const override;
  MomentSpan GetSpan(const SceneMoment& moment, vtkIdType pulses) const override;
  bool AreAtRest(const MomentSpan& span) const override;

  const Content& GetContent() const { return *this->Shared; }

  /// Returns the path of a part, by its number.
  std::unique_ptr<PartPath> MakePath(std::size_t part) const;
  void AddSteps(const MovingPartData& part);

private:
  std::shared_ptr<const Content> Shared;
  PulseClock Clock;
  bool OnlySteps = true;         ///< no part moves between steps
  std::vector<MotionData> Steps; ///< motions of parts that step at different times
};

} // namespace helios

#endif
