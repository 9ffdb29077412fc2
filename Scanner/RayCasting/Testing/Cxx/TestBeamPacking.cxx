// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosBeamPacking.h"
#include "heliosRayCastingScenes.h"
#include "heliosTreeArray.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>

using helios::BeamNode;
using helios::Dice;
using helios::PackedFrame;
using helios::PackedNode;
using helios::PackedWord;
using helios::PlainBox;

namespace
{

int GetNumber(vtkTypeInt32 word, int axis)
{
  return word >> (PackedWord::Bits * axis) & PackedWord::Largest;
}

/// Boxes of about a size, around a place; each third one is flat along an axis.
void MakeBoxes(Dice& dice, double place, double size, PlainBox boxes[], int count)
{
  for (int i = 0; i < count; ++i)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      const double low = place + size * dice(-1, 1);
      const double width = (i + axis) % 3 == 0 ? 0.0 : size * dice();
      boxes[i].Low[axis] = static_cast<float>(low);
      boxes[i].High[axis] = std::max(boxes[i].Low[axis], static_cast<float>(low + width));
    }
  }
}

} // namespace

TEST_CASE(
  "BeamPacking: packed boxes hold the boxes with a margin, and are little larger", "[BeamPacking]")
{
  Dice dice;
  for (const double place : { 0.0, 1e-30, 0.7, -1.0, 1e-3 })
  {
    for (const double size : { 0.0, 1e-32, 1e-12, 1e-7, 1e-3, 0.3 })
    {
      const int count = 1 + static_cast<int>(dice() * BeamNode::Width);
      PlainBox boxes[BeamNode::Width];
      MakeBoxes(dice, place, size, boxes, count);
      PackedNode node;
      helios::PackBoxes(boxes, count, node);
      REQUIRE(node.GetCount() == count);
      for (int k = 0; k < 3 * count; ++k)
      {
        const int i = k / 3;
        const int axis = k % 3;
        const double step = node.Factors[axis] / static_cast<double>(PackedWord::Units[axis]);
        const double low = node.Origin[axis] + step * GetNumber(node.Low[i], axis);
        const double high = node.Origin[axis] + step * GetNumber(node.High[i], axis);
        const double margin = 0.99 * PackedNode::Margin * step;
        INFO("place " << place << ", size " << size << ", step " << step);
        CHECK(low <= boxes[i].Low[axis] - margin);
        CHECK(high >= boxes[i].High[axis] + margin);
        CHECK(low >= boxes[i].Low[axis] - 1.01 * step);
        CHECK(high <= boxes[i].High[axis] + 1.01 * step);
        const double length = 2 * size + std::abs(place) * 0x1p-20;
        CHECK(step <= std::max(0x1p-100, 3 * length / PackedWord::Largest));
      }
    }
  }
}

TEST_CASE("BeamPacking: packed corners are within half a step", "[BeamPacking]")
{
  Dice dice;
  for (const double size : { 0.0, 1e-9, 1e-4, 0.4 })
  {
    for (int count = 1; count <= helios::BeamLeaf::Size; ++count)
    {
      double corners[helios::BeamLeaf::Size][3][3];
      for (int k = 0; k < 9 * count; ++k)
      {
        corners[k / 9][k / 3 % 3][k % 3] = 0.3 + size * dice(-1, 1);
      }
      PackedFrame frame;
      vtkTypeUInt32 words[3 * helios::BeamLeaf::Size];
      helios::PackCorners(corners, count, frame, words);
      REQUIRE(frame.Count == count);
      for (int k = 0; k < 9 * count; ++k)
      {
        const int triangle = k / 9;
        const int corner = k / 3 % 3;
        const double step = frame.GetStep(k % 3);
        const int number =
          GetNumber(static_cast<vtkTypeInt32>(words[corner * count + triangle]), k % 3);
        const double x = frame.Origin[k % 3] + step * number;
        CHECK(std::abs(x - corners[triangle][corner][k % 3]) <= 0.5 * step);
        CHECK(step <= 2 * (2 * size + 0x1p-22) / PackedWord::Largest);
      }
    }
  }
}

TEST_CASE("BeamPacking: a tree array keeps its values, from a cache line on", "[BeamPacking]")
{
  helios::TreeArray<vtkTypeUInt32> array;
  CHECK(array.GetMemorySize() == 0);
  std::size_t size = 0;
  for (std::size_t next = 1; next < 3000000; next = next * 3 / 2 + 1)
  {
    array.Resize(next);
    CHECK(reinterpret_cast<std::uintptr_t>(&array[0]) % 64 == 0);
    for (; size < next; ++size)
    {
      array[size] = static_cast<vtkTypeUInt32>(7 * size);
    }
  }
  array.Resize(size / 3);
  array.Shrink();
  CHECK(array.GetMemorySize() == array.GetSize() * sizeof(vtkTypeUInt32));
  helios::TreeArray<vtkTypeUInt32> moved(std::move(array));
  bool isSame = true;
  for (std::size_t i = 0; i < moved.GetSize(); ++i)
  {
    isSame = isSame && moved[i] == static_cast<vtkTypeUInt32>(7 * i);
  }
  CHECK(isSame);
  moved = helios::TreeArray<vtkTypeUInt32>();
  CHECK(moved.GetMemorySize() == 0);
}
