// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosVoxelSums.h"

#include <vtkMath.h>

namespace helios
{

namespace
{

/// Returns the direction of two opposite ones that points up; of horizontal ones that to +y, else
/// to +x.
Vec3 TurnUp(const Vec3& normal)
{
  for (const int axis : { 2, 1, 0 })
  {
    if (normal[axis] != 0.0)
    {
      return normal[axis] > 0.0 ? normal : normal * -1.0;
    }
  }
  return normal;
}

} // namespace

void PlaneSum::Add(const double local[3])
{
  std::int64_t v[3];
  for (int axis = 0; axis < 3; ++axis)
  {
    v[axis] = GetNearest(local[axis] * 0x1p30);
    this->Sums[axis] += v[axis];
  }
  Wide* product = this->Products;
  for (int row = 0; row < 3; ++row)
  {
    for (int column = row; column < 3; ++column)
    {
      *product++ += static_cast<Wide>(v[row]) * v[column];
    }
  }
  ++this->Count;
}

Vec3 PlaneSum::GetNormal() const
{
  double covariance[3][3];
  const Wide* product = this->Products;
  for (int row = 0; row < 3; ++row)
  {
    for (int column = row; column < 3; ++column)
    {
      const Wide moment =
        this->Count * *product++ - static_cast<Wide>(this->Sums[row]) * this->Sums[column];
      covariance[row][column] = covariance[column][row] = static_cast<double>(moment);
    }
  }
  double* matrix[3] = { covariance[0], covariance[1], covariance[2] };
  double vectors[3][3];
  double* columns[3] = { vectors[0], vectors[1], vectors[2] };
  double spread[3]; // descending
  vtkMath::Jacobi(matrix, spread, columns);
  constexpr double line = 1e-12; // share of the squared length: above the rounding of coordinates
  if (spread[1] <= line * spread[0])
  {
    return Vec3(0.0, 0.0, 0.0);
  }
  return TurnUp(GetUnit({ vectors[0][2], vectors[1][2], vectors[2][2] }));
}

} // namespace helios
