// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosConfidence.h"

#include <algorithm>
#include <cmath>

namespace helios
{
namespace
{

constexpr double NormalQuantile = 1.959963984540054; // 97.5 %
constexpr double Tail = 0.025;

/// Returns the logarithm of the binomial probability of k hits in n trials.
double LogBinomial(double k, double n, double p)
{
  return std::lgamma(n + 1.0) - std::lgamma(k + 1.0) - std::lgamma(n - k + 1.0) + k * std::log(p) +
    (n - k) * std::log1p(-p);
}

} // namespace

//------------------------------------------------------------------------------
Estimate EstimateFraction(vtkIdType hits, vtkIdType trials)
{
  if (trials <= 0)
  {
    return { 0.0, 0.0, 1.0 };
  }
  const auto n = static_cast<double>(trials);
  const double p = static_cast<double>(std::clamp<vtkIdType>(hits, 0, trials)) / n;
  const double z2 = NormalQuantile * NormalQuantile;
  const double middle = (p + z2 / (2.0 * n)) / (1.0 + z2 / n);
  const double half =
    NormalQuantile * std::sqrt(p * (1.0 - p) / n + z2 / (4.0 * n * n)) / (1.0 + z2 / n);
  // exact at the ends, where rounding is not
  return { p, hits <= 0 ? 0.0 : std::max(0.0, middle - half),
    hits >= trials ? 1.0 : std::min(1.0, middle + half) };
}

//------------------------------------------------------------------------------
Estimate EstimateQuantile(const std::vector<double>& sorted, double quantile)
{
  if (sorted.empty())
  {
    return {};
  }
  const auto n = static_cast<double>(sorted.size());
  const std::size_t last = sorted.size() - 1;
  // The number of values below the quantile is binomial.
  double below = 0.0;
  std::size_t lower = 0;
  std::size_t upper = last;
  for (std::size_t k = 0; k <= last; ++k)
  {
    below += std::exp(LogBinomial(static_cast<double>(k), n, quantile));
    lower = below <= Tail ? k : lower;
    if (below >= 1.0 - Tail)
    {
      upper = k;
      break;
    }
  }
  const auto middle = static_cast<std::size_t>(quantile * static_cast<double>(last));
  return { sorted[middle], sorted[std::min(lower, middle)], sorted[std::max(upper, middle)] };
}

//------------------------------------------------------------------------------
Estimate EstimateRms(const std::vector<double>& deviations)
{
  if (deviations.empty())
  {
    return {};
  }
  const auto n = static_cast<double>(deviations.size());
  double sum = 0.0;
  for (const double deviation : deviations)
  {
    sum += deviation * deviation;
  }
  const double mean = sum / n;
  double spread = 0.0;
  for (const double deviation : deviations)
  {
    spread += std::pow(deviation * deviation - mean, 2);
  }
  const double half = n > 1.0 ? NormalQuantile * std::sqrt(spread / (n - 1.0) / n) : mean;
  return { std::sqrt(mean), std::sqrt(std::max(0.0, mean - half)), std::sqrt(mean + half) };
}

} // namespace helios
