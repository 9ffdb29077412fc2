// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosBeamTree.h"

#include "heliosCoreBounds.h"
#include "heliosHeightTree.h"
#include "heliosTriangleArea.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

namespace helios
{

namespace
{

constexpr float Endless = std::numeric_limits<float>::max();

} // namespace

/**
 * The optimal conversion of a binary tree to a wide one: Cost[k] is the minimum sum of the surfaces
 * of the nodes of its subtree as k children of a wide node; Left[k] is the number of them in the
 * left child, 0 if one less is as good. With k = 1 it becomes a separate node, of Width children.
 * (Ylitie, Karras, Laine, "Efficient Incoherent Ray Traversal on GPUs Through Compressed Wide
 * BVHs", HPG 2017.)
 */
struct BeamTree::Share
{
  float Cost[Width + 1];
  unsigned char Left[Width + 1];
};

class BeamTree::Collapse
{
public:
  Collapse(const Bvh& binary, StopCheck& check)
    : Binary(binary)
    , Shares(binary.Nodes.size())
  {
    for (std::size_t i = this->Shares.size(); i-- > 0;) // children follow their parents
    {
      check.Count();
      this->SetShare(this->Shares[i], binary.Nodes[i]);
    }
  }

  /// A child of a wide node: the side of a binary one.
  struct Child
  {
    vtkTypeInt32 Node;
    int Side;
  };

  /// Collects the children of the wide node for a binary one; returns their number.
  int GetChildren(vtkTypeInt32 node, Child children[Width]) const
  {
    const Bvh::Node& n = this->Binary.Nodes[node];
    if (n.Count[0] > 0 && n.Count[1] > 0 && n.First[0] == n.First[1])
    {
      children[0] = { node, 0 }; // a tree of one leaf has it on both sides
      return 1;
    }
    int count = 0;
    this->Part(node, this->Shares[node].Left[1], Width, children, count);
    return count;
  }

private:
  float GetCost(const Bvh::Node& node, int side, int k) const
  {
    return node.Count[side] > 0 ? 0.0f : this->Shares[node.First[side]].Cost[k];
  }

  void SetShare(Share& share, const Bvh::Node& node) const
  {
    for (int k = 2; k <= Width; ++k)
    {
      share.Cost[k] = Endless;
      for (int left = 1; left < k; ++left)
      {
        const float cost = this->GetCost(node, 0, left) + this->GetCost(node, 1, k - left);
        if (cost < share.Cost[k])
        {
          share.Cost[k] = cost;
          share.Left[k] = static_cast<unsigned char>(left);
        }
      }
    }
    const auto getSide = [&node](int axis) {
      return Max(node.High[axis][0], node.High[axis][1]) -
        Min(node.Low[axis][0], node.Low[axis][1]);
    };
    const double x = getSide(0);
    const double y = getSide(1);
    const double z = getSide(2);
    share.Left[1] = share.Left[Width];
    share.Cost[1] = share.Cost[Width] + static_cast<float>(x * y + y * z + z * x);
    for (int k = 2; k <= Width; ++k)
    {
      if (share.Cost[k - 1] <= share.Cost[k])
      {
        share.Cost[k] = share.Cost[k - 1];
        share.Left[k] = 0;
      }
    }
  }

  /// Distributes k children over the two sides of a node.
  void Part(vtkTypeInt32 node, int left, int k, Child children[Width], int& count) const
  {
    this->Add(node, 0, left, children, count);
    this->Add(node, 1, k - left, children, count);
  }

  void Add(vtkTypeInt32 node, int side, int k, Child children[Width], int& count) const
  {
    const Bvh::Node& n = this->Binary.Nodes[node];
    const vtkTypeInt32 inner = n.First[side];
    while (n.Count[side] == 0 && k > 1 && this->Shares[inner].Left[k] == 0)
    {
      --k;
    }
    if (n.Count[side] > 0 || k == 1)
    {
      children[count++] = { node, side };
      return;
    }
    this->Part(inner, this->Shares[inner].Left[k], k, children, count);
  }

  const Bvh& Binary;
  std::vector<Share> Shares;
};

namespace
{

/// Returns the triangles of a mesh that have an area.
std::vector<vtkTypeInt32> FindTriangles(const TriangleMesh& mesh)
{
  std::vector<vtkTypeInt32> triangles;
  triangles.reserve(static_cast<std::size_t>(mesh.GetNumberOfTriangles()));
  for (vtkTypeInt32 i = 0; i < mesh.GetNumberOfTriangles(); ++i)
  {
    if (SpansArea(mesh.GetCorner(i, 0), mesh.GetCorner(i, 1), mesh.GetCorner(i, 2)))
    {
      triangles.push_back(i);
    }
  }
  return triangles;
}

/// Returns whether all corners of a triangle are in a box.
bool IsInside(const TriangleMesh& mesh, vtkTypeInt32 triangle, const double box[6])
{
  bool isInside = true;
  for (int corner = 0; corner < 3; ++corner)
  {
    const double* p = mesh.GetCorner(triangle, corner);
    for (int axis = 0; axis < 3; ++axis)
    {
      isInside = isInside && p[axis] >= box[2 * axis] && p[axis] <= box[2 * axis + 1];
    }
  }
  return isInside;
}

bool CanBeBuilt(const TriangleMesh& mesh)
{
  return mesh.GetNumberOfTriangles() > 0 &&
    mesh.GetNumberOfTriangles() <= BeamTree::MaximumTriangles;
}

} // namespace

//------------------------------------------------------------------------------
void BeamTree::Build(const TriangleMesh& mesh, StopCheck& check)
{
  *this = BeamTree();
  this->Mesh = &mesh;
  if (CanBeBuilt(mesh))
  {
    double core[6];
    GetCoreBounds(mesh, core);
    std::vector<vtkTypeInt32> triangles = FindTriangles(mesh);
    this->BuildOutliers(triangles, core, check);
    this->BuildNodes(triangles, check);
  }
}

void BeamTree::BuildWhole(const TriangleMesh& mesh, StopCheck& check)
{
  *this = BeamTree();
  this->Mesh = &mesh;
  if (CanBeBuilt(mesh))
  {
    std::vector<vtkTypeInt32> triangles = FindTriangles(mesh);
    this->BuildNodes(triangles, check);
  }
}

/// Moves the triangles outside of a box to the outliers.
void BeamTree::BuildOutliers(
  std::vector<vtkTypeInt32>& inside, const double core[6], StopCheck& check)
{
  const auto outside = std::stable_partition(inside.begin(), inside.end(),
    [this, core](vtkTypeInt32 i) { return IsInside(*this->Mesh, i, core); });
  std::vector<vtkTypeInt32> outliers(outside, inside.end());
  inside.erase(outside, inside.end());
  this->OutliersExist = !outliers.empty();
  check.Poll();
  this->Outliers.Build(*this->Mesh, std::move(outliers), check);
}

/// Builds the tree over some triangles.
void BeamTree::BuildNodes(std::vector<vtkTypeInt32>& inside, StopCheck& check)
{
  if (inside.empty())
  {
    return;
  }
  double low[3], high[3];
  std::copy_n(this->Mesh->GetCorner(inside.front(), 0), 3, low);
  std::copy_n(low, 3, high);
  for (const vtkTypeInt32 i : inside)
  {
    for (int corner = 0; corner < 3; ++corner)
    {
      const double* p = this->Mesh->GetCorner(i, corner);
      for (int axis = 0; axis < 3; ++axis)
      {
        low[axis] = Min(low[axis], p[axis]);
        high[axis] = Max(high[axis], p[axis]);
      }
    }
  }
  this->SetFrame(low, high);
  Bvh binary;
  binary.Build(*this->Mesh, std::move(inside), check);
  this->MakeNode(binary, Collapse(binary, check), 0, check);
  this->Nodes.shrink_to_fit();
  this->Leaves.insert(this->Leaves.end(), LeafSize, 0); // vectors read past the end
  this->Leaves.shrink_to_fit();
}

void BeamTree::SetFrame(const double low[3], const double high[3])
{
  double largest = 0.0;
  for (int axis = 0; axis < 3; ++axis)
  {
    this->Centre[axis] = 0.5 * low[axis] + 0.5 * high[axis];
    this->Half[axis] =
      Max(high[axis] - this->Centre[axis], this->Centre[axis] - low[axis]) * (1 + 0x1p-23);
    largest = Max(largest, this->Half[axis]);
  }
  this->Scale = std::ldexp(1.0, -std::ilogb(largest) - 1);
}

void BeamTree::Build(const HeightField& field)
{
  *this = BeamTree();
  double b[6];
  field.GetBounds(b);
  const double low[3] = { b[0], b[2], b[4] };
  const double high[3] = { b[1], b[3], b[5] };
  this->SetFrame(low, high);
  this->Heights = std::make_shared<HeightTree>(field, this->Centre, this->Scale);
}

vtkTypeUInt32 BeamTree::MakeLeaf(const Bvh& binary, vtkTypeInt32 first, vtkTypeInt32 count)
{
  const auto made = static_cast<vtkTypeUInt32>(this->Leaves.size());
  const vtkTypeInt32* triangles = binary.Order.data() + first;
  this->Leaves.push_back(count);
  this->Leaves.insert(this->Leaves.end(), triangles, triangles + count);
  for (int k = 0; k < 9; ++k)
  {
    for (int i = 0; i < count; ++i)
    {
      const double x = this->Mesh->GetCorner(triangles[i], k / 3)[k % 3];
      const auto local = static_cast<float>(this->GetLocal(x, k % 3));
      vtkTypeInt32 bits;
      std::memcpy(&bits, &local, sizeof(bits));
      this->Leaves.push_back(bits);
    }
  }
  return made | LeafBit;
}

/// Creates a wide node from a binary one.
vtkTypeUInt32 BeamTree::MakeNode(
  const Bvh& binary, const Collapse& collapse, vtkTypeInt32 index, StopCheck& check)
{
  check.Count();
  Collapse::Child children[Width];
  const int count = collapse.GetChildren(index, children);
  const auto made = static_cast<vtkTypeUInt32>(this->Nodes.size());
  Node empty;
  std::fill_n(empty.Low[0], 3 * Width, Endless);
  std::fill_n(empty.High[0], 3 * Width, -Endless);
  std::fill_n(empty.Children, Width, 0);
  this->Nodes.push_back(empty);
  for (int i = 0; i < count; ++i)
  {
    const Bvh::Node& b = binary.Nodes[children[i].Node];
    const int side = children[i].Side;
    const vtkTypeUInt32 child = b.Count[side] > 0
      ? this->MakeLeaf(binary, b.First[side], b.Count[side])
      : this->MakeNode(binary, collapse, b.First[side], check);
    Node& n = this->Nodes[made]; // here, since creating nodes moves them
    for (int axis = 0; axis < 3; ++axis)
    {
      n.Low[axis][i] = RoundDown(this->GetLocal(b.Low[axis][side], axis));
      n.High[axis][i] = RoundUp(this->GetLocal(b.High[axis][side], axis));
    }
    n.Children[i] = child;
  }
  return made;
}

} // namespace helios
