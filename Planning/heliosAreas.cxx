// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosAreas.h"

#include <vtkCellArray.h>
#include <vtkPolyData.h>

#include <algorithm>

namespace helios
{

Areas::Areas(vtkPolyData* outlines)
{
  if (!outlines)
  {
    return;
  }
  for (vtkCellArray* cells : { outlines->GetPolys(), outlines->GetLines() })
  {
    for (vtkIdType cell = 0; cell < cells->GetNumberOfCells(); ++cell)
    {
      vtkIdType size;
      const vtkIdType* corners;
      cells->GetCellAtId(cell, size, corners);
      Outline outline{ {}, { 1e300, 1e300 }, { -1e300, -1e300 } };
      for (vtkIdType i = 0; i < size; ++i)
      {
        double p[3];
        outlines->GetPoint(corners[i], p);
        outline.Corners.push_back({ p[0], p[1] });
        for (int axis : { 0, 1 })
        {
          outline.Low[axis] = std::min(outline.Low[axis], p[axis]);
          outline.High[axis] = std::max(outline.High[axis], p[axis]);
        }
      }
      this->Outlines.push_back(outline);
    }
  }
}

bool Areas::Contain(double x, double y) const
{
  const Place p = { x, y };
  return std::any_of(this->Outlines.begin(), this->Outlines.end(),
    [&p](const Outline& outline) { return Contains(outline, p); });
}

bool Areas::Contains(const Outline& outline, const Place& p)
{
  if (p[0] < outline.Low[0] || p[0] > outline.High[0] || p[1] < outline.Low[1] ||
    p[1] > outline.High[1])
  {
    return false;
  }
  // A ray along x crosses the outline an odd number of times.
  bool isInside = false;
  const std::size_t count = outline.Corners.size();
  for (std::size_t i = 0; i < count; ++i)
  {
    const Place& a = outline.Corners[i];
    const Place& b = outline.Corners[(i + 1) % count];
    const double side = (b[0] - a[0]) * (p[1] - a[1]) - (p[0] - a[0]) * (b[1] - a[1]);
    if (side == 0.0 && p[0] >= std::min(a[0], b[0]) && p[0] <= std::max(a[0], b[0]) &&
      p[1] >= std::min(a[1], b[1]) && p[1] <= std::max(a[1], b[1]))
    {
      return true;
    }
    if ((a[1] > p[1]) != (b[1] > p[1]) && (side > 0.0) == (b[1] > a[1]))
    {
      isInside = !isInside;
    }
  }
  return isInside;
}

} // namespace helios
