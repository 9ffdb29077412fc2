// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Whether coordinates in single precision hold the shapes that they are of.

#ifndef heliosFloatCoordinates_h
#define heliosFloatCoordinates_h

#include "heliosStatus.h"

#include <vtkDataArray.h>
#include <vtkFloatArray.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

namespace helios
{

/**
 * Refuses float coordinates of a thing far from the origin, where neighbouring floats are farther
 * apart than a millimetre and than a millionth of the whole extent. In UTM they are half a metre
 * apart. vtkPoints is float by default.
 */
inline Status CheckFloatCoordinates(vtkDataArray* coordinates, const char* thing)
{
  auto* floats = vtkFloatArray::FastDownCast(coordinates);
  if (!floats)
  {
    return {};
  }
  float largest = 0.0F;
  double extent = 0.0;
  const vtkIdType count = floats->GetNumberOfTuples();
  const float* values = floats->GetPointer(0);
  for (int axis = 0; axis < 3; ++axis)
  {
    float low = std::numeric_limits<float>::max();
    float high = -low;
    for (vtkIdType i = 0; i < count; ++i)
    {
      const float value = values[3 * i + axis]; // a NaN changes nothing
      low = std::min(low, value);
      high = std::max(high, value);
    }
    if (low <= high)
    {
      largest = std::max({ largest, std::abs(low), std::abs(high) });
      extent = std::max(extent, static_cast<double>(high) - low);
    }
  }
  constexpr double minimum = 1e-3;
  const double step =
    static_cast<double>(std::nextafter(largest, std::numeric_limits<float>::infinity())) - largest;
  if (!(step > minimum && step > 1e-6 * extent))
  {
    return {};
  }
  std::ostringstream text;
  text << thing << " has float coordinates of up to " << largest << " m, where they are " << step
       << " m apart; give it double coordinates (vtkPoints::SetDataTypeToDouble()), or subtract an "
          "offset from all inputs";
  return Status::Error(text.str());
}

} // namespace helios

#endif
