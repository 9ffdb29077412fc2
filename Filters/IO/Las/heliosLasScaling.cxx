// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosLasScaling.h"

#include "heliosCoordinateSystem.h"
#include "heliosSceneCrs.h"

#include <vtkPoints.h>
#include <vtkPolyData.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace helios
{

namespace
{

constexpr double LargestNumber = 2147483647.0;
constexpr double Margin = 8.0; // in extents of the first block

/// Returns the nearest number to a power of ten.
double ToPower(int power)
{
  return power < 0 ? 1.0 / std::pow(10.0, -power) : std::pow(10.0, power);
}

/// Finds the finest power of ten, from one up, that can hold an extent.
int FindPower(double extent, int finest)
{
  int power = finest;
  while (Margin * extent > LargestNumber * ToPower(power))
  {
    ++power;
  }
  return power;
}

bool IsAngle(const CoordinateSystem& system, int axis)
{
  return system.IsSet() && system.IsGeographic() && axis < 2;
}

/// Returns the extents of finite points; the first one in whole units, or in thousandths of
/// degrees.
std::array<double, 3> Measure(
  vtkPoints* points, const CoordinateSystem& system, std::array<double, 3>& offset)
{
  constexpr double partsOfDegree = 1000.0;
  std::array<double, 3> extents{};
  const vtkIdType count = points ? points->GetNumberOfPoints() : 0;
  for (int axis = 0; axis < 3; ++axis)
  {
    double minimum = std::numeric_limits<double>::infinity();
    double maximum = -minimum;
    for (vtkIdType i = 0; i < count; ++i)
    {
      double point[3];
      points->GetPoint(i, point);
      minimum = std::isfinite(point[axis]) ? std::min(minimum, point[axis]) : minimum;
      maximum = std::isfinite(point[axis]) ? std::max(maximum, point[axis]) : maximum;
    }
    double first[3] = { 0.0, 0.0, 0.0 };
    if (count > 0)
    {
      points->GetPoint(0, first);
    }
    const double parts = IsAngle(system, axis) ? partsOfDegree : 1.0;
    offset[axis] =
      std::isfinite(first[axis]) ? std::round(parts * first[axis]) / parts + 0.0 : 0.0; // not -0
    extents[axis] = minimum <= maximum ? maximum - minimum : 0.0;
  }
  return extents;
}

/// Returns the step of an axis by its unit, no coarser than the given one.
double ChooseStep(const CoordinateSystem& system, int axis, double given, double extent)
{
  constexpr double finer = 0.5; // 1e-9 degrees are 0.1 mm
  const double resolution = GetResolution(system, axis);
  const bool isAngle = IsAngle(system, axis);
  const bool isFiner = given < (isAngle ? finer : 1.0) * resolution;
  if (!isAngle && !isFiner)
  {
    return resolution;
  }
  const int finest = static_cast<int>(std::floor(std::log10(isFiner ? given : resolution) + 1e-9));
  const double step = ToPower(FindPower(extent, finest));
  return isAngle ? step : std::min(step, resolution);
}

} // namespace

void ChooseLasScaling(
  vtkPolyData* points, const CoordinateSystem& system, double scale, LasScaling& scaling)
{
  const std::array<double, 3> extents = Measure(points->GetPoints(), system, scaling.Offset);
  const CoordinateSteps steps = GetCoordinateSteps(points);
  if (scale == 0.0)
  {
    constexpr int finest = -6;
    scale = ToPower(FindPower(*std::max_element(extents.begin(), extents.end()), finest));
  }
  scaling.Scale.fill(scale);
  if (scale == DefaultLasScale && steps.HasOffset)
  {
    scaling.Scale = steps.Scale;
    scaling.Offset = steps.Offset;
  }
  for (int axis = 0; scale == DefaultLasScale && !steps.HasOffset && axis < 3; ++axis)
  {
    scaling.Scale[axis] = ChooseStep(system, axis, steps.Scale[axis], extents[axis]);
  }
}

} // namespace helios
