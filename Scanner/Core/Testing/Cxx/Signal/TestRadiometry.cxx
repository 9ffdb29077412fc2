// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Expected values: 40-digit evaluation of the lidar equation and of Kruse's formula.
#include "heliosRadiometry.h"

#include <catch2/catch.hpp>

#include <limits>

using helios::AtmosphericExtinction;

TEST_CASE("AtmosphericExtinction: Kruse's values", "[Radiometry]")
{
  struct Row
  {
    double Visibility, Wavelength, Extinction;
  };
  for (const Row& row : { Row{ 10, 532, 4.084935659e-4 }, Row{ 10, 905, 2.047515459e-4 },
         Row{ 10, 1064, 1.658999389e-4 }, Row{ 10, 1550, 1.017276788e-4 },
         Row{ 23, 532, 1.776058982e-4 }, Row{ 23, 905, 8.902241127e-5 },
         Row{ 23, 1064, 7.213040822e-5 }, Row{ 23, 1550, 4.422942555e-5 } })
  {
    CHECK(AtmosphericExtinction(row.Visibility, row.Wavelength) ==
      Approx(row.Extinction).epsilon(1e-9));
  }
  CHECK(AtmosphericExtinction(5, 1064) == Approx(4.043464e-4).epsilon(1e-6));
  CHECK(AtmosphericExtinction(5, 532) == Approx(8.088812e-4).epsilon(1e-6));
  CHECK(AtmosphericExtinction(std::numeric_limits<double>::infinity(), 1064) == 0.0);
}

TEST_CASE("LidarEquation: absolute power", "[Radiometry]")
{
  const helios::LidarEquation equation{ 0.15, 0.9, 7.21304082232259e-5 };
  const double degree = 0.017453292519943295;
  struct Row
  {
    double Range, P0, P45, P60, P80;
  };
  for (const Row& row :
    { Row{ 10, 2.527601030733e-05, 1.787283828965e-05, 1.263800515366e-05, 4.389133128558e-06 },
      Row{ 100, 2.494996110359e-07, 1.764228668669e-07, 1.247498055180e-07, 4.332515278500e-08 },
      Row{ 1000, 2.191206784973e-09, 1.549417176636e-09, 1.095603392486e-09, 3.804990651019e-10 },
      Row{
        10000, 5.981612499755e-12, 4.229638761007e-12, 2.990806249877e-12, 1.038696110092e-12 } })
  {
    CHECK(equation(row.Range, 0.5, 1.0) == Approx(row.P0).epsilon(2e-12));
    CHECK(equation(row.Range, 0.5, std::cos(45 * degree)) == Approx(row.P45).epsilon(2e-12));
    CHECK(equation(row.Range, 0.5, std::cos(60 * degree)) == Approx(row.P60).epsilon(2e-12));
    CHECK(equation(row.Range, 0.5, std::cos(80 * degree)) == Approx(row.P80).epsilon(2e-12));
  }
}

TEST_CASE("CachedTransmission: equals the exponential", "[Radiometry]")
{
  const helios::LidarEquation equation{ 0.15, 0.9, 7.2e-5 };
  helios::CachedTransmission transmission(equation);
  for (const double range : { 500.0, 500.01, 503.0, 506.8, 507.5, 12000.0, 20.0 })
  {
    CHECK(transmission(range) == Approx(std::exp(-2 * 7.2e-5 * range)).epsilon(4e-15));
  }
}
