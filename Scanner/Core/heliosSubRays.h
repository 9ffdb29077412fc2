// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// The sub-rays of a beam.

#ifndef heliosSubRays_h
#define heliosSubRays_h

#include "heliosPose.h"

#include <functional>
#include <mutex>
#include <utility>
#include <vector>

namespace helios
{

/// A sub-ray in the frame of the beam.
struct SubRay
{
  Vec3 Direction;
  double Weight;
  Vec3 Offset; // [m], of the start
};

/// Sub-rays that are computed on first use, from any thread.
class LazySubRays
{
public:
  using Maker = std::function<std::vector<SubRay>()>;

  explicit LazySubRays(Maker maker)
    : Make(std::move(maker))
  {
  }

  const std::vector<SubRay>& Get() const
  {
    std::call_once(this->IsMade, [this] { this->SubRays = this->Make(); });
    return this->SubRays;
  }

private:
  Maker Make;
  mutable std::once_flag IsMade;
  mutable std::vector<SubRay> SubRays;
};

} // namespace helios

#endif
