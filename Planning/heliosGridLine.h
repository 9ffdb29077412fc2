// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Evenly spaced places along one axis.

#ifndef heliosGridLine_h
#define heliosGridLine_h

#include <vtkType.h>

#include <algorithm>
#include <cmath>

namespace helios
{

/**
 * Places a step apart from half a step inside the lower end on; none lies on the upper end, which may
 * be the border of a scene. One in the middle where the way is shorter than a step.
 */
class GridLine
{
public:
  GridLine(double low, double high, double step)
    : First(high - low < step ? 0.5 * (low + high) : low + 0.5 * step)
    , Step(step)
    , Count(std::max<vtkIdType>(
        1, static_cast<vtkIdType>(std::ceil((high - this->First) / step - 1e-9))))
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
