// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosRandom.h"

#include <Random123/philox.h>
#include <Random123/u01fixedpt.h>

#include <cmath>

namespace helios
{
namespace
{

r123::Philox4x64::ctr_type Draw(
  std::uint64_t seed, RandomStream stream, std::uint64_t item, std::uint32_t draw)
{
  const r123::Philox4x64::ctr_type counter{ { item, draw, 0, 0 } };
  const r123::Philox4x64::key_type key{ { seed, static_cast<std::uint64_t>(stream) } };
  return r123::Philox4x64()(counter, key);
}

} // namespace

std::array<double, 4> Uniform4(
  std::uint64_t seed, RandomStream stream, std::uint64_t item, std::uint32_t draw)
{
  const auto bits = Draw(seed, stream, item, draw);
  return { u01fixedpt_open_open_64_double(bits[0]), u01fixedpt_open_open_64_double(bits[1]),
    u01fixedpt_open_open_64_double(bits[2]), u01fixedpt_open_open_64_double(bits[3]) };
}

std::array<double, 2> NormalPair(
  std::uint64_t seed, RandomStream stream, std::uint64_t item, std::uint32_t draw)
{
  constexpr double twoPi = 6.283185307179586;
  const auto u = Uniform4(seed, stream, item, draw);
  const double radius = std::sqrt(-2.0 * std::log(u[0]));
  return { radius * std::cos(twoPi * u[1]), radius * std::sin(twoPi * u[1]) };
}

} // namespace helios
