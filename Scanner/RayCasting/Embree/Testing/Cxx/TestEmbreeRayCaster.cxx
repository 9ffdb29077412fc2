// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHeliosEmbreeRayCaster.h"

#include "../../../Testing/Cxx/heliosRayCasterChecks.h"
#include "vtkHeliosBvhRayCaster.h"

using helios::Vec3;

namespace
{

/// The number of Embree's hits and occlusions that differ from the double-precision tree.
int CountDifferencesFromBvh(const helios::Soup& soup, const std::vector<vtkHeliosRay>& rays)
{
  const auto scene = soup.GetPolyData();
  vtkNew<vtkHeliosBvhRayCaster> bvh;
  vtkNew<vtkHeliosEmbreeRayCaster> embree;
  REQUIRE(bvh->Build(scene));
  REQUIRE(embree->Build(scene));
  const auto truth = helios::Cast(bvh, rays);
  std::vector<unsigned char> occluded(rays.size(), 2);
  embree->Occluded(rays.data(), occluded.data(), static_cast<vtkIdType>(rays.size()));
  int differences = helios::CountDifferences(helios::Cast(embree, rays), truth);
  for (std::size_t i = 0; i < rays.size(); ++i)
  {
    differences += occluded[i] != (truth[i].CellId >= 0 ? 1 : 0);
  }
  return differences;
}

/// Bundles of 19 rays within 0.3 mrad, as from a scanner.
std::vector<vtkHeliosRay> MakeBundles(
  const Vec3& from, const Vec3& low, const Vec3& high, int count)
{
  helios::Dice dice(6);
  std::vector<vtkHeliosRay> rays;
  for (int i = 0; i < count; ++i)
  {
    const Vec3 target(dice(low[0], high[0]), dice(low[1], high[1]), dice(low[2], high[2]));
    const Vec3 direction = (target - from).Normalized();
    for (int k = 0; k < 19; ++k)
    {
      rays.push_back(helios::MakeRay(from, direction + dice.Direction() * (k == 0 ? 0 : 0.3e-3)));
    }
  }
  return rays;
}

} // namespace

TEST_CASE("EmbreeRayCaster: equal to brute force bit for bit", "[EmbreeRayCaster]")
{
  helios::CheckAgainstBruteForce<vtkHeliosEmbreeRayCaster>(1000);
}

TEST_CASE("EmbreeRayCaster: no leak at corners and edges", "[EmbreeRayCaster]")
{
  helios::CheckLeaks<vtkHeliosEmbreeRayCaster>(5);
}

TEST_CASE("EmbreeRayCaster: the lowest cell id at equal ranges", "[EmbreeRayCaster]")
{
  helios::CheckTies<vtkHeliosEmbreeRayCaster>();
}

TEST_CASE("EmbreeRayCaster: degenerate triangles are not hit", "[EmbreeRayCaster]")
{
  helios::CheckDegenerate<vtkHeliosEmbreeRayCaster>();
}

TEST_CASE("EmbreeRayCaster: byte-identical for any number of threads", "[EmbreeRayCaster]")
{
  helios::CheckThreads<vtkHeliosEmbreeRayCaster>();
}

TEST_CASE(
  "EmbreeRayCaster: equal to the double-precision tree on terrain with leaves", "[EmbreeRayCaster]")
{
  for (const Vec3& offset : helios::Offsets)
  {
    helios::Soup soup = helios::MakeTerrain(200, 1.0);
    helios::AddLeaves(soup, 20000, 0.05, { 60, 60, 5 }, { 140, 140, 15 });
    soup.Move(offset);
    INFO("offset " << offset[0]);
    CHECK(CountDifferencesFromBvh(soup, helios::MakeRays(soup, 20000)) == 0);
    CHECK(
      CountDifferencesFromBvh(soup,
        MakeBundles(offset + Vec3(101, 99, 5), offset, offset + Vec3(200, 200, 10), 1000)) == 0);
    CHECK(
      CountDifferencesFromBvh(soup,
        MakeBundles(offset + Vec3(101, 99, 800), offset, offset + Vec3(200, 200, 10), 1000)) == 0);
  }
}

TEST_CASE("EmbreeRayCaster: equal to the double-precision tree on slivers", "[EmbreeRayCaster]")
{
  // A fan of 2000 triangles, 1 km long and 0.8 m wide; needles 10 m long and 1e-9 m wide.
  helios::Soup soup;
  const vtkIdType centre = soup.AddPoint({ 0, 0, 0 });
  for (int i = 0; i < 2000; ++i)
  {
    const double angle = 2 * vtkMath::Pi() * i / 2000 / 4;
    soup.AddPoint({ 1000 * std::cos(angle), 1000 * std::sin(angle), 0 });
    soup.Triangles.push_back({ centre, i + 1, i + 2 });
  }
  soup.Triangles.pop_back();
  helios::Dice dice;
  for (int i = 0; i < 500; ++i)
  {
    const Vec3 p = dice.Point(-10, 10);
    soup.AddTriangle(p, p + dice.Direction() * 10, p + dice.Direction() * 1e-9);
  }
  CHECK(CountDifferencesFromBvh(soup, helios::MakeRays(soup, 10000)) == 0);
}

TEST_CASE("EmbreeRayCaster: small distant leaves are hit", "[EmbreeRayCaster]")
{
  // Floats cannot represent a leaf of 0.1 mm at 1 km, or of 1 mm at 9 km.
  for (const auto& [leaf, distance] : { std::make_pair(1e-4, 1e3), std::make_pair(1e-3, 9e3) })
  {
    helios::Soup soup;
    soup.AddTriangle({ -1e4, -1e4, 0 }, { 1e4, -1e4, 0 }, { 0, 2e4, 0 });
    helios::Dice dice;
    std::vector<vtkHeliosRay> rays;
    for (int i = 0; i < 100; ++i)
    {
      const Vec3 p(distance, 0.1 * i, 1.0);
      soup.AddTriangle(p, p + Vec3(leaf, 0, 0), p + Vec3(0, leaf, 0));
      const Vec3 from = p + Vec3(0, 0, 99) + dice.Direction();
      rays.push_back(helios::MakeRay(from, p + Vec3(0.3 * leaf, 0.3 * leaf, 0) - from));
    }
    vtkNew<vtkHeliosEmbreeRayCaster> caster;
    REQUIRE(caster->Build(soup.GetPolyData()));
    const auto hits = helios::Cast(caster, rays);
    for (int i = 0; i < 100; ++i)
    {
      CHECK(hits[i].CellId == i + 1);
      CHECK(hits[i].Range == Approx(1.0).epsilon(1e-12));
    }
    CHECK(CountDifferencesFromBvh(soup, rays) == 0);
  }
}

TEST_CASE("EmbreeRayCaster: equal to the double-precision tree at silhouettes", "[EmbreeRayCaster]")
{
  // Rays that graze a sphere at its corners and edges, from 10 to 1e6 radii away.
  for (const Vec3& offset : helios::Offsets)
  {
    helios::Soup soup = helios::MakeIcosphere(4);
    soup.Move(offset);
    helios::Dice dice(7);
    std::vector<vtkHeliosRay> rays;
    for (int i = 0; i < 20000; ++i)
    {
      const Vec3 out = dice.Direction();
      const Vec3 from = offset + out * std::pow(10, dice(1, 6));
      const auto& triangle = soup.Triangles[static_cast<std::size_t>(i) % soup.Triangles.size()];
      const Vec3 a = soup.Points[triangle[0]] - offset;
      const Vec3 b = soup.Points[triangle[1]] - offset;
      const double s = i % 2 == 0 ? dice() : 0.0;
      const Vec3 rim = (a - out * a.Dot(out)).Normalized();
      const Vec3 targets[3] = { a + (b - a) * s, rim, rim * (1.0 - 1e-3 * dice()) };
      rays.push_back(helios::MakeRay(from, offset + targets[i % 3] - from));
    }
    CHECK(CountDifferencesFromBvh(soup, rays) == 0);
  }
}

TEST_CASE(
  "EmbreeRayCaster: equal to the double-precision tree with distant points", "[EmbreeRayCaster]")
{
  helios::Soup soup = helios::MakeMixture();
  auto rays = helios::MakeRays(soup, 3000);
  soup.AddTriangle({ 1e30, 1e30, 1e30 }, { 1e30, 2e30, 1e30 }, { 1e30, 1e30, 2e30 });
  soup.AddTriangle({ 0.1, 0.2, 0.3 }, { 1e5, -200, 1 }, { 1e5, 300, 2 });
  soup.Triangles.push_back(soup.Triangles.front());
  soup.Triangles.insert(soup.Triangles.begin(), soup.Triangles.end()[-2]);
  helios::Dice dice(8);
  for (int i = 0; i < 3000; ++i)
  {
    const Vec3 from = dice.Point(-2, 2);
    const Vec3 near(dice(0, 200), dice(0, 0.5), dice(0.2, 0.5));
    rays.push_back(
      helios::MakeRay(from, i % 2 == 0 ? near - from : Vec3(1, 1 + dice(), 1 + dice())));
  }
  CHECK(CountDifferencesFromBvh(soup, rays) == 0);
  // A scene of only outliers: effectively no box.
  helios::Soup wide;
  wide.AddTriangle({ -1e30, -1e30, 0 }, { 1e30, -1e30, 0 }, { 0, 2e30, 1 });
  wide.AddTriangle({ 1, 1, 1 }, { 2, 2, 2 }, { 3, 3, 3 });
  CHECK(CountDifferencesFromBvh(wide, rays) == 0);
}

TEST_CASE(
  "EmbreeRayCaster: no hits in a scene without area, or without triangles", "[EmbreeRayCaster]")
{
  const std::vector<vtkHeliosRay> rays(3, helios::MakeRay({ 0, 0, 0 }, { 1, 1, 1 }));
  helios::Soup soup;
  soup.AddTriangle({ 1, 1, 1 }, { 2, 2, 2 }, { 3, 3, 3 });
  vtkNew<vtkHeliosEmbreeRayCaster> caster;
  CHECK(helios::Cast(caster, rays)[2].CellId == -1);
  REQUIRE(caster->Build(soup.GetPolyData()));
  CHECK(helios::Cast(caster, rays)[2].CellId == -1);
  soup.AddTriangle({ 5, 4, 4 }, { 4, 5, 4 }, { 4, 4, 5 });
  REQUIRE(caster->Build(soup.GetPolyData()));
  CHECK(helios::Cast(caster, rays)[2].CellId == 1);
  vtkObject::GlobalWarningDisplayOff();
  CHECK_FALSE(caster->Build(nullptr));
  vtkObject::GlobalWarningDisplayOn();
  CHECK(helios::Cast(caster, rays)[2].CellId == -1);
  CHECK(caster->GetAcceleratorSize() == 0);
}

TEST_CASE("EmbreeRayCaster: any scale", "[EmbreeRayCaster]")
{
  for (double scale : { 1e-50, 1e-20, 1e20, 1e45 })
  {
    helios::Soup soup = helios::MakeMixture();
    soup.Move({ 0, 0, 0 }, scale);
    INFO("scale " << scale);
    CHECK(CountDifferencesFromBvh(soup, helios::MakeRays(soup, 2000)) == 0);
  }
}

TEST_CASE("EmbreeRayCaster: memory is small compared with the scene", "[EmbreeRayCaster]")
{
  vtkNew<vtkHeliosEmbreeRayCaster> caster;
  const helios::Soup soup = helios::MakeTerrain(300, 1.0);
  REQUIRE(caster->Build(soup.GetPolyData()));
  const double perTriangle =
    static_cast<double>(caster->GetAcceleratorSize()) / static_cast<double>(soup.Triangles.size());
  CHECK(perTriangle > 10);
  CHECK(perTriangle <= 104);
}
