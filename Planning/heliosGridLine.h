// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Evenly spaced positions along one axis.

#ifndef heliosGridLine_h
#define heliosGridLine_h

#include <vtkType.h>

#include <algorithm>
#include <cmath>

namespace helios
{

/**
 * Positions one step apart, the first half a step above the lower end; none is on the upper end,
 * which may be the border of a scene. One in the middle if the interval is shorter than a step.
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
