// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Reference casters for comparison: bare loops over Embree, CGAL's AABB tree and vtkOBBTree.
//
// CGAL's AABB tree is under the GPL, and so is a program with this header: it is for measuring, and
// is not installed.

#ifndef heliosBareCasters_h
#define heliosBareCasters_h

#include "heliosEmbree.h"
#include "heliosPose.h"
#include "heliosTriangleMesh.h"
#include "vtkHeliosRayCaster.h"

#include <CGAL/AABB_traits_3.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/Simple_cartesian.h>

#include <vtkGenericCell.h>
#include <vtkNew.h>
#include <vtkOBBTree.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>

#include <algorithm>
#include <atomic>
#include <functional>
#include <limits>
#include <time.h>
#include <vector>
#include <xmmintrin.h>

namespace helios
{
namespace bench
{

using Rays = std::vector<vtkHeliosRay>;
using Hits = std::vector<vtkHeliosHit>;

constexpr double Inf = std::numeric_limits<double>::infinity();

inline double GetThreadTime()
{
  timespec t;
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
  return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}

inline double GetMedian(std::vector<double> values)
{
  std::sort(values.begin(), values.end());
  return values[values.size() / 2];
}

/// Casts rays [first, last) of a set.
struct Contender
{
  const char* Name;
  std::function<void(const Rays&, Hits&, std::size_t, std::size_t)> Cast;
  std::size_t Share = 1; // share of its rays in a race: one in this many
};

/// The range in double from a ray to the plane of a triangle.
inline double Refine(const TriangleMesh& mesh, const vtkHeliosRay& ray, vtkIdType triangle)
{
  const Vec3 a(mesh.GetCorner(triangle, 0));
  const Vec3 b(mesh.GetCorner(triangle, 1));
  const Vec3 c(mesh.GetCorner(triangle, 2));
  const Vec3 n = (b - a).Cross(c - a);
  return n.Dot(a - Vec3(ray.Origin)) / n.Dot(Vec3(ray.Direction));
}

/// Embree's robust float triangles; optionally centred, and with the range of the double triangle.
class BareEmbree
{
public:
  explicit BareEmbree(const TriangleMesh& mesh, bool isCentred = true, bool isRefined = true)
    : Mesh(mesh)
    , IsRefined(isRefined)
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
      this->Centre[axis] = isCentred ? 0.5 * (bounds[2 * axis] + bounds[2 * axis + 1]) : 0.0;
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
    EmbreeContext context;
    InitContext(context);
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
      TraceRay(rtcIntersect1, this->Scene, context, rayHit);
      hits[i] = rayHit.hit.geomID == RTC_INVALID_GEOMETRY_ID
        ? vtkHeliosHit{ Inf, -1 }
        : vtkHeliosHit{ this->IsRefined ? Refine(this->Mesh, ray, rayHit.hit.primID)
                                        : rayHit.ray.tfar,
            rayHit.hit.primID };
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

  const TriangleMesh& Mesh;
  bool IsRefined;
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
  using Shared_data = const TriangleMesh*;
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
  explicit BareCgal(const TriangleMesh& mesh)
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
  const TriangleMesh& Mesh;
  CGAL::AABB_tree<CGAL::AABB_traits_3<Kernel, IndexPrimitive>> Tree;
};

/// vtkOBBTree queried with segments clipped to the scene's box, in scene coordinates or centred;
/// the range is from the point found.
class BareObbTree
{
public:
  BareObbTree(vtkPolyData* scene, bool isCentred, double tolerance)
    : Tolerance(tolerance)
  {
    vtkNew<vtkPoints> points;
    points->SetDataTypeToDouble();
    points->SetNumberOfPoints(scene->GetNumberOfPoints());
    if (isCentred)
    {
      scene->GetCenter(this->Centre);
    }
    for (vtkIdType i = 0; i < scene->GetNumberOfPoints(); ++i)
    {
      const Vec3 p = Vec3(scene->GetPoint(i)) - Vec3(this->Centre);
      points->SetPoint(i, p.GetData());
    }
    this->Local->SetPoints(points);
    this->Local->SetPolys(scene->GetPolys());
    this->Local->BuildCells();
    this->Local->GetBounds(this->Bounds);
    this->Tree->SetDataSet(this->Local);
    this->Tree->BuildLocator();
  }

  void Cast(const Rays& rays, Hits& hits, std::size_t first, std::size_t last) const
  {
    for (std::size_t i = first; i < last; ++i)
    {
      hits[i] = this->CastOne(rays[i]);
    }
  }

private:
  vtkHeliosHit CastOne(const vtkHeliosRay& ray) const
  {
    const Vec3 origin = Vec3(ray.Origin) - Vec3(this->Centre);
    const Vec3 direction(ray.Direction);
    double entry = 0.0, exit = Inf;
    for (int axis = 0; axis < 3; ++axis)
    {
      const double t0 = (this->Bounds[2 * axis] - 1e-3 - origin[axis]) / direction[axis];
      const double t1 = (this->Bounds[2 * axis + 1] + 1e-3 - origin[axis]) / direction[axis];
      entry = std::max(entry, std::min(t0, t1));
      exit = std::min(exit, std::max(t0, t1));
    }
    double s, x[3], parameters[3];
    int subId = 0;
    vtkIdType triangle = -1;
    Vec3 from = origin + entry * direction;
    Vec3 to = origin + exit * direction;
    auto* tree = const_cast<vtkOBBTree*>(this->Tree.Get());
    const bool isHit = entry < exit &&
      tree->IntersectWithLine(from.GetData(), to.GetData(), this->Tolerance, s, x, parameters,
        subId, triangle, this->Cell);
    return isHit ? vtkHeliosHit{ (Vec3(x) - origin).Norm(), triangle } : vtkHeliosHit{ Inf, -1 };
  }

  double Tolerance;
  double Centre[3] = { 0.0, 0.0, 0.0 };
  double Bounds[6];
  vtkNew<vtkPolyData> Local;
  vtkNew<vtkOBBTree> Tree;
  vtkNew<vtkGenericCell> Cell;
};

} // namespace bench
} // namespace helios

#endif
