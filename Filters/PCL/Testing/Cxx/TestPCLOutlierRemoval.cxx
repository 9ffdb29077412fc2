// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosPclTesting.h"
#include "vtkHeliosPCLOutlierRemoval.h"

#include <catch2/catch.hpp>

#include <set>

namespace
{

/// A roof of 10000 points 0.1 m apart, and 50 points above it in the air.
helios::Triples MakeRoofWithOutliers()
{
  helios::Uniform uniform(11);
  helios::Triples points;
  for (int i = 0; i < 10000; ++i)
  {
    const double x = 0.1 * (i % 100) + uniform(-0.02, 0.02);
    const double y = 0.1 * (i / 100) + uniform(-0.02, 0.02);
    points.push_back(helios::Utm + helios::Triple{ x, y, 0.4 * x });
  }
  for (int i = 0; i < 50; ++i)
  {
    points.push_back(helios::Utm +
      helios::Triple{ 2.0 * (i % 5) + 0.5, 1.0 * (i / 5) + 0.5, 0.4 * 10 + 3.0 + 0.3 * (i % 7) });
  }
  return points;
}

} // namespace

TEST_CASE(
  "PCLOutlierRemoval: known outliers are removed, and few other points", "[PCLOutlierRemoval]")
{
  helios::Filtering<vtkHeliosPCLOutlierRemoval> run(MakeRoofWithOutliers());
  run.Filter->SetStandardDeviations(1.0);
  REQUIRE(run.Run());
  vtkIdType outliersLeft = 0;
  for (vtkIdType i = 0; i < run.Count(); ++i)
  {
    outliersLeft += run.GetId(i) >= 10000 ? 1 : 0;
  }
  CHECK(outliersLeft == 0);
  CHECK(run.Count() >= 9990);
  CHECK(run.CountMoved() == 0);
  const vtkIdType kept = run.Count();

  run.Filter->SelectOutliersOn();
  REQUIRE(run.Run());
  CHECK(run.Count() == 10050 - kept);
  std::set<vtkIdType> found;
  for (vtkIdType i = 0; i < run.Count(); ++i)
  {
    found.insert(run.GetId(i));
  }
  for (vtkIdType i = 10000; i < 10050; ++i)
  {
    CHECK(found.count(i) == 1);
  }
}

TEST_CASE("PCLOutlierRemoval: a larger StandardDeviations keeps more points", "[PCLOutlierRemoval]")
{
  helios::Filtering<vtkHeliosPCLOutlierRemoval> run(MakeRoofWithOutliers());
  run.Filter->SetStandardDeviations(0.0);
  REQUIRE(run.Run());
  const vtkIdType few = run.Count();
  run.Filter->SetStandardDeviations(1000.0);
  REQUIRE(run.Run());
  CHECK(run.Count() == 10050);
  CHECK(few < 10050);
}

TEST_CASE("PCLOutlierRemoval: fewer points than neighbours", "[PCLOutlierRemoval]")
{
  const helios::Triple far = { 50.0, 0.0, 0.0 };
  helios::Filtering<vtkHeliosPCLOutlierRemoval> run({ helios::Utm, helios::Utm + far });
  REQUIRE(run.Run());
  CHECK(run.Count() == 2);
  run.Filter->SelectOutliersOn();
  REQUIRE(run.Run());
  CHECK(run.Count() == 0);
  helios::Triples points(6, helios::Utm);
  points.push_back(helios::Utm + far);
  helios::Filtering<vtkHeliosPCLOutlierRemoval> seven(points);
  REQUIRE(seven.Run());
  CHECK(seven.Count() == 6);
}
