// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma GCC diagnostic ignored "-Wpsabi" // vectors are passed to inlined functions only
#include "heliosSingleMaximum.h"

#include "heliosRayVectors.h"

#include <algorithm>
#include <cmath>

namespace helios
{
namespace
{

constexpr std::size_t Lanes = QuadWidth; // terms summed in parallel

/// Returns exp(-y) for 0 <= y <= 8 to 1e-10, to the last bits for y <= 2: the series of its 64th
/// root.
HELIOS_INLINE Doubles ExpMinus(const Doubles& y)
{
  const Doubles z = Min<Doubles>(y, Doubles() + 8.0) * (1 / 64.0);
  const Doubles high = 1 / 24.0 - z * (1 / 120.0 - z * (1 / 720.0 - z * (1 / 5040.0)));
  Doubles e = 1.0 - z * (1.0 - z * (1 / 2.0 - z * (1 / 6.0 - z * high)));
  for (int i = 0; i < 6; ++i)
  {
    e *= e;
  }
  return e;
}

/// Returns the sum of all lanes, adjacent ones first.
HELIOS_INLINE double AddUp(const Doubles& v)
{
  return (v[0] + v[1]) + (v[2] + v[3]);
}

} // namespace

/// Moments of the places about 0, not divided by the power.
struct SingleMaximum::Moments
{
  double Power, First, Second, Third;
};

/// The sum, and the sums of its terms times u and u^2, u = (x - x_k) / sigma.
struct SingleMaximum::Sums
{
  double W0, W1, W2;
};

void SingleMaximum::Open(std::size_t maximum)
{
  this->Count = 0;
  this->Places.resize(std::max(this->Places.size(), maximum + Lanes));
  this->Powers.resize(this->Places.size());
}

//------------------------------------------------------------------------------
/// Makes places relative to the first, and pads the lanes with zeros.
HELIOS_CLONES
void SingleMaximum::FillLanes()
{
  this->First = this->Places[0];
  for (; this->Count % Lanes != 0; ++this->Count)
  {
    this->Places[this->Count] = this->First;
    this->Powers[this->Count] = 0.0;
  }
  for (std::size_t i = 0; i < this->Count; ++i)
  {
    this->Places[i] -= this->First;
  }
}

//------------------------------------------------------------------------------
HELIOS_CLONES
SingleMaximum::Moments SingleMaximum::GetMoments() const
{
  Doubles power = {}, first = {}, second = {}, third = {};
  for (std::size_t i = 0; i < this->Count; i += Lanes)
  {
    const Doubles x = Load<Doubles>(&this->Places[i]);
    const Doubles p = Load<Doubles>(&this->Powers[i]);
    const Doubles px = p * x;
    const Doubles pxx = px * x;
    power += p;
    first += px;
    second += pxx;
    third += pxx * x;
  }
  return { AddUp(power), AddUp(first), AddUp(second), AddUp(third) };
}

//------------------------------------------------------------------------------
HELIOS_CLONES
SingleMaximum::Sums SingleMaximum::GetSums(double place, double scale) const
{
  Doubles w0 = {}, w1 = {}, w2 = {};
  for (std::size_t i = 0; i < this->Count; i += Lanes)
  {
    const Doubles u = (place - Load<Doubles>(&this->Places[i])) * scale;
    const Doubles w = Load<Doubles>(&this->Powers[i]) * ExpMinus(0.5 * u * u);
    w0 += w;
    w1 += w * u;
    w2 += w * u * u;
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

  // Newton's method on the logarithm of the sum. For a small spread the maximum
  // is at mean - mu3 / (2 sigma^2), up to terms of its fifth power.
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
    result.Value = sums.W0 * (1.0 + 0.5 * slope * step); // up to terms of step^3
    result.Place -= step / scale;
    if (std::abs(step) < 1e-5) // the next step would be its square
    {
      break;
    }
  }
  result.Place += this->First;
  return true;
}

} // namespace helios
