// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosColorMaps.h"

#include <algorithm>
#include <cmath>

namespace helios::viewer
{

namespace
{

struct ClassColor
{
  int Number;
  const char* Name;
  Rgb Color;
};

// LAS 1.4 R15, table 17; colours as Python/vtkhelios/reports/picture.py draws them.
constexpr ClassColor Classes[] = {
  { 0, "never classified", { 199, 199, 204 } },
  { 1, "unclassified", { 170, 170, 176 } },
  { 2, "ground", { 168, 143, 110 } },
  { 3, "low vegetation", { 158, 194, 92 } },
  { 4, "medium vegetation", { 122, 179, 82 } },
  { 5, "high vegetation", { 84, 168, 87 } },
  { 6, "building", { 209, 107, 84 } },
  { 7, "low noise", { 220, 60, 160 } },
  { 9, "water", { 77, 140, 217 } },
  { 10, "rail", { 120, 96, 140 } },
  { 11, "road", { 140, 143, 153 } },
  { 13, "wire guard", { 235, 200, 90 } },
  { 14, "wire conductor", { 250, 220, 60 } },
  { 15, "transmission tower", { 230, 160, 60 } },
  { 16, "wire connector", { 200, 180, 60 } },
  { 17, "bridge deck", { 180, 120, 150 } },
  { 18, "high noise", { 240, 90, 190 } },
};

const ClassColor* FindClass(int number)
{
  const auto* end = std::end(Classes);
  const auto* found = std::find_if(
    std::begin(Classes), end, [number](const ClassColor& c) { return c.Number == number; });
  return found == end ? nullptr : found;
}

// Viridis of S. van der Walt and N. Smith (matplotlib, CC0): every 15th of its 256 colours.
constexpr double Viridis[18][3] = { { 68, 1, 84 }, { 72, 23, 105 }, { 71, 42, 122 },
  { 67, 61, 132 }, { 61, 78, 138 }, { 53, 94, 141 }, { 46, 109, 142 }, { 41, 123, 142 },
  { 35, 137, 142 }, { 31, 151, 139 }, { 33, 165, 133 }, { 46, 179, 124 }, { 70, 192, 111 },
  { 101, 203, 94 }, { 137, 213, 72 }, { 176, 221, 47 }, { 216, 226, 25 }, { 253, 231, 37 } };

/// Returns the colour at a share of viridis.
Rgb GetViridis(double share)
{
  const double at = 17.0 * share;
  const int node = std::min(16, static_cast<int>(at));
  Rgb color;
  for (std::size_t c = 0; c < 3; ++c)
  {
    const double value = Viridis[node][c] + (at - node) * (Viridis[node + 1][c] - Viridis[node][c]);
    color[c] = static_cast<std::uint8_t>(std::lround(value));
  }
  return color;
}

} // namespace

//------------------------------------------------------------------------------
Ramp MakeRamp(const RampPart& part)
{
  Ramp ramp;
  for (std::size_t i = 0; i < ramp.size(); ++i)
  {
    ramp[i] = GetViridis(part.First + (part.Last - part.First) * static_cast<double>(i) / 255.0);
  }
  return ramp;
}

//------------------------------------------------------------------------------
Rgb GetDistinctColor(std::int64_t n)
{
  constexpr Rgb colors[12] = { { 114, 158, 206 }, { 255, 158, 74 }, { 103, 191, 92 },
    { 237, 102, 93 }, { 173, 139, 201 }, { 168, 120, 110 }, { 237, 151, 202 }, { 162, 162, 162 },
    { 205, 204, 93 }, { 109, 204, 218 }, { 219, 179, 130 }, { 120, 150, 110 } };
  return colors[((n % 12) + 12) % 12];
}

//------------------------------------------------------------------------------
Rgb GetClassColor(int number)
{
  const ClassColor* known = FindClass(number);
  return known ? known->Color : Rgb{ 199, 199, 204 };
}

//------------------------------------------------------------------------------
std::string GetClassName(int number)
{
  const ClassColor* known = FindClass(number);
  return known ? known->Name : "class " + std::to_string(number);
}

} // namespace helios::viewer
