// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosPclTesting.h"
#include "vtkHeliosPCLNormals.h"

#include <vtkMath.h>

#include <catch2/catch.hpp>

#include <limits>

namespace names = vtkHeliosArrayNames;

namespace
{

/// Points on a sphere about a position, by equal areas.
helios::Triples MakeSphere(int count, double radius)
{
  helios::Triples points;
  for (int i = 0; i < count; ++i)
  {
    const double z = 1.0 - 2.0 * (i + 0.5) / count;
    const double r = std::sqrt(1.0 - z * z);
    const double angle = 2.399963229728653 * i;
    points.push_back(helios::Utm +
      helios::Triple{ radius * r * std::cos(angle), radius * r * std::sin(angle), radius * z });
  }
  return points;
}

/// The largest angle between the normals and the radii, and whether each points outward.
double GetLargestAngle(helios::Filtering<vtkHeliosPCLNormals>& run, double side, double& wrongSides)
{
  double largest = 0.0;
  wrongSides = 0;
  for (vtkIdType i = 0; i < run.Count(); ++i)
  {
    double p[3];
    double n[3];
    run.Output()->GetPoint(i, p);
    vtkMath::Subtract(p, helios::Utm.data(), p);
    run.Get(names::Normals)->GetTuple(i, n);
    CHECK(vtkMath::Norm(n) == Approx(1.0));
    const double cosine = vtkMath::Dot(p, n) / vtkMath::Norm(p);
    largest = std::max(largest, std::acos(std::min(1.0, std::abs(cosine))));
    wrongSides += cosine * side < 0.0 ? 1 : 0;
  }
  return largest;
}

} // namespace

TEST_CASE("PCLNormals: normals of a sphere are its radii", "[PCLNormals]")
{
  // 4 pi 25 m2 for 20000 points: 0.125 m apart. The 24 neighbours are within 0.4 m, and not quite
  // evenly around the point: the plane tilts by a share of their distance over the radius.
  helios::Filtering<vtkHeliosPCLNormals> run(MakeSphere(20000, 5.0));
  run.Filter->SetNumberOfNeighbors(24);
  run.Filter->SetSide(vtkHeliosPCLNormals::ToViewpoint);
  run.Filter->SetViewpoint(helios::Utm.data());
  REQUIRE(run.Run());
  CHECK(run.CountMoved() == 0);
  double wrongSides = 0;
  CHECK(GetLargestAngle(run, -1.0, wrongSides) < 0.4 / 5.0 / 4.0);
  CHECK(wrongSides == 0);
  CHECK(run.Output()->GetPointData()->GetNormals() == run.Get(names::Normals));
  double range[2];
  run.Get(vtkHeliosPCLArrayNames::Curvature)->GetRange(range);
  CHECK(range[0] > 0.0);
  CHECK(range[1] < 1e-3); // (0.4^2 / 2 / 5)^2 / 12 over 0.4^2 / 2

  run.Filter->SetRadius(0.4);
  REQUIRE(run.Run());
  CHECK(GetLargestAngle(run, -1.0, wrongSides) < 0.4 / 5.0 / 4.0);
}

TEST_CASE("PCLNormals: normals of a plane point up, without curvature", "[PCLNormals]")
{
  helios::Uniform uniform(23);
  helios::Triples points;
  for (int i = 0; i < 2000; ++i)
  {
    const double x = uniform(-5, 5);
    const double y = uniform(-5, 5);
    points.push_back(helios::Utm + helios::Triple{ x, y, 0.75 * x });
  }
  helios::Filtering<vtkHeliosPCLNormals> run(points);
  REQUIRE(run.Run());
  for (vtkIdType i = 0; i < run.Count(); ++i)
  {
    const double* n = run.Get(names::Normals)->GetTuple3(i);
    REQUIRE(std::abs(n[0] + 0.6) < 1e-4);
    REQUIRE(std::abs(n[1]) < 1e-4);
    REQUIRE(std::abs(n[2] - 0.8) < 1e-4);
    REQUIRE(run.Get(vtkHeliosPCLArrayNames::Curvature)->GetTuple1(i) < 1e-6);
  }
}

TEST_CASE("PCLNormals: isolated points have no normal", "[PCLNormals]")
{
  helios::Triples points = MakeSphere(2000, 1.0);
  points.push_back(helios::Utm + helios::Triple{ 30.0, 0.0, 0.0 });
  helios::Filtering<vtkHeliosPCLNormals> run(points);
  run.Filter->SetRadius(0.3);
  REQUIRE(run.Run());
  CHECK(run.Log->HasWarning("1 of 2001 points have too few neighbours for a normal"));
  const double* n = run.Get(names::Normals)->GetTuple3(2000);
  CHECK((n[0] == 0.0 && n[1] == 0.0 && n[2] == 0.0));
}

TEST_CASE("PCLNormals: a viewpoint that is not finite", "[PCLNormals]")
{
  helios::Filtering<vtkHeliosPCLNormals> run(MakeSphere(50, 1.0));
  run.Filter->SetViewpoint(0.0, std::numeric_limits<double>::quiet_NaN(), 0.0);
  CHECK(run.FailsWith("Viewpoint is (0, nan, 0); set finite numbers"));
}
