// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// The number of pulses in a time.

#ifndef heliosPulseCount_h
#define heliosPulseCount_h

#include <vtkType.h>

#include <algorithm>
#include <cmath>

namespace helios
{

/// Returns the number of i >= 0 with i / rate < duration; a last pulse lost to rounding is not
/// counted.
inline vtkIdType CountPulses(double duration, double rate)
{
  const double pulses = duration * rate;
  const double nearest = std::round(pulses);
  const double count = std::abs(pulses - nearest) <= 1e-12 * pulses ? nearest : std::ceil(pulses);
  return static_cast<vtkIdType>(std::min(std::max(count, 0.0), 9e15));
}

/// Returns the first pulse of piece p: count p / pieces, without overflow.
inline vtkIdType SplitPulses(vtkIdType count, vtkIdType piece, vtkIdType pieces)
{
  return count / pieces * piece + count % pieces * piece / pieces;
}

} // namespace helios

#endif
