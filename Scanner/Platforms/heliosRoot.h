// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef heliosRoot_h
#define heliosRoot_h

#include <cmath>

namespace helios
{

/// Returns the zero of a continuous function between a and b, where it has opposite signs: regula
/// falsi with the Illinois weighting, bisection where that is slow.
template <typename FunctionT>
double FindRoot(const FunctionT& f, double a, double b)
{
  double fa = f(a);
  double fb = f(b);
  if (fa == 0.0 || fb == 0.0 || (fa > 0.0) == (fb > 0.0))
  {
    return std::abs(fa) < std::abs(fb) ? a : b;
  }
  for (int i = 0; i < 200; ++i)
  {
    const bool halve = i % 4 == 3 || !std::isfinite(fa) || !std::isfinite(fb);
    double c = halve ? 0.5 * (a + b) : (a * fb - b * fa) / (fb - fa);
    if (!(c > std::fmin(a, b)) || !(c < std::fmax(a, b)))
    {
      c = 0.5 * (a + b);
    }
    if (c == a || c == b)
    {
      break;
    }
    const double fc = f(c);
    if (fc == 0.0)
    {
      return c;
    }
    if ((fc > 0.0) == (fb > 0.0))
    {
      fa *= 0.5;
    }
    else
    {
      a = b;
      fa = fb;
    }
    b = c;
    fb = fc;
    if (std::abs(b - a) <= 4e-16 * std::fmax(std::abs(a), std::abs(b)))
    {
      break;
    }
  }
  return b;
}

} // namespace helios

#endif
