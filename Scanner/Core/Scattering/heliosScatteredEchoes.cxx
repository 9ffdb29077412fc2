// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosScatteredEchoes.h"

#include "heliosConstants.h"

#include <algorithm>
#include <cstddef>
#include <limits>

namespace helios
{
namespace
{

constexpr double MinimumErrors = 3.0; // smallest rise, in standard errors
constexpr double MinimumShare = 0.5;  // smallest share of scattered light in an echo
constexpr int PlacesBetween = 8;      // where the signal between two echoes is known

/// Computes the scattered light at ranges, and how far it rises between them.
class ScatteredSignal
{
public:
  ScatteredSignal(const ScatteredProfile& profile, const PulseShape& shape)
    : Profile(profile)
    , Shape(shape)
  {
  }

  ScatteredPower Get(double range) const
  {
    return this->Profile.GetPower(
      this->GetFrom(range), this->GetTo(range), [&](double r) { return this->GetShape(range, r); });
  }

  /// Returns the rise from a lower signal, in standard errors.
  double GetRise(double range, double low) const
  {
    const ScatteredPower rise =
      this->Profile.GetPower(std::min(this->GetFrom(range), this->GetFrom(low)),
        std::max(this->GetTo(range), this->GetTo(low)),
        [&](double r) { return this->GetShape(range, r) - this->GetShape(low, r); });
    return rise.Power / std::max(rise.Error, std::numeric_limits<double>::min());
  }

  /// Returns the rise of an echo above the lowest signal before another.
  double GetRiseBetween(double range, double other) const
  {
    double low = range;
    double lowest = std::numeric_limits<double>::infinity();
    for (int i = 1; i <= PlacesBetween; ++i)
    {
      const double place = range + (other - range) * i / (PlacesBetween + 1);
      const double power = this->Get(place).Power;
      low = power < lowest ? place : low;
      lowest = std::min(lowest, power);
    }
    return this->GetRise(range, low);
  }

private:
  /// Returns the pulse of a return at a range, relative to its peak.
  double GetShape(double range, double ofReturn) const
  {
    return this->Shape(2.0 / SpeedOfLight * (range - ofReturn));
  }
  double GetFrom(double range) const { return range - 0.5 * SpeedOfLight * this->Shape.GetEnd(); }
  double GetTo(double range) const { return range - 0.5 * SpeedOfLight * this->Shape.GetStart(); }

  const ScatteredProfile& Profile;
  const PulseShape& Shape;
};

/// Returns the least rise of an echo above what is beside it.
double GetCertainty(
  const ScatteredSignal& signal, const std::vector<Echo>& echoes, std::size_t index)
{
  const Echo& echo = echoes[index];
  const ScatteredPower scattered = signal.Get(echo.Range);
  if (scattered.Power < MinimumShare * echo.Amplitude)
  {
    return std::numeric_limits<double>::infinity();
  }
  double least = scattered.Power / std::max(scattered.Error, std::numeric_limits<double>::min());
  if (index > 0)
  {
    least = std::min(least, signal.GetRiseBetween(echo.Range, echoes[index - 1].Range));
  }
  if (index + 1 < echoes.size())
  {
    least = std::min(least, signal.GetRiseBetween(echo.Range, echoes[index + 1].Range));
  }
  return least;
}

} // namespace

//------------------------------------------------------------------------------
ScatteredPower GetScatteredPower(
  const ScatteredProfile& profile, const PulseShape& shape, bool isSum, double range)
{
  constexpr double all = std::numeric_limits<double>::infinity();
  return isSum ? profile.GetPower(-all, all, [](double) { return 1.0; })
               : ScatteredSignal(profile, shape).Get(range);
}

//------------------------------------------------------------------------------
void DropUncertainEchoes(
  const ScatteredProfile& profile, const PulseShape& shape, std::vector<Echo>& echoes)
{
  const ScatteredSignal signal(profile, shape);
  for (bool hasDropped = !profile.GetReturns().empty(); hasDropped;)
  {
    double least = MinimumErrors;
    std::size_t uncertain = echoes.size();
    for (std::size_t i = 0; i < echoes.size(); ++i)
    {
      const double certainty = GetCertainty(signal, echoes, i);
      if (certainty < least)
      {
        least = certainty;
        uncertain = i;
      }
    }
    hasDropped = uncertain < echoes.size();
    if (hasDropped)
    {
      echoes.erase(echoes.begin() + static_cast<std::ptrdiff_t>(uncertain));
    }
  }
}

} // namespace helios
