// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Differences between the echoes of two runs.

#ifndef heliosTradeErrors_h
#define heliosTradeErrors_h

#include "heliosEchoComparison.h"
#include "heliosStatus.h"
#include "vtkHeliosArrayNames.h"

#include <vtkDataArray.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <iostream>
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

  /// Returns whether no error exceeds the error of another method, or a negligible level.
  bool IsNoWorse(const TradeErrors& other, const TradeErrors& floor) const
  {
    return this->RangeRms <= std::max(other.RangeRms, floor.RangeRms) &&
      this->AmplitudeRms <= std::max(other.AmplitudeRms, floor.AmplitudeRms) &&
      this->Missed + this->Extra <=
      std::max(other.Missed + other.Extra, floor.Missed + floor.Extra);
  }
};

/// Ends the program after an error.
inline void Require(const Status& status)
{
  if (!status.IsOk())
  {
    std::cerr << status.Message() << "\n";
    std::exit(1);
  }
}

/// Matches are the nearest, within 0.6 of the least separation of two equal echoes, c sigma.
inline TradeErrors Compare(vtkPolyData* run, vtkPolyData* reference, double separation)
{
  EchoMatching matching;
  matching.Distance = 0.6 * separation;
  EchoComparison comparison;
  Require(comparison.Add(run, reference, matching));
  const EchoErrors errors = comparison.GetErrors();
  return { 100.0 * errors.Missed.Value, 100.0 * errors.Invented.Value, errors.RangeBias,
    errors.RangeRms.Value, errors.RangeP99, errors.AmplitudeRms.Value };
}

} // namespace helios::bench

#endif
