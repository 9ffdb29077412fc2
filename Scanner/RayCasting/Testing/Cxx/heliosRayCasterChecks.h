// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Checks for every ray caster backend.

#ifndef heliosRayCasterChecks_h
#define heliosRayCasterChecks_h

#include "heliosRayCastingScenes.h"
#include "heliosSceneGeometry.h"

#include <vtkNew.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <thread>

namespace helios
{

/// Equal to brute force bit for bit, hits and occlusion, at any scene location.
template <typename CasterT>
void CheckAgainstBruteForce(int rayCount)
{
  for (const Vec3& offset : Offsets)
  {
    for (double scale : { 0.01, 1.0, 1000.0 })
    {
      Soup soup = MakeMixture();
      soup.Move(offset, scale);
      const auto scene = soup.GetPolyData();
      vtkNew<CasterT> caster;
      REQUIRE(caster->Build(scene));
      const auto rays = MakeRays(soup, rayCount);
      std::vector<vtkHeliosHit> truth;
      for (const vtkHeliosRay& ray : rays)
      {
        truth.push_back(IntersectBruteForce(caster->GetGeometry().GetMesh(), ray));
      }
      std::vector<unsigned char> occluded(rays.size(), 2);
      caster->Occluded(rays.data(), occluded.data(), static_cast<vtkIdType>(rays.size()));
      int occlusionDifferences = 0;
      for (std::size_t i = 0; i < rays.size(); ++i)
      {
        occlusionDifferences += occluded[i] != (truth[i].CellId >= 0 ? 1 : 0);
      }
      INFO("offset " << offset[0] << ", scale " << scale);
      CHECK(CountDifferences(Cast(caster, rays), truth) == 0);
      CHECK(occlusionDifferences == 0);
      const auto hits = std::count_if(
        truth.begin(), truth.end(), [](const vtkHeliosHit& hit) { return hit.CellId >= 0; });
      CHECK(hits > rayCount / 4);
      CHECK(hits < rayCount);
    }
  }
}

/// Rays from inside a closed mesh, aimed exactly at its corners and at points of its edges.
inline std::vector<vtkHeliosRay> MakeRaysAtEdges(const Soup& soup, const Vec3& origin)
{
  std::vector<vtkHeliosRay> rays;
  for (const Vec3& p : soup.Points)
  {
    rays.push_back(MakeRay(origin, p - origin));
  }
  for (const auto& triangle : soup.Triangles)
  {
    for (int i = 0; i < 3; ++i)
    {
      const vtkIdType from = triangle[i];
      const vtkIdType to = triangle[(i + 1) % 3];
      for (double s : { 0.25, 0.5, 0.7, 0.9 })
      {
        if (from < to)
        {
          rays.push_back(
            MakeRay(origin, soup.Points[from] * (1 - s) + soup.Points[to] * s - origin));
        }
      }
    }
  }
  return rays;
}

/// No ray leaves a closed mesh through an edge or a corner; each hits at the expected range.
template <typename CasterT>
void CheckLeaks(int level)
{
  const struct
  {
    Vec3 Offset;
    double Radius;
    bool IsFloat;
  } places[4] = { { Offsets[0], 1.0, false }, { Offsets[0], 10.0, true },
    { Offsets[1], 10.0, false }, { Offsets[1], 400.0, false } };
  for (const auto& place : places)
  {
    Soup soup = MakeIcosphere(level);
    soup.Move(place.Offset, place.Radius);
    for (Vec3& p : soup.Points)
    {
      p = place.IsFloat ? Vec3(float(p[0]), float(p[1]), float(p[2])) : p;
    }
    vtkNew<CasterT> caster;
    const auto scene = soup.GetPolyData();
    REQUIRE(caster->Build(scene));
    for (const Vec3& start : { Vec3(0, 0, 0), Vec3(0.31, -0.52, 0.47) })
    {
      const auto rays = MakeRaysAtEdges(soup, place.Offset + start * place.Radius);
      const auto hits = Cast(caster, rays);
      const auto misses = std::count_if(
        hits.begin(), hits.end(), [](const vtkHeliosHit& hit) { return hit.CellId < 0; });
      double worst = 0.0;
      for (const vtkHeliosHit& hit : hits)
      {
        worst = std::max(worst, std::abs(hit.Range - 1.0));
      }
      INFO("offset " << place.Offset[0] << ", radius " << place.Radius << ", " << rays.size()
                     << " rays");
      CHECK(misses == 0);
      // Points of edges are rounded at the scene's location: an ulp of 5.5e6 m is 2^-30 m.
      CHECK(worst < 1e-14 + (place.Offset[0] > 0 ? 0x1p-27 : 0.0) / place.Radius);
    }
  }
}

/// Checks that the lowest cell id wins among triangles at equal range, in any order of points.
template <typename CasterT>
void CheckTies()
{
  Dice dice(5);
  Soup soup;
  for (int i = 0; i < 200; ++i)
  {
    const Vec3 p[3] = { dice.Point(-1, 1), dice.Point(-1, 1), dice.Point(-1, 1) };
    soup.AddTriangle(p[0], p[1], p[2]);
  }
  const std::array<int, 3> orders[3] = { { 0, 2, 1 }, { 1, 2, 0 }, { 0, 1, 2 } };
  for (const auto& order : orders)
  {
    for (int i = 199; i >= 0; --i)
    {
      const auto t = soup.Triangles[i];
      soup.Triangles.push_back({ t[order[0]], t[order[1]], t[order[2]] });
    }
  }
  vtkNew<CasterT> caster;
  const auto scene = soup.GetPolyData();
  REQUIRE(caster->Build(scene));
  int wrong = 0;
  int found = 0;
  for (const vtkHeliosHit& hit : Cast(caster, MakeRays(soup, 20000)))
  {
    found += hit.CellId >= 0;
    wrong += hit.CellId >= 200;
  }
  CHECK(found > 5000);
  CHECK(wrong == 0);
}

/// Triangles without area are never hit, and invalid rays hit nothing.
template <typename CasterT>
void CheckDegenerate()
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double inf = NoHit;
  Soup soup;
  soup.AddTriangle({ 1, 0, 0 }, { 1, 0, 0 }, { 1, 0, 0 });
  soup.AddTriangle({ 1, -1, 0 }, { 1, 0, 0 }, { 1, 3, 0 });
  soup.AddTriangle({ 1, -0.1, -0.3 }, { 1, 0.1, 0.3 }, { 1, 0.2, 0.6 });
  soup.AddTriangle({ 2, -1, -1 }, { 2, 1, -1 }, { 2, 0, 2 });
  vtkNew<CasterT> caster;
  const auto scene = soup.GetPolyData();
  REQUIRE(caster->Build(scene));
  std::vector<vtkHeliosRay> rays;
  for (double y : { -0.1, 0.0, 0.1, 0.15 })
  {
    rays.push_back(MakeRay({ 0, y, 0 }, { 1, 0, 0 }));
    rays.push_back(MakeRay({ 0, 0, 0 }, { 1, y, 3 * y }));
  }
  for (const vtkHeliosHit& hit : Cast(caster, rays))
  {
    CHECK(hit.CellId == 3);
    CHECK(hit.Range == 2.0);
  }
  const std::vector<vtkHeliosRay> senseless = { MakeRay({ 0, 0, 0 }, { 0, 0, 0 }),
    MakeRay({ 0, 0, 0 }, { nan, 0, 0 }), MakeRay({ 0, 0, 0 }, { 1, nan, 0 }),
    MakeRay({ 0, 0, 0 }, { inf, 0, 0 }), MakeRay({ 0, 0, 0 }, { 1, 0, -inf }),
    MakeRay({ nan, 0, 0 }, { 1, 0, 0 }), MakeRay({ 0, inf, 0 }, { 1, 0, 0 }),
    MakeRay({ 0, 0, 0 }, { 1, 0, 0 }, nan), MakeRay({ 0, 0, 0 }, { 1, 0, 0 }, 0),
    MakeRay({ 0, 0, 0 }, { 1, 0, 0 }, -1), MakeRay({ 0, 0, 0 }, { 1, 0, 0 }, 1.9),
    MakeRay({ 0, 0, 0 }, { -1, 0, 0 }), MakeRay({ 2, 0, 0 }, { 1, 0, 0 }) };
  for (const vtkHeliosHit& hit : Cast(caster, senseless))
  {
    CHECK(hit.CellId == -1);
    CHECK(hit.Range == inf);
  }
  std::vector<unsigned char> occluded(senseless.size(), 2);
  caster->Occluded(senseless.data(), occluded.data(), static_cast<vtkIdType>(senseless.size()));
  CHECK(std::count(occluded.begin(), occluded.end(), 0) == static_cast<int>(senseless.size()));
  CHECK(Cast(caster, { MakeRay({ 0, 0, 0 }, { 1, 0, 0 }, 2.0) })[0].CellId == 3);
}

/// Concurrent threads, with batches of any size, get the same result as one.
template <typename CasterT>
void CheckThreads()
{
  Soup soup = MakeTerrain(100, 1.0);
  AddLeaves(soup, 5000, 0.1, { 0, 0, 5 }, { 100, 100, 15 });
  vtkNew<CasterT> caster;
  const auto scene = soup.GetPolyData();
  REQUIRE(caster->Build(scene));
  const auto rays = MakeRays(soup, 20000);
  const auto truth = Cast(caster, rays);
  std::vector<vtkHeliosHit> hits[2];
  const auto work = [&caster, &rays](std::vector<vtkHeliosHit>& result, std::size_t batch)
  {
    result.resize(rays.size());
    for (std::size_t i = 0; i < rays.size(); i += batch)
    {
      const std::size_t count = std::min(batch, rays.size() - i);
      caster->Intersect(&rays[i], &result[i], static_cast<vtkIdType>(count));
    }
  };
  std::thread other([&work, &hits] { work(hits[0], 19); });
  work(hits[1], 1);
  other.join();
  CHECK(CountDifferences(hits[0], truth) == 0);
  CHECK(CountDifferences(hits[1], truth) == 0);
}

} // namespace helios

#endif
