// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// The ray casters against bare loops of Embree's own triangles and of CGAL's AABB tree, on the same
// rays: a tripod (TLS) and an aircraft (ALS), single rays and bundles of 19 and 217 within 0.3
// mrad, over a canopy of 984 k and a terrain of 2 M triangles in UTM coordinates. Hits are checked
// before times are printed; repeats alternate between casters, rates are medians by thread CPU
// time.
//
// CGAL's AABB tree is under the GPL, and so is this program once built: it is for measuring, and is
// not installed.
//
// Usage: BenchRayCasters [repeats [pulses]]

#include "heliosBareCasters.h"
#include "heliosBenchScenes.h"
#include "heliosConeProbe.h"
#include "heliosSceneGeometry.h"
#include "vtkHeliosBeamRayCaster.h"
#include "vtkHeliosBvhRayCaster.h"
#include "vtkHeliosEmbreeRayCaster.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <thread>

namespace
{

using namespace helios::bench;

struct Differences
{
  std::size_t Missed = 0;    // with a true hit
  std::size_t Invented = 0;  // without one
  std::size_t Triangles = 0; // another triangle
  std::size_t Ranges = 0;    // different range, in any bit
};

Differences Compare(const Hits& truth, const Hits& hits)
{
  Differences d;
  for (std::size_t i = 0; i < truth.size(); ++i)
  {
    const bool isHit = truth[i].CellId >= 0;
    d.Missed += isHit && hits[i].CellId < 0;
    d.Invented += !isHit && hits[i].CellId >= 0;
    d.Triangles += hits[i].CellId != truth[i].CellId;
    d.Ranges += hits[i].Range != truth[i].Range;
  }
  return d;
}

/// Casts a caster's subset of the rays; returns its rate [Mray/s].
double GetRate(const Contender& contender, const Rays& rays, Hits& hits)
{
  // In runs of whole bundles, so that neighbours stay adjacent.
  const std::size_t run = contender.Share == 1 ? rays.size() : 19 * 217;
  std::size_t count = 0;
  const double start = GetThreadTime();
  for (std::size_t i = 0; i < rays.size(); i += run * contender.Share)
  {
    const std::size_t last = std::min(rays.size(), i + run);
    contender.Cast(rays, hits, i, last);
    count += last - i;
  }
  return 1e-6 * static_cast<double>(count) / (GetThreadTime() - start);
}

/// Times casters in turns, and prints their rates and the speed-up of the first over them.
void Race(const std::vector<Contender>& contenders, const Rays& rays, int repeats)
{
  std::vector<std::vector<double>> rates(contenders.size());
  std::vector<std::vector<double>> ratios(contenders.size());
  Hits hits(rays.size());
  for (int repeat = 0; repeat < repeats; ++repeat)
  {
    for (std::size_t c = 0; c < contenders.size(); ++c)
    {
      rates[c].push_back(GetRate(contenders[c], rays, hits));
      ratios[c].push_back(rates[0].back() / rates[c].back());
    }
  }
  std::printf("        ");
  for (std::size_t c = 0; c < contenders.size(); ++c)
  {
    std::printf("  %s %5.2f", contenders[c].Name, GetMedian(rates[c]));
    if (c > 0)
    {
      std::printf(" (x%.2f)", GetMedian(ratios[c]));
    }
  }
}

/// Casts every second run of rays; returns its thread CPU time.
double CastEverySecond(const Contender& contender, const Rays& rays, Hits& hits, std::size_t first)
{
  const std::size_t run = 19 * 217;
  const double start = GetThreadTime();
  for (std::size_t i = first * run; i < rays.size(); i += 2 * run)
  {
    contender.Cast(rays, hits, i, std::min(rays.size(), i + run));
  }
  return GetThreadTime() - start;
}

/// Speed-up of two threads over one, by the CPU time of the longer of the two.
double GetSpeedUp(const Contender& contender, const Rays& rays, int repeats)
{
  std::vector<double> speedUps;
  Hits hits(rays.size());
  for (int repeat = 0; repeat < repeats; ++repeat)
  {
    const double alone =
      CastEverySecond(contender, rays, hits, 0) + CastEverySecond(contender, rays, hits, 1);
    double times[2];
    std::thread other(
      [&contender, &rays, &hits, &times] { times[1] = CastEverySecond(contender, rays, hits, 1); });
    times[0] = CastEverySecond(contender, rays, hits, 0);
    other.join();
    speedUps.push_back(alone / std::max(times[0], times[1]));
  }
  return GetMedian(speedUps);
}

/// Checks the hits of a set of rays and times it; returns whether ours are right.
bool RunSet(
  const char* set, const std::vector<Contender>& contenders, const Rays& rays, int repeats)
{
  Hits truth(rays.size());
  Hits hits(rays.size());
  contenders[3].Cast(rays, truth, 0, rays.size());
  const auto hitCount = std::count_if(
    truth.begin(), truth.end(), [](const vtkHeliosHit& hit) { return hit.CellId >= 0; });
  contenders[0].Cast(rays, hits, 0, rays.size());
  Differences ours = Compare(truth, hits);
  contenders[1].Cast(rays, hits, 0, rays.size());
  const Differences others = Compare(truth, hits);
  ours.Triangles += others.Triangles;
  ours.Ranges += others.Ranges;
  contenders[2].Cast(rays, hits, 0, rays.size());
  const Differences bare = Compare(truth, hits);
  std::printf(
    "  %-6s %zu rays, %td hits; ours: %zu other triangles, %zu other ranges; bare Embree: "
    "%.4f %% other triangles, %zu missed, %zu invented\n",
    set, rays.size(), hitCount, ours.Triangles, ours.Ranges,
    100.0 * static_cast<double>(bare.Triangles) / static_cast<double>(rays.size()), bare.Missed,
    bare.Invented);
  Race(contenders, rays, repeats);
  std::printf("  2 threads x%.2f\n", GetSpeedUp(contenders[0], rays, repeats));
  std::fflush(stdout);
  return ours.Triangles == 0 && ours.Ranges == 0;
}

/// Whether a cone hit is valid for its 19 rays, the first of which is its axis.
bool IsTrue(const helios::TriangleMesh& mesh, const vtkHeliosConeHit& cone, double tolerance,
  const vtkHeliosRay* rays, const vtkHeliosHit* hits)
{
  bool isTrue = cone.Kind != vtkHeliosConeHit::PlanarFootprint ||
    (hits[0].CellId == cone.CellId && hits[0].Range == cone.Range);
  for (int i = 0; i < 19 && cone.Kind != vtkHeliosConeHit::Unresolved; ++i)
  {
    isTrue = isTrue && (hits[i].CellId >= 0) == (cone.Kind == vtkHeliosConeHit::PlanarFootprint);
    isTrue = isTrue &&
      (hits[i].CellId < 0 ||
        std::abs(Refine(mesh, rays[i], cone.CellId) - hits[i].Range) <= 1.001 * tolerance + 1e-9);
  }
  return isTrue;
}

/// Checks and times the cone probe for the cones around bundles of 19 rays.
bool RunProbe(vtkHeliosRayCaster* caster, const Rays& rays, int repeats)
{
  const double tolerance = 2.5e-4;
  Hits hits(rays.size());
  caster->Intersect(rays.data(), hits.data(), static_cast<vtkIdType>(rays.size()));
  const helios::ConeProbe* cones = caster->GetConeProbe();
  const auto probe = [cones, tolerance](const vtkHeliosRay& ray)
  { return cones->Probe(ray.Origin, ray.Direction, 0.3e-3 * (1 + 1e-9), tolerance); };
  double counts[3] = { 0, 0, 0 };
  std::size_t wrong = 0;
  for (std::size_t i = 0; i < rays.size(); i += 19)
  {
    const vtkHeliosConeHit cone = probe(rays[i]);
    ++counts[cone.Kind];
    wrong += !IsTrue(caster->GetGeometry().GetMesh(), cone, tolerance, &rays[i], &hits[i]);
  }
  const double number = static_cast<double>(rays.size() / 19);
  std::vector<double> rates;
  for (int repeat = 0; repeat < repeats; ++repeat)
  {
    const double start = GetThreadTime();
    for (std::size_t i = 0; i < rays.size(); i += 19)
    {
      probe(rays[i]);
    }
    rates.push_back(1e-6 * number / (GetThreadTime() - start));
  }
  std::printf("          ConeProbe %.2f M/s: %.1f %% empty, %.1f %% planar to %g mm, %zu wrong\n",
    GetMedian(rates), 100 * counts[vtkHeliosConeHit::Empty] / number,
    100 * counts[vtkHeliosConeHit::PlanarFootprint] / number, 1e3 * tolerance, wrong);
  return wrong == 0;
}

/// Bytes per triangle of a scene and of each accelerator.
void PrintSizes(const char* name, const helios::TriangleMesh& mesh, std::size_t beam,
  std::size_t embree, std::size_t bvh, std::size_t bare)
{
  const double triangles = static_cast<double>(mesh.GetNumberOfTriangles());
  const double points = static_cast<double>(mesh.GetNumberOfPoints());
  std::printf(
    "%s: %.0f triangles; bytes per triangle: scene %.0f, our beam %.0f, ours on Embree %.0f, "
    "our bvh %.0f, bare Embree %.0f\n",
    name, triangles, 12 + 24 * points / triangles, static_cast<double>(beam) / triangles,
    static_cast<double>(embree) / triangles, static_cast<double>(bvh) / triangles,
    static_cast<double>(bare) / triangles);
}

bool Run(const char* name, vtkPolyData* scene, double width, double height, int repeats, int pulses)
{
  vtkNew<vtkHeliosBeamRayCaster> beam;
  vtkNew<vtkHeliosEmbreeRayCaster> embree;
  vtkNew<vtkHeliosBvhRayCaster> bvh;
  if (!beam->Build(scene) || !embree->Build(scene) || !bvh->Build(scene))
  {
    return false;
  }
  const helios::TriangleMesh& mesh = bvh->GetGeometry().GetMesh();
  const BareEmbree bareEmbree(mesh);
  const BareCgal bareCgal(mesh);
  PrintSizes(name, mesh, beam->GetAcceleratorSize(), embree->GetAcceleratorSize(),
    bvh->GetAcceleratorSize(), static_cast<std::size_t>(bareEmbree.Bytes));

  const auto cast = [](const vtkHeliosRayCaster* caster)
  {
    return [caster](const Rays& rays, Hits& hits, std::size_t first, std::size_t last)
    { caster->Intersect(&rays[first], &hits[first], static_cast<vtkIdType>(last - first)); };
  };
  const auto castBare = [](const auto& caster)
  {
    return [&caster](const Rays& rays, Hits& hits, std::size_t first, std::size_t last)
    { caster.Cast(rays, hits, first, last); };
  };
  const auto castBeams = [&beam](int size)
  {
    return [&beam, size](const Rays& rays, Hits& hits, std::size_t first, std::size_t last)
    {
      const auto beams = static_cast<vtkIdType>(last - first) / size;
      beam->IntersectBeams(&rays[first], &hits[first], size, beams);
    };
  };
  std::vector<Contender> contenders = { { "beam", cast(beam) }, { "on Embree", cast(embree) },
    { "bare Embree", castBare(bareEmbree) }, { "bvh", cast(bvh), 4 },
    { "bare CGAL", castBare(bareCgal), 16 } };
  const int singles = 4 * pulses;
  bool isRight = RunSet("TLS", contenders, helios::MakeTripodRays(width, singles, 1), repeats);
  isRight &=
    RunSet("ALS", contenders, helios::MakeAirborneRays(width, height, singles, 1), repeats);
  for (int rings : { 3, 9 })
  {
    const int size = 1 + 3 * rings * (rings - 1); // 19 and 217 rays
    contenders[0].Cast = castBeams(size);
    const int count = rings == 3 ? pulses : pulses / 8;
    const Rays tripod = helios::MakeTripodRays(width, count, rings);
    const Rays aircraft = helios::MakeAirborneRays(width, height, count, rings);
    isRight &= RunSet(rings == 3 ? "TLSx19" : "TLSx217", contenders, tripod, repeats);
    isRight &= rings != 3 || RunProbe(beam, tripod, repeats);
    isRight &= RunSet(rings == 3 ? "ALSx19" : "ALSx217", contenders, aircraft, repeats);
    isRight &= rings != 3 || RunProbe(beam, aircraft, repeats);
  }
  return isRight;
}

} // namespace

int main(int argc, char** argv)
{
  const int repeats = argc > 1 ? std::atoi(argv[1]) : 5;
  const int pulses = argc > 2 ? std::atoi(argv[2]) : 100000;
  if (repeats < 1 || pulses < 100)
  {
    std::fprintf(stderr, "usage: BenchRayCasters [repeats >= 1 [pulses >= 100]]\n");
    return EXIT_FAILURE;
  }
  std::printf("Mray/s of one thread, medians of %d repeats; (x...): speed-up of our beams.\n"
              "Goals: bundles x1.4 bare Embree and x6 bare CGAL, single rays x0.9 bare Embree, "
              "2 threads x1.9.\n",
    repeats);
  bool isRight = Run("canopy", helios::MakeBenchCanopy(), 200.0, 600.0, repeats, pulses);
  isRight &= Run("terrain", helios::MakeBenchTerrain(), 1000.0, 800.0, repeats, pulses);
  std::printf("%s\n",
    isRight ? "Ours equals the double-precision tree bit for bit." : "OUR ANSWERS ARE WRONG.");
  return isRight ? EXIT_SUCCESS : EXIT_FAILURE;
}
