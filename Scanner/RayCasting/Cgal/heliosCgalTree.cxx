// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosCgalTree.h"

#include "heliosStopCheck.h"
#include "heliosTriangleArea.h"
#include "heliosTriangleMesh.h"

#include <CGAL/AABB_traits_3.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <utility>
#include <vector>

namespace helios
{

namespace
{

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;

/// A triangle of the mesh by its index, 4 bytes; all share the mesh.
struct IndexPrimitive
{
  using Id = vtkTypeInt32;
  using Point = Kernel::Point_3;
  using Datum = Kernel::Triangle_3;
  using Shared_data = const TriangleMesh*;
  using Point_reference = Point;
  using Datum_reference = Datum;

  IndexPrimitive() = default;
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

using Tree = CGAL::AABB_tree<CGAL::AABB_traits_3<Kernel, IndexPrimitive>>;
using Node = CGAL::AABB_node<CGAL::AABB_traits_3<Kernel, IndexPrimitive>>;

/// Returns the range at which a ray enters the box of a node; NoHit for a miss or beyond its
/// maximum range.
double GetEntry(const TestRay& ray, const Node& node)
{
  const CGAL::Bbox_3& box = node.bbox();
  double low[3], high[3], entry, exit;
  for (int axis = 0; axis < 3; ++axis)
  {
    low[axis] = box.min(axis) - ray.Origin[axis];
    high[axis] = box.max(axis) - ray.Origin[axis];
  }
  GetBoxRange(low, high, ray.Inverse, entry, exit);
  return entry <= exit && exit > 0.0 && entry <= ray.MaximumRange ? entry : NoHit;
}

/// A visitor of CGAL's traversal; the ray's maximum range shrinks to its best hit.
class Search
{
public:
  using Priority = double; // the higher is visited first

  Search(const TriangleMesh& mesh, const TestRay& ray, bool isAnyEnough)
    : Mesh(mesh)
    , Ray(ray)
    , IsAnyEnough(isAnyEnough)
  {
  }

  const vtkHeliosHit& GetHit() const { return this->Hit; }

  bool go_further() const { return !this->IsAnyEnough || this->Hit.CellId < 0; }

  void intersection(const TestRay&, const IndexPrimitive& primitive)
  {
    const vtkTypeInt32 triangle = primitive.id();
    const double* points[3] = { this->Mesh.GetCorner(triangle, 0),
      this->Mesh.GetCorner(triangle, 1), this->Mesh.GetCorner(triangle, 2) };
    const double range = TestTriangle(this->Ray, points);
    if (range < this->Hit.Range || (range == this->Hit.Range && triangle < this->Hit.CellId))
    {
      this->Hit = { range, triangle };
      this->Ray.MaximumRange = range;
    }
  }

  bool do_intersect(const TestRay&, const Node& node) const
  {
    return GetEntry(this->Ray, node) < NoHit;
  }

  std::pair<bool, Priority> do_intersect_with_priority(const TestRay&, const Node& node) const
  {
    const double entry = GetEntry(this->Ray, node);
    return { entry < NoHit, -entry };
  }

private:
  const TriangleMesh& Mesh;
  TestRay Ray;
  bool IsAnyEnough;
  vtkHeliosHit Hit{ NoHit, -1 };
};

} // namespace

struct CgalTree::Internals
{
  const TriangleMesh* Mesh = nullptr;
  Tree Boxes;

  vtkHeliosHit Find(const vtkHeliosRay& ray, bool isAnyEnough) const
  {
    TestRay test;
    if (this->Boxes.empty() || !test.Set(ray))
    {
      return { NoHit, -1 };
    }
    Search search(*this->Mesh, test, isAnyEnough);
    this->Boxes.traversal_with_priority(test, search);
    return search.GetHit();
  }
};

//------------------------------------------------------------------------------
CgalTree::CgalTree()
  : State(new Internals)
{
}

//------------------------------------------------------------------------------
CgalTree::~CgalTree() = default;

//------------------------------------------------------------------------------
void CgalTree::Build(const TriangleMesh& mesh, StopCheck& check)
{
  std::vector<vtkTypeInt32> triangles;
  for (vtkIdType i = 0; i < mesh.GetNumberOfTriangles(); ++i)
  {
    if (SpansArea(mesh.GetCorner(i, 0), mesh.GetCorner(i, 1), mesh.GetCorner(i, 2)))
    {
      triangles.push_back(static_cast<vtkTypeInt32>(i));
    }
  }
  this->State = std::make_unique<Internals>();
  this->State->Mesh = &mesh;
  this->State->Boxes.insert(triangles.begin(), triangles.end(), &mesh);
  const Tree::AABB_traits& traits = this->State->Boxes.traits();
  using Split = StoppableSplit<Tree::AABB_traits::Split_primitives>;
  this->State->Boxes.custom_build(traits.compute_bbox_object(),
    Split(traits.split_primitives_object(), check)); // now: queries must be const
}

//------------------------------------------------------------------------------
vtkHeliosHit CgalTree::Intersect(const vtkHeliosRay& ray) const
{
  return this->State->Find(ray, false);
}

//------------------------------------------------------------------------------
bool CgalTree::IsOccluded(const vtkHeliosRay& ray) const
{
  return this->State->Find(ray, true).CellId >= 0;
}

//------------------------------------------------------------------------------
std::size_t CgalTree::GetMemorySize() const
{
  const std::size_t count = this->State->Boxes.size();
  return count * sizeof(IndexPrimitive) + (count > 1 ? count - 1 : 0) * sizeof(Node);
}

} // namespace helios
