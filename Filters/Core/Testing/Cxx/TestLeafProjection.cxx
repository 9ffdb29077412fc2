// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Projections of leaf angle distributions, against closed forms.
#include "heliosLeafProjection.h"

#include <vtkDoubleArray.h>
#include <vtkMath.h>
#include <vtkNew.h>

#include <catch2/catch.hpp>

#include <cmath>

using helios::LeafProjection;
using Distribution = LeafProjection::Distribution;

namespace
{

double GetAt(const LeafProjection& leaves, double degrees)
{
  return leaves.Get(vtkMath::RadiansFromDegrees(degrees));
}

/// The mean of G over all directions, by the midpoint rule.
double GetMean(const LeafProjection& leaves)
{
  constexpr int steps = 9000;
  double sum = 0.0;
  for (int i = 0; i < steps; ++i)
  {
    const double angle = 0.5 * vtkMath::Pi() * (i + 0.5) / steps;
    sum += leaves.Get(angle) * std::sin(angle);
  }
  return sum * 0.5 * vtkMath::Pi() / steps;
}

} // namespace

TEST_CASE("LeafProjection: the mean over all directions is a half", "[LeafProjection]")
{
  const auto kind =
    GENERATE(Distribution::Spherical, Distribution::Uniform, Distribution::Planophile,
      Distribution::Erectophile, Distribution::Plagiophile, Distribution::Extremophile,
      Distribution::Ellipsoidal, Distribution::Horizontal, Distribution::Vertical);
  LeafProjection leaves;
  leaves.Set(kind, 2.5);
  CHECK(GetMean(leaves) == Approx(0.5).epsilon(1e-4));
}

TEST_CASE("LeafProjection: horizontal and vertical leaves", "[LeafProjection]")
{
  LeafProjection leaves;
  leaves.Set(Distribution::Horizontal);
  CHECK(GetAt(leaves, 60) == Approx(0.5));
  leaves.Set(Distribution::Vertical);
  CHECK(GetAt(leaves, 0) == Approx(0.0).margin(1e-12));
  CHECK(GetAt(leaves, 90) == Approx(2.0 / vtkMath::Pi()));
}

TEST_CASE("LeafProjection: vertical projections of leaves of some angles", "[LeafProjection]")
{
  // The mean cosine of the normals: integrals of the densities.
  LeafProjection leaves;
  leaves.Set(Distribution::Uniform);
  CHECK(GetAt(leaves, 0) == Approx(2.0 / vtkMath::Pi()).epsilon(1e-5));
  leaves.Set(Distribution::Planophile);
  CHECK(GetAt(leaves, 0) == Approx(8.0 / (3.0 * vtkMath::Pi())).epsilon(1e-5));
  leaves.Set(Distribution::Erectophile);
  CHECK(GetAt(leaves, 0) == Approx(4.0 / (3.0 * vtkMath::Pi())).epsilon(1e-5));
}

TEST_CASE("LeafProjection: Campbell's ellipsoid", "[LeafProjection]")
{
  // G of an oblate spheroid is its shadow over half its surface.
  const double ratio = 3.0;
  const double e = std::sqrt(1.0 - 1.0 / (ratio * ratio));
  const double surface = 0.5 * (ratio * ratio + 0.5 / e * std::log((1.0 + e) / (1.0 - e)));
  LeafProjection leaves;
  leaves.Set(Distribution::Ellipsoidal, ratio);
  for (const double degrees : { 0.0, 30.0, 57.0, 90.0 })
  {
    const double angle = vtkMath::RadiansFromDegrees(degrees);
    const double shadow = ratio * std::hypot(ratio * std::cos(angle), std::sin(angle));
    CHECK(GetAt(leaves, degrees) == Approx(0.5 * shadow / surface).epsilon(1e-4));
  }
  leaves.Set(Distribution::Ellipsoidal, 1.0);
  CHECK(GetAt(leaves, 20) == Approx(0.5).epsilon(1e-5));
}

TEST_CASE("LeafProjection: rows are sorted, merged and checked", "[LeafProjection]")
{
  vtkNew<vtkDoubleArray> table;
  table->SetNumberOfComponents(4);
  const double rows[][4] = { { 1, 0, 0, 0.8 }, { 0, 0, 1, 0.2 }, { 0, 1, 0, 0.6 } };
  for (const auto& row : rows)
  {
    table->InsertNextTuple(row);
  }
  LeafProjection leaves;
  REQUIRE(leaves.Set(table).IsOk());
  CHECK(leaves.GetRows().size() == 2);
  CHECK(GetAt(leaves, 45) == Approx(0.45));
  table->SetComponent(1, 3, -0.1);
  const helios::Status status = leaves.Set(table);
  CHECK(status.Message().find("needs rows x y z G") != std::string::npos);
}
