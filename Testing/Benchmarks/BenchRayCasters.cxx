// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// The ray casters against bare loops of Embree's own triangles and of CGAL's AABB tree, on the same
// rays: a tripod (TLS) and an aircraft (ALS), single rays and bundles of 19 within 0.3 mrad, over a
// canopy of 984 k and a terrain of 2 M triangles in UTM coordinates. Answers are checked before
// times are printed; repeats of all casters take turns, rates are medians by thread CPU time.
//
// CGAL's AABB tree is under the GPL, and so is this program once built: it is for measuring, and is
// not installed.
//
// Usage: BenchRayCasters [repeats [pulses]]

#include "heliosBenchScenes.h"
#include "heliosTriangleMesh.h"
#include "vtkHeliosBvhRayCaster.h"
#include "vtkHeliosEmbreeRayCaster.h"

#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/Simple_cartesian.h>

#include <embree3/rtcore.h>

#include <algorithm>
#include <atomic>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <limits>
#include <thread>
#include <time.h>
#include <xmmintrin.h>

namespace
{

using Rays = std::vector<vtkHeliosRay>;
using Hits = std::vector<vtkHeliosHit>;

constexpr double Inf = std::numeric_limits<double>::infinity();

double GetThreadTime()
{
  timespec t;
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
  return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}

double GetMedian(std::vector<double> values)
{
  std::sort(values.begin(), values.end());
  return values[values.size() / 2];
}

/// Something that casts rays [first, last) of a set.
struct Contender
{
  const char* Name;
  std::function<void(const Rays&, Hits&, std::size_t, std::size_t)> Cast;
  std::size_t Share = 1; // of the rays it casts in a race: one in so many
};

/// The range in double at which a ray meets the plane of a triangle.
double Refine(const helios::TriangleMesh& mesh, const vtkHeliosRay& ray, vtkIdType triangle)
{
  const helios::Vec3 a(mesh.GetCorner(triangle, 0));
  const helios::Vec3 b(mesh.GetCorner(triangle, 1));
  const helios::Vec3 c(mesh.GetCorner(triangle, 2));
  const helios::Vec3 n = (b - a).Cross(c - a);
  return n.Dot(a - helios::Vec3(ray.Origin)) / n.Dot(helios::Vec3(ray.Direction));
}

/// Embree's robust float triangles, centred; the range from the double triangle it finds.
class BareEmbree
{
public:
  explicit BareEmbree(const helios::TriangleMesh& mesh)
    : Mesh(mesh)
  {
    double bounds[6];
    mesh.GetBounds(bounds);
    this->Device = rtcNewDevice(nullptr);
    rtcSetDeviceMemoryMonitorFunction(this->Device, CountMemory, &this->Bytes);
    this->Scene = rtcNewScene(this->Device);
    rtcSetSceneFlags(this->Scene, RTC_SCENE_FLAG_ROBUST);
    RTCGeometry geometry = rtcNewGeometry(this->Device, RTC_GEOMETRY_TYPE_TRIANGLE);
    auto* points = static_cast<float*>(rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0,
      RTC_FORMAT_FLOAT3, 3 * sizeof(float), static_cast<std::size_t>(mesh.GetNumberOfPoints())));
    for (int axis = 0; axis < 3; ++axis)
    {
      this->Centre[axis] = 0.5 * (bounds[2 * axis] + bounds[2 * axis + 1]);
      for (vtkIdType i = 0; i < mesh.GetNumberOfPoints(); ++i)
      {
        points[3 * i + axis] =
          static_cast<float>(mesh.GetPoints()[3 * i + axis] - this->Centre[axis]);
      }
    }
    auto* corners = static_cast<unsigned int*>(
      rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
        3 * sizeof(unsigned int), static_cast<std::size_t>(mesh.GetNumberOfTriangles())));
    std::copy_n(mesh.GetCorners(), 3 * mesh.GetNumberOfTriangles(), corners);
    rtcCommitGeometry(geometry);
    rtcAttachGeometry(this->Scene, geometry);
    rtcReleaseGeometry(geometry);
    rtcCommitScene(this->Scene);
  }
  ~BareEmbree()
  {
    rtcReleaseScene(this->Scene);
    rtcReleaseDevice(this->Device);
  }

  void Cast(const Rays& rays, Hits& hits, std::size_t first, std::size_t last) const
  {
    const unsigned int saved = _mm_getcsr();
    _mm_setcsr(saved | 0x8040);
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    for (std::size_t i = first; i < last; ++i)
    {
      const vtkHeliosRay& ray = rays[i];
      RTCRayHit rayHit;
      rayHit.ray.org_x = static_cast<float>(ray.Origin[0] - this->Centre[0]);
      rayHit.ray.org_y = static_cast<float>(ray.Origin[1] - this->Centre[1]);
      rayHit.ray.org_z = static_cast<float>(ray.Origin[2] - this->Centre[2]);
      rayHit.ray.dir_x = static_cast<float>(ray.Direction[0]);
      rayHit.ray.dir_y = static_cast<float>(ray.Direction[1]);
      rayHit.ray.dir_z = static_cast<float>(ray.Direction[2]);
      rayHit.ray.tnear = 0.0f;
      rayHit.ray.tfar = std::numeric_limits<float>::infinity();
      rayHit.ray.time = 0.0f;
      rayHit.ray.mask = -1;
      rayHit.ray.flags = 0;
      rayHit.hit.geomID = RTC_INVALID_GEOMETRY_ID;
      rtcIntersect1(this->Scene, &context, &rayHit);
      hits[i] = rayHit.hit.geomID == RTC_INVALID_GEOMETRY_ID
        ? vtkHeliosHit{ Inf, -1 }
        : vtkHeliosHit{ Refine(this->Mesh, ray, rayHit.hit.primID), rayHit.hit.primID };
    }
    _mm_setcsr(saved);
  }

  std::atomic<long> Bytes{ 0 };

private:
  static bool CountMemory(void* bytes, ssize_t size, bool)
  {
    *static_cast<std::atomic<long>*>(bytes) += size;
    return true;
  }

  const helios::TriangleMesh& Mesh;
  double Centre[3];
  RTCDevice Device;
  RTCScene Scene;
};

using Kernel = CGAL::Simple_cartesian<double>;

/// A triangle of the mesh by its index, 4 bytes.
struct IndexPrimitive
{
  using Id = vtkTypeInt32;
  using Point = Kernel::Point_3;
  using Datum = Kernel::Triangle_3;
  using Shared_data = const helios::TriangleMesh*;
  using Point_reference = Point;
  using Datum_reference = Datum;

  IndexPrimitive() = default;
  IndexPrimitive(Id triangle, Shared_data)
    : Triangle(triangle)
  {
  }
  template <typename IteratorT>
  IndexPrimitive(IteratorT i, Shared_data)
    : Triangle(*i)
  {
  }
  static Shared_data construct_shared_data(Shared_data mesh) { return mesh; }
  static Point GetPoint(Shared_data mesh, Id triangle, int corner)
  {
    const double* p = mesh->GetCorner(triangle, corner);
    return { p[0], p[1], p[2] };
  }
  Id id() const { return this->Triangle; }
  Datum datum(Shared_data mesh) const
  {
    return { GetPoint(mesh, this->Triangle, 0), GetPoint(mesh, this->Triangle, 1),
      GetPoint(mesh, this->Triangle, 2) };
  }
  Point reference_point(Shared_data mesh) const { return GetPoint(mesh, this->Triangle, 0); }

  Id Triangle;
};

class BareCgal
{
public:
  explicit BareCgal(const helios::TriangleMesh& mesh)
    : Mesh(mesh)
  {
    std::vector<vtkTypeInt32> triangles(static_cast<std::size_t>(mesh.GetNumberOfTriangles()));
    for (std::size_t i = 0; i < triangles.size(); ++i)
    {
      triangles[i] = static_cast<vtkTypeInt32>(i);
    }
    this->Tree.insert(triangles.begin(), triangles.end(), &this->Mesh);
    this->Tree.build();
  }

  void Cast(const Rays& rays, Hits& hits, std::size_t first, std::size_t last) const
  {
    for (std::size_t i = first; i < last; ++i)
    {
      const double* o = rays[i].Origin;
      const double* d = rays[i].Direction;
      const Kernel::Ray_3 ray(
        Kernel::Point_3(o[0], o[1], o[2]), Kernel::Vector_3(d[0], d[1], d[2]));
      const auto triangle = this->Tree.first_intersected_primitive(ray);
      hits[i] = triangle ? vtkHeliosHit{ Refine(this->Mesh, rays[i], *triangle), *triangle }
                         : vtkHeliosHit{ Inf, -1 };
    }
  }

private:
  const helios::TriangleMesh& Mesh;
  CGAL::AABB_tree<CGAL::AABB_traits<Kernel, IndexPrimitive>> Tree;
};

struct Differences
{
  std::size_t Missed = 0;    // where there is a hit
  std::size_t Invented = 0;  // where there is none
  std::size_t Triangles = 0; // another triangle
  std::size_t Ranges = 0;    // another range, in any bit
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

/// Casts a contender's share of the rays; returns its rate [Mray/s].
double GetRate(const Contender& contender, const Rays& rays, Hits& hits)
{
  // In runs of whole bundles, so that neighbours stay neighbours.
  const std::size_t run = contender.Share == 1 ? rays.size() : 19 * 16;
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

/// Times contenders in turns, and prints their rates and how much faster than them the first is.
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

/// Casts every second run of rays; returns the thread's CPU time for it.
double CastEverySecond(const Contender& contender, const Rays& rays, Hits& hits, std::size_t first)
{
  const std::size_t run = 19 * 16 * 16;
  const double start = GetThreadTime();
  for (std::size_t i = first * run; i < rays.size(); i += 2 * run)
  {
    contender.Cast(rays, hits, i, std::min(rays.size(), i + run));
  }
  return GetThreadTime() - start;
}

/// How much faster two threads are than one, by the CPU time of the longer of the two.
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

/// Checks the answers on a set of rays and races on it; returns whether ours are right.
bool RunSet(
  const char* set, const std::vector<Contender>& contenders, const Rays& rays, int repeats)
{
  Hits truth(rays.size());
  Hits hits(rays.size());
  contenders[2].Cast(rays, truth, 0, rays.size());
  const auto hitCount = std::count_if(
    truth.begin(), truth.end(), [](const vtkHeliosHit& hit) { return hit.CellId >= 0; });
  contenders[0].Cast(rays, hits, 0, rays.size());
  const Differences ours = Compare(truth, hits);
  contenders[1].Cast(rays, hits, 0, rays.size());
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

/// The bytes a triangle of a scene and of each accelerator.
void PrintSizes(const char* name, const helios::TriangleMesh& mesh, std::size_t embree,
  std::size_t bvh, std::size_t bare)
{
  const double triangles = static_cast<double>(mesh.GetNumberOfTriangles());
  const double points = static_cast<double>(mesh.GetNumberOfPoints());
  std::printf(
    "%s: %.0f triangles; bytes a triangle: scene %.0f, ours on Embree %.0f, our bvh %.0f, "
    "bare Embree %.0f\n",
    name, triangles, 12 + 24 * points / triangles, static_cast<double>(embree) / triangles,
    static_cast<double>(bvh) / triangles, static_cast<double>(bare) / triangles);
}

bool Run(const char* name, vtkPolyData* scene, double width, double height, int repeats, int pulses)
{
  vtkNew<vtkHeliosEmbreeRayCaster> embree;
  vtkNew<vtkHeliosBvhRayCaster> bvh;
  if (!embree->Build(scene) || !bvh->Build(scene))
  {
    return false;
  }
  const helios::TriangleMesh& mesh = bvh->GetMesh();
  const BareEmbree bareEmbree(mesh);
  const BareCgal bareCgal(mesh);
  PrintSizes(name, mesh, embree->GetAcceleratorSize(), bvh->GetAcceleratorSize(),
    static_cast<std::size_t>(bareEmbree.Bytes));

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
  const std::vector<Contender> contenders = { { "ours", cast(embree) },
    { "bare Embree", castBare(bareEmbree) }, { "bvh", cast(bvh), 4 },
    { "bare CGAL", castBare(bareCgal), 16 } };
  const int singles = 4 * pulses;
  bool isRight = RunSet("TLS", contenders, helios::MakeTripodRays(width, singles, 1), repeats);
  isRight &=
    RunSet("ALS", contenders, helios::MakeAirborneRays(width, height, singles, 1), repeats);
  isRight &= RunSet("TLSx19", contenders, helios::MakeTripodRays(width, pulses, 3), repeats);
  isRight &=
    RunSet("ALSx19", contenders, helios::MakeAirborneRays(width, height, pulses, 3), repeats);
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
  std::printf("Mray/s of one thread, medians of %d repeats; (x...): how much faster ours is.\n"
              "Goals: bundles x1.4 bare Embree and x6 bare CGAL, single rays x0.9 bare Embree, "
              "2 threads x1.9.\n",
    repeats);
  bool isRight = Run("canopy", helios::MakeBenchCanopy(), 200.0, 600.0, repeats, pulses);
  isRight &= Run("terrain", helios::MakeBenchTerrain(), 1000.0, 800.0, repeats, pulses);
  std::printf("%s\n",
    isRight ? "Ours equals the double-precision tree bit for bit." : "OUR ANSWERS ARE WRONG.");
  return isRight ? EXIT_SUCCESS : EXIT_FAILURE;
}
