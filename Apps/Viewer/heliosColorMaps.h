// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// The colours that clouds and scenes are drawn in.

#ifndef heliosColorMaps_h
#define heliosColorMaps_h

#include <array>
#include <cstdint>
#include <string>

namespace helios
{

using Rgb = std::array<std::uint8_t, 3>;

/// 256 colours from low to high, alike in brightness steps: light blue over green to red.
const std::array<Rgb, 256>& GetRamp();

/// The colour of number n of things that have no order: 12 muted colours, then again.
Rgb GetDistinctColor(std::int64_t n);

/// The colour of an ASPRS class; grey for one without a colour of its own.
Rgb GetClassColor(int number);

/// The name of an ASPRS class, "class 42" for one without.
std::string GetClassName(int number);

} // namespace helios

#endif
