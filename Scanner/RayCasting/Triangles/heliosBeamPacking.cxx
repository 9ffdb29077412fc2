// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosBeamPacking.h"

#include <limits>

namespace helios
{

namespace
{

constexpr float Endless = std::numeric_limits<float>::max();
constexpr int SmallestExponent = -100; // exponent of a step; smaller ones are no shorter in effect
constexpr int ExponentBias = 127;      // bias of floats

/// Returns the exponent of a power of two, of which so many steps are at least a length.
int GetExponent(double length, int steps)
{
  const double step = length / steps;
  return step > 0.0 ? std::max(std::ilogb(step) + 1, SmallestExponent) : SmallestExponent;
}

/// Packs the sides of children along an axis.
void PackSides(const PlainBox* boxes, int count, int axis, PackedNode& node)
{
  constexpr double margin = PackedNode::Margin;
  constexpr int steps = PackedWord::Largest - 2; // the margins take two
  double low = Endless;
  double high = -Endless;
  for (int i = 0; i < count; ++i)
  {
    low = std::min<double>(low, boxes[i].Low[axis]);
    high = std::max<double>(high, boxes[i].High[axis]);
  }
  const float origin =
    RoundDown(low - 2 * margin * std::ldexp(1.0, GetExponent(high - low, steps)));
  const double step = std::ldexp(1.0, GetExponent(high - origin, steps));
  node.Origin[axis] = origin;
  node.Factors[axis] = static_cast<float>(step) * PackedWord::Units[axis];
  for (int i = 0; i < count; ++i)
  {
    const double from =
      std::floor((boxes[i].Low[axis] - static_cast<double>(origin)) / step - margin);
    const double to =
      std::ceil((boxes[i].High[axis] - static_cast<double>(origin)) / step + margin);
    node.Low[i] |= static_cast<int>(std::max(from, 0.0)) << (PackedWord::Bits * axis);
    node.High[i] |= static_cast<int>(std::min<double>(to, PackedWord::Largest))
      << (PackedWord::Bits * axis);
  }
}

} // namespace

void PackBoxes(const PlainBox* boxes, int count, PackedNode& node)
{
  node.Origin[3] = 0.0f;
  node.Factors[3] = static_cast<float>(count);
  std::fill_n(node.Low, BeamNode::Width, 0);
  std::fill_n(node.High, BeamNode::Width, 0);
  for (int axis = 0; axis < 3; ++axis)
  {
    PackSides(boxes, count, axis, node);
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
    const float origin = RoundDown(low);
    const int exponent = GetExponent(high - origin, PackedWord::Largest);
    frame.Origin[axis] = origin;
    frame.Exponents[axis] = static_cast<unsigned char>(exponent + ExponentBias);
    const double inverse = std::ldexp(1.0, -exponent);
    for (int i = 0; i < 3 * count; ++i)
    {
      const double number = (corners[i % count][i / count][axis] - origin) * inverse;
      words[i] |= static_cast<vtkTypeUInt32>(number + 0.5) << (PackedWord::Bits * axis);
    }
  }
}

} // namespace helios
