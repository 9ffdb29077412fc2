// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosPclTesting.h"
#include "vtkHeliosPCLGroundFilter.h"

#include <catch2/catch.hpp>

namespace names = vtkHeliosArrayNames;

namespace
{

constexpr int NotGround = 5;

double GetTerrain(double x, double y)
{
  return 6.0 * std::sin(x / 25.0) + 4.0 * std::cos(y / 18.0) + 0.1 * x;
}

struct Landscape
{
  helios::Triples Points;
  std::vector<int> Classes;

  void Add(double x, double y, double z, int id)
  {
    this->Points.push_back(helios::Utm + helios::Triple{ x, y, z });
    this->Classes.push_back(id);
  }
  vtkSmartPointer<vtkPolyData> MakeCloud() const { return helios::MakeCloud(this->Points); }
};

/// Hills up to 40 % steep with houses, cars and trees, scanned from above at 8 points/m2 with 2 cm
/// of noise; below a tree every third pulse reaches the ground.
Landscape MakeLandscape()
{
  helios::Uniform uniform(41);
  Landscape land;
  for (int i = 0; i < 80000; ++i)
  {
    const double x = uniform(-50, 50);
    const double y = uniform(-50, 50);
    const double noise = 0.02 * uniform.Normal();
    const double u = std::fmod(x + 50.0, 25.0) - 12.5;
    const double v = std::fmod(y + 50.0, 25.0) - 12.5;
    const double ground = GetTerrain(x, y);
    if (std::abs(u) < 5.0 && std::abs(v) < 4.0 && x < 25) // a house with a gabled roof
    {
      const double eaves = GetTerrain(x - u, y - v) + 5.0;
      land.Add(x, y, eaves + 0.7 * (4.0 - std::abs(v)) + noise, NotGround);
    }
    else if (std::abs(u - 9.0) < 1.0 && std::abs(v) < 2.2) // a car
    {
      land.Add(x, y, GetTerrain(x, y) + 1.4 + noise, NotGround);
    }
    else if (std::hypot(u + 8.0, v - 8.0) < 3.5 && uniform(0, 3) > 1.0) // a tree
    {
      land.Add(x, y, ground + uniform(2.0, 9.0), NotGround);
    }
    else
    {
      land.Add(x, y, ground + noise, 2);
    }
  }
  return land;
}

} // namespace

TEST_CASE("PCLGroundFilter: at least 95 % of known ground is correct", "[PCLGroundFilter]")
{
  const Landscape land = MakeLandscape();
  helios::Filtering<vtkHeliosPCLGroundFilter> run(land.MakeCloud());
  REQUIRE(run.Run());
  CHECK(run.CountMoved() == 0);
  REQUIRE(run.Count() == 80000);
  int missed = 0; // ground not classified as ground
  int wrong = 0;  // other points classified as ground
  int ground = 0;
  for (vtkIdType i = 0; i < run.Count(); ++i)
  {
    const int found = static_cast<int>(run.Get(names::ClassificationIds)->GetTuple1(i));
    REQUIRE((found == 1 || found == 2));
    const bool isGround = land.Classes[static_cast<std::size_t>(i)] == 2;
    ground += isGround ? 1 : 0;
    missed += isGround && found != 2 ? 1 : 0;
    wrong += !isGround && found == 2 ? 1 : 0;
  }
  INFO("missed " << missed << " of " << ground << ", wrong " << wrong);
  CHECK(missed + wrong < 0.05 * 80000);
  CHECK(missed < 0.05 * ground);
  CHECK(wrong < 0.05 * (80000 - ground));
}

TEST_CASE("PCLGroundFilter: other classes are kept", "[PCLGroundFilter]")
{
  helios::Triples points;
  for (int i = 0; i < 400; ++i)
  {
    points.push_back(helios::Utm + helios::Triple{ 0.5 * (i % 20), 0.5 * (i / 20), 0.0 });
  }
  points.push_back(helios::Utm + helios::Triple{ 5.1, 5.1, 4.0 });
  points.push_back(helios::Utm + helios::Triple{ 5.2, 5.2, 4.0 });
  const auto cloud = helios::MakeCloud(points);
  helios::AddColumn<vtkIntArray>(cloud->GetPointData(), names::ClassificationIds, 402,
    [](vtkIdType i) { return i == 401 ? 2 : 6; });
  helios::Filtering<vtkHeliosPCLGroundFilter> run(cloud);
  REQUIRE(run.Run());
  vtkDataArray* classes = run.Get(names::ClassificationIds);
  for (vtkIdType i = 0; i < 400; ++i)
  {
    REQUIRE(classes->GetTuple1(i) == 2);
  }
  CHECK(classes->GetTuple1(400) == 6);
  CHECK(classes->GetTuple1(401) == 1); // no longer ground
  CHECK(cloud->GetPointData()->GetArray(names::ClassificationIds)->GetTuple1(0) == 6);
}

TEST_CASE("PCLGroundFilter: more cells than PCL supports", "[PCLGroundFilter]")
{
  helios::Filtering<vtkHeliosPCLGroundFilter> run(
    { helios::Utm, helios::Utm + helios::Triple{ 1000.0, 1000.0, 0.0 } });
  run.Filter->SetCellSize(0.01);
  CHECK(run.FailsWith("CellSize is 0.01 m, which makes more cells than PCL can count; set 0.02"));
}
