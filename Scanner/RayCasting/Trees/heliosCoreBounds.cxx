// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosCoreBounds.h"

#include "heliosTriangleMesh.h"

#include <algorithm>
#include <cstddef>
#include <vector>

namespace helios
{

void GetCoreBounds(const TriangleMesh& mesh, double bounds[6])
{
  const vtkIdType count = 3 * mesh.GetNumberOfTriangles();
  const vtkIdType stride = 3 * (count / (3 << 16)) + 1; // samples first, second and third corners
  std::vector<double> values;
  double width = 0.0;
  for (int axis = 0; axis < 3; ++axis)
  {
    values.clear();
    for (vtkIdType i = 0; i < count; i += stride)
    {
      values.push_back(mesh.GetPoints()[3 * static_cast<vtkIdType>(mesh.GetCorners()[i]) + axis]);
    }
    const auto low = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 1024);
    const auto high = values.end() - 1 - (low - values.begin());
    std::nth_element(values.begin(), low, values.end());
    bounds[2 * axis] = *low;
    std::nth_element(low, high, values.end()); // moves what is at low, too
    bounds[2 * axis + 1] = *high;
    width = std::max(width, bounds[2 * axis + 1] - bounds[2 * axis]);
  }
  for (int axis = 0; axis < 3; ++axis)
  {
    bounds[2 * axis] -= 4 * width;
    bounds[2 * axis + 1] += 4 * width;
  }
}

} // namespace helios
