// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHeliosFiberArray.h"

#include <catch2/catch.hpp>
#include <vtkMath.h>
#include <vtkNew.h>

#include <limits>

TEST_CASE("FiberArray: angular step and positions on the ground in closed form", "[FiberArray]")
{
  vtkNew<vtkHeliosFiberArray> array;
  array->SetNumberOfFibers(128);
  array->SetScanAngle(30.0);
  const double expected[3] = { -577.350269190, -566.407913670, -555.567295686 };
  for (vtkIdType i = 0; i < 3; ++i)
  {
    double d[3];
    REQUIRE(array->GetDirection(i, d));
    CHECK(d[0] == 0.0);
    CHECK(vtkMath::Norm(d) == Approx(1.0).epsilon(4e-16));
    CHECK(1000.0 * d[2] / d[1] == Approx(expected[i]).epsilon(1e-9));
    const double step = array->GetScanAngle(i + 1) - array->GetScanAngle(i);
    CHECK(vtkMath::RadiansFromDegrees(step) == Approx(8.245650009422e-3).epsilon(1e-9));
  }
}

TEST_CASE("FiberArray: symmetric, and both ends are reached", "[FiberArray]")
{
  vtkNew<vtkHeliosFiberArray> array;
  array->SetScanAngle(7.15);
  for (const int fibers : { 2, 3, 127, 128, 1000 })
  {
    array->SetNumberOfFibers(fibers);
    CHECK(array->GetScanAngle(0) == -7.15);
    CHECK(array->GetScanAngle(fibers - 1) == 7.15);
    for (vtkIdType i = 0; i < fibers; ++i)
    {
      REQUIRE(array->GetScanAngle(i) == -array->GetScanAngle(fibers - 1 - i)); // to the last bit
    }
  }
}

TEST_CASE("FiberArray: a single fibre points straight ahead", "[FiberArray]")
{
  vtkNew<vtkHeliosFiberArray> array;
  array->SetNumberOfFibers(1);
  for (const vtkIdType pulse : { 0LL, 1LL, 86400000000LL })
  {
    double d[3];
    REQUIRE(array->GetDirection(pulse, d));
    CHECK(d[0] == 0.0);
    CHECK(d[1] == 1.0);
    CHECK(d[2] == 0.0);
  }
}

TEST_CASE("FiberArray: fibres in order, for a day at 1 MHz", "[FiberArray]")
{
  vtkNew<vtkHeliosFiberArray> array;
  array->SetPulseFrequency(1e6);
  array->SetNumberOfFibers(127);
  for (const vtkIdType pulse : { 127LL, 12345678901LL, 86399999999LL, 86400000000LL })
  {
    CHECK(array->GetScanAngle(pulse) == array->GetScanAngle(pulse % 127));
  }
  CHECK(array->GetScanAngle(126) > array->GetScanAngle(127));
}

TEST_CASE("FiberArray: values are clamped to their ranges", "[FiberArray]")
{
  vtkNew<vtkHeliosFiberArray> array;
  array->SetNumberOfFibers(0);
  CHECK(array->GetNumberOfFibers() == 1);
  array->SetScanAngle(-3.0);
  CHECK(array->GetScanAngle() == 0.0);
  array->SetScanAngle(std::numeric_limits<double>::infinity());
  CHECK(array->GetScanAngle() == 180.0);
  const vtkMTimeType before = array->GetMTime();
  array->SetScanAngle(200.0);
  CHECK(array->GetMTime() == before); // unchanged
  array->SetScanAngle(std::numeric_limits<double>::quiet_NaN());
  CHECK(array->GetScanAngle() == 0.0);
}
