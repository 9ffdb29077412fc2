// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosBvh.h"
#include "heliosTriangleDistance.h"
#include "heliosTriangleMesh.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace helios
{

/// The search for the triangle nearest to a segment: nodes farther than the best are skipped.
class Bvh::NearestSearch
{
public:
  NearestSearch(const Bvh& tree, const Vec3& a, const Vec3& b, double reach)
    : Tree(tree)
    , Start(a)
    , Way(b - a)
    , HalfLength(0.5 * this->Way.Norm())
    , Reach(reach)
  {
    const Vec3 middle = a + 0.5 * this->Way;
    for (int axis = 0; axis < 3; ++axis)
    {
      this->Low[axis] = std::min(a[axis], b[axis]);
      this->High[axis] = std::max(a[axis], b[axis]);
      this->Middle[axis] = middle[axis];
    }
  }

  double Run()
  {
    if (!this->Tree.Nodes.empty())
    {
      this->VisitNode(this->Tree.Nodes[0]);
    }
    return this->Nearest;
  }

private:
  void VisitNode(const Node& node)
  {
    double bounds[2] = { this->GetBound(node, 0), this->GetBound(node, 1) };
    int child = bounds[0] <= bounds[1] ? 0 : 1;
    for (int i = 0; i < 2; ++i, child = 1 - child)
    {
      if (bounds[child] > this->Reach)
      {
        continue;
      }
      const auto first = static_cast<std::size_t>(node.First[child]);
      const auto count = static_cast<std::size_t>(node.Count[child]);
      if (count == 0)
      {
        this->VisitNode(this->Tree.Nodes[first]);
      }
      for (std::size_t k = first; k < first + count; ++k)
      {
        this->VisitTriangle(this->Tree.Order[k]);
      }
    }
  }

  /// Returns a lower bound of the distance from the segment to the box of a child: from the
  /// segment's box and its bounding ball.
  double GetBound(const Node& node, int child) const
  {
    double toBox = 0.0;
    double toMiddle = 0.0;
    for (int axis = 0; axis < 3; ++axis)
    {
      const double low = node.Low[axis][child];
      const double high = node.High[axis][child];
      const double gap = std::max({ 0.0, low - this->High[axis], this->Low[axis] - high });
      const double from = std::max({ 0.0, low - this->Middle[axis], this->Middle[axis] - high });
      toBox += gap * gap;
      toMiddle += from * from;
    }
    const double bound = std::max(std::sqrt(toBox), std::sqrt(toMiddle) - this->HalfLength);
    return bound * (1.0 - 1e-12); // allows for rounding
  }

  void VisitTriangle(vtkTypeInt32 triangle)
  {
    Vec3 corners[3];
    for (int k = 0; k < 3; ++k)
    {
      corners[k] = Vec3(this->Tree.Mesh->GetCorner(triangle, k)) - this->Start; // small numbers
    }
    const double distance = SegmentToTriangle({ 0.0, 0.0, 0.0 }, this->Way, corners);
    if (distance <= this->Reach)
    {
      this->Nearest = this->Reach = distance;
    }
  }

  const Bvh& Tree;
  Vec3 Start;
  Vec3 Way;
  double HalfLength;
  double Reach;
  double Low[3];
  double High[3];
  double Middle[3];
  double Nearest = std::numeric_limits<double>::infinity();
};

double Bvh::GetDistance(const Vec3& a, const Vec3& b, double reach) const
{
  return NearestSearch(*this, a, b, reach).Run();
}

} // namespace helios
