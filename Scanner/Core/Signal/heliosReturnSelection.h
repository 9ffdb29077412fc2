// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Selects the returns of a pulse for the echoes of a waveform, for the scanner and the filters.

#ifndef heliosReturnSelection_h
#define heliosReturnSelection_h

#include "heliosConstants.h"
#include "vtkHeliosInstrument.h"

#include <algorithm>
#include <cstddef>
#include <vector>

namespace helios
{

/// The maximum of ReturnNumber.
constexpr std::size_t MaximumReturns = 255;

/// Returns the range of an echo [m], from two-way times [ns]: the waveform's start, and the echo's
/// after it.
inline double GetRange(double startTime, double time)
{
  return 0.5 * SpeedOfLight * (startTime + time);
}

/**
 * Selects the echoes of a pulse that are kept, given in order of range: a selection of
 * vtkHeliosInstrument, and of these the first maximum ones (0: all).
 */
template <typename EchoT>
void SelectReturns(
  const std::vector<EchoT>& echoes, int selection, int maximum, std::vector<std::size_t>& kept)
{
  kept.clear();
  if (echoes.empty())
  {
    return;
  }
  const std::size_t last = echoes.size() - 1;
  const auto isWeaker = [](const EchoT& a, const EchoT& b) { return a.Amplitude < b.Amplitude; };
  switch (selection)
  {
    case vtkHeliosInstrument::FIRST:
      kept.push_back(0);
      break;
    case vtkHeliosInstrument::LAST:
      kept.push_back(last);
      break;
    case vtkHeliosInstrument::STRONGEST:
      kept.push_back(static_cast<std::size_t>(
        std::max_element(echoes.begin(), echoes.end(), isWeaker) - echoes.begin()));
      break;
    case vtkHeliosInstrument::FIRST_AND_LAST:
      kept.push_back(0);
      if (last > 0)
      {
        kept.push_back(last);
      }
      break;
    default:
      for (std::size_t i = 0; i <= last; ++i)
      {
        kept.push_back(i);
      }
  }
  const std::size_t most = maximum > 0 ? static_cast<std::size_t>(maximum) : MaximumReturns;
  kept.resize(std::min({ kept.size(), most, MaximumReturns }));
}

} // namespace helios

#endif
