// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// The counts of a run.

#ifndef heliosRunCounts_h
#define heliosRunCounts_h

#include <vtkType.h>

#include <algorithm>

namespace helios
{

struct RunCounts
{
  vtkIdType Pulses = 0; ///< pulse times of the legs
  vtkIdType Echoes = 0;
  vtkIdType FirstReturns = 0;
  vtkIdType PulsesFired = 0;
  vtkIdType PulsesHit = 0;         ///< with a surface within the measured ranges
  vtkIdType PulsesOnPlane = 0;     ///< with a planar footprint: in closed form
  vtkIdType PulsesWithoutBins = 0; ///< with maxima found without bins
  vtkIdType PulsesBinned = 0;
  vtkIdType SubRays = 0;         ///< traced
  vtkIdType HitsOutOfRange = 0;  ///< of sub-rays
  double LargestAmplitude = 0.0; ///< [W], detected or not

  /// Adds the counts of other pulses.
  void Add(const RunCounts& other)
  {
    this->Pulses += other.Pulses;
    this->Echoes += other.Echoes;
    this->FirstReturns += other.FirstReturns;
    this->PulsesFired += other.PulsesFired;
    this->PulsesHit += other.PulsesHit;
    this->PulsesOnPlane += other.PulsesOnPlane;
    this->PulsesWithoutBins += other.PulsesWithoutBins;
    this->PulsesBinned += other.PulsesBinned;
    this->SubRays += other.SubRays;
    this->HitsOutOfRange += other.HitsOutOfRange;
    this->LargestAmplitude = std::max(this->LargestAmplitude, other.LargestAmplitude);
  }
};

} // namespace helios

#endif
