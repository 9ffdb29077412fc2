// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosMotionBoxes.h"

#include "heliosSceneGeometry.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace helios
{

namespace
{

constexpr double Small = 1.1; // relative sizes of boxes
constexpr double Large = 1.5;
constexpr vtkIdType MaximumPulses = 1 << 20;
constexpr vtkIdType PulsesPerInstance =
  4; // at least: boxes take a tenth of the time of their pulses

double GetDiagonal(const double bounds[6])
{
  return std::hypot(bounds[1] - bounds[0], bounds[3] - bounds[2], bounds[5] - bounds[4]);
}

} // namespace

//------------------------------------------------------------------------------
MotionBoxes::MotionBoxes(const SceneGeometry& moving)
  : Motions(moving.GetMoved()->GetMotions())
{
}

//------------------------------------------------------------------------------
bool MotionBoxes::IsOf(const SceneGeometry& moving) const
{
  return this->Motions.lock() == moving.GetMoved()->GetMotions();
}

//------------------------------------------------------------------------------
std::shared_ptr<const MovingBoxes> MotionBoxes::Get(
  const SceneGeometry& moving, const SceneMoment& moment)
{
  const std::lock_guard<std::mutex> lock(this->Mutex);
  const auto known = std::find_if(this->Last.begin(), this->Last.end(),
    [&moment](const auto& boxes) { return boxes && boxes->Span.Has(moment); });
  if (known != this->Last.end())
  {
    return *known;
  }
  this->MakeTracks(moving);
  Bounds bounds;
  const auto made = std::make_shared<MovingBoxes>();
  made->Span = this->ChooseSpan(moving, moment, bounds);
  made->Boxes.Instances = this->Instances;
  made->Boxes.Build(std::move(bounds));
  this->Last[this->Next] = made;
  this->Next = (this->Next + 1) % this->Last.size();
  return made;
}

//------------------------------------------------------------------------------
/// Makes the tracks of the instances that move, once.
void MotionBoxes::MakeTracks(const SceneGeometry& moving)
{
  const auto& all = moving.GetInstances();
  const bool areMade = !this->Tracks.empty();
  for (std::size_t i = 0; !areMade && i < all.size(); ++i)
  {
    if (all[i].Motion >= 0)
    {
      this->Instances.push_back(static_cast<int>(i));
      this->Tracks.push_back(moving.GetMoved()->GetMotions()->MakeTrack(all[i].Motion));
    }
  }
}

//------------------------------------------------------------------------------
/// Returns a span with a moment, and computes the boxes of the instances.
MomentSpan MotionBoxes::ChooseSpan(
  const SceneGeometry& moving, const SceneMoment& moment, Bounds& bounds)
{
  const InstanceMotions& motions = *moving.GetMoved()->GetMotions();
  const vtkIdType minimum = PulsesPerInstance * static_cast<vtkIdType>(this->Tracks.size());
  for (; this->Pulses < minimum && this->Pulses < MaximumPulses; this->Pulses *= 2)
  {
  }
  MomentSpan span = motions.GetSpan(moment, this->Pulses);
  double size = this->ComputeBounds(moving, span, bounds);
  const bool isSmall = size < Small;
  while (isSmall ? size < Small && this->Pulses < MaximumPulses
                 : size > Large && this->Pulses / 2 >= minimum && this->Pulses > 1)
  {
    this->Pulses = isSmall ? 2 * this->Pulses : this->Pulses / 2;
    span = motions.GetSpan(moment, this->Pulses);
    size = this->ComputeBounds(moving, span, bounds);
  }
  return span;
}

//------------------------------------------------------------------------------
/// Computes the boxes of the instances over a span; returns the sum of their sizes, relative to that
/// of the boxes of their prototypes.
double MotionBoxes::ComputeBounds(
  const SceneGeometry& moving, const MomentSpan& span, Bounds& bounds)
{
  bounds.resize(this->Tracks.size());
  double atRest = 0.0;
  double swept = 0.0;
  for (std::size_t i = 0; i < this->Tracks.size(); ++i)
  {
    const SceneInstance& instance =
      moving.GetInstances()[static_cast<std::size_t>(this->Instances[i])];
    double own[6];
    moving.GetPrototype(instance).GetBounds(own);
    this->Tracks[i]->ComputeBounds(span, own, bounds[i].data());
    atRest += instance.Place.Scale * GetDiagonal(own);
    swept += GetDiagonal(bounds[i].data());
  }
  return swept / atRest;
}

} // namespace helios
