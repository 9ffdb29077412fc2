// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Encodes point values in one or two bytes.

#ifndef heliosCloudCodes_h
#define heliosCloudCodes_h

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

namespace helios::viewer
{

constexpr std::uint8_t NoIncidence = 255;

/// Encodes an amplitude in 512 steps per octave, from 2^-96 on; 0: not set.
inline std::uint16_t EncodeAmplitude(double amplitude)
{
  if (!(amplitude > 0.0))
  {
    return 0;
  }
  const double code = std::round(512.0 * (std::log2(amplitude) + 96.0));
  return static_cast<std::uint16_t>(std::min(std::max(code, 1.0), 65535.0));
}

inline double DecodeAmplitude(std::uint16_t code)
{
  return code == 0 ? std::numeric_limits<double>::quiet_NaN() : std::exp2(code / 512.0 - 96.0);
}

/// Steps of 90/254 of a degree.
inline std::uint8_t EncodeIncidence(double degrees)
{
  const double code = std::round(degrees * (254.0 / 90.0));
  return std::isfinite(code) ? static_cast<std::uint8_t>(std::min(std::max(code, 0.0), 254.0))
                             : NoIncidence;
}

inline double DecodeIncidence(std::uint8_t code)
{
  return code == NoIncidence ? std::numeric_limits<double>::quiet_NaN() : code * (90.0 / 254.0);
}

inline std::uint8_t ToByte(double value)
{
  return static_cast<std::uint8_t>(value > 0.0 ? std::min(value, 255.0) : 0.0);
}

constexpr std::uint32_t NoColor = 0xFFFFFFFF;

/// Packs red, green and blue in [0, 1] into one number.
inline std::uint32_t PackColor(const double* rgb)
{
  const auto byte = [rgb](int i)
  { return static_cast<std::uint32_t>(ToByte(std::round(255.0 * rgb[i]))); };
  return std::isnan(rgb[0]) ? NoColor : (byte(0) << 16) | (byte(1) << 8) | byte(2);
}

} // namespace helios::viewer

#endif
