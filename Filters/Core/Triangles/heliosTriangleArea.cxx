// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosTriangleArea.h"

#include <algorithm>
#include <cmath>

namespace helios
{

namespace
{

/// Adds a number to an expansion, an unevaluated sum of numbers: exact.
void Grow(double* expansion, int& length, double term)
{
  for (int i = 0; i < length; ++i)
  {
    const double sum = expansion[i] + term;
    const double termPart = sum - expansion[i];
    expansion[i] = (expansion[i] - (sum - termPart)) + (term - termPart);
    term = sum;
  }
  expansion[length++] = term;
}

/// Whether (b - a) x (c - a) is zero in the plane of two axes: six products, added exactly.
bool IsStraight(const double* a, const double* b, const double* c, int x, int y)
{
  const double factors[6][2] = { { a[x], b[y] }, { -a[y], b[x] }, { b[x], c[y] }, { -b[y], c[x] },
    { c[x], a[y] }, { -c[y], a[x] } };
  double sum[12];
  int length = 0;
  for (const auto& factor : factors)
  {
    const double product = factor[0] * factor[1];
    Grow(sum, length, std::fma(factor[0], factor[1], -product));
    Grow(sum, length, product);
  }
  return std::all_of(sum, sum + length, [](double part) { return part == 0.0; });
}

/// Same test with rounded differences: true only if certainly not collinear.
bool IsSurelyBent(const double* a, const double* b, const double* c, int x, int y)
{
  const double left = (b[x] - a[x]) * (c[y] - a[y]);
  const double right = (b[y] - a[y]) * (c[x] - a[x]);
  return std::abs(left - right) > 0x1p-51 * (std::abs(left) + std::abs(right));
}

} // namespace

bool SpansArea(const double a[3], const double b[3], const double c[3])
{
  return IsSurelyBent(a, b, c, 0, 1) || IsSurelyBent(a, b, c, 1, 2) ||
    IsSurelyBent(a, b, c, 2, 0) || !IsStraight(a, b, c, 0, 1) || !IsStraight(a, b, c, 1, 2) ||
    !IsStraight(a, b, c, 2, 0);
}

} // namespace helios
