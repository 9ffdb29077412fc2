// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHeliosEmbreeRayCaster.h"

#include "heliosEmbreePacket.h"
#include "heliosTriangleMesh.h"

#include <vtkObjectFactory.h>
#include <vtkSMPTools.h>

#include <embree3/rtcore.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>
#include <mutex>
#include <string>
#include <xmmintrin.h>

namespace
{

using helios::Packet;

/// Embree wants subnormal floats flushed while it traverses; restored afterwards.
class FlushSubnormals
{
public:
  FlushSubnormals()
    : Saved(_mm_getcsr())
  {
    _mm_setcsr(this->Saved | 0x8040); // FTZ and DAZ
  }
  ~FlushSubnormals() { _mm_setcsr(this->Saved); }
  FlushSubnormals(const FlushSubnormals&) = delete;
  void operator=(const FlushSubnormals&) = delete;

private:
  unsigned int Saved;
};

/// A packet as Embree traces it.
struct alignas(64) Trace
{
  RTCIntersectContext Context; // first: Embree hands its address to the callbacks
  int Lane = 0;                // of the ray that is traced alone
  alignas(64) int Valid[helios::Lanes];
  Packet Rays;
  union
  {
    helios::FloatRays Floats;
    RTCRayHit8 RayHits;
  };
};

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

  std::size_t GetSize() const { return static_cast<std::size_t>(this->Bytes.load()); }

  /// Traces a packet; the best hits are then in its rays.
  void Intersect(Trace& trace, const vtkHeliosRay* rays, int count) const;

  /// Traces a packet; the rays that have any hit then have one.
  void Occluded(Trace& trace, const vtkHeliosRay* rays, int count) const;

private:
  void GetPoints(unsigned int triangle, const double* points[3]) const
  {
    for (int corner = 0; corner < 3; ++corner)
    {
      points[corner] = this->Mesh->GetCorner(triangle, corner);
    }
  }

  static void OnBounds(const RTCBoundsFunctionArguments* args);
  static void OnIntersect(const RTCIntersectFunctionNArguments* args);
  static void OnOccluded(const RTCOccludedFunctionNArguments* args);
  static void OnError(void* self, RTCError code, const char* text);
  static bool OnMemory(void* self, ssize_t bytes, bool post);

  const helios::TriangleMesh* Mesh = nullptr;
  helios::LocalFrame Frame;
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
}

void vtkHeliosEmbreeRayCaster::Internals::OnError(void* self, RTCError, const char* text)
{
  auto* internals = static_cast<Internals*>(self);
  const std::lock_guard<std::mutex> lock(internals->Mutex);
  internals->Problem = text ? text : "unknown error";
}

bool vtkHeliosEmbreeRayCaster::Internals::OnMemory(void* self, ssize_t bytes, bool)
{
  static_cast<Internals*>(self)->Bytes += bytes;
  return true;
}

void vtkHeliosEmbreeRayCaster::Internals::OnBounds(const RTCBoundsFunctionArguments* args)
{
  const auto* self = static_cast<const Internals*>(args->geometryUserPtr);
  const double* points[3];
  self->GetPoints(args->primID, points);
  float low[3] = { 1, 1, 1 }; // an empty box, which Embree leaves out
  float high[3] = { -1, -1, -1 };
  if (helios::HasArea(points[0], points[1], points[2]))
  {
    self->Frame.GetBox(points, low, high);
  }
  *args->bounds_o = { low[0], low[1], low[2], 0, high[0], high[1], high[2], 0 };
}

void vtkHeliosEmbreeRayCaster::Internals::OnIntersect(const RTCIntersectFunctionNArguments* args)
{
  const auto* self = static_cast<const Internals*>(args->geometryUserPtr);
  auto& trace = *reinterpret_cast<Trace*>(args->context);
  const double* points[3];
  self->GetPoints(args->primID, points);
  float* far = &RTCRayN_tfar(RTCRayHitN_RayN(args->rayhit, args->N), args->N, 0);
  if (args->N == 1)
  {
    trace.Rays.GetHalf(trace.Lane).TestLane(trace.Lane % helios::Half, points, args->primID, *far);
  }
  else
  {
    trace.Rays.TestLanes(args->valid, points, args->primID, far);
  }
}

void vtkHeliosEmbreeRayCaster::Internals::OnOccluded(const RTCOccludedFunctionNArguments* args)
{
  const auto* self = static_cast<const Internals*>(args->geometryUserPtr);
  auto& trace = *reinterpret_cast<Trace*>(args->context);
  const double* points[3];
  self->GetPoints(args->primID, points);
  for (unsigned int i = 0; i < args->N; ++i)
  {
    const int lane = trace.Lane + static_cast<int>(i);
    float far;
    if (args->valid[i] &&
      trace.Rays.GetHalf(lane).TestLane(lane % helios::Half, points, args->primID, far))
    {
      RTCRayN_tfar(args->ray, args->N, i) = -std::numeric_limits<float>::infinity();
    }
  }
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
  double bounds[6];
  mesh.GetBounds(bounds);
  this->Frame.Set(bounds);
  const std::string config =
    "threads=" + std::to_string(vtkSMPTools::GetEstimatedNumberOfThreads());
  this->Device = rtcNewDevice(config.c_str());
  if (!this->Device)
  {
    return "Embree cannot make its device, error " + std::to_string(rtcGetDeviceError(nullptr));
  }
  rtcSetDeviceErrorFunction(this->Device, OnError, this);
  rtcSetDeviceMemoryMonitorFunction(this->Device, OnMemory, this);
  this->Scene = rtcNewScene(this->Device);
  rtcSetSceneFlags(this->Scene, RTC_SCENE_FLAG_ROBUST);
  RTCGeometry geometry = rtcNewGeometry(this->Device, RTC_GEOMETRY_TYPE_USER);
  rtcSetGeometryUserPrimitiveCount(
    geometry, static_cast<unsigned int>(mesh.GetNumberOfTriangles()));
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
  int count) const
{
  rtcInitIntersectContext(&trace.Context);
  const int alive = trace.Rays.Set(this->Frame, rays, count, trace.Floats, trace.Valid);
  if (alive > 0 && this->Scene)
  {
    rtcIntersect8(trace.Valid, this->Scene, &trace.Context, &trace.RayHits);
  }
}

void vtkHeliosEmbreeRayCaster::Internals::Occluded(Trace& trace,
  const vtkHeliosRay* rays,
  int count) const
{
  rtcInitIntersectContext(&trace.Context);
  const int alive = trace.Rays.Set(this->Frame, rays, count, trace.Floats, trace.Valid);
  if (alive > 0 && this->Scene)
  {
    rtcOccluded8(trace.Valid, this->Scene, &trace.Context, &trace.RayHits.ray);
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
    this->Device->Intersect(trace, rays + first, lanes);
    for (int lane = 0; lane < lanes; ++lane)
    {
      const helios::HalfPacket& half = trace.Rays.GetHalf(lane);
      const vtkIdType cell = half.Triangle[lane % helios::Half];
      hits[first + lane] = cell != helios::HalfPacket::NoTriangle
        ? vtkHeliosHit{ half.Range[lane % helios::Half], cell }
        : vtkHeliosHit{ helios::NoHit, -1 };
    }
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
    this->Device->Occluded(trace, rays + first, lanes);
    for (int lane = 0; lane < lanes; ++lane)
    {
      occluded[first + lane] =
        trace.Rays.GetHalf(lane).Triangle[lane % helios::Half] != helios::HalfPacket::NoTriangle;
    }
  }
}

std::size_t vtkHeliosEmbreeRayCaster::GetAcceleratorSize() const
{
  return this->Device->GetSize();
}
