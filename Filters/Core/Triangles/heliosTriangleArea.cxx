// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosTriangleArea.h"

#include <algorithm>
#include <cmath>
#include <limits>

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

/// Returns the sign of (b - a) x (c - a) in the plane of two axes, as its leading part: six
/// products, added exactly.
double ComputeExactTurn(const double* a, const double* b, const double* c, int x, int y)
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
  while (length > 0 && sum[length - 1] == 0.0)
  {
    --length;
  }
  return length > 0 ? sum[length - 1] : 0.0; // no other part is as large
}

bool IsStraight(const double* a, const double* b, const double* c, int x, int y)
{
  return ComputeExactTurn(a, b, c, x, y) == 0.0;
}

/// Returns whether three points are certainly not collinear, by rounded differences.
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

//------------------------------------------------------------------------------
/// Returns whether three points are collinear; each coordinate and each operation has a rounding
/// error of half an ulp.
bool IsFlat(const double a[3], const double b[3], const double c[3])
{
  constexpr double unit = std::numeric_limits<double>::epsilon() / 2.0;
  double u[3], v[3], uError[3], vError[3];
  for (int i = 0; i < 3; ++i)
  {
    u[i] = b[i] - a[i];
    v[i] = c[i] - a[i];
    uError[i] = 4.0 * unit * (std::abs(a[i]) + std::abs(b[i]));
    vError[i] = 4.0 * unit * (std::abs(a[i]) + std::abs(c[i]));
  }
  static constexpr int planes[3][2] = { { 0, 1 }, { 1, 2 }, { 2, 0 } };
  for (const auto& [i, j] : planes)
  {
    const double cross = u[i] * v[j] - u[j] * v[i];
    const double error = uError[i] * std::abs(v[j]) + std::abs(u[i]) * vError[j] +
      uError[j] * std::abs(v[i]) + std::abs(u[j]) * vError[i];
    if (!(std::abs(cross) <= error))
    {
      return false;
    }
  }
  return true;
}

//------------------------------------------------------------------------------
double ComputeTurn(const double a[2], const double b[2], const double c[2])
{
  constexpr double bound = 0x1.8000000000004p-52; // Shewchuk's, of the rounded determinant
  const double left = (b[0] - a[0]) * (c[1] - a[1]);
  const double right = (b[1] - a[1]) * (c[0] - a[0]);
  const double turn = left - right;
  return std::abs(turn) > bound * (std::abs(left) + std::abs(right))
    ? turn
    : ComputeExactTurn(a, b, c, 0, 1);
}

} // namespace helios
