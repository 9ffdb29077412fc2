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

// LAS 1.4 R15, table 17; colours as Python/vtkhelios/picture.py draws them.
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

std::array<Rgb, 256> MakeRamp()
{
  // Height in Python/vtkhelios/picture.py.
  constexpr double nodes[6][3] = { { 92, 128, 199 }, { 64, 173, 179 }, { 107, 191, 112 },
    { 242, 217, 102 }, { 237, 128, 64 }, { 191, 56, 56 } };
  std::array<Rgb, 256> ramp;
  for (int i = 0; i < 256; ++i)
  {
    const double at = 5.0 * i / 255.0;
    const int node = std::min(4, static_cast<int>(at));
    for (int c = 0; c < 3; ++c)
    {
      const double value = nodes[node][c] + (at - node) * (nodes[node + 1][c] - nodes[node][c]);
      ramp[static_cast<std::size_t>(i)][static_cast<std::size_t>(c)] =
        static_cast<std::uint8_t>(std::lround(value));
    }
  }
  return ramp;
}

} // namespace

//------------------------------------------------------------------------------
const std::array<Rgb, 256>& GetRamp()
{
  static const std::array<Rgb, 256> ramp = MakeRamp();
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
