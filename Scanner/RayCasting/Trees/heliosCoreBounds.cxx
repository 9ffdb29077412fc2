// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosCoreBounds.h"

#include "heliosTriangleMesh.h"

#include <algorithm>
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
    std::sort(values.begin(), values.end());
    bounds[2 * axis] = values[values.size() / 1024];
    bounds[2 * axis + 1] = values[values.size() - 1 - values.size() / 1024];
    width = std::max(width, bounds[2 * axis + 1] - bounds[2 * axis]);
  }
  for (int axis = 0; axis < 3; ++axis)
  {
    bounds[2 * axis] -= 4 * width;
    bounds[2 * axis + 1] += 4 * width;
  }
}

} // namespace helios
