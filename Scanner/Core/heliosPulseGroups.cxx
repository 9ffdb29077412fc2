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

} // namespace

PulseGroups::PulseGroups(const ScanModel& model)
  : Model(model)
  , IsOn(model.Cones && model.ConeTangent > 0.0 && model.Medium.IsEmpty() &&
      (model.Path.Beam == BeamPath::ConeFirst ||
        (model.Path.Beam == BeamPath::Fixed && !model.HasOffsets)))
  , Span(LargestSpan)
{
}

void PulseGroups::Start(const std::vector<Pulse>& pulses)
{
  this->Pulses = &pulses;
  this->End = 0;
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
    const Pulse& pulse = (*this->Pulses)[i];
    ConeAxis& cone = this->Cones[i - first];
    const Vec3 axis = pulse.GetDirection();
    std::copy_n(this->Model.GetApex(pulse).GetData(), 3, cone.Origin);
    std::copy_n(axis.GetData(), 3, cone.Axis);
  }
  return this->Model.Cones->FindGroup(
    this->Cones.data(), this->Cones.size(), this->Model.ConeTangent, this->Group);
}

} // namespace helios
