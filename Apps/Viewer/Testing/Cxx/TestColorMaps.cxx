// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosColorMaps.h"

#include <catch2/catch.hpp>

using namespace helios;
using namespace helios::viewer;

TEST_CASE("ColorMaps: the ramp goes through its nodes")
{
  CHECK(GetRamp()[0] == Rgb{ 92, 128, 199 });
  CHECK(GetRamp()[51] == Rgb{ 64, 173, 179 });
  CHECK(GetRamp()[255] == Rgb{ 191, 56, 56 });
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
