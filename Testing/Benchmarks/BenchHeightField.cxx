// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// A raster of heights as a height field and as a mesh: memory, time to build, rays a second.
// Usage: BenchHeightField [side [beams]]
#pragma GCC diagnostic ignored "-Wpsabi" // heliosBeamBundle.h needs it

#include "heliosBeamBundle.h"
#include "heliosBenchClock.h"
#include "heliosConeProbe.h"
#include "heliosHeightField.h"
#include "heliosPose.h"
#include "heliosRandom.h"
#include "heliosRasterScenes.h"

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <vector>

namespace
{

using helios::SceneTree;
using helios::Vec3;

constexpr int RaysPerBeam = 19;

double GetUniform(std::uint64_t i, std::uint64_t k)
{
  return helios::Uniform4(1, helios::RandomStream::Scene, i, k)[0];
}

/// Where beams start, relative to the middle of the raster, and how far from there they aim [m].
struct Scan
{
  const char* Name;
  double Height;
  double Nearest;
  double Farthest;
};

/// Beams of a divergence of 0.3 mrad, line by line.
std::vector<vtkHeliosRay> MakeRays(const Scan& scan, const Vec3& middle, int beams)
{
  std::vector<vtkHeliosRay> rays;
  const Vec3 from = middle + Vec3(0, 0, scan.Height);
  for (int i = 0; i < beams; ++i)
  {
    const double angle = 2 * vtkMath::Pi() * (i % 1000) / 1000;
    const double reach = scan.Nearest + (scan.Farthest - scan.Nearest) * i / beams;
    const Vec3 axis =
      (middle + Vec3(std::cos(angle), std::sin(angle), 0) * reach - from).Normalized();
    for (int k = 0; k < RaysPerBeam; ++k)
    {
      const auto pulse = static_cast<std::uint64_t>(i);
      const auto ray = static_cast<std::uint64_t>(k);
      const Vec3 aside(GetUniform(pulse, 3 * ray) - 0.5, GetUniform(pulse, 3 * ray + 1) - 0.5,
        GetUniform(pulse, 3 * ray + 2) - 0.5);
      const Vec3 direction = axis + aside * (k == 0 ? 0.0 : 3e-4);
      rays.push_back(
        { { from[0], from[1], from[2] }, { direction[0], direction[1], direction[2] } });
    }
  }
  return rays;
}

using Hits = std::vector<vtkHeliosHit>;

void TraceBeams(const SceneTree& tree, const std::vector<vtkHeliosRay>& rays, Hits& hits)
{
  helios::BeamBundle bundle(tree);
  for (std::size_t i = 0; i < rays.size(); i += RaysPerBeam)
  {
    bundle.Trace(&rays[i], &hits[i], RaysPerBeam);
  }
}

void TraceAxes(const SceneTree& tree, const std::vector<vtkHeliosRay>& rays, Hits& hits)
{
  for (std::size_t i = 0; i < rays.size(); i += RaysPerBeam)
  {
    hits[i] = tree.Intersect(rays[i]);
  }
}

void ProbeCones(const SceneTree& tree, const std::vector<vtkHeliosRay>& rays, Hits& hits)
{
  const auto probe = helios::MakeConeProbe(tree);
  const helios::PlaneLimits limits(0.002);
  for (std::size_t i = 0; i < rays.size(); i += RaysPerBeam)
  {
    const Vec3 axis = Vec3(rays[i].Direction).Normalized();
    const auto hit = probe->Probe(rays[i].Origin, axis.GetData(), 3e-4, limits);
    hits[i] = { hit.Range, hit.CellId };
  }
}

using Trace = std::function<void(const SceneTree&, const std::vector<vtkHeliosRay>&, Hits&)>;

/// The time of a beam in the tree [us].
double Measure(
  const SceneTree& tree, const Trace& trace, const std::vector<vtkHeliosRay>& rays, Hits& hits)
{
  hits.assign(rays.size(), { 0.0, -1 });
  std::vector<double> seconds;
  for (int i = 0; i < 5; ++i)
  {
    const double start = helios::CpuSeconds();
    trace(tree, rays, hits);
    seconds.push_back(helios::CpuSeconds() - start);
  }
  return helios::Median(seconds) / static_cast<double>(rays.size()) * RaysPerBeam * 1e6;
}

bool AreSame(const Hits& a, const Hits& b)
{
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
    [](const vtkHeliosHit& x, const vtkHeliosHit& y)
    { return x.CellId == y.CellId && x.Range == y.Range; });
}

bool Compare(
  const SceneTree& ofField, const SceneTree& ofMesh, const Vec3& middle, double width, int beams)
{
  const Scan scans[] = { { "aircraft, 1000 m", 1000.0, 0.0, 0.45 * width },
    { "tripod, 2 m", 12.0, 2.0, 200.0 } };
  const struct
  {
    const char* Name;
    Trace Run;
  } traces[] = { { "single rays", TraceAxes }, { "beams of 19 rays", TraceBeams },
    { "cone probes", ProbeCones } };
  for (const Scan& scan : scans)
  {
    const auto rays = MakeRays(scan, middle, beams);
    for (const auto& trace : traces)
    {
      Hits hits, truth;
      const double field = Measure(ofField, trace.Run, rays, hits);
      const double mesh = Measure(ofMesh, trace.Run, rays, truth);
      if (!AreSame(hits, truth))
      {
        std::printf("%s, %s: hits differ\n", scan.Name, trace.Name);
        return false;
      }
      std::printf("%-16s  %-16s  field %6.2f us  mesh %6.2f us  %.2f times as fast\n", scan.Name,
        trace.Name, field, mesh, mesh / field);
    }
  }
  return true;
}

} // namespace

int main(int argc, char** argv)
{
  const int side = argc > 1 ? std::atoi(argv[1]) : 4000;
  const int beams = argc > 2 ? std::atoi(argv[2]) : 100000;
  helios::HeightRaster raster(side, side, { 476000.0, 0.5, 0.0, 5473000.0, 0.0, -0.5 });
  raster.AddHills(8.0, 0.1);
  const auto image = raster.MakeImage<vtkFloatArray>();
  const double cells = static_cast<double>(side - 1) * (side - 1);
  double start = helios::WallSeconds();
  helios::HeightField field;
  SceneTree ofField;
  if (const helios::Status status = field.Set(image); !status.IsOk())
  {
    std::printf("%s\n", status.Message().c_str());
    return 1;
  }
  ofField.Build(field);
  std::printf("%d x %d float heights\n", side, side);
  std::printf("field: %.2f s, %.2f bytes a cell\n", helios::WallSeconds() - start,
    (4.0 * side * side + static_cast<double>(field.GetMemorySize() + ofField.GetMemorySize())) /
      cells);

  start = helios::WallSeconds();
  const auto scene = helios::MakeMesh(raster);
  helios::TriangleMesh mesh;
  SceneTree ofMesh;
  helios::StopCheck never(nullptr);
  if (!mesh.Set(scene).IsOk())
  {
    return 1;
  }
  ofMesh.Build(mesh, never);
  std::printf("mesh: %.2f s, %.2f bytes a cell\n", helios::WallSeconds() - start,
    (1024.0 * static_cast<double>(scene->GetActualMemorySize()) +
      static_cast<double>(mesh.GetMemorySize() + ofMesh.GetMemorySize())) /
      cells);
  const double* t = raster.Transform.data();
  const Vec3 middle(t[0] + 0.5 * side * t[1], t[3] + 0.5 * side * t[5], 0.0);
  return Compare(ofField, ofMesh, middle, side * t[1], beams) ? 0 : 1;
}
