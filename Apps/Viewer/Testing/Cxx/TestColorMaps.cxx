// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosColorMaps.h"
#include "heliosTheme.h"

#include <catch2/catch.hpp>

#include <cmath>
#include <cstdlib>

using namespace helios;
using namespace helios::viewer;

namespace
{

/// The CIE 1976 lightness L* of an sRGB colour, in [0, 100].
double GetLightness(const Rgb& color)
{
  constexpr double shares[3] = { 0.2126, 0.7152, 0.0722 };
  double luminance = 0.0;
  for (std::size_t c = 0; c < 3; ++c)
  {
    const double value = color[c] / 255.0;
    luminance +=
      shares[c] * (value <= 0.04045 ? value / 12.92 : std::pow((value + 0.055) / 1.055, 2.4));
  }
  return 116.0 * std::cbrt(luminance) - 16.0;
}

} // namespace

TEST_CASE("ColorMaps: the ramp is viridis")
{
  const Ramp ramp = MakeRamp(RampPart());
  CHECK(ramp[0] == Rgb{ 68, 1, 84 });
  CHECK(ramp[255] == Rgb{ 253, 231, 37 });
  const Rgb middle{ 33, 145, 140 }; // matplotlib's viridis(0.5)
  for (std::size_t c = 0; c < 3; ++c)
  {
    CHECK(std::abs(ramp[128][c] - middle[c]) <= 2);
  }
  CHECK(MakeRamp({ 0.5, 1.0 })[0] == ramp[127]);
}

TEST_CASE("ColorMaps: the lightness of the ramp rises evenly, without hue it is in order")
{
  const Ramp ramp = MakeRamp(RampPart());
  const double span = GetLightness(ramp[255]) - GetLightness(ramp[0]);
  CHECK(span > 70.0);
  for (std::size_t i = 16; i < 256; ++i)
  {
    const double step = (GetLightness(ramp[i]) - GetLightness(ramp[i - 16])) / span * 255.0 / 16.0;
    CAPTURE(i, step);
    CHECK(step > 0.75);
    CHECK(step < 1.25);
  }
}

TEST_CASE("Theme: all colours of the ramp stand out from the background, as the text does")
{
  for (const std::string& name : GetThemeNames())
  {
    const Theme& theme = FindTheme(name);
    CHECK(theme.Name == name);
    for (const Rgb& background : theme.Background)
    {
      for (const Rgb& color : MakeRamp(theme.Ramp))
      {
        CHECK(std::abs(GetLightness(color) - GetLightness(background)) > 15.0);
      }
      CHECK(std::abs(GetLightness(theme.Ink) - GetLightness(background)) > 60.0);
    }
    CHECK(std::abs(GetLightness(theme.Ink) - GetLightness(theme.Panel)) > 60.0);
  }
  CHECK(FindTheme("unknown").Name == "dark");
}

TEST_CASE("ColorMaps: classes have the colours and names of ASPRS")
{
  CHECK(GetClassName(2) == "ground");
  CHECK(GetClassName(6) == "building");
  CHECK(GetClassName(77) == "class 77");
  CHECK(GetClassColor(9) == Rgb{ 77, 140, 217 });
  CHECK(GetClassColor(77) == GetClassColor(0));
}

TEST_CASE("ColorMaps: distinct colours repeat after twelve, also for negative numbers")
{
  CHECK(GetDistinctColor(0) != GetDistinctColor(1));
  CHECK(GetDistinctColor(12) == GetDistinctColor(0));
  CHECK(GetDistinctColor(-1) == GetDistinctColor(11));
}
