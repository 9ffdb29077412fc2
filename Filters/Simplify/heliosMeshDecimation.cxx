// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosMeshDecimation.h"

#include "heliosSurfaceDistance.h"

#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>
#include <OpenMesh/Tools/Decimater/DecimaterT.hh>
#include <OpenMesh/Tools/Decimater/ModBaseT.hh>
#include <OpenMesh/Tools/Decimater/ModQuadricT.hh>

#include <algorithm>
#include <utility>

namespace helios
{

namespace
{

struct Traits : public OpenMesh::DefaultTraits
{
  using Point = OpenMesh::Vec3d;
  using Normal = OpenMesh::Vec3d;
};
using HalfedgeMesh = OpenMesh::TriMesh_ArrayKernelT<Traits>;

Vec3 ToVec3(const OpenMesh::Vec3d& p)
{
  return { p[0], p[1], p[2] };
}

/**
 * Limits collapses by distance, like OpenMesh's ModHausdorff, but also checks the removed point
 * itself, rejects zero-area and flipped triangles, and chains the points of a triangle by index
 * instead of copying them.
 */
template <typename MeshT>
class ModDistance : public OpenMesh::Decimater::ModBaseT<MeshT>
{
public:
  DECIMATING_MODULE(ModDistance, MeshT, Distance)

  explicit ModDistance(MeshT& mesh)
    : Base(mesh, true)
    , NumberOfVertices(static_cast<int>(mesh.n_vertices()))
    , IsOriginal(mesh.n_edges(), true)
    , First(mesh.n_faces(), -1)
    , Next(mesh.n_vertices() + mesh.n_edges(), -1)
  {
    for (const auto edge : mesh.all_edges())
    {
      const auto side = mesh.halfedge_handle(edge, 0);
      this->Ends.emplace_back(
        mesh.from_vertex_handle(side).idx(), mesh.to_vertex_handle(side).idx());
    }
  }

  void SetTolerances(const std::vector<double>& tolerances) { this->Tolerances = &tolerances; }

  /// Sets the stop check. OpenMesh computes priorities throughout, initially for every point: the
  /// check runs there.
  void SetStopCheck(StopCheck& check) { this->Check = &check; }

  /// Returns the removed point of each collapse, and its target.
  const std::vector<std::pair<int, int>>& GetHistory() const { return this->History; }

  float collapse_priority(const CollapseInfo& info) override
  {
    this->Check->Count();
    this->Collect(info);
    const bool isLegal = this->KeepsFacing() &&
      std::all_of(this->Samples.begin(), this->Samples.end(),
        [this](int sample) { return this->IsNear(sample); });
    return static_cast<float>(isLegal ? Base::LEGAL_COLLAPSE : Base::ILLEGAL_COLLAPSE);
  }

  void preprocess_collapse(const CollapseInfo& info) override
  {
    this->Collect(info);
    this->History.emplace_back(info.v0.idx(), info.v1.idx());
    for (const auto edge : Base::mesh().ve_range(info.v0))
    {
      this->IsOriginal[edge.idx()] = false;
    }
    for (const int face : this->Ring)
    {
      this->First[face] = -1;
    }
    for (const int sample : this->Samples)
    {
      const std::size_t nearest = this->FindNearest(this->GetSample(sample));
      int& first = this->First[this->Changed[nearest]];
      this->Next[sample] = first;
      first = sample;
    }
  }

private:
  Vec3 GetVertex(int vertex)
  {
    return ToVec3(Base::mesh().point(typename MeshT::VertexHandle(vertex)));
  }

  /// Returns a vertex, or the midpoint of an edge of the patch.
  Vec3 GetSample(int sample)
  {
    if (sample < this->NumberOfVertices)
    {
      return this->GetVertex(sample);
    }
    const std::pair<int, int>& ends = this->Ends[sample - this->NumberOfVertices];
    return (this->GetVertex(ends.first) + this->GetVertex(ends.second)) * 0.5;
  }

  double GetTolerance(int sample) const
  {
    if (sample < this->NumberOfVertices)
    {
      return (*this->Tolerances)[sample];
    }
    const std::pair<int, int>& ends = this->Ends[sample - this->NumberOfVertices];
    return std::min((*this->Tolerances)[ends.first], (*this->Tolerances)[ends.second]);
  }

  /// Collects the triangles about v0, the remaining ones after the collapse, and the samples they
  /// must be near.
  void Collect(const CollapseInfo& info)
  {
    this->Ring.clear();
    this->Changed.clear();
    this->Before.clear();
    this->After.clear();
    this->Samples.assign(1, info.v0.idx());
    for (const auto edge : Base::mesh().ve_range(info.v0))
    {
      if (this->IsOriginal[edge.idx()])
      {
        this->Samples.push_back(this->NumberOfVertices + edge.idx());
      }
    }
    for (const auto face : Base::mesh().vf_range(info.v0))
    {
      this->Ring.push_back(face.idx());
      for (int sample = this->First[face.idx()]; sample >= 0; sample = this->Next[sample])
      {
        this->Samples.push_back(sample);
      }
      if (face != info.fl && face != info.fr)
      {
        this->AddChanged(info, face);
      }
    }
  }

  void AddChanged(const CollapseInfo& info, typename MeshT::FaceHandle face)
  {
    const auto side = Base::mesh().halfedge_handle(face);
    const typename MeshT::VertexHandle corners[3] = { Base::mesh().from_vertex_handle(side),
      Base::mesh().to_vertex_handle(side),
      Base::mesh().to_vertex_handle(Base::mesh().next_halfedge_handle(side)) };
    const auto before = [&](int i) { return ToVec3(Base::mesh().point(corners[i])); };
    const auto after = [&](int i) { return corners[i] == info.v0 ? ToVec3(info.p1) : before(i); };
    this->Changed.push_back(face.idx());
    this->Before.push_back({ before(0), before(1), before(2) });
    this->After.push_back({ after(0), after(1), after(2) });
  }

  static Vec3 GetNormal(const Triangle& t) { return (t[1] - t[0]).Cross(t[2] - t[0]); }

  /// Returns whether no triangle rotates by 75 degrees or more, or loses all of its area.
  bool KeepsFacing() const
  {
    for (std::size_t i = 0; i < this->After.size(); ++i)
    {
      const Vec3 before = GetNormal(this->Before[i]);
      const Vec3 after = GetNormal(this->After[i]);
      if (!(before.Dot(after) > 0.26 * before.Norm() * after.Norm()))
      {
        return false;
      }
    }
    return !this->After.empty();
  }

  bool IsNear(int sample)
  {
    const Vec3 p = this->GetSample(sample);
    const double tolerance = this->GetTolerance(sample);
    return std::any_of(this->After.begin(), this->After.end(),
      [&p, tolerance](const Triangle& t) { return GetDistance(p, t) <= tolerance; });
  }

  std::size_t FindNearest(const Vec3& point) const
  {
    std::size_t nearest = 0;
    double minimum = GetDistance(point, this->After[0]);
    for (std::size_t i = 1; i < this->After.size(); ++i)
    {
      const double distance = GetDistance(point, this->After[i]);
      nearest = distance < minimum ? i : nearest;
      minimum = std::min(distance, minimum);
    }
    return nearest;
  }

  int NumberOfVertices;
  std::vector<std::pair<int, int>> Ends;           ///< ends of the edges of the patch
  std::vector<bool> IsOriginal;                    ///< edges unchanged from the patch
  const std::vector<double>* Tolerances = nullptr; ///< one per vertex
  StopCheck* Check = nullptr;
  std::vector<std::pair<int, int>> History;
  std::vector<int> First; ///< sample assigned to a triangle; -1: none
  std::vector<int> Next;  ///< sample assigned to the same triangle
  std::vector<int> Ring;
  std::vector<int> Changed;
  std::vector<Triangle> Before, After; ///< the changed ones
  std::vector<int> Samples;
};

/// OpenMesh's decimater, which can also apply given collapses only.
class Decimater : public OpenMesh::Decimater::DecimaterT<HalfedgeMesh>
{
public:
  explicit Decimater(HalfedgeMesh& mesh)
    : BaseDecimaterT(mesh)
    , DecimaterT(mesh)
  {
  }

  void Repeat(const std::vector<std::pair<int, int>>& history)
  {
    for (const auto& collapse : history)
    {
      const auto side = this->mesh().find_halfedge(
        HalfedgeMesh::VertexHandle(collapse.first), HalfedgeMesh::VertexHandle(collapse.second));
      if (!side.is_valid())
      {
        continue;
      }
      CollapseInfo info(this->mesh(), side);
      if (this->is_collapse_legal(info) && this->collapse_priority(info) >= 0.0F)
      {
        this->preprocess_collapse(info);
        this->mesh().collapse(side);
        this->postprocess_collapse(info);
      }
    }
  }
};

/// Returns the patch as half-edges; lists the triangle of each face, and the rejected triangles.
HalfedgeMesh MakeMesh(const Patch& patch, std::vector<vtkIdType>& ofFace,
  std::vector<vtkIdType>& rejected, StopCheck& check)
{
  HalfedgeMesh mesh;
  const std::size_t count = patch.Cells.size();
  mesh.reserve(patch.Points.size(), 3 * count / 2 + patch.Points.size() / 8, count);
  mesh.request_vertex_status();
  for (std::size_t i = 0; i < patch.Points.size(); ++i)
  {
    const Vec3& p = patch.Points[i];
    const auto vertex = mesh.add_vertex({ p[0], p[1], p[2] });
    mesh.status(vertex).set_locked(patch.IsLocked[i]);
  }
  const auto handle = [](vtkTypeInt32 id) { return HalfedgeMesh::VertexHandle(id); };
  for (std::size_t i = 0; i < count; ++i)
  {
    check.Count();
    const vtkTypeInt32* c = &patch.Corners[3 * i];
    const bool fits = mesh.add_face(handle(c[0]), handle(c[1]), handle(c[2])).is_valid();
    (fits ? ofFace : rejected).push_back(static_cast<vtkIdType>(i));
  }
  for (const vtkIdType triangle : rejected)
  {
    for (int corner = 0; corner < 3; ++corner)
    {
      mesh.status(handle(patch.Corners[3 * triangle + corner])).set_locked(true);
    }
  }
  return mesh;
}

/// Returns the remaining triangles, in the order of the patch.
DecimatedPatch GetResult(const Patch& patch, const HalfedgeMesh& mesh,
  const std::vector<vtkIdType>& ofFace, const std::vector<vtkIdType>& rejected)
{
  std::vector<int> faceOf(patch.Cells.size(), -1);
  for (std::size_t i = 0; i < ofFace.size(); ++i)
  {
    faceOf[static_cast<std::size_t>(ofFace[i])] = static_cast<int>(i);
  }
  DecimatedPatch result;
  result.Rejected = static_cast<vtkIdType>(rejected.size());
  for (std::size_t i = 0; i < faceOf.size(); ++i)
  {
    const HalfedgeMesh::FaceHandle face(faceOf[i]);
    if (!face.is_valid())
    {
      const vtkTypeInt32* c = &patch.Corners[3 * i];
      result.Corners.insert(result.Corners.end(), c, c + 3);
    }
    else if (!mesh.status(face).deleted())
    {
      for (const auto vertex : mesh.fv_range(face))
      {
        result.Corners.push_back(vertex.idx());
      }
    }
    else
    {
      continue;
    }
    result.Triangles.push_back(static_cast<vtkIdType>(i));
  }
  return result;
}

} // namespace

MeshDecimation::MeshDecimation(const Patch& patch)
  : Source(patch)
{
}

DecimatedPatch MeshDecimation::Run(const std::vector<double>& tolerances, StopCheck& check)
{
  std::vector<vtkIdType> ofFace;
  std::vector<vtkIdType> rejected;
  HalfedgeMesh mesh = MakeMesh(this->Source, ofFace, rejected, check);

  Decimater decimater(mesh);
  OpenMesh::Decimater::ModQuadricT<HalfedgeMesh>::Handle quadric;
  ModDistance<HalfedgeMesh>::Handle distance;
  decimater.add(quadric);
  decimater.add(distance);
  decimater.module(quadric).unset_max_err();
  decimater.module(distance).SetTolerances(tolerances);
  decimater.module(distance).SetStopCheck(check);
  decimater.initialize();
  check.Poll();
  decimater.Repeat(this->History);
  decimater.decimate();
  this->History = decimater.module(distance).GetHistory();
  return GetResult(this->Source, mesh, ofFace, rejected);
}

} // namespace helios
