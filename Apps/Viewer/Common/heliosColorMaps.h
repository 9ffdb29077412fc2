// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Colours of clouds and scenes.

#ifndef heliosColorMaps_h
#define heliosColorMaps_h

#include <array>
#include <cstdint>
#include <string>

namespace helios::viewer
{

using Rgb = std::array<std::uint8_t, 3>;

/// A part of the colour map, in [0, 1].
struct RampPart
{
  double First = 0.0;
  double Last = 1.0;
};

/// Colours from low to high.
using Ramp = std::array<Rgb, 256>;

/// A translucent cover of colours.
struct Veil
{
  Rgb Color{ 0, 0, 0 };
  double Share = 0.0; ///< 0: clear, 1: opaque

  Rgb Over(const Rgb& color) const
  {
    Rgb covered;
    for (std::size_t c = 0; c < 3; ++c)
    {
      const double value = color[c] + this->Share * (this->Color[c] - color[c]);
      covered[c] = static_cast<std::uint8_t>(value + 0.5);
    }
    return covered;
  }
};

/// Returns a part of viridis: perceptually uniform, its lightness increases, so it is safe for
/// colour vision deficiency.
Ramp MakeRamp(const RampPart& part);

/// Returns the colour of category n: 12 muted colours, repeated.
Rgb GetDistinctColor(std::int64_t n);

/// Returns the colour of an ASPRS class; grey for one without a colour of its own.
Rgb GetClassColor(int number);

/// Returns the name of an ASPRS class, "class 42" for one without.
std::string GetClassName(int number);

} // namespace helios::viewer

#endif
