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

/// 256 colours from low to high, uniform in brightness: light blue over green to red.
const std::array<Rgb, 256>& GetRamp();

/// The colour of category n: 12 muted colours, repeated.
Rgb GetDistinctColor(std::int64_t n);

/// The colour of an ASPRS class; grey for one without a colour of its own.
Rgb GetClassColor(int number);

/// The name of an ASPRS class, "class 42" for one without.
std::string GetClassName(int number);

} // namespace helios::viewer

#endif
