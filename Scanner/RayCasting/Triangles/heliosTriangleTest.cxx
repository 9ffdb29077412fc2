// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosTriangleTest.h"

#include <cmath>

namespace helios
{

namespace
{

/// A number as an unevaluated sum, with exact sums and products.
struct TwoDoubles
{
  double High;
  double Low;
};

TwoDoubles Sum(double a, double b)
{
  const double sum = a + b;
  const double bPart = sum - a;
  return { sum, (a - (sum - bPart)) + (b - bPart) };
}

TwoDoubles Product(double a, double b)
{
  const double product = a * b;
  return { product, std::fma(a, b, -product) };
}

/// Returns a b - c d, to twice the precision of double before the last rounding.
double DifferenceOfProducts(TwoDoubles a, TwoDoubles b, TwoDoubles c, TwoDoubles d)
{
  const TwoDoubles ab = Product(a.High, b.High);
  const TwoDoubles cd = Product(c.High, d.High);
  const TwoDoubles difference = Sum(ab.High, -cd.High);
  const double rest = (a.High * b.Low + a.Low * b.High) - (c.High * d.Low + c.Low * d.High);
  return difference.High + (difference.Low + ((ab.Low - cd.Low) + rest));
}

} // namespace

void GetFlatNormal(const double* const points[3], int pivot, double normal[3])
{
  const double* p = points[pivot];
  TwoDoubles a[3], b[3];
  for (int axis = 0; axis < 3; ++axis)
  {
    a[axis] = Sum(p[axis], -points[(pivot + 2) % 3][axis]);
    b[axis] = Sum(points[(pivot + 1) % 3][axis], -p[axis]);
  }
  for (int axis = 0; axis < 3; ++axis)
  {
    const int y = (axis + 1) % 3;
    const int z = (axis + 2) % 3;
    normal[axis] = DifferenceOfProducts(a[y], b[z], a[z], b[y]);
  }
}

int GetSignOfTie(double a, double b, double c, double d)
{
  const double left = a * b;
  const double right = c * d;
  const double leftError = std::fma(a, b, -left);
  const double rightError = std::fma(c, d, -right);
  return (leftError > rightError) - (leftError < rightError);
}

} // namespace helios
