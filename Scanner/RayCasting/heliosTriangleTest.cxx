// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosTriangleTest.h"

#include <algorithm>
#include <cmath>

namespace helios
{

namespace
{

/// A number as an unevaluated sum, and the exact sums and products that give one.
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

/// a b - c d, to twice the precision of double before the last rounding.
double DifferenceOfProducts(TwoDoubles a, TwoDoubles b, TwoDoubles c, TwoDoubles d)
{
  const TwoDoubles ab = Product(a.High, b.High);
  const TwoDoubles cd = Product(c.High, d.High);
  const TwoDoubles difference = Sum(ab.High, -cd.High);
  const double rest = (a.High * b.Low + a.Low * b.High) - (c.High * d.Low + c.Low * d.High);
  return difference.High + (difference.Low + ((ab.Low - cd.Low) + rest));
}

/// Whether (b - a) x (c - a) is zero in the plane of two axes: six exact products added exactly.
bool IsStraight(const double* a, const double* b, const double* c, int x, int y)
{
  const double factors[6][2] = { { a[x], b[y] }, { -a[y], b[x] }, { b[x], c[y] }, { -b[y], c[x] },
    { c[x], a[y] }, { -c[y], a[x] } };
  double sum[12]; // an expansion (Shewchuk 1997): zero if and only if all of it is
  int length = 0;
  for (const auto& factor : factors)
  {
    const TwoDoubles product = Product(factor[0], factor[1]);
    for (double term : { product.Low, product.High })
    {
      for (int i = 0; i < length; ++i)
      {
        const TwoDoubles partial = Sum(sum[i], term);
        sum[i] = partial.Low;
        term = partial.High;
      }
      sum[length++] = term;
    }
  }
  return std::all_of(sum, sum + length, [](double part) { return part == 0.0; });
}

/// The same from the rounded differences, with Shewchuk's bound: true only if surely not straight.
bool IsSurelyBent(const double* a, const double* b, const double* c, int x, int y)
{
  const double left = (b[x] - a[x]) * (c[y] - a[y]);
  const double right = (b[y] - a[y]) * (c[x] - a[x]);
  return std::abs(left - right) > 0x1p-51 * (std::abs(left) + std::abs(right));
}

} // namespace

bool HasArea(const double* p0, const double* p1, const double* p2)
{
  return IsSurelyBent(p0, p1, p2, 0, 1) || IsSurelyBent(p0, p1, p2, 1, 2) ||
    IsSurelyBent(p0, p1, p2, 2, 0) || !IsStraight(p0, p1, p2, 0, 1) ||
    !IsStraight(p0, p1, p2, 1, 2) || !IsStraight(p0, p1, p2, 2, 0);
}

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
