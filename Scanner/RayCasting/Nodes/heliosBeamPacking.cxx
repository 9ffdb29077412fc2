// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosBeamPacking.h"

#include <limits>

namespace helios
{

namespace
{

constexpr float Endless = std::numeric_limits<float>::max();
constexpr int SmallestExponent = -100; // of a step; smaller ones are no shorter in effect
constexpr int ExponentBias = 127;      // of floats

/// Sets the origin and the step of an axis, so that the numbers reach from low to high.
void SetSteps(PackedFrame& frame, int axis, float low, double high)
{
  const double step = (high - low) / PackedFrame::Largest;
  const int exponent = step > 0.0 ? std::ilogb(step) + 1 : SmallestExponent;
  frame.Origin[axis] = low;
  frame.Exponents[axis] =
    static_cast<unsigned char>(std::max(exponent, SmallestExponent) + ExponentBias);
}

/// Returns a number along an axis as the traversal decodes it.
float Decode(const PackedFrame& frame, int axis, vtkTypeUInt32 number)
{
  return frame.Origin[axis] + static_cast<float>(number) * frame.GetStep(axis);
}

/// Returns the largest number not above x, and the smallest not below it.
vtkTypeUInt32 EncodeDown(const PackedFrame& frame, int axis, float x)
{
  const double steps =
    (static_cast<double>(x) - frame.Origin[axis]) / frame.GetStep(axis);
  auto number = static_cast<vtkTypeUInt32>(
    std::min(std::max(std::floor(steps), 0.0), static_cast<double>(PackedFrame::Largest)));
  while (number > 0 && Decode(frame, axis, number) > x)
  {
    --number;
  }
  return number;
}
vtkTypeUInt32 EncodeUp(const PackedFrame& frame, int axis, float x)
{
  const double steps =
    (static_cast<double>(x) - frame.Origin[axis]) / frame.GetStep(axis);
  auto number = static_cast<vtkTypeUInt32>(
    std::min(std::max(std::ceil(steps), 0.0), static_cast<double>(PackedFrame::Largest)));
  while (number < PackedFrame::Largest && Decode(frame, axis, number) < x)
  {
    ++number;
  }
  return number;
}

} // namespace

void PackBoxes(const PlainBox* boxes, int count, PackedNode& node)
{
  node.Frame.Count = static_cast<unsigned char>(count);
  std::fill_n(node.Low, BeamNode::Width, 0u);
  std::fill_n(node.High, BeamNode::Width, 0u);
  for (int axis = 0; axis < 3; ++axis)
  {
    float low = Endless;
    float high = -Endless;
    for (int i = 0; i < count; ++i)
    {
      low = std::min(low, boxes[i].Low[axis]);
      high = std::max(high, boxes[i].High[axis]);
    }
    SetSteps(node.Frame, axis, low, high);
    const int shift = PackedFrame::Bits * axis;
    for (int i = 0; i < count; ++i)
    {
      node.Low[i] |= EncodeDown(node.Frame, axis, boxes[i].Low[axis]) << shift;
      node.High[i] |= EncodeUp(node.Frame, axis, boxes[i].High[axis]) << shift;
    }
  }
}

void PackCorners(const double (*corners)[3][3], int count, PackedFrame& frame, vtkTypeUInt32* words)
{
  frame.Count = static_cast<unsigned char>(count);
  std::fill_n(words, 3 * count, 0u);
  for (int axis = 0; axis < 3; ++axis)
  {
    double low = Endless;
    double high = -Endless;
    for (int i = 0; i < 3 * count; ++i)
    {
      low = std::min(low, corners[i / 3][i % 3][axis]);
      high = std::max(high, corners[i / 3][i % 3][axis]);
    }
    SetSteps(frame, axis, RoundDown(low), high);
    const double step = frame.GetStep(axis);
    for (int i = 0; i < 3 * count; ++i)
    {
      const double x = corners[i % count][i / count][axis];
      const double number = std::floor((x - frame.Origin[axis]) / step + 0.5);
      words[i] |= std::min(static_cast<vtkTypeUInt32>(number), PackedFrame::Largest)
        << (PackedFrame::Bits * axis);
    }
  }
}

} // namespace helios
