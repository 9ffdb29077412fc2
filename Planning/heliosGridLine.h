// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Evenly spaced places along one axis.

#ifndef heliosGridLine_h
#define heliosGridLine_h

#include <vtkType.h>

#include <cmath>

namespace helios
{

/**
 * Places a step apart from half a step inside the lower end on, so that none lies on the border of a
 * scene; one in the middle where the way is shorter than a step.
 */
class GridLine
{
public:
  GridLine(double low, double high, double step)
    : First(high - low < step ? 0.5 * (low + high) : low + 0.5 * step)
    , Step(step)
    // A place on the upper end, but for rounding, counts.
    , Count(1 + static_cast<vtkIdType>(std::floor((high - this->First) / step + 1e-9)))
  {
  }

  vtkIdType GetCount() const { return this->Count; }
  double GetPlace(vtkIdType i) const { return this->First + static_cast<double>(i) * this->Step; }

private:
  double First;
  double Step;
  vtkIdType Count;
};

} // namespace helios

#endif
