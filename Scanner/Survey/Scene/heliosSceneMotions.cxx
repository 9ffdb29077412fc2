// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosSceneMotions.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

namespace helios
{

namespace
{

/// Returns a place at rest, moved. A place that is none moves as the points of a part do.
Similarity GetMoved(const Similarity& atRest, const MotionMap& map)
{
  Similarity place = atRest;
  if (!map.Turns)
  {
    place.Translation = atRest.Translation + map.Shift;
    return place;
  }
  place.HasRotation = true;
  place.HasPivot = atRest.IsIdentity();
  if (place.HasPivot)
  {
    place.Turn = map.Linear;
    place.Pivot = map.Center;
    place.Translation = map.Shift;
    return place;
  }
  place.Turn = atRest.HasRotation ? map.Linear * atRest.Turn : map.Linear;
  place.Translation = map * atRest.Translation;
  return place;
}

/// A part that stays where it is.
class RestingPath : public PartPath
{
public:
  bool Move(const SceneMoment&, MotionMap&) override { return false; }
  PathBound GetBound(const MomentSpan&) override { return {}; }
  PathRates GetRates(const SceneMoment&) override { return {}; }
};

/// A part's instance, on the path of the part.
class PartTrack : public InstanceTrack
{
public:
  PartTrack(std::unique_ptr<PartPath> path, std::unique_ptr<ShapePath> shape,
    const Similarity& atRest, const Vec3& centroid)
    : Path(std::move(path))
    , Shape(std::move(shape))
    , AtRest(atRest)
    , Centroid(centroid)
  {
  }

  void Move(const SceneMoment& moment, Similarity& place) override
  {
    if (this->Path->Move(moment, this->Map))
    {
      place = GetMoved(this->AtRest, this->Map);
    }
  }

  void ComputeBounds(const MomentSpan& span, const double prototype[6], double bounds[6]) override
  {
    std::array<double, 6> own{};
    std::copy_n(prototype, 6, own.begin());
    own = this->Shape ? this->Shape->GetBounds(span) : own;
    const PathBound bound = this->Path->GetBound(span);
    const Similarity place = GetMoved(this->AtRest, bound.Map);
    const Vec3 pivot = bound.Map.Center + bound.Map.Shift;
    double distance = 0.0; // distance of the farthest corner
    for (int axis = 0; axis < 3; ++axis)
    {
      bounds[2 * axis] = std::numeric_limits<double>::infinity();
      bounds[2 * axis + 1] = -std::numeric_limits<double>::infinity();
    }
    for (int corner = 0; corner < 8; ++corner)
    {
      const double p[3] = { own[corner & 1], own[2 + (corner >> 1 & 1)], own[4 + (corner >> 2)] };
      Vec3 q;
      place.Apply(p, q.GetData());
      distance = std::max(distance, (q - pivot).Norm());
      for (int axis = 0; axis < 3; ++axis)
      {
        bounds[2 * axis] = std::min(bounds[2 * axis], q[axis]);
        bounds[2 * axis + 1] = std::max(bounds[2 * axis + 1], q[axis]);
      }
    }
    const double world = std::max({ std::abs(pivot[0]), std::abs(pivot[1]), std::abs(pivot[2]) });
    const double rounding = 1e-12 * (distance + bound.Shift + world);
    const double reach = bound.GetReach(distance) + rounding;
    const double ball = bound.Shift + distance + rounding;
    for (int axis = 0; axis < 3; ++axis)
    {
      bounds[2 * axis] = std::max(bounds[2 * axis] - reach, pivot[axis] - ball);
      bounds[2 * axis + 1] = std::min(bounds[2 * axis + 1] + reach, pivot[axis] + ball);
    }
  }

  Vec3 GetVelocity(const SceneMoment& moment, const Vec3& point) override
  {
    return this->Path->GetRates(moment).GetVelocity(point);
  }

  Pose GetPose(const SceneMoment& moment) override
  {
    this->Path->Move(moment, this->Map);
    Pose pose;
    pose.Position = this->Map.Shift;
    if (this->Map.Turns)
    {
      const Vec3 arm = this->Centroid - this->Map.Center;
      pose.Position = this->Map.Shift + (this->Map.Linear * arm - arm);
      double m[3][3];
      std::copy_n(&this->Map.Linear.M[0][0], 9, &m[0][0]);
      pose.Orientation.FromMatrix3x3(m);
      pose.Orientation.Normalize();
    }
    return pose;
  }

  void FindShape(const SceneMoment& moment, MeshShape& shape) override
  {
    this->Shape->Find(moment, shape);
  }

private:
  std::unique_ptr<PartPath> Path;
  std::unique_ptr<ShapePath> Shape; // null: it is rigid
  Similarity AtRest;
  Vec3 Centroid; // centroid of the part at rest
  MotionMap Map;
};

} // namespace

//------------------------------------------------------------------------------
SceneMotions::SceneMotions(std::shared_ptr<const Content> content, const PulseClock& clock)
  : Shared(std::move(content))
  , Clock(clock)
{
  std::for_each(this->Shared->Parts.begin(), this->Shared->Parts.end(),
    [this](const MovingPartData& part) { this->AddSteps(part); });
}

//------------------------------------------------------------------------------
/// Adds when a part steps, unless it is known.
void SceneMotions::AddSteps(const MovingPartData& part)
{
  constexpr std::size_t most = 8;
  const bool doesStep = part.Motion || part.Frames;
  this->OnlySteps = this->OnlySteps && !part.Track && !(doesStep && part.Data.IsContinuous) &&
    this->Steps.size() <= most;
  const auto isSame = [&part](const MotionData& other)
  {
    return other.Seconds == part.Data.Seconds && other.Pulses == part.Data.Pulses &&
      other.Every == part.Data.Every;
  };
  if (this->OnlySteps && doesStep && std::none_of(this->Steps.begin(), this->Steps.end(), isSame))
  {
    this->Steps.push_back(part.Data);
  }
}

//------------------------------------------------------------------------------
int SceneMotions::GetNumberOfTracks() const
{
  return static_cast<int>(this->Shared->Instances.size());
}

//------------------------------------------------------------------------------
std::unique_ptr<InstanceTrack> SceneMotions::MakeTrack(int motion) const
{
  const Instance& instance = this->Shared->Instances[static_cast<std::size_t>(motion)];
  const MovingPartData& part = this->Shared->Parts[instance.Part];
  std::unique_ptr<PartPath> path = this->MakePath(instance.Part);
  path = path ? std::move(path) : std::make_unique<RestingPath>();
  auto shape = instance.Frames
    ? std::make_unique<ShapePath>(part.Data, instance.Frames, this->Clock)
    : nullptr;
  return std::make_unique<PartTrack>(
    std::move(path), std::move(shape), instance.AtRest, part.Centroid);
}

//------------------------------------------------------------------------------
const MeshFrames* SceneMotions::GetFrames(int motion) const
{
  const auto& frames = this->Shared->Instances[static_cast<std::size_t>(motion)].Frames;
  return frames ? frames->Frames.get() : nullptr;
}

//------------------------------------------------------------------------------
std::unique_ptr<PartPath> SceneMotions::MakePath(std::size_t number) const
{
  const MovingPartData& part = this->Shared->Parts[number];
  std::unique_ptr<PartPath> path;
  if (part.Motion && part.Data.IsContinuous)
  {
    path = std::make_unique<ContinuousPath>(part.Data, part.Motion, this->Clock);
  }
  else if (part.Motion)
  {
    path = std::make_unique<StepPath>(part.Data, part.Motion, this->Clock);
  }
  if (part.Track)
  {
    path =
      std::make_unique<MountedPath>(std::make_unique<TrajectoryPath>(part.Track), std::move(path));
  }
  auto carrier = part.Carrier == MovingPartData::None ? nullptr : this->MakePath(part.Carrier);
  if (carrier) // null: none, or it deforms where it stands
  {
    path = std::make_unique<MountedPath>(std::move(carrier), std::move(path));
  }
  return path;
}

//------------------------------------------------------------------------------
MomentSpan SceneMotions::GetSpan(const SceneMoment& moment, vtkIdType pulses) const
{
  MomentSpan span;
  span.First = moment.Pulse / pulses * pulses;
  span.Last = span.First + pulses - 1;
  const auto getTime = [this](vtkIdType pulse)
  { return this->Clock.StartTime + static_cast<double>(pulse) / this->Clock.Rate; };
  span.Start = std::min(moment.Time, getTime(span.First - 1));
  span.End = std::max(moment.Time, getTime(span.Last + 1));
  return span;
}

//------------------------------------------------------------------------------
bool SceneMotions::AreAtRest(const MomentSpan& span) const
{
  return this->OnlySteps &&
    std::all_of(this->Steps.begin(), this->Steps.end(),
      [&](const MotionData& motion)
      {
        return FindSeenStep(motion, this->Clock, span.First) ==
          FindSeenStep(motion, this->Clock, span.Last);
      });
}

} // namespace helios
