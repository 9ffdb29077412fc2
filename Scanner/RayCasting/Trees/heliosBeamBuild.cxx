// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma GCC diagnostic ignored "-Wpsabi" // vectors are passed to inlined functions only
#include "heliosBeamTree.h"

#include "heliosBeamBuilder.h"
#include "heliosBoxRefit.h"
#include "heliosCoreBounds.h"
#include "heliosHeightTree.h"
#include "heliosThreadLoop.h"
#include "heliosTriangleArea.h"

#include <vtkSMPTools.h>

#include <algorithm>
#include <cstring>
#include <limits>

namespace helios
{

namespace
{

constexpr double Endless = std::numeric_limits<double>::infinity();
constexpr vtkIdType BlockSize = 1 << 16; ///< triangles that a thread visits at once

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

/// Returns whether a triangle has an area.
bool HasArea(const TriangleMesh& mesh, vtkTypeInt32 i)
{
  return SpansArea(mesh.GetCorner(i, 0), mesh.GetCorner(i, 1), mesh.GetCorner(i, 2));
}

bool CanBeBuilt(const TriangleMesh& mesh)
{
  return mesh.GetNumberOfTriangles() > 0 &&
    mesh.GetNumberOfTriangles() <= BeamTree::MaximumTriangles;
}

/// Calls visit(i, last) for the blocks of triangles, on all threads, in rounds between checks for a
/// stop.
template <typename VisitT>
void VisitBlocks(const TriangleMesh& mesh, StopCheck& check, VisitT visit)
{
  const vtkIdType count = mesh.GetNumberOfTriangles();
  const vtkIdType blocks = (count + BlockSize - 1) / BlockSize;
  const vtkIdType round = 16 * vtkSMPTools::GetEstimatedNumberOfThreads();
  for (vtkIdType first = 0; first < blocks; first += round)
  {
    check.Poll();
    LoopOnThreads(first, std::min(blocks, first + round),
      [&](vtkIdType begin, vtkIdType end)
      {
        for (vtkIdType i = begin; i < end; ++i)
        {
          visit(static_cast<std::size_t>(i), std::min(count, (i + 1) * BlockSize));
        }
      });
  }
}

} // namespace

/// Consecutive triangles: those that have an area and are inside a box, and outliers.
struct BeamTree::Block
{
  vtkIdType Count = 0; ///< number of the former
  double Low[3] = { Endless, Endless, Endless };
  double High[3] = { -Endless, -Endless, -Endless };
  std::vector<vtkTypeInt32> Outliers;

  void Add(const TriangleMesh& mesh, vtkTypeInt32 triangle, const double box[6])
  {
    if (!HasArea(mesh, triangle))
    {
      return;
    }
    if (!IsInside(mesh, triangle, box))
    {
      this->Outliers.push_back(triangle);
      return;
    }
    ++this->Count;
    for (int k = 0; k < 9; ++k)
    {
      const double x = mesh.GetCorner(triangle, k / 3)[k % 3];
      this->Low[k % 3] = Min(this->Low[k % 3], x);
      this->High[k % 3] = Max(this->High[k % 3], x);
    }
  }
};

//------------------------------------------------------------------------------
void BeamTree::Build(const TriangleMesh& mesh, StopCheck& check)
{
  *this = BeamTree();
  this->Mesh = &mesh;
  if (CanBeBuilt(mesh))
  {
    double core[6];
    GetCoreBounds(mesh, core);
    this->BuildNodes(core, check, LeafSize);
  }
}

void BeamTree::BuildWhole(const TriangleMesh& mesh, StopCheck& check, int leafSize)
{
  *this = BeamTree();
  this->Mesh = &mesh;
  if (CanBeBuilt(mesh))
  {
    const double all[6] = { -Endless, Endless, -Endless, Endless, -Endless, Endless };
    this->BuildNodes(all, check, leafSize);
  }
}

/// Builds the tree over the triangles in a box, and that of the others.
void BeamTree::BuildNodes(const double box[6], StopCheck& check, int leafSize)
{
  const TriangleMesh& mesh = *this->Mesh;
  std::vector<Block> blocks(
    static_cast<std::size_t>((mesh.GetNumberOfTriangles() + BlockSize - 1) / BlockSize));
  VisitBlocks(mesh, check,
    [&](std::size_t block, vtkIdType last)
    {
      for (auto i = static_cast<vtkIdType>(block) * BlockSize; i < last; ++i)
      {
        blocks[block].Add(mesh, static_cast<vtkTypeInt32>(i), box);
      }
    });
  Block all;
  std::vector<vtkIdType> starts; // places of the triangles of a block in the tree
  for (const Block& each : blocks)
  {
    starts.push_back(all.Count);
    all.Count += each.Count;
    all.Outliers.insert(all.Outliers.end(), each.Outliers.begin(), each.Outliers.end());
    for (int axis = 0; axis < 3; ++axis)
    {
      all.Low[axis] = Min(all.Low[axis], each.Low[axis]);
      all.High[axis] = Max(all.High[axis], each.High[axis]);
    }
  }
  this->OutliersExist = !all.Outliers.empty();
  this->Outliers.Build(mesh, std::move(all.Outliers), check);
  if (all.Count == 0)
  {
    return;
  }
  this->Frame.Set(all.Low, all.High);
  BeamBuilder builder(mesh, this->Frame, all.Count, leafSize);
  VisitBlocks(mesh, check,
    [&](std::size_t block, vtkIdType last)
    {
      vtkIdType next = starts[block];
      for (auto i = static_cast<vtkIdType>(block) * BlockSize; i < last; ++i)
      {
        const auto triangle = static_cast<vtkTypeInt32>(i);
        if (HasArea(mesh, triangle) && IsInside(mesh, triangle, box))
        {
          builder.SetTriangle(next++, triangle);
        }
      }
    });
  builder.Build(this->Storage, check);
}

//------------------------------------------------------------------------------
void BeamTree::BuildShape(const TriangleMesh& mesh, const std::vector<vtkTypeInt32>& triangles,
  const double bounds[6], StopCheck& check)
{
  *this = BeamTree();
  this->Mesh = &mesh;
  const double low[3] = { bounds[0], bounds[2], bounds[4] };
  const double high[3] = { bounds[1], bounds[3], bounds[5] };
  if (!CanBeBuilt(mesh) || triangles.empty())
  {
    return;
  }
  this->Frame.Set(low, high);
  BeamBuilder builder(mesh, this->Frame, static_cast<vtkIdType>(triangles.size()), LeafSize);
  for (std::size_t i = 0; i < triangles.size(); ++i)
  {
    builder.SetTriangle(static_cast<vtkIdType>(i), triangles[i]);
  }
  builder.Build(this->Storage, check);
  this->OpenLeaves();
}

/// Packs corners in steps so large that LeafFilter keeps all triangles.
void BeamTree::OpenLeaves()
{
  constexpr unsigned char exponent = 127 + 40; // 2^40 times the size of the tree
  constexpr std::size_t head = sizeof(PackedFrame) / sizeof(vtkTypeUInt32);
  for (std::size_t i = 0; i < this->Storage.Nodes.GetSize(); ++i)
  {
    const PackedNode& node = this->Storage.Nodes[i];
    for (int child = 0; child < node.GetCount(); ++child)
    {
      if (node.Children[child] & LeafBit)
      {
        vtkTypeUInt32* words = &this->Storage.Leaves[node.Children[child] & ~LeafBit];
        PackedFrame frame = {};
        std::memcpy(&frame, words, sizeof(frame));
        std::fill_n(frame.Origin, 3, 0.0f);
        std::fill_n(frame.Exponents, 3, exponent);
        std::memcpy(words, &frame, sizeof(frame));
        std::fill_n(words + head + frame.Count, 3 * frame.Count, 0u);
      }
    }
  }
}

//------------------------------------------------------------------------------
void BeamTree::CopyShape(const BeamTree& other, const MeshShape& shape)
{
  *this = BeamTree();
  this->Mesh = other.Mesh;
  this->Frame = other.Frame;
  this->Storage.Nodes.Copy(other.Storage.Nodes);
  this->Storage.Leaves.Copy(other.Storage.Leaves);
  this->Storage.Root = other.Storage.Root;
  this->IsComputed = true;
  this->Shape = &shape;
}

//------------------------------------------------------------------------------
void BeamTree::Fit(const RefitOrder& order, double low, double high, BoxRefit& refit)
{
  refit.Run(
    order, *this->Shape, this->Mesh->GetNumberOfPoints(), low, high, this->Frame, this->Storage);
}

//------------------------------------------------------------------------------
void BeamTree::Build(const HeightField& field)
{
  *this = BeamTree();
  double b[6];
  field.GetBounds(b);
  const double low[3] = { b[0], b[2], b[4] };
  const double high[3] = { b[1], b[3], b[5] };
  this->Frame.Set(low, high);
  this->IsComputed = true;
  this->Heights = std::make_shared<HeightTree>(field, this->Frame.Centre, this->Frame.Scale);
}

} // namespace helios
