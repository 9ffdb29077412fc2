// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHeliosBeamRayCaster.h"

#include "heliosExtremeChecks.h"
#include "heliosRayCasterChecks.h"
#include "vtkHeliosBvhRayCaster.h"

using helios::Dice;
using helios::Vec3;

namespace
{

/// Returns the number of hits of beams, and of a last partial one, that differ from the bvh's.
int CountDifferences(
  const helios::Soup& soup, const std::vector<vtkHeliosRay>& rays, int raysPerBeam)
{
  const auto scene = soup.GetPolyData();
  vtkNew<vtkHeliosBvhRayCaster> bvh;
  vtkNew<vtkHeliosBeamRayCaster> beam;
  REQUIRE(bvh->Build(scene));
  REQUIRE(beam->Build(scene));
  const auto truth = helios::Cast(bvh, rays);
  std::vector<vtkHeliosHit> hits(rays.size(), { -7.0, -7 });
  const auto count = static_cast<vtkIdType>(rays.size());
  const vtkIdType beams = count / raysPerBeam;
  beam->IntersectBeams(rays.data(), hits.data(), raysPerBeam, beams);
  const int rest = static_cast<int>(count - beams * raysPerBeam);
  beam->IntersectBeams(rays.data() + count - rest, hits.data() + count - rest, rest, 1);
  return helios::CountDifferences(hits, truth);
}

/// Beams of 19 rays from one point to points in a box; spread is the tangent of their half angle.
std::vector<vtkHeliosRay> MakeBeams(const Vec3& from, const Vec3& low, const Vec3& high,
  double spread, double skew = 0.0, int count = 300)
{
  Dice dice(6);
  std::vector<vtkHeliosRay> rays;
  for (int i = 0; i < count; ++i)
  {
    const Vec3 target(dice(low[0], high[0]), dice(low[1], high[1]), dice(low[2], high[2]));
    const Vec3 direction = (target - from).Normalized();
    for (int k = 0; k < 19; ++k)
    {
      rays.push_back(helios::MakeRay(from + dice.Direction() * (skew * dice()),
        direction + dice.Direction() * (k == 0 ? 0.0 : spread)));
    }
  }
  return rays;
}

/// Beams about each axis, with directions exactly along it, and next to it.
std::vector<vtkHeliosRay> MakeBeamsAlongAxes(const helios::Soup& soup, double distance)
{
  Dice dice(7);
  std::vector<vtkHeliosRay> rays;
  for (int i = 0; i < 600; ++i)
  {
    const auto pick = static_cast<std::size_t>(dice() * static_cast<double>(soup.Points.size()));
    const Vec3& target = soup.Points[pick];
    Vec3 direction(0, 0, 0);
    direction[i % 3] = i % 2 == 0 ? 1.0 : -1.0;
    for (int k = 0; k < 19; ++k)
    {
      const double size = std::pow(10.0, -3.0 * (k % 12));
      Vec3 d = direction;
      d[(i + 1) % 3] = k % 3 == 0 ? 0.0 : (k % 3 == 1 ? size : -size);
      d[(i + 2) % 3] = k % 4 == 0 ? 0.0 : size * 1e-3 * dice(-1, 1);
      rays.push_back(helios::MakeRay(target - direction * distance, d));
    }
  }
  return rays;
}

helios::Soup MakeForest()
{
  helios::Soup soup = helios::MakeTerrain(100, 2.0);
  helios::AddLeaves(soup, 10000, 0.05, { 60, 60, 5 }, { 140, 140, 15 });
  return soup;
}

} // namespace

TEST_CASE("BeamRayCaster: equal to brute force bit for bit", "[BeamRayCaster]")
{
  helios::CheckAgainstBruteForce<vtkHeliosBeamRayCaster>(1000);
}

TEST_CASE("BeamRayCaster: no leak at corners and edges", "[BeamRayCaster]")
{
  helios::CheckLeaks<vtkHeliosBeamRayCaster>(5);
}

TEST_CASE("BeamRayCaster: the lowest cell id at equal ranges", "[BeamRayCaster]")
{
  helios::CheckTies<vtkHeliosBeamRayCaster>();
}

TEST_CASE("BeamRayCaster: degenerate triangles are not hit", "[BeamRayCaster]")
{
  helios::CheckDegenerate<vtkHeliosBeamRayCaster>();
}

TEST_CASE("BeamRayCaster: byte-identical for any number of threads", "[BeamRayCaster]")
{
  helios::CheckThreads<vtkHeliosBeamRayCaster>();
}

TEST_CASE("BeamRayCaster: extreme coordinates", "[BeamRayCaster]")
{
  vtkNew<vtkHeliosBeamRayCaster> caster;
  helios::CheckRangeLaw(*caster);
  helios::CheckSmallLeaves(*caster);
  helios::CheckHeightFieldLeaks(*caster);
  helios::CheckNeedles(*caster);
  helios::CheckSphere(*caster);
  helios::CheckSineTerrain(*caster);
}

TEST_CASE("BeamRayCaster: beams equal single rays, for random beams", "[BeamRayCaster]")
{
  for (const Vec3& offset : helios::Offsets)
  {
    for (double scale : { 0.01, 1.0, 1000.0 })
    {
      helios::Soup soup = helios::MakeMixture();
      soup.Move(offset, scale);
      INFO("offset " << offset[0] << ", scale " << scale);
      const auto rays = helios::MakeRays(soup, 2000);
      CHECK(CountDifferences(soup, rays, 1) == 0);
      CHECK(CountDifferences(soup, rays, 19) == 0);
      CHECK(CountDifferences(soup, rays, 300) == 0);
      for (double distance : { 0.1, 3.0, 1e4 })
      {
        CHECK(CountDifferences(soup, MakeBeamsAlongAxes(soup, distance * scale), 19) == 0);
      }
    }
  }
}

TEST_CASE("BeamRayCaster: beams equal single rays, at any width and skewness", "[BeamRayCaster]")
{
  for (const Vec3& offset : helios::Offsets)
  {
    helios::Soup soup = MakeForest();
    soup.Move(offset);
    const Vec3 low = offset;
    const Vec3 high = offset + Vec3(200, 200, 10);
    for (double height : { 8.0, 800.0, 1e6 }) // within the crowns, from an aircraft, from orbit
    {
      const Vec3 from = offset + Vec3(101, 99, height);
      for (double spread : { 0.0, 1e-7, 0.3e-3, 0.02, 0.577 })
      {
        for (double skew : { 0.0, 0.01, 5.0 })
        {
          INFO("offset " << offset[0] << ", height " << height << ", spread " << spread << ", skew "
                         << skew);
          const int count = spread < 0.01 && skew < 1.0 ? 100 : 2;
          CHECK(CountDifferences(soup, MakeBeams(from, low, high, spread, skew, count), 19) == 0);
        }
      }
    }
  }
}

TEST_CASE("BeamRayCaster: beams at corners and edges of a closed mesh", "[BeamRayCaster]")
{
  for (const Vec3& offset : helios::Offsets)
  {
    helios::Soup soup = helios::MakeIcosphere(3);
    soup.Move(offset, 10.0);
    for (const Vec3& start : { Vec3(0, 0, 0), Vec3(0.31, -0.52, 0.47), Vec3(3, 7, -2) })
    {
      const auto rays = helios::MakeRaysAtEdges(soup, offset + start * 10.0);
      CHECK(CountDifferences(soup, rays, 7) == 0);
      CHECK(CountDifferences(soup, rays, 64) == 0);
    }
  }
}

TEST_CASE("BeamRayCaster: invalid and limited rays in a beam", "[BeamRayCaster]")
{
  const helios::Soup soup = MakeForest();
  auto rays = MakeBeams({ 101, 99, 8 }, { 0, 0, 0 }, { 200, 200, 10 }, 0.3e-3);
  const double senseless[5] = { std::nan(""), helios::NoHit, -helios::NoHit, 1e101, 0.0 };
  Dice dice(8);
  for (std::size_t i = 0; i < rays.size(); i += 3)
  {
    const double value = senseless[i % 5];
    switch (i % 4)
    {
      case 0:
        rays[i].MaximumRange = value;
        break;
      case 1:
        rays[i].MaximumRange = dice(0, 100);
        break;
      case 2:
        rays[i].Origin[i % 3] = value;
        break;
      default:
        rays[i].Direction[0] = rays[i].Direction[1] = rays[i].Direction[2] = value;
    }
  }
  CHECK(CountDifferences(soup, rays, 19) == 0);
  rays.assign(19, helios::MakeRay({ 0, 0, 0 }, { 0, 0, 0 }));
  CHECK(CountDifferences(soup, rays, 19) == 0);
}

TEST_CASE("BeamRayCaster: small distant leaves, by beams", "[BeamRayCaster]")
{
  Dice dice(9);
  helios::Soup soup = helios::MakeTerrain(100, 200.0);
  std::vector<vtkHeliosRay> rays;
  for (double leaf : { 1e-1, 1e-2, 1e-3, 1e-4 })
  {
    for (double x : { 1e3, 1e4, 1.9e4 })
    {
      const Vec3 centre(x, 1e4 + 1e3 * leaf, 20.0);
      const Vec3 from = centre + Vec3(3, 5, 400);
      const double size = 0.7 * leaf;
      soup.AddTriangle(centre + Vec3(-size, -size, 0), centre + Vec3(size, -size, 0.1 * size),
        centre + Vec3(0, size, 0));
      for (int i = 0; i < 19; ++i)
      {
        rays.push_back(
          helios::MakeRay(from, centre + Vec3(dice(-size, size), dice(-size, size), 0) - from));
      }
    }
  }
  CHECK(CountDifferences(soup, rays, 19) == 0);
  vtkNew<vtkHeliosBeamRayCaster> caster;
  REQUIRE(caster->Build(soup.GetPolyData()));
  std::vector<vtkHeliosHit> hits(rays.size());
  caster->IntersectBeams(rays.data(), hits.data(), 19, 12);
  for (vtkIdType k = 0; k < 12; ++k) // some rays of each beam hit its leaf
  {
    CHECK(std::count_if(hits.begin() + 19 * k, hits.begin() + 19 * (k + 1),
            [k](const vtkHeliosHit& hit) { return hit.CellId == 20000 + k; }) > 4);
  }
}

TEST_CASE("BeamRayCaster: a distant point changes no other hit", "[BeamRayCaster]")
{
  helios::Soup soup = helios::MakeMixture();
  const auto rays = helios::MakeRays(soup, 3000);
  vtkNew<vtkHeliosBeamRayCaster> caster;
  REQUIRE(caster->Build(soup.GetPolyData()));
  const auto before = helios::Cast(caster, rays);
  soup.AddTriangle({ 1e30, 1e30, 1e30 }, { 1e30, 2e30, 1e30 }, { 1e30, 1e30, 2e30 });
  soup.AddTriangle({ 1e3, 1e3, 1e3 }, { 1e3, 2e3, 1e3 }, { 1e3, 1e3, 2e3 });
  REQUIRE(caster->Build(soup.GetPolyData()));
  const auto isOther = [&soup](const vtkHeliosHit& hit)
  { return hit.CellId >= static_cast<vtkIdType>(soup.Triangles.size()) - 2; };
  const auto after = helios::Cast(caster, rays);
  int differences = 0;
  for (std::size_t i = 0; i < rays.size(); ++i)
  {
    differences += !isOther(after[i]) &&
      (after[i].CellId != before[i].CellId || after[i].Range != before[i].Range);
  }
  CHECK(differences == 0);
  CHECK(CountDifferences(soup, rays, 19) == 0);
}

TEST_CASE("BeamRayCaster: without triangles, and without area", "[BeamRayCaster]")
{
  const auto ray = helios::MakeRay({ 0, 0, 0 }, { 1, 0, 0 });
  vtkNew<vtkHeliosBeamRayCaster> caster;
  vtkHeliosHit hits[3];
  caster->IntersectBeams(&ray, hits, 1, 1);
  CHECK(hits[0].CellId == -1);
  helios::Soup soup;
  soup.AddTriangle({ 1, -1, 0 }, { 1, 0, 0 }, { 1, 3, 0 });
  CHECK(CountDifferences(soup, { ray, ray, ray }, 3) == 0);
}

TEST_CASE("BeamRayCaster: other ray casters trace beams as single rays", "[BeamRayCaster]")
{
  const helios::Soup soup = MakeForest();
  vtkNew<vtkHeliosBvhRayCaster> caster;
  REQUIRE(caster->Build(soup.GetPolyData()));
  const auto rays = MakeBeams({ 101, 99, 8 }, { 0, 0, 0 }, { 200, 200, 10 }, 0.3e-3);
  std::vector<vtkHeliosHit> hits(rays.size());
  caster->IntersectBeams(rays.data(), hits.data(), 19, 300);
  CHECK(helios::CountDifferences(hits, helios::Cast(caster, rays)) == 0);
}

TEST_CASE("BeamRayCaster: memory is small compared with the scene", "[BeamRayCaster]")
{
  const auto getBytes = [](const helios::Soup& soup)
  {
    vtkNew<vtkHeliosBeamRayCaster> caster;
    REQUIRE(caster->Build(soup.GetPolyData()));
    return static_cast<double>(caster->GetAcceleratorSize()) /
      static_cast<double>(soup.Triangles.size());
  };
  const double terrain = getBytes(helios::MakeTerrain(200, 1.0));
  CHECK(terrain > 16); // a triangle and three words
  CHECK(terrain < 32); // 28 for a mesh with half a point a triangle: 60
  CHECK(getBytes(MakeForest()) < 36);
}

TEST_CASE("BeamRayCaster: a mesh of several parts", "[BeamRayCaster]")
{
  const helios::Soup soup = helios::MakeTerrain(300, 1.0);
  REQUIRE(soup.Triangles.size() > 4 * 4096); // BeamBuilder
  const auto rays = MakeBeams({ 150, 150, 60 }, { 0, 0, -5 }, { 300, 300, 5 }, 1e-3);
  CHECK(CountDifferences(soup, rays, 19) == 0);
  CHECK(CountDifferences(soup, rays, 1) == 0);
}
