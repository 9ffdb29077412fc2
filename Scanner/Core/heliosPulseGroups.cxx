// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosPulseGroups.h"

#include "heliosScanModel.h"

#include <algorithm>

namespace helios
{
namespace
{

constexpr std::size_t LargestSpan = 32;
constexpr std::size_t SmallestSpan = 8;
constexpr std::size_t FirstPause =
  32; // pulses without a group after a failure with the smallest span
constexpr std::size_t LongestPause = 256; // after several failures

/// Returns the ray along the axis of the cone about a pulse's beam.
vtkHeliosRay MakeAxis(const ScanModel& model, const Pulse& pulse)
{
  const Vec3 direction = pulse.GetDirection();
  vtkHeliosRay axis;
  std::copy_n(model.GetApex(pulse).GetData(), 3, axis.Origin);
  std::copy_n(direction.GetData(), 3, axis.Direction);
  return axis;
}

} // namespace

PulseGroups::PulseGroups(const ScanModel& model)
  : Model(model)
  , IsOn(model.Cones && model.ConeTangent > 0.0 && model.Medium.IsEmpty() &&
      (model.Path.Beam == BeamPath::ConeFirst ||
        (model.Path.Beam == BeamPath::Fixed && !model.HasOffsets)))
  , Span(LargestSpan)
{
}

void PulseGroups::Start(const std::vector<Pulse>& pulses, const std::vector<vtkIdType>& indices)
{
  this->Pulses = &pulses;
  this->Indices = &indices;
  this->End = 0;
}

//------------------------------------------------------------------------------
MomentSpan PulseGroups::GetSpan(std::size_t first, std::size_t last) const
{
  return { (*this->Indices)[first], (*this->Indices)[last - 1], (*this->Pulses)[first].Time,
    (*this->Pulses)[last - 1].Time };
}

//------------------------------------------------------------------------------
const ConeGroup* PulseGroups::Get(std::size_t slot)
{
  if (!this->IsOn)
  {
    return nullptr;
  }
  if (slot >= this->End)
  {
    this->Extend(slot);
  }
  return this->IsFound ? &this->Group : nullptr;
}

//------------------------------------------------------------------------------
vtkHeliosConeHit PulseGroups::FindOnly(std::size_t slot)
{
  const vtkHeliosConeHit unknown{ vtkHeliosConeHit::Unresolved, -1, 0.0 };
  const ConeGroup* group = this->Get(slot);
  if (!group)
  {
    return unknown;
  }
  const Pulse& pulse = (*this->Pulses)[slot];
  const vtkHeliosRay axis = MakeAxis(this->Model, pulse);
  const ConeTriangles found = group->Select(
    axis.Origin, axis.Direction, this->Model.ConeTangent, this->Model.Plan.GetLargestDistance());
  vtkHeliosHit hit{ NoHit, -1 };
  if (found.IsOne())
  {
    group->Meet(found.Covering, &axis, 1, &hit);
  }
  const double range = hit.Range - this->Model.ApexOffset;
  return found.AreNone() ? vtkHeliosConeHit{ vtkHeliosConeHit::Empty, -1, range }
    : hit.CellId >= 0    ? vtkHeliosConeHit{ vtkHeliosConeHit::PlanarFootprint, hit.CellId, range }
                         : unknown;
}

//------------------------------------------------------------------------------
/// Finds the triangles about a pulse and the next ones, by fewer pulses at a time as long as they are too many.
void PulseGroups::Extend(std::size_t slot)
{
  const std::size_t count = this->Pulses->size();
  if (this->Pause > 0)
  {
    this->End = std::min(count, slot + this->Pause);
    this->Pause -= this->End - slot;
    this->IsFound = false;
    return;
  }
  do
  {
    this->End = std::min(count, slot + this->Span);
    this->IsFound = this->Find(slot, this->End);
  } while (!this->IsFound && this->Span > SmallestSpan && (this->Span = SmallestSpan));
  if (this->IsFound)
  {
    const bool areFew = 2 * this->Group.GetNumberOfTriangles() <= ConeGroup::Capacity;
    this->Span = areFew ? LargestSpan : SmallestSpan;
    this->Failures = 0;
    return;
  }
  this->Pause = std::min(LongestPause, FirstPause << std::min<std::size_t>(this->Failures++, 8));
}

//------------------------------------------------------------------------------
/// Finds the triangles about the pulses [first, last).
bool PulseGroups::Find(std::size_t first, std::size_t last)
{
  this->Cones.resize(last - first);
  for (std::size_t i = first; i < last; ++i)
  {
    const vtkHeliosRay axis = MakeAxis(this->Model, (*this->Pulses)[i]);
    std::copy_n(axis.Origin, 3, this->Cones[i - first].Origin);
    std::copy_n(axis.Direction, 3, this->Cones[i - first].Axis);
  }
  return this->Model.Cones->FindGroup(this->Cones.data(), this->Cones.size(),
    this->Model.ConeTangent, this->GetSpan(first, last), this->Group);
}

} // namespace helios
