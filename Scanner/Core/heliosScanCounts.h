// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// The counts of a scan or a run, from the kernels to the summary of a run.

#ifndef heliosScanCounts_h
#define heliosScanCounts_h

#include "heliosErrorTerms.h"

#include <vtkType.h>

#include <algorithm>
#include <string>

namespace helios
{

/// Sums over pulses, independent of threads. A new count is a member and a row of CountNames.
struct ScanCounts
{
  vtkIdType Pulses = 0; ///< pulse indices of the legs, emitted or not; of runs only
  vtkIdType Echoes = 0;
  vtkIdType FirstReturns = 0; ///< runs only
  vtkIdType PulsesFired = 0;
  vtkIdType PulsesHit = 0;     ///< with a surface in the range gate
  vtkIdType PulsesOnPlane = 0; ///< with a planar footprint: in closed form
  vtkIdType PulsesSampled = 0; ///< adaptive, by samples: too many surfaces in the beam
  /// sampled pulses for which the largest number of samples was not enough
  vtkIdType PulsesUnresolved = 0;
  vtkIdType PulsesWithoutBins = 0; ///< pulses whose maxima were found by Newton's method
  vtkIdType PulsesBinned = 0;
  vtkIdType SubRays = 0;         ///< traced, or returns of visible parts
  vtkIdType HitsOutOfRange = 0;  ///< sub-rays that hit a surface outside the range gate
  vtkIdType CutWaveforms = 0;    ///< for a warning; not in summaries
  double LargestAmplitude = 0.0; ///< largest of the returned signals, detected or not [W]
  TermFaults Faults;             ///< faults of the error model

  void Add(const ScanCounts& other);
};

/// A count and its name in summaries, journals and GetCount().
struct CountName
{
  const char* Name;
  vtkIdType ScanCounts::*Count;
};

constexpr CountName CountNames[] = {
  { "pulses", &ScanCounts::Pulses },
  { "points", &ScanCounts::Echoes },
  { "firstReturns", &ScanCounts::FirstReturns },
  { "pulsesFired", &ScanCounts::PulsesFired },
  { "pulsesHit", &ScanCounts::PulsesHit },
  { "pulsesOnPlane", &ScanCounts::PulsesOnPlane },
  { "pulsesSampled", &ScanCounts::PulsesSampled },
  { "pulsesUnresolved", &ScanCounts::PulsesUnresolved },
  { "pulsesWithoutBins", &ScanCounts::PulsesWithoutBins },
  { "pulsesBinned", &ScanCounts::PulsesBinned },
  { "subRays", &ScanCounts::SubRays },
  { "hitsOutOfRange", &ScanCounts::HitsOutOfRange },
};

inline void ScanCounts::Add(const ScanCounts& other)
{
  for (const CountName& count : CountNames)
  {
    this->*count.Count += other.*count.Count;
  }
  this->CutWaveforms += other.CutWaveforms;
  this->LargestAmplitude = std::max(this->LargestAmplitude, other.LargestAmplitude);
  for (std::size_t term = 0; term < this->Faults.size(); ++term)
  {
    this->Faults[term].Add(other.Faults[term]);
  }
}

/// Returns the names of all counts, separated by blanks.
inline std::string GetCountNames()
{
  std::string names;
  for (const CountName& count : CountNames)
  {
    names += (names.empty() ? "" : " ") + std::string(count.Name);
  }
  return names;
}

/// Returns a count by its name; -1 for any other name.
inline vtkIdType GetCount(const ScanCounts& counts, const std::string& name)
{
  for (const CountName& count : CountNames)
  {
    if (name == count.Name)
    {
      return counts.*count.Count;
    }
  }
  return -1;
}

} // namespace helios

#endif
