// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Speed and accuracy of ray casters: speed against range error and missed hits, of vtkHelios
// casters and bare loops, over a canopy, a terrain, slivers and a mixed-scale scene, at local, UTM
// and geocentric coordinates. Prints a table and writes it as CSV; plot_ray_casters.py draws it.
//
// The reference is the double-precision tree, whose hits the tests verify; ranges are compared with
// the plane of the true triangle in extended precision. vtkHelios must equal it, or no table is
// written.
//
// Usage: BenchRayCasterTrade [--quick] [--scene NAME] [table.csv]

#include "heliosBareCasters.h"
#include "heliosBenchScenes.h"
#include "heliosSceneGeometry.h"
#include "vtkHeliosBvhRayCaster.h"
#include "vtkHeliosCgalRayCaster.h"
#include "vtkHeliosEmbreeRayCaster.h"
#include "vtkHeliosObbTreeRayCaster.h"

#include <cstdio>
#include <cstdlib>
#include <string>

namespace
{

using namespace helios::bench;
using helios::Vec3;

/// A scene and rays over it, in local coordinates.
struct Setting
{
  const char* Name;
  vtkSmartPointer<vtkPolyData> Scene;
  Rays Probes;
};

struct Place
{
  const char* Name;
  Vec3 Offset;
};

const Place Places[] = { { "local", { 0, 0, 0 } }, { "UTM", { 5e5, 5.5e6, 300 } },
  { "geocentric", { 4e6, 6e5, 4.9e6 } } };

/// The result of a caster.
struct Result
{
  double Rate = 0.0; // [Mray/s]
  std::size_t Cast = 0;
  std::size_t Missed = 0;   // no hit on a surface
  std::size_t Invented = 0; // a hit without a surface
  std::size_t Other = 0;    // a surface more than 1 mm nearer or farther
  double WorstError = 0.0;  // [m], of the rest
};

void Move(Setting& setting, const Vec3& shift)
{
  vtkPoints* points = setting.Scene->GetPoints();
  for (vtkIdType i = 0; i < points->GetNumberOfPoints(); ++i)
  {
    const Vec3 p = Vec3(points->GetPoint(i)) + shift;
    points->SetPoint(i, p.GetData());
  }
  points->Modified();
  for (vtkHeliosRay& ray : setting.Probes)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      ray.Origin[axis] += shift[axis];
    }
  }
}

/// A ray from above or the side to a random point inside a triangle.
vtkHeliosRay AimAt(vtkPolyData* scene, vtkIdType triangle, std::uint64_t item, double distance)
{
  const auto a = helios::Uniform4(2, helios::RandomStream::Scene, item, 0);
  vtkIdType count;
  const vtkIdType* ids;
  scene->GetPolys()->GetCellAtId(triangle, count, ids);
  const double s = std::sqrt(a[0]);
  const Vec3 target = (1 - s) * Vec3(scene->GetPoint(ids[0])) +
    s * (1 - a[1]) * Vec3(scene->GetPoint(ids[1])) + s * a[1] * Vec3(scene->GetPoint(ids[2]));
  const Vec3 back = Vec3(a[2] - 0.5, a[3] - 0.5, 0.5 + a[2]).Normalized();
  const Vec3 from = target + distance * back;
  return { { from[0], from[1], from[2] }, { -back[0], -back[1], -back[2] } };
}

Rays AimAtTriangles(vtkPolyData* scene, vtkIdType first, vtkIdType count, double distance)
{
  Rays rays;
  for (std::uint64_t i = 0; i < 50000; ++i)
  {
    const double u = helios::Uniform4(3, helios::RandomStream::Scene, i, 0)[0];
    const auto triangle = first + static_cast<vtkIdType>(u * static_cast<double>(count));
    rays.push_back(AimAt(scene, triangle, i, distance));
  }
  return rays;
}

/// A fan of slivers, 1 km long and 0.8 m wide at the rim.
Setting MakeSlivers()
{
  helios::BenchScene fan;
  constexpr int needles = 8000;
  const vtkIdType hub = fan.AddPoint({ 500, 500, 0 });
  for (int i = 0; i <= needles; ++i)
  {
    const double turn = 2 * vtkMath::Pi() * i / needles;
    fan.AddPoint({ 500 + 1000 * std::cos(turn), 500 + 1000 * std::sin(turn), i % 2 ? 0.2 : 0.0 });
  }
  for (vtkIdType i = 1; i <= needles; ++i)
  {
    fan.AddTriangle(hub, hub + i, hub + i + 1);
  }
  const auto scene = fan.Finish();
  return { "slivers", scene, AimAtTriangles(scene, 0, needles, 100.0) };
}

/// Leaves of 0.1 to 100 mm, 1 m above 20 km of hills.
Setting MakeMixedScale()
{
  helios::BenchScene mixed;
  mixed.AddHills(400, 20000.0);
  const vtkIdType terrain = 2 * 400 * 400;
  constexpr int leaves = 20000;
  for (std::uint64_t i = 0; i < leaves; ++i)
  {
    const auto a = helios::Uniform4(4, helios::RandomStream::Scene, i, 0);
    const double x = 20000 * a[0], y = 20000 * a[1];
    const double size = 0.5 * std::pow(10.0, -1.0 - 3.0 * a[2]);
    mixed.AddQuad(
      { x, y, helios::GetHillHeight(x, y) + 1 }, { size, 0, 0 }, { 0, size, 0.2 * size });
  }
  const auto scene = mixed.Finish();
  return { "mixed scale", scene, AimAtTriangles(scene, terrain, 2 * leaves, 50.0) };
}

/// Rays aimed exactly at the vertices and edge midpoints of hills: misses are leaks.
Setting MakeEdges()
{
  helios::BenchScene hills;
  hills.AddHills(100, 100.0);
  const auto scene = hills.Finish();
  const Vec3 from = helios::BenchOffset + Vec3(51.234, 48.171, 500);
  Rays rays;
  const auto aim = [&rays, &from](const Vec3& at)
  {
    const Vec3 d = (at - from).Normalized();
    rays.push_back({ { from[0], from[1], from[2] }, { d[0], d[1], d[2] } });
  };
  const auto point = [&scene](vtkIdType i) { return Vec3(scene->GetPoint(i)); };
  for (vtkIdType j = 1; j < 100; ++j)
  {
    for (vtkIdType i = 1; i < 100; ++i)
    {
      const vtkIdType a = j * 101 + i;
      aim(point(a));
      aim(0.5 * (point(a) + point(a + 1)));
      aim(0.5 * (point(a) + point(a + 101)));
    }
  }
  return { "edges", scene, rays };
}

std::vector<Setting> MakeSettings(bool isQuick)
{
  const int pulses = isQuick ? 500 : 5000;
  std::vector<Setting> settings = { { "canopy", helios::MakeBenchCanopy(),
                                      helios::MakeTripodRays(200.0, pulses, 3) },
    { "terrain", helios::MakeBenchTerrain(), helios::MakeTripodRays(1000.0, pulses, 3) },
    MakeSlivers(), MakeMixedScale(), MakeEdges() };
  for (Setting& setting : settings)
  {
    Move(setting, Vec3(0, 0, 0) - helios::BenchOffset);
  }
  // Rays aimed at triangles use the scene's original position: all move alike.
  return settings;
}

/// The range from a ray to the plane of a triangle, in extended precision.
long double GetTrueRange(const helios::TriangleMesh& mesh, const vtkHeliosRay& ray, vtkIdType cell)
{
  long double e[2][3], o[3];
  for (int axis = 0; axis < 3; ++axis)
  {
    const long double a = mesh.GetCorner(cell, 0)[axis];
    e[0][axis] = mesh.GetCorner(cell, 1)[axis] - a;
    e[1][axis] = mesh.GetCorner(cell, 2)[axis] - a;
    o[axis] = a - ray.Origin[axis];
  }
  long double above = 0, below = 0;
  for (int x = 0; x < 3; ++x)
  {
    const int y = (x + 1) % 3, z = (x + 2) % 3;
    const long double n = e[0][y] * e[1][z] - e[0][z] * e[1][y];
    above += n * o[x];
    below += n * ray.Direction[x];
  }
  return above / below;
}

Result Measure(const Contender& contender, const helios::TriangleMesh& mesh, const Rays& rays,
  const Hits& truth, int repeats)
{
  Hits hits(rays.size());
  Result result;
  std::vector<double> rates;
  result.Cast = rays.size() / contender.Share;
  for (int repeat = 0; repeat < repeats; ++repeat)
  {
    const double start = GetThreadTime();
    contender.Cast(rays, hits, 0, result.Cast);
    rates.push_back(1e-6 * static_cast<double>(result.Cast) / (GetThreadTime() - start));
  }
  result.Rate = GetMedian(rates);
  for (std::size_t i = 0; i < result.Cast; ++i)
  {
    const bool isSurface = truth[i].CellId >= 0;
    const bool isHit = hits[i].CellId >= 0;
    result.Missed += isSurface && !isHit;
    result.Invented += !isSurface && isHit;
    if (isSurface && isHit)
    {
      const long double range = GetTrueRange(mesh, rays[i], truth[i].CellId);
      const double error = std::abs(static_cast<double>(hits[i].Range - range));
      result.Other += error > 1e-3;
      result.WorstError = error > 1e-3 ? result.WorstError : std::max(result.WorstError, error);
    }
  }
  return result;
}

class Table
{
public:
  explicit Table(const std::string& path)
    : File(path.empty() ? nullptr : std::fopen(path.c_str(), "w"))
  {
    this->Print("scene,coordinates,caster,kind,mray_per_s,rays,missed,invented,other_surface,"
                "worst_range_error_m,bytes_per_triangle\n");
  }
  ~Table()
  {
    if (this->File)
    {
      std::fclose(this->File);
    }
  }
  Table(const Table&) = delete;
  void operator=(const Table&) = delete;

  void Add(const char* scene, const char* place, const char* caster, bool isOurs, const Result& r,
    double bytes)
  {
    std::printf("%-12s %-11s %-26s %9.4f Mray/s %7zu rays %5zu missed %4zu invented %5zu other "
                "%8.1e m %5.0f B\n",
      scene, place, caster, r.Rate, r.Cast, r.Missed, r.Invented, r.Other, r.WorstError, bytes);
    std::fflush(stdout);
    char line[512];
    std::snprintf(line, sizeof line, "%s,%s,%s,%s,%.5g,%zu,%zu,%zu,%zu,%.3g,%.4g\n", scene, place,
      caster, isOurs ? "ours" : "bare", r.Rate, r.Cast, r.Missed, r.Invented, r.Other, r.WorstError,
      bytes);
    this->Print(line);
  }

private:
  void Print(const char* line) const
  {
    if (this->File)
    {
      std::fputs(line, this->File);
    }
  }
  std::FILE* File;
};

/// Runs our casters on a scene at a position; false if one that must be exact is not.
bool RunPlace(const Setting& setting, const Place& place, int repeats, Table& table)
{
  vtkNew<vtkHeliosBvhRayCaster> bvh;
  vtkNew<vtkHeliosEmbreeRayCaster> embree;
  vtkNew<vtkHeliosCgalRayCaster> cgal;
  vtkNew<vtkHeliosObbTreeRayCaster> obbTree;
  const Rays& rays = setting.Probes;
  Hits truth(rays.size());
  bvh->Build(setting.Scene);
  bvh->Intersect(rays.data(), truth.data(), static_cast<vtkIdType>(rays.size()));
  const helios::TriangleMesh& mesh = bvh->GetGeometry().GetMesh();
  const double triangles = static_cast<double>(mesh.GetNumberOfTriangles());
  bool isRight = true;
  const auto runOurs = [&](vtkHeliosRayCaster* caster, std::size_t share, bool isExact)
  {
    caster->Build(setting.Scene);
    const auto cast = [caster](const Rays& r, Hits& h, std::size_t first, std::size_t last)
    { caster->Intersect(&r[first], &h[first], static_cast<vtkIdType>(last - first)); };
    const Result r = Measure({ caster->GetName(), cast, share }, mesh, rays, truth, repeats);
    isRight &= !isExact || r.Missed + r.Invented + r.Other == 0;
    table.Add(setting.Name, place.Name, caster->GetName(), true, r,
      static_cast<double>(caster->GetAcceleratorSize()) / triangles);
  };
  const auto runBare = [&](const char* name, const auto& caster, std::size_t share, double bytes)
  {
    const auto cast = [&caster](const Rays& r, Hits& h, std::size_t first, std::size_t last)
    { caster.Cast(r, h, first, last); };
    const Result r = Measure({ name, cast, share }, mesh, rays, truth, repeats);
    table.Add(setting.Name, place.Name, name, false, r, bytes / triangles);
  };
  runOurs(embree, 1, true);
  runOurs(bvh, 1, true);
  runOurs(cgal, 2, true);
  runOurs(obbTree, 50, false);
  {
    const BareEmbree world(mesh, false, false), local(mesh, true, false), refined(mesh, true, true);
    const double bytes = static_cast<double>(local.Bytes);
    runBare("Embree float uncentred", world, 1, bytes);
    runBare("Embree float centred", local, 1, bytes);
    runBare("Embree centred refined", refined, 1, bytes);
  }
  runBare("CGAL Simple_cartesian", BareCgal(mesh), 4, 68 * triangles);
  runBare("vtkOBBTree tol 0", BareObbTree(setting.Scene, true, 0.0), 50, 0.0);
  runBare("vtkOBBTree tol 1e-6", BareObbTree(setting.Scene, true, 1e-6), 50, 0.0);
  runBare("vtkOBBTree uncentred", BareObbTree(setting.Scene, false, 1e-6), 50, 0.0);
  return isRight;
}

/// Command line options.
struct Options
{
  bool IsQuick = false;
  std::string Scene; // empty: all
  std::string Path;

  /// Returns false if not valid.
  bool Read(int argc, char** argv)
  {
    for (int i = 1; i < argc; ++i)
    {
      const std::string word = argv[i];
      const bool isScene = word == "--scene" && i + 1 < argc;
      const bool isPath = !word.empty() && word[0] != '-' && this->Path.empty();
      if (!isPath && !isScene && word != "--quick")
      {
        return false;
      }
      this->IsQuick |= word == "--quick";
      this->Scene = isScene ? argv[++i] : this->Scene;
      this->Path = isPath ? word : this->Path;
    }
    return true;
  }
};

bool Run(const Options& options)
{
  bool isRight = true;
  Table table(options.Path);
  for (const Place& place : Places)
  {
    for (Setting& setting : MakeSettings(options.IsQuick))
    {
      if (options.Scene.empty() || options.Scene == setting.Name)
      {
        Move(setting, place.Offset);
        isRight &= RunPlace(setting, place, options.IsQuick ? 1 : 3, table);
      }
    }
  }
  return isRight;
}

} // namespace

int main(int argc, char** argv)
{
  Options options;
  if (!options.Read(argc, argv))
  {
    std::fprintf(stderr, "usage: BenchRayCasterTrade [--quick] [--scene NAME] [table.csv]\n");
    return EXIT_FAILURE;
  }
  const bool isRight = Run(options);
  if (!isRight && !options.Path.empty())
  {
    std::remove(options.Path.c_str());
  }
  std::printf("%s\n", isRight ? "embree, bvh and cgal are exact." : "OUR ANSWERS ARE WRONG.");
  return isRight ? EXIT_SUCCESS : EXIT_FAILURE;
}
