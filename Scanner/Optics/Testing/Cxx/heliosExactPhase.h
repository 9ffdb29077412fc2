// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// The reference for deflectors: phases in 128-bit integers.

#ifndef heliosExactPhase_h
#define heliosExactPhase_h

#include <cmath>
#include <cstdint>

namespace helios
{

/// frac(index * frequency / rate) of the stored frequency (all its bits), for an integer rate.
inline double ExactPhase(std::int64_t index, double frequency, std::int64_t rate)
{
  int exponent = 0;
  const double fraction = std::frexp(frequency, &exponent); // frequency = fraction 2^exponent
  const auto mantissa = static_cast<std::int64_t>(std::ldexp(fraction, 53));
  const __int128 turn = static_cast<__int128>(rate) << (53 - exponent);
  const __int128 rest = static_cast<__int128>(index) * mantissa % turn; // has the frequency's sign
  return static_cast<double>(rest < 0 ? rest + turn : rest) / static_cast<double>(turn);
}

} // namespace helios

#endif
