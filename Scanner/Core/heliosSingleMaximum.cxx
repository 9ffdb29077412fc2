// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosSingleMaximum.h"

#include "heliosVectorLoops.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace helios
{
namespace
{

// Terms that are summed side by side, so that the compiler can use vector instructions.
constexpr std::size_t Lanes = 8;

/// exp(-y) for 0 <= y <= 8 to 1e-10, to the last bits for y <= 2: the series of its 64th root.
HELIOS_INLINE double ExpMinus(double y)
{
  const double z = std::min(y, 8.0) * (1 / 64.0);
  const double high = 1 / 24.0 - z * (1 / 120.0 - z * (1 / 720.0 - z * (1 / 5040.0)));
  double e = 1.0 - z * (1.0 - z * (1 / 2.0 - z * (1 / 6.0 - z * high)));
  for (int i = 0; i < 6; ++i)
  {
    e *= e;
  }
  return e;
}

double AddUp(const double lanes[Lanes])
{
  return std::accumulate(lanes, lanes + Lanes, 0.0);
}

} // namespace

/// Of the places about 0, not divided by the power.
struct SingleMaximum::Moments
{
  double Power, First, Second, Third;
};

/// The sum, and the sums of its terms times u and u^2, u = (x - x_k) / sigma.
struct SingleMaximum::Sums
{
  double W0, W1, W2;
};

void SingleMaximum::Open(std::size_t most)
{
  this->Count = 0;
  this->Places.resize(std::max(this->Places.size(), most + Lanes));
  this->Powers.resize(this->Places.size());
}

//------------------------------------------------------------------------------
/// Makes places relative to the first, and adds nothing there up to a full number of lanes.
HELIOS_CLONES
void SingleMaximum::FillLanes()
{
  this->First = this->Places[0];
  for (; this->Count % Lanes != 0; ++this->Count)
  {
    this->Places[this->Count] = this->First;
    this->Powers[this->Count] = 0.0;
  }
  for (std::size_t i = 0; i < this->Count; i += Lanes)
  {
    for (std::size_t k = 0; k < Lanes; ++k)
    {
      this->Places[i + k] -= this->First;
    }
  }
}

//------------------------------------------------------------------------------
HELIOS_CLONES
SingleMaximum::Moments SingleMaximum::GetMoments() const
{
  double power[Lanes] = {}, first[Lanes] = {}, second[Lanes] = {}, third[Lanes] = {};
  for (std::size_t i = 0; i < this->Count; i += Lanes)
  {
    for (std::size_t k = 0; k < Lanes; ++k)
    {
      const double x = this->Places[i + k];
      const double p = this->Powers[i + k];
      const double px = p * x;
      power[k] += p;
      first[k] += px;
      second[k] += px * x;
      third[k] += px * x * x;
    }
  }
  return { AddUp(power), AddUp(first), AddUp(second), AddUp(third) };
}

//------------------------------------------------------------------------------
HELIOS_CLONES
SingleMaximum::Sums SingleMaximum::GetSums(double place, double scale) const
{
  double w0[Lanes] = {}, w1[Lanes] = {}, w2[Lanes] = {};
  for (std::size_t i = 0; i < this->Count; i += Lanes)
  {
    for (std::size_t k = 0; k < Lanes; ++k)
    {
      const double u = (place - this->Places[i + k]) * scale;
      const double w = this->Powers[i + k] * ExpMinus(0.5 * u * u);
      w0[k] += w;
      w1[k] += w * u;
      w2[k] += w * u * u;
    }
  }
  return { AddUp(w0), AddUp(w1), AddUp(w2) };
}

//------------------------------------------------------------------------------
bool SingleMaximum::Find(double sigma, Result& result)
{
  this->FillLanes();
  const Moments m = this->GetMoments();
  if (!(m.Power > 0.0))
  {
    return false;
  }
  const double mean = m.First / m.Power;
  const double variance = std::max(0.0, m.Second / m.Power - mean * mean);

  // Newton on the logarithm of the sum. For a small spread the maximum lies at
  // mean - mu3 / (2 sigma^2) but for terms of its fifth power.
  const double scale = 1.0 / sigma;
  const bool isSmall = variance * scale * scale < 1e-2;
  const double mu3 = m.Third / m.Power - mean * (3.0 * variance + mean * mean);
  result = { isSmall ? mean - 0.5 * scale * scale * mu3 : mean, m.Power, variance };
  for (int iteration = 0; iteration < 50; ++iteration)
  {
    const Sums sums = this->GetSums(result.Place, scale);
    const double slope = sums.W1 / sums.W0;
    // 0 only for two halves two sigma apart
    const double curvature = 1.0 - (sums.W2 / sums.W0 - slope * slope);
    const double step = slope / std::max(curvature, 0.02);
    result.Value = sums.W0 * (1.0 + 0.5 * slope * step); // but for terms of step^3
    result.Place -= step / scale;
    if (std::abs(step) < 1e-5) // the next would be its square
    {
      break;
    }
  }
  result.Place += this->First;
  return true;
}

} // namespace helios
