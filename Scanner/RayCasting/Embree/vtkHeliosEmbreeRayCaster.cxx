// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHeliosEmbreeRayCaster.h"

#include "heliosBvh.h"
#include "heliosEmbreePacket.h"
#include "heliosTriangleMesh.h"

#include <vtkObjectFactory.h>
#include <vtkSMPTools.h>

#include <embree3/rtcore.h>

#include <algorithm>
#include <atomic>
#include <limits>
#include <mutex>
#include <string>
#include <vector>

#if defined(__SSE2__)
#include <xmmintrin.h>
#endif

namespace
{

/// Embree is slow on subnormal floats: they are zero while it traverses, in this thread.
class FlushSubnormals
{
public:
#if defined(__SSE2__)
  FlushSubnormals()
    : Saved(_mm_getcsr())
  {
    _mm_setcsr(this->Saved | 0x8040); // flush to zero, denormals are zero
  }
  ~FlushSubnormals()
  {
    _mm_setcsr(this->Saved);
  }
#else
  FlushSubnormals() {}
#endif
  FlushSubnormals(const FlushSubnormals&) = delete;
  void operator=(const FlushSubnormals&) = delete;

private:
  unsigned int Saved = 0;
};

/// A packet as Embree traces it.
struct alignas(64) Trace
{
  RTCIntersectContext Context; // first: the callbacks are given its address
  int Lane = 0;                // of a ray that is traced alone
  alignas(64) int Valid[helios::Lanes];
  helios::Packet Rays;
  union
  {
    helios::FloatRays Floats;
    RTCRayHit8 RayHits;
  };

  bool Test(int lane, const double* const points[3], vtkTypeInt32 triangle, float& far)
  {
    return this->Rays.GetHalf(lane).TestLane(lane % helios::Half, points, triangle, far);
  }
  vtkHeliosHit GetHit(int lane) { return this->Rays.GetHalf(lane).GetHit(lane % helios::Half); }

  /// The one valid ray, for Embree's functions that take one.
  RTCRayHit GetAlone()
  {
    this->Lane =
      static_cast<int>(std::find(this->Valid, this->Valid + helios::Lanes, -1) - this->Valid);
    const int i = this->Lane;
    const helios::FloatRays& f = this->Floats;
    RTCRayHit alone;
    alone.ray = { f.Origin[0][i],
      f.Origin[1][i],
      f.Origin[2][i],
      f.Near[i],
      f.Direction[0][i],
      f.Direction[1][i],
      f.Direction[2][i],
      f.Time[i],
      f.Far[i],
      f.Mask[i],
      f.Id[i],
      f.Flags[i] };
    alone.hit.geomID = RTC_INVALID_GEOMETRY_ID;
    return alone;
  }
};

static_assert(sizeof(helios::FloatRays) == sizeof(RTCRay8), "the float rays are a RTCRay8");

/**
 * The box that holds all but a few corners in a thousand, with four times its size around it. What
 * reaches out of it (a stray corner at 1e30) would take away the floats' resolution from the rest.
 */
void GetCoreBounds(const helios::TriangleMesh& mesh, double bounds[6])
{
  const vtkIdType count = 3 * mesh.GetNumberOfTriangles();
  const vtkIdType stride = 3 * (count / (3 << 16)) + 1; // takes first, second and third corners
  std::vector<double> values;
  double width = 0.0;
  for (int axis = 0; axis < 3; ++axis)
  {
    values.clear();
    for (vtkIdType i = 0; i < count; i += stride)
    {
      values.push_back(mesh.GetPoints()[3 * static_cast<vtkIdType>(mesh.GetCorners()[i]) + axis]);
    }
    std::sort(values.begin(), values.end());
    bounds[2 * axis] = values[values.size() / 1024];
    bounds[2 * axis + 1] = values[values.size() - 1 - values.size() / 1024];
    width = std::max(width, bounds[2 * axis + 1] - bounds[2 * axis]);
  }
  for (int axis = 0; axis < 3; ++axis)
  {
    bounds[2 * axis] -= 4 * width;
    bounds[2 * axis + 1] += 4 * width;
  }
}

} // namespace

class vtkHeliosEmbreeRayCaster::Internals
{
public:
  Internals() = default;
  ~Internals() { this->Clear(); }
  Internals(const Internals&) = delete;
  void operator=(const Internals&) = delete;

  /// Makes Embree's tree; returns an empty text, or what went wrong.
  std::string Build(const helios::TriangleMesh& mesh);
  void Clear();

  std::size_t GetMemorySize() const
  {
    return static_cast<std::size_t>(this->Bytes.load()) + this->IsJoined.capacity() / 8 +
      this->Outliers.GetMemorySize();
  }

  /// The first hits of up to eight rays.
  void Intersect(Trace& trace, const vtkHeliosRay* rays, int count, vtkHeliosHit* hits) const;
  void Occluded(Trace& trace, const vtkHeliosRay* rays, int count, unsigned char* occluded) const;

private:
  void GetPoints(vtkTypeInt32 triangle, const double* points[3]) const
  {
    for (int corner = 0; corner < 3; ++corner)
    {
      points[corner] = this->Mesh->GetCorner(triangle, corner);
    }
  }
  void SortTriangles();
  bool HaveCommonEdge(vtkTypeInt32 a, vtkTypeInt32 b) const;
  std::string Commit();

  /// Calls test(points, triangle) for the triangles of a box of Embree's.
  template <typename TestT>
  void ForEach(unsigned int first, TestT test) const
  {
    vtkTypeInt32 triangle = static_cast<vtkTypeInt32>(first);
    do
    {
      const double* points[3];
      this->GetPoints(triangle, points);
      test(points, triangle);
    } while (this->IsJoined[++triangle]);
  }

  static void OnBounds(const RTCBoundsFunctionArguments* args);
  static void OnIntersect(const RTCIntersectFunctionNArguments* args);
  static void OnOccluded(const RTCOccludedFunctionNArguments* args);
  static void OnError(void* self, RTCError code, const char* text);
  static bool OnMemory(void* self, ssize_t bytes, bool post);

  const helios::TriangleMesh* Mesh = nullptr;
  helios::LocalFrame Frame;
  std::vector<bool> IsLeftOut; ///< while it is built
  std::vector<bool> IsJoined;  ///< shares the box of the triangle before: a quad, mostly
  helios::Bvh Outliers;        ///< the triangles that reach far out, if there are any
  bool HasOutliers = false;
  RTCDevice Device = nullptr;
  RTCScene Scene = nullptr;
  std::atomic<std::ptrdiff_t> Bytes{ 0 };
  std::mutex Mutex;
  std::string Problem;
};

void vtkHeliosEmbreeRayCaster::Internals::Clear()
{
  if (this->Scene)
  {
    rtcReleaseScene(this->Scene);
  }
  if (this->Device)
  {
    rtcReleaseDevice(this->Device);
  }
  this->Scene = nullptr;
  this->Device = nullptr;
  this->Bytes = 0;
  this->Frame = helios::LocalFrame();
  this->HasOutliers = false;
  this->Outliers = helios::Bvh();
  this->IsJoined = std::vector<bool>();
}

void vtkHeliosEmbreeRayCaster::Internals::OnError(void* self, RTCError, const char* text)
{
  auto* internals = static_cast<Internals*>(self);
  const std::lock_guard<std::mutex> lock(internals->Mutex);
  internals->Problem = std::string("Embree: ") + (text ? text : "unknown error");
}

bool vtkHeliosEmbreeRayCaster::Internals::OnMemory(void* self, ssize_t bytes, bool)
{
  static_cast<Internals*>(self)->Bytes += bytes;
  return true;
}

void vtkHeliosEmbreeRayCaster::Internals::OnBounds(const RTCBoundsFunctionArguments* args)
{
  const auto* self = static_cast<const Internals*>(args->geometryUserPtr);
  float low[3] = { 1, 1, 1 }; // an empty box, which Embree leaves out
  float high[3] = { -1, -1, -1 };
  if (!self->IsLeftOut[args->primID] && !self->IsJoined[args->primID])
  {
    std::fill_n(low, 3, std::numeric_limits<float>::max());
    std::fill_n(high, 3, -std::numeric_limits<float>::max());
    self->ForEach(args->primID,
      [self, &low, &high](const double* const points[3], vtkTypeInt32)
      { self->Frame.AddBox(points, low, high); });
  }
  *args->bounds_o = { low[0], low[1], low[2], 0, high[0], high[1], high[2], 0 };
}

void vtkHeliosEmbreeRayCaster::Internals::OnIntersect(const RTCIntersectFunctionNArguments* args)
{
  const auto* self = static_cast<const Internals*>(args->geometryUserPtr);
  auto& trace = *reinterpret_cast<Trace*>(args->context);
  float* far = &RTCRayN_tfar(RTCRayHitN_RayN(args->rayhit, args->N), args->N, 0);
  self->ForEach(args->primID,
    [args, &trace, far](const double* const points[3], vtkTypeInt32 triangle)
    {
      if (args->N == 1)
      {
        trace.Test(trace.Lane, points, triangle, *far);
      }
      else
      {
        trace.Rays.TestLanes(args->valid, points, triangle, far);
      }
    });
}

void vtkHeliosEmbreeRayCaster::Internals::OnOccluded(const RTCOccludedFunctionNArguments* args)
{
  const auto* self = static_cast<const Internals*>(args->geometryUserPtr);
  auto& trace = *reinterpret_cast<Trace*>(args->context);
  float* far = &RTCRayN_tfar(args->ray, args->N, 0);
  self->ForEach(args->primID,
    [args, &trace, far](const double* const points[3], vtkTypeInt32 triangle)
    {
      for (unsigned int i = 0; i < args->N; ++i)
      {
        const int lane = trace.Lane + static_cast<int>(i);
        if (args->valid[i] && trace.Test(lane, points, triangle, far[i]))
        {
          far[i] = -std::numeric_limits<float>::infinity(); // Embree's word for occluded
        }
      }
    });
}

bool vtkHeliosEmbreeRayCaster::Internals::HaveCommonEdge(vtkTypeInt32 a, vtkTypeInt32 b) const
{
  const vtkTypeInt32* p = this->Mesh->GetCorners() + 3 * static_cast<vtkIdType>(a);
  const vtkTypeInt32* q = this->Mesh->GetCorners() + 3 * static_cast<vtkIdType>(b);
  int common = 0;
  for (int i = 0; i < 3; ++i)
  {
    common += p[i] == q[0] || p[i] == q[1] || p[i] == q[2];
  }
  return common == 2;
}

/// Decides which triangles go to Embree, which of them in pairs, and which are outliers.
void vtkHeliosEmbreeRayCaster::Internals::SortTriangles()
{
  const auto count = static_cast<vtkTypeInt32>(this->Mesh->GetNumberOfTriangles());
  this->IsLeftOut.assign(static_cast<std::size_t>(count), false);
  this->IsJoined.assign(static_cast<std::size_t>(count) + 1, false); // one more ends the last box
  double core[6];
  GetCoreBounds(*this->Mesh, core);
  double low[3] = { core[1], core[3], core[5] };
  double high[3] = { core[0], core[2], core[4] };
  std::vector<vtkTypeInt32> outliers;
  bool mayJoin = false;
  for (vtkTypeInt32 i = 0; i < count; ++i)
  {
    const double* p[3];
    this->GetPoints(i, p);
    bool isInside = true;
    for (int axis = 0; axis < 3; ++axis)
    {
      const double least = std::min({ p[0][axis], p[1][axis], p[2][axis] });
      const double most = std::max({ p[0][axis], p[1][axis], p[2][axis] });
      isInside = isInside && least >= core[2 * axis] && most <= core[2 * axis + 1];
      low[axis] = isInside ? std::min(low[axis], least) : low[axis];
      high[axis] = isInside ? std::max(high[axis], most) : high[axis];
    }
    const bool hasArea = helios::HasArea(p[0], p[1], p[2]);
    this->IsLeftOut[i] = !hasArea || !isInside;
    if (hasArea && !isInside)
    {
      outliers.push_back(i);
    }
    this->IsJoined[i] = mayJoin && !this->IsLeftOut[i] && this->HaveCommonEdge(i - 1, i);
    mayJoin = !this->IsLeftOut[i] && !this->IsJoined[i];
  }
  this->HasOutliers = !outliers.empty();
  this->Outliers.Build(*this->Mesh, std::move(outliers));
  this->Frame.Set(low, high);
}

std::string vtkHeliosEmbreeRayCaster::Internals::Build(const helios::TriangleMesh& mesh)
{
  this->Clear();
  this->Problem.clear();
  this->Mesh = &mesh;
  if (mesh.GetNumberOfTriangles() == 0)
  {
    return {};
  }
  this->SortTriangles();
  const std::string problem = this->Commit();
  this->IsLeftOut = std::vector<bool>();
  return problem;
}

std::string vtkHeliosEmbreeRayCaster::Internals::Commit()
{
  const std::string threads = std::to_string(vtkSMPTools::GetEstimatedNumberOfThreads());
  this->Device = rtcNewDevice(("threads=" + threads).c_str());
  if (!this->Device)
  {
    return "Embree cannot make its device (error " + std::to_string(rtcGetDeviceError(nullptr)) +
      "); use vtkHeliosBvhRayCaster";
  }
  rtcSetDeviceErrorFunction(this->Device, OnError, this);
  rtcSetDeviceMemoryMonitorFunction(this->Device, OnMemory, this);
  this->Scene = rtcNewScene(this->Device);
  rtcSetSceneFlags(this->Scene, RTC_SCENE_FLAG_ROBUST);
  RTCGeometry geometry = rtcNewGeometry(this->Device, RTC_GEOMETRY_TYPE_USER);
  rtcSetGeometryUserPrimitiveCount(
    geometry, static_cast<unsigned int>(this->Mesh->GetNumberOfTriangles()));
  rtcSetGeometryUserData(geometry, this);
  rtcSetGeometryBoundsFunction(geometry, OnBounds, nullptr);
  rtcSetGeometryIntersectFunction(geometry, OnIntersect);
  rtcSetGeometryOccludedFunction(geometry, OnOccluded);
  rtcCommitGeometry(geometry);
  rtcAttachGeometry(this->Scene, geometry);
  rtcReleaseGeometry(geometry);
  rtcCommitScene(this->Scene);
  return this->Problem;
}

void vtkHeliosEmbreeRayCaster::Internals::Intersect(Trace& trace,
  const vtkHeliosRay* rays,
  int count,
  vtkHeliosHit* hits) const
{
  // The context's default is INCOHERENT. COHERENT loses hits with tiny direction components.
  rtcInitIntersectContext(&trace.Context);
  const int alive = trace.Rays.Set(this->Frame, rays, count, trace.Floats, trace.Valid);
  if (alive == 1)
  {
    RTCRayHit alone = trace.GetAlone();
    rtcIntersect1(this->Scene, &trace.Context, &alone);
  }
  else if (alive > 1)
  {
    rtcIntersect8(trace.Valid, this->Scene, &trace.Context, &trace.RayHits);
  }
  for (int lane = 0; lane < count; ++lane)
  {
    hits[lane] = trace.GetHit(lane);
    helios::TestRay ray;
    if (this->HasOutliers && ray.Set(rays[lane]))
    {
      ray.MaximumRange = std::min(ray.MaximumRange, hits[lane].Range);
      const vtkHeliosHit hit = this->Outliers.Intersect(ray);
      const bool isBetter = hit.Range < hits[lane].Range ||
        (hit.Range == hits[lane].Range && hit.CellId < hits[lane].CellId);
      hits[lane] = hit.CellId >= 0 && isBetter ? hit : hits[lane];
    }
  }
}

void vtkHeliosEmbreeRayCaster::Internals::Occluded(Trace& trace,
  const vtkHeliosRay* rays,
  int count,
  unsigned char* occluded) const
{
  rtcInitIntersectContext(&trace.Context);
  const int alive = trace.Rays.Set(this->Frame, rays, count, trace.Floats, trace.Valid);
  if (alive == 1)
  {
    RTCRayHit alone = trace.GetAlone();
    rtcOccluded1(this->Scene, &trace.Context, &alone.ray);
  }
  else if (alive > 1)
  {
    trace.Lane = 0;
    rtcOccluded8(trace.Valid, this->Scene, &trace.Context, &trace.RayHits.ray);
  }
  for (int lane = 0; lane < count; ++lane)
  {
    helios::TestRay ray;
    occluded[lane] = trace.GetHit(lane).CellId >= 0 ||
      (this->HasOutliers && ray.Set(rays[lane]) && this->Outliers.IsOccluded(ray));
  }
}

vtkStandardNewMacro(vtkHeliosEmbreeRayCaster);

vtkHeliosEmbreeRayCaster::vtkHeliosEmbreeRayCaster()
  : Device(new Internals)
{
}

vtkHeliosEmbreeRayCaster::~vtkHeliosEmbreeRayCaster() = default;

void vtkHeliosEmbreeRayCaster::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
}

bool vtkHeliosEmbreeRayCaster::BuildAccelerator(const helios::TriangleMesh& mesh)
{
  const std::string problem = this->Device->Build(mesh);
  if (!problem.empty())
  {
    this->Device->Clear();
    vtkErrorMacro(<< "Build: " << problem << ".");
  }
  return problem.empty();
}

void vtkHeliosEmbreeRayCaster::Intersect(const vtkHeliosRay* rays,
  vtkHeliosHit* hits,
  vtkIdType count) const
{
  const FlushSubnormals flush;
  Trace trace;
  for (vtkIdType first = 0; first < count; first += helios::Lanes)
  {
    const int lanes = static_cast<int>(std::min<vtkIdType>(helios::Lanes, count - first));
    this->Device->Intersect(trace, rays + first, lanes, hits + first);
  }
}

void vtkHeliosEmbreeRayCaster::Occluded(const vtkHeliosRay* rays,
  unsigned char* occluded,
  vtkIdType count) const
{
  const FlushSubnormals flush;
  Trace trace;
  for (vtkIdType first = 0; first < count; first += helios::Lanes)
  {
    const int lanes = static_cast<int>(std::min<vtkIdType>(helios::Lanes, count - first));
    this->Device->Occluded(trace, rays + first, lanes, occluded + first);
  }
}

std::size_t vtkHeliosEmbreeRayCaster::GetAcceleratorSize() const
{
  return this->Device->GetMemorySize();
}
