// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Differences between the echoes of two runs.

#ifndef heliosTradeErrors_h
#define heliosTradeErrors_h

#include "vtkHeliosArrayNames.h"

#include <vtkDataArray.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace helios::bench
{

struct RunEcho
{
  double Range;
  double Amplitude;
};

/// The echoes of every pulse, sorted by range.
using RunEchoes = std::vector<std::vector<RunEcho>>;

inline RunEchoes GetEchoes(vtkPolyData* output, int pulses)
{
  namespace names = vtkHeliosArrayNames;
  RunEchoes echoes(static_cast<std::size_t>(pulses));
  vtkDataArray* ids = output->GetPointData()->GetArray(names::PulseIds);
  vtkDataArray* ranges = output->GetPointData()->GetArray(names::Range);
  vtkDataArray* amplitudes = output->GetPointData()->GetArray(names::Amplitude);
  for (vtkIdType i = 0; i < output->GetNumberOfPoints(); ++i)
  {
    echoes[static_cast<std::size_t>(ids->GetTuple1(i))].push_back(
      { ranges->GetTuple1(i), amplitudes->GetTuple1(i) });
  }
  return echoes;
}

struct TradeErrors
{
  double Missed = 0.0;       // unmatched echoes of the reference [%]
  double Extra = 0.0;        // echoes unmatched in the reference [%]
  double RangeBias = 0.0;    // [m], of matched echoes
  double RangeRms = 0.0;     // [m]
  double RangeP99 = 0.0;     // [m]
  double AmplitudeRms = 0.0; // relative

  /// Whether no error exceeds that of another method, or a negligible level.
  bool IsNoWorse(const TradeErrors& other, const TradeErrors& floor) const
  {
    return this->RangeRms <= std::max(other.RangeRms, floor.RangeRms) &&
      this->AmplitudeRms <= std::max(other.AmplitudeRms, floor.AmplitudeRms) &&
      this->Missed + this->Extra <=
      std::max(other.Missed + other.Extra, floor.Missed + floor.Extra);
  }
};

/// Matches are the nearest, within 0.6 of the least separation of two equal echoes, c sigma.
inline TradeErrors Compare(const RunEchoes& run, const RunEchoes& reference, double separation)
{
  TradeErrors errors;
  std::vector<double> away;
  double bias = 0.0, amplitude2 = 0.0;
  std::size_t expected = 0, given = 0;
  for (std::size_t pulse = 0; pulse < reference.size(); ++pulse)
  {
    std::vector<bool> taken(run[pulse].size(), false);
    expected += reference[pulse].size();
    given += run[pulse].size();
    for (const RunEcho& echo : reference[pulse])
    {
      std::size_t best = taken.size();
      double nearest = 0.6 * separation;
      for (std::size_t i = 0; i < taken.size(); ++i)
      {
        const double distance = std::abs(run[pulse][i].Range - echo.Range);
        if (!taken[i] && distance <= nearest)
        {
          nearest = distance;
          best = i;
        }
      }
      if (best < taken.size())
      {
        taken[best] = true;
        away.push_back(nearest);
        bias += run[pulse][best].Range - echo.Range;
        const double ratio = run[pulse][best].Amplitude / echo.Amplitude - 1.0;
        amplitude2 += ratio * ratio;
      }
    }
  }
  const auto found = static_cast<double>(away.size());
  double range2 = 0.0;
  for (const double distance : away)
  {
    range2 += distance * distance;
  }
  std::sort(away.begin(), away.end());
  errors.Missed = 100.0 * (static_cast<double>(expected) - found) / static_cast<double>(expected);
  errors.Extra = 100.0 * (static_cast<double>(given) - found) / static_cast<double>(expected);
  if (!away.empty())
  {
    errors.RangeBias = bias / found;
    errors.RangeRms = std::sqrt(range2 / found);
    errors.RangeP99 = away[away.size() * 99 / 100];
    errors.AmplitudeRms = std::sqrt(amplitude2 / found);
  }
  return errors;
}

} // namespace helios::bench

#endif
