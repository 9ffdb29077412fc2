// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosEmbreeTree.h"

#include "heliosCoreBounds.h"
#include "heliosStatus.h"
#include "heliosTriangleArea.h"
#include "heliosTriangleMesh.h"

#include <vtkSMPTools.h>

#include <algorithm>
#include <atomic>
#include <cstring>
#include <limits>
#include <thread>

#if defined(__SSE2__)
#include <xmmintrin.h>
#endif

namespace helios
{

namespace
{

static_assert(sizeof(RTCRayHit16) <= sizeof(Packet::Floats), "room for the largest packet");
static_assert(offsetof(RTCRay16, tfar) == 64 * static_cast<int>(RayField::Far), "the same order");
static_assert(offsetof(RTCRay, id) == 4 * static_cast<int>(RayField::Id), "the same order");

/// Embree is slow on subnormal floats: flushed to zero during traversal, in this thread.
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

/// Returns the number of rays Embree traces at a time on this machine.
int GetNativeWidth(RTCDevice device)
{
  if (rtcGetDeviceProperty(device, RTC_DEVICE_PROPERTY_NATIVE_RAY16_SUPPORTED))
  {
    return 16;
  }
  return rtcGetDeviceProperty(device, RTC_DEVICE_PROPERTY_NATIVE_RAY8_SUPPORTED) ? 8 : 4;
}

/// Embree reports its progress in any of its threads; the abort check runs in the first one.
struct Watch
{
  explicit Watch(const StopCheck& check)
    : Check(check)
  {
  }

  static bool OnProgress(void* self, double)
  {
    auto* watch = static_cast<Watch*>(self);
    if (std::this_thread::get_id() == watch->Thread && !watch->IsStopped)
    {
      watch->Poll();
    }
    return !watch->IsStopped;
  }

  /// Exceptions must not propagate through Embree.
  void Poll()
  {
    try
    {
      this->Check.Poll();
    }
    catch (const Stopped&)
    {
      this->IsStopped = true;
    }
  }

  const StopCheck& Check;
  std::thread::id Thread = std::this_thread::get_id();
  std::atomic<bool> IsStopped{ false };
};

/// Returns the single valid ray of a packet, for Embree's functions that take one.
RTCRay GetAlone(const Packet& rays)
{
  const auto lane = std::find(rays.Valid, rays.Valid + rays.Width, -1) - rays.Valid;
  float fields[12];
  for (int field = 0; field < 12; ++field)
  {
    fields[field] = rays.Floats[field * rays.Width + lane];
  }
  RTCRay ray;
  std::memcpy(&ray, fields, sizeof(ray));
  return ray;
}

} // namespace

void EmbreeTree::Clear()
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
  this->Frame = LocalFrame();
  this->HasOutliers = false;
  this->Outliers = Bvh();
  this->IsPaired = std::vector<bool>();
}

std::size_t EmbreeTree::GetMemorySize() const
{
  return static_cast<std::size_t>(this->Bytes.load()) + this->IsPaired.capacity() / 8 +
    this->Outliers.GetMemorySize();
}

Status EmbreeTree::Build(const TriangleMesh& mesh, StopCheck& check)
{
  this->Clear();
  this->Problem = {};
  this->Mesh = &mesh;
  if (mesh.GetNumberOfTriangles() == 0)
  {
    return {};
  }
  this->SortTriangles(check);
  const Status status = this->Commit(check);
  this->IsLeftOut = std::vector<bool>();
  return status;
}

/// Decides which triangles go to Embree, which of them in pairs, and which are outliers.
void EmbreeTree::SortTriangles(StopCheck& check)
{
  const auto count = static_cast<vtkTypeInt32>(this->Mesh->GetNumberOfTriangles());
  this->IsLeftOut.assign(static_cast<std::size_t>(count), false);
  this->IsPaired.assign(static_cast<std::size_t>(count), false);
  double core[6];
  GetCoreBounds(*this->Mesh, core);
  double low[3] = { core[1], core[3], core[5] };
  double high[3] = { core[0], core[2], core[4] };
  std::vector<vtkTypeInt32> outliers;
  bool mayPair = false;
  for (vtkTypeInt32 i = 0; i < count; ++i)
  {
    check.Count();
    const double* p[3];
    this->GetPoints(i, p);
    bool isInside = true;
    double minimum[3], maximum[3];
    for (int axis = 0; axis < 3; ++axis)
    {
      minimum[axis] = Min(Min(p[0][axis], p[1][axis]), p[2][axis]);
      maximum[axis] = Max(Max(p[0][axis], p[1][axis]), p[2][axis]);
      isInside = isInside && minimum[axis] >= core[2 * axis] && maximum[axis] <= core[2 * axis + 1];
    }
    const bool hasArea = SpansArea(p[0], p[1], p[2]);
    const bool isTaken = hasArea && isInside;
    for (int axis = 0; axis < 3 && isTaken; ++axis)
    {
      low[axis] = Min(low[axis], minimum[axis]);
      high[axis] = Max(high[axis], maximum[axis]);
    }
    if (hasArea && !isInside)
    {
      outliers.push_back(i);
    }
    const bool isPair = mayPair && isTaken && this->HaveCommonEdge(i - 1, i);
    if (isPair)
    {
      this->IsPaired[i - 1] = true;
    }
    this->IsLeftOut[i] = !isTaken || isPair;
    mayPair = isTaken && !isPair;
  }
  this->HasOutliers = !outliers.empty();
  this->Outliers.Build(*this->Mesh, std::move(outliers), check);
  this->Frame.Set(low, high);
}

bool EmbreeTree::HaveCommonEdge(vtkTypeInt32 a, vtkTypeInt32 b) const
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

Status EmbreeTree::Commit(StopCheck& check)
{
  const std::string threads = std::to_string(vtkSMPTools::GetEstimatedNumberOfThreads());
  this->Device = rtcNewDevice(("threads=" + threads).c_str());
  if (!this->Device)
  {
    return Status::Error("Embree cannot create its device (error " +
      std::to_string(rtcGetDeviceError(nullptr)) + "); use vtkHeliosBvhRayCaster");
  }
  rtcSetDeviceErrorFunction(this->Device, OnError, this);
  rtcSetDeviceMemoryMonitorFunction(this->Device, OnMemory, this);
  this->Width = GetNativeWidth(this->Device);
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
  Watch watch(check);
  rtcSetSceneProgressMonitorFunction(this->Scene, Watch::OnProgress, &watch);
  rtcCommitScene(this->Scene);
  rtcSetSceneProgressMonitorFunction(this->Scene, nullptr, nullptr);
  if (watch.IsStopped)
  {
    throw Stopped();
  }
  return this->Problem;
}

void EmbreeTree::OnError(void* self, RTCError, const char* text)
{
  auto* tree = static_cast<EmbreeTree*>(self);
  const std::lock_guard<std::mutex> lock(tree->Mutex);
  tree->Problem = Status::Error(std::string("Embree: ") + (text ? text : "unknown error"));
}

bool EmbreeTree::OnMemory(void* self, std::ptrdiff_t bytes, bool)
{
  static_cast<EmbreeTree*>(self)->Bytes += bytes;
  return true;
}

void EmbreeTree::OnBounds(const RTCBoundsFunctionArguments* args)
{
  const auto* self = static_cast<const EmbreeTree*>(args->geometryUserPtr);
  float low[3] = { 1, 1, 1 }; // an empty box, which Embree skips
  float high[3] = { -1, -1, -1 };
  if (!self->IsLeftOut[args->primID])
  {
    const TrianglePair pair = self->GetPair(args->primID);
    std::fill_n(low, 3, std::numeric_limits<float>::max());
    std::fill_n(high, 3, -std::numeric_limits<float>::max());
    for (int i = 0; i < pair.Count; ++i)
    {
      self->Frame.AddBox(pair.Points[i], low, high);
    }
  }
  *args->bounds_o = { low[0], low[1], low[2], 0, high[0], high[1], high[2], 0 };
}

inline void EmbreeTree::GetPoints(vtkTypeInt32 triangle, const double* points[3]) const
{
  for (int corner = 0; corner < 3; ++corner)
  {
    points[corner] = this->Mesh->GetCorner(triangle, corner);
  }
}

inline TrianglePair EmbreeTree::GetPair(unsigned int first) const
{
  TrianglePair pair;
  pair.First = static_cast<vtkTypeInt32>(first);
  pair.Count = this->IsPaired[first] ? 2 : 1;
  this->GetPoints(pair.First, pair.Points[0]);
  if (pair.Count == 2)
  {
    this->GetPoints(pair.First + 1, pair.Points[1]);
  }
  return pair;
}

void EmbreeTree::OnIntersect(const RTCIntersectFunctionNArguments* args)
{
  const auto* self = static_cast<const EmbreeTree*>(args->geometryUserPtr);
  Packet& rays = reinterpret_cast<Trace*>(args->context)->Rays;
  const TrianglePair pair = self->GetPair(args->primID);
  RTCRayN* floats = RTCRayHitN_RayN(args->rayhit, args->N);
  float* far = &RTCRayN_tfar(floats, args->N, 0);
  if (static_cast<int>(args->N) == rays.Width)
  {
    rays.TestLanes(args->valid, pair, far);
    return;
  }
  for (unsigned int i = 0; i < args->N; ++i) // single ray: its id is its lane
  {
    if (args->valid[i])
    {
      rays.TestLane(static_cast<int>(RTCRayN_id(floats, args->N, i)), pair, far[i]);
    }
  }
}

void EmbreeTree::OnOccluded(const RTCOccludedFunctionNArguments* args)
{
  const auto* self = static_cast<const EmbreeTree*>(args->geometryUserPtr);
  Packet& rays = reinterpret_cast<Trace*>(args->context)->Rays;
  const TrianglePair pair = self->GetPair(args->primID);
  float* far = &RTCRayN_tfar(args->ray, args->N, 0);
  for (unsigned int i = 0; i < args->N; ++i)
  {
    const int lane = static_cast<int>(RTCRayN_id(args->ray, args->N, i));
    if (args->valid[i] && rays.TestLane(lane, pair, far[i]))
    {
      far[i] = -std::numeric_limits<float>::infinity(); // Embree's value for occluded
    }
  }
}

// Traces coherently; the context's default is INCOHERENT, and COHERENT loses hits with tiny
// direction components.
void EmbreeTree::TraceFirst(Trace& trace, int alive) const
{
  InitContext(trace.Context);
  const int* valid = trace.Rays.Valid;
  void* floats = trace.Rays.Floats;
  if (alive == 1)
  {
    RTCRayHit alone;
    alone.ray = GetAlone(trace.Rays);
    alone.hit.geomID = RTC_INVALID_GEOMETRY_ID;
    TraceRay(rtcIntersect1, this->Scene, trace.Context, alone);
  }
  else if (alive > 0 && this->Width == 4)
  {
    TracePacket(rtcIntersect4, valid, this->Scene, trace.Context, floats);
  }
  else if (alive > 0 && this->Width == 8)
  {
    TracePacket(rtcIntersect8, valid, this->Scene, trace.Context, floats);
  }
  else if (alive > 0)
  {
    TracePacket(rtcIntersect16, valid, this->Scene, trace.Context, floats);
  }
}

void EmbreeTree::TraceAny(Trace& trace, int alive) const
{
  InitContext(trace.Context);
  const int* valid = trace.Rays.Valid;
  void* floats = trace.Rays.Floats;
  if (alive == 1)
  {
    RTCRay alone = GetAlone(trace.Rays);
    TraceRay(rtcOccluded1, this->Scene, trace.Context, alone);
  }
  else if (alive > 0 && this->Width == 4)
  {
    TracePacket(rtcOccluded4, valid, this->Scene, trace.Context, floats);
  }
  else if (alive > 0 && this->Width == 8)
  {
    TracePacket(rtcOccluded8, valid, this->Scene, trace.Context, floats);
  }
  else if (alive > 0)
  {
    TracePacket(rtcOccluded16, valid, this->Scene, trace.Context, floats);
  }
}

/// Returns the better of a hit and a nearer hit of the outliers.
vtkHeliosHit EmbreeTree::AddOutliers(const vtkHeliosRay& ray, const vtkHeliosHit& hit) const
{
  TestRay rest;
  if (!rest.Set(ray))
  {
    return hit;
  }
  rest.MaximumRange = Min(rest.MaximumRange, hit.Range);
  const vtkHeliosHit other = this->Outliers.Intersect(rest);
  const bool isBetter =
    other.Range < hit.Range || (other.Range == hit.Range && other.CellId < hit.CellId);
  return other.CellId >= 0 && isBetter ? other : hit;
}

void EmbreeTree::Intersect(const vtkHeliosRay* rays, vtkHeliosHit* hits, vtkIdType count) const
{
  const FlushSubnormals flush;
  Trace trace;
  trace.Rays.SetWidth(this->Width);
  for (vtkIdType first = 0; first < count; first += this->Width)
  {
    const int lanes = static_cast<int>(std::min<vtkIdType>(this->Width, count - first));
    this->TraceFirst(trace, trace.Rays.Set(this->Frame, rays + first, lanes));
    for (int lane = 0; lane < lanes; ++lane)
    {
      const vtkHeliosHit hit = trace.Rays.GetHit(lane);
      hits[first + lane] = this->HasOutliers ? this->AddOutliers(rays[first + lane], hit) : hit;
    }
  }
}

void EmbreeTree::Occluded(const vtkHeliosRay* rays, unsigned char* occluded, vtkIdType count) const
{
  const FlushSubnormals flush;
  Trace trace;
  trace.Rays.SetWidth(this->Width);
  for (vtkIdType first = 0; first < count; first += this->Width)
  {
    const int lanes = static_cast<int>(std::min<vtkIdType>(this->Width, count - first));
    this->TraceAny(trace, trace.Rays.Set(this->Frame, rays + first, lanes));
    for (int lane = 0; lane < lanes; ++lane)
    {
      TestRay ray;
      occluded[first + lane] = trace.Rays.GetHit(lane).CellId >= 0 ||
        (this->HasOutliers && ray.Set(rays[first + lane]) && this->Outliers.IsOccluded(ray));
    }
  }
}

} // namespace helios
