// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// A sample of the pulses of a scan.

#ifndef heliosPulseSubset_h
#define heliosPulseSubset_h

#include <vtkType.h>

#include <cstdint>

namespace helios
{

/**
 * One pulse of each Step consecutive ones, anywhere among them, so that no sample is in step with
 * scan lines. It depends on the pulse index and a key alone: the same for all windows and pieces.
 * With another key the groups of pulses begin elsewhere: a scan of fewer pulses than Step has one
 * of them, or none.
 */
class PulseSubset
{
public:
  PulseSubset() = default;
  PulseSubset(vtkIdType step, vtkIdType key)
    : Step(step)
    , Key(Mix(static_cast<std::uint64_t>(key)))
    , Start(this->Place(this->Key))
  {
  }

  /// Returns the index of the pulse of sample n; negative of a pulse before the first.
  vtkIdType Get(vtkIdType n) const
  {
    return this->Step == 1
      ? n
      : n * this->Step - this->Start + this->Place(this->Key + static_cast<std::uint64_t>(n) + 1);
  }

  /// Returns the number of samples with indices below this one.
  vtkIdType CountBelow(vtkIdType index) const
  {
    const vtkIdType n = (index + this->Start) / this->Step;
    return n + (this->Get(n) < index ? 1 : 0);
  }

private:
  /// Mixes bits: SplitMix64 (Steele, Lea and Flood 2014).
  static std::uint64_t Mix(std::uint64_t z)
  {
    z = (z + 1) * 0x9e3779b97f4a7c15u;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    return z ^ (z >> 31);
  }
  vtkIdType Place(std::uint64_t number) const
  {
    return static_cast<vtkIdType>(Mix(number) % static_cast<std::uint64_t>(this->Step));
  }

  vtkIdType Step = 1;
  std::uint64_t Key = 0;
  vtkIdType Start = 0;
};

} // namespace helios

#endif
