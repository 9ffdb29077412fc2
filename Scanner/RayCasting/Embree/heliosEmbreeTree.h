// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Embree's tree over the triangles of a scene.

#ifndef heliosEmbreeTree_h
#define heliosEmbreeTree_h

#include "heliosBvh.h"
#include "heliosEmbree.h"
#include "heliosEmbreePacket.h"
#include "heliosStatus.h"

#include <atomic>
#include <cstddef>
#include <mutex>
#include <string>
#include <vector>

namespace helios
{

class TriangleMesh;

class EmbreeTree
{
public:
  EmbreeTree() = default;
  ~EmbreeTree() { this->Clear(); }
  EmbreeTree(const EmbreeTree&) = delete;
  void operator=(const EmbreeTree&) = delete;

  /// Builds over a mesh, which must outlive it. Throws Stopped on an abort request.
  Status Build(const TriangleMesh& mesh, StopCheck& check);
  void Clear();

  void Intersect(const vtkHeliosRay* rays, vtkHeliosHit* hits, vtkIdType count) const;
  void Occluded(const vtkHeliosRay* rays, unsigned char* occluded, vtkIdType count) const;

  std::size_t GetMemorySize() const;

private:
  /// A packet of rays, with the callback arguments of Embree.
  struct Trace
  {
    EmbreeContext Context; // first: callbacks receive its address
    Packet Rays;
  };

  void SortTriangles(StopCheck& check);
  Status Commit(StopCheck& check);
  void GetPoints(vtkTypeInt32 triangle, const double* points[3]) const;
  bool HaveCommonEdge(vtkTypeInt32 a, vtkTypeInt32 b) const;
  TrianglePair GetPair(unsigned int first) const;

  /// Finds the best hits of a packet, or any hits; stores them in its rays.
  void TraceFirst(Trace& trace, int alive) const;
  void TraceAny(Trace& trace, int alive) const;
  vtkHeliosHit AddOutliers(const vtkHeliosRay& ray, const vtkHeliosHit& hit) const;

  static void OnBounds(const RTCBoundsFunctionArguments* args);
  static void OnIntersect(const RTCIntersectFunctionNArguments* args);
  static void OnOccluded(const RTCOccludedFunctionNArguments* args);
  static void OnError(void* self, RTCError code, const char* text);
  static bool OnMemory(void* self, std::ptrdiff_t bytes, bool post);

  const TriangleMesh* Mesh = nullptr;
  LocalFrame Frame;
  std::vector<bool> IsLeftOut; ///< during the build
  std::vector<bool> IsPaired;  ///< shares a box with the next triangle: usually a quad
  Bvh Outliers;                ///< the triangles that reach far out
  bool HasOutliers = false;
  RTCDevice Device = nullptr;
  RTCScene Scene = nullptr;
  int Width = QuadWidth; ///< rays traced at a time
  std::atomic<std::ptrdiff_t> Bytes{ 0 };
  std::mutex Mutex;
  Status Problem;
};

} // namespace helios

#endif
