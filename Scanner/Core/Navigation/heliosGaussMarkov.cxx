// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosGaussMarkov.h"

#include "heliosRandom.h"

#include <cmath>

namespace helios
{

namespace
{

constexpr std::int64_t StepsPerTime = 256; // steps of the correlation time
constexpr std::int64_t StepsPerKnot = 32 * StepsPerTime;

/// Returns the random number of a step's start; its item is unique, whatever the level of
/// bisection.
double Draw(std::uint64_t seed, std::uint32_t component, std::int64_t step)
{
  return NormalPair(seed, RandomStream::Navigation, static_cast<std::uint64_t>(step), component)[0];
}

/// Returns the process of unit variance at the start of a step.
double Bisect(std::uint64_t seed, std::uint32_t component, std::int64_t step)
{
  std::int64_t below = step / StepsPerKnot - (step % StepsPerKnot < 0 ? 1 : 0);
  below *= StepsPerKnot;
  double a = Draw(seed, component, below);
  if (step == below)
  {
    return a;
  }
  double b = Draw(seed, component, below + StepsPerKnot);
  for (std::int64_t half = StepsPerKnot / 2; half > 0; half /= 2)
  {
    const double h = static_cast<double>(half) / static_cast<double>(StepsPerTime);
    const std::int64_t middle = below + half;
    const double m =
      (a + b) / (2.0 * std::cosh(h)) + std::sqrt(std::tanh(h)) * Draw(seed, component, middle);
    if (step == middle)
    {
      return m;
    }
    const bool isAbove = step > middle;
    below = isAbove ? middle : below;
    a = isAbove ? m : a;
    b = isAbove ? b : m;
  }
  return a;
}

} // namespace

//------------------------------------------------------------------------------
double GaussMarkov::GetValue(
  std::uint64_t seed, std::uint32_t component, double time, Cursor& cursor) const
{
  const double steps = time / this->CorrelationTime * static_cast<double>(StepsPerTime);
  const double floor = std::floor(steps);
  const auto step = static_cast<std::int64_t>(floor);
  if (step != cursor.Step)
  {
    cursor.Begin = Bisect(seed, component, step);
    cursor.End = Bisect(seed, component, step + 1);
    cursor.Step = step;
  }
  return this->Rms * (cursor.Begin + (steps - floor) * (cursor.End - cursor.Begin));
}

} // namespace helios
