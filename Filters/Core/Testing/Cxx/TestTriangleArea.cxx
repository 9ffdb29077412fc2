// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosPose.h"
#include "heliosTriangleArea.h"

#include <catch2/catch.hpp>

#include <cmath>

namespace
{

using helios::Vec3;

bool SpansArea(double x, double y, double z, const Vec3& offset)
{
  const double a[3] = { offset[0], offset[1], offset[2] };
  const double b[3] = { a[0] + 1.0, a[1] + 2.0, a[2] + 4.0 };
  const double c[3] = { a[0] + x, a[1] + y, a[2] + z };
  return helios::SpansArea(a, b, c);
}

} // namespace

TEST_CASE("TriangleArea: collinear points have no area", "[TriangleArea]")
{
  for (const auto& offset : { Vec3(0, 0, 0), Vec3(0.5, -3, 1024), Vec3(5e5, 5.5e6, 300) })
  {
    CHECK_FALSE(SpansArea(3, 6, 12, offset));
    CHECK_FALSE(SpansArea(-0.25, -0.5, -1, offset));
    CHECK_FALSE(SpansArea(0, 0, 0, offset));
    CHECK_FALSE(SpansArea(1, 2, 4, offset));
  }
}

TEST_CASE("TriangleArea: one unit in the last place is an area", "[TriangleArea]")
{
  for (const auto& offset : { Vec3(0, 0, 0), Vec3(5e5, 5.5e6, 300) })
  {
    const double z = offset[2] + 12.0;
    const double ulp = std::nextafter(z, 1e9) - z;
    CHECK(SpansArea(3, 6, 12 + ulp, offset));
    CHECK(SpansArea(3, 6, 12 - ulp, offset));
  }
}

TEST_CASE("TriangleArea: agrees with exact integers", "[TriangleArea]")
{
  int straight = 0;
  for (int x = -4; x <= 4; ++x)
  {
    for (int y = -4; y <= 4; ++y)
    {
      // a at the origin, b = (2, 2, 0), c = (x, y, 0), shifted so that the double filter cannot
      // decide
      const double s = 0x1p52;
      const double a[3] = { s, s, s };
      const double b[3] = { s + 2, s + 2, s };
      const double c[3] = { s + x, s + y, s };
      CHECK(helios::SpansArea(a, b, c) == (x != y));
      straight += x == y;
    }
  }
  CHECK(straight == 9);
}
