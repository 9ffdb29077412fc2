// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma GCC diagnostic ignored "-Wpsabi" // vectors are passed to inlined functions only
#include "heliosBoxRefit.h"

#include "heliosRayVectors.h"
#include "heliosTriangleMesh.h"

#include <algorithm>

namespace helios
{

namespace
{

HELIOS_INLINE Doubles GetSize(const Doubles& x)
{
  return Max<Doubles>(x, -x);
}

/// Returns, per lane, a power of two of which so many steps are at least a length.
HELIOS_INLINE Floats GetSteps(const Floats& length, float steps)
{
  constexpr float smallest = 0x1p-100f; // smaller ones are no shorter in effect
  const Floats least = Max<Floats>(length * ((1 + 0x1p-20f) / steps), Floats() + smallest);
  const ShortMasks bits = reinterpret_cast<ShortMasks>(least);
  const ShortMasks next = (bits & 0x7f800000) + 0x00800000;
  return reinterpret_cast<Floats>(next);
}

/// Returns the inverse of powers of two.
HELIOS_INLINE Floats GetInverse(const Floats& steps)
{
  const ShortMasks bits = (254 << 23) - reinterpret_cast<ShortMasks>(steps);
  return reinterpret_cast<Floats>(bits);
}

HELIOS_INLINE int PackNumbers(const Floats& numbers)
{
  const ShortMasks whole = __builtin_convertvector(numbers, ShortMasks); // to zero: down
  return whole[0] | whole[1] << PackedWord::Bits | whole[2] << 2 * PackedWord::Bits;
}

/// The boxes of the children of a node, as numbers: see PackBoxes().
struct NodePacking
{
  // Exceeds the rounding of numbers here, too.
  static constexpr float Margin = static_cast<float>(PackedNode::Margin) + 0x1p-12f;

  Floats Origin;
  Floats Inverse;

  HELIOS_INLINE void Set(const Floats& low, const Floats& high, PackedNode& node)
  {
    constexpr float steps = PackedWord::Largest - 2; // the margins take two
    const Floats units = { PackedWord::Units[0], PackedWord::Units[1], PackedWord::Units[2], 0.0f };
    const Floats first = low - 2 * Margin * GetSteps(high - low, steps);
    this->Origin = first - Max<Floats>(first, -first) * 0x1p-22f;
    const Floats size = GetSteps(high - this->Origin, steps);
    this->Inverse = GetInverse(size);
    const float count = node.Factors[3];
    Store(node.Origin, this->Origin);
    Store(node.Factors, size * units);
    node.Origin[3] = 0.0f;
    node.Factors[3] = count;
  }
  HELIOS_INLINE int PackLow(const Floats& low) const
  {
    return PackNumbers(Max<Floats>((low - this->Origin) * this->Inverse - Margin, Floats()));
  }
  HELIOS_INLINE int PackHigh(const Floats& high) const
  {
    const Floats number = (high - this->Origin) * this->Inverse + (1 + Margin);
    return PackNumbers(Min<Floats>(number, Floats() + static_cast<float>(PackedWord::Largest)));
  }
};

/// The box of a point between two fractions, in the frame of a tree.
struct PointFit
{
  Doubles Centre;
  double Scale;
  double First;
  double Last;

  HELIOS_INLINE void Run(const Doubles& from, const Doubles& to, float* low, float* high) const
  {
    const Doubles way = to - from; // the arithmetic of MeshShape::Interpolate()
    const Doubles a = from + this->First * way;
    const Doubles b = from + this->Last * way;
    const Doubles least = (Min(a, b) - this->Centre) * this->Scale;
    const Doubles most = (Max(a, b) - this->Centre) * this->Scale;
    Store(low, __builtin_convertvector(least - GetSize(least) * 0x1p-23, Floats));
    Store(high, __builtin_convertvector(most + GetSize(most) * 0x1p-23, Floats));
  }
};

} // namespace

//------------------------------------------------------------------------------
void RefitOrder::Set(const BeamStorage& tree, const TriangleMesh& mesh)
{
  std::vector<vtkTypeUInt32> waiting{ tree.Root };
  while (!waiting.empty())
  {
    const vtkTypeUInt32 number = waiting.back();
    waiting.pop_back();
    this->Nodes.push_back(number);
    const PackedNode& node = tree.Nodes[number];
    for (int i = 0; i < node.GetCount(); ++i)
    {
      if (!(node.Children[i] & BeamNode::LeafBit))
      {
        waiting.push_back(node.Children[i]);
      }
    }
  }
  std::reverse(this->Nodes.begin(), this->Nodes.end());
  for (const vtkTypeUInt32 number : this->Nodes)
  {
    const PackedNode& node = tree.Nodes[number];
    for (int i = 0; i < node.GetCount(); ++i)
    {
      if (node.Children[i] & BeamNode::LeafBit)
      {
        const BeamLeaf leaf = tree.GetLeaf(node.Children[i] & ~BeamNode::LeafBit);
        this->Counts.push_back(static_cast<unsigned char>(leaf.Count));
        for (int k = 0; k < leaf.Count; ++k)
        {
          const vtkTypeInt32* corners =
            mesh.GetCorners() + 3 * static_cast<vtkIdType>(leaf.Triangles[k]);
          this->Corners.insert(this->Corners.end(), corners, corners + 3);
        }
      }
    }
  }
}

//------------------------------------------------------------------------------
HELIOS_CLONES
void BoxRefit::FitPoints(const MeshShape& shape, vtkIdType count, double low, double high,
  const TreeFrame& frame, Box* boxes)
{
  const PointFit fit{ { frame.Centre[0], frame.Centre[1], frame.Centre[2], 0.0 }, frame.Scale, low,
    high };
  for (vtkIdType i = 0; i + 1 < count; ++i)
  {
    fit.Run(Load<Doubles>(shape.From + 3 * i), Load<Doubles>(shape.To + 3 * i), boxes[i].Low,
      boxes[i].High);
  }
  const double* from = shape.From + 3 * (count - 1); // a vector would end beyond it
  const double* to = shape.To + 3 * (count - 1);
  fit.Run(Doubles{ from[0], from[1], from[2], 0.0 }, Doubles{ to[0], to[1], to[2], 0.0 },
    boxes[count - 1].Low, boxes[count - 1].High);
}

//------------------------------------------------------------------------------
HELIOS_CLONES
void BoxRefit::FitNodes(const RefitOrder& order, const Box* points, Box* nodes, BeamStorage& tree)
{
  const unsigned char* counts = order.Counts.data();
  const vtkTypeInt32* corner = order.Corners.data();
  Floats lows[BeamNode::Width], highs[BeamNode::Width];
  for (const vtkTypeUInt32 number : order.Nodes)
  {
    PackedNode& node = tree.Nodes[number];
    const int count = node.GetCount();
    Floats low = Floats() + 1e30f;
    Floats high = Floats() - 1e30f;
    for (int i = 0; i < count; ++i)
    {
      const vtkTypeUInt32 child = node.Children[i];
      if (child & BeamNode::LeafBit)
      {
        const vtkTypeInt32* end = corner + 3 * *counts++;
        lows[i] = Load<Floats>(points[*corner].Low);
        highs[i] = Load<Floats>(points[*corner].High);
        for (++corner; corner < end; ++corner)
        {
          lows[i] = Min(lows[i], Load<Floats>(points[*corner].Low));
          highs[i] = Max(highs[i], Load<Floats>(points[*corner].High));
        }
      }
      else
      {
        lows[i] = Load<Floats>(nodes[child].Low);
        highs[i] = Load<Floats>(nodes[child].High);
      }
      low = Min(low, lows[i]);
      high = Max(high, highs[i]);
    }
    Store(nodes[number].Low, low);
    Store(nodes[number].High, high);
    NodePacking packing;
    packing.Set(low, high, node);
    for (int i = 0; i < count; ++i)
    {
      node.Low[i] = packing.PackLow(lows[i]);
      node.High[i] = packing.PackHigh(highs[i]);
    }
  }
}

//------------------------------------------------------------------------------
void BoxRefit::Run(const RefitOrder& order, const MeshShape& shape, vtkIdType numberOfPoints,
  double low, double high, const TreeFrame& frame, BeamStorage& tree)
{
  this->Points.resize(static_cast<std::size_t>(numberOfPoints));
  this->Nodes.resize(tree.Nodes.GetSize());
  FitPoints(shape, numberOfPoints, low, high, frame, this->Points.data());
  FitNodes(order, this->Points.data(), this->Nodes.data(), tree);
}

} // namespace helios
