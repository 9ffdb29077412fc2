// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// What a run has counted.

#ifndef heliosRunCounts_h
#define heliosRunCounts_h

#include <vtkType.h>

#include <algorithm>

namespace helios
{

struct RunCounts
{
  vtkIdType Pulses = 0; ///< of the legs' pulse times
  vtkIdType Echoes = 0;
  vtkIdType FirstReturns = 0;
  vtkIdType PulsesFired = 0;
  vtkIdType PulsesHit = 0;         ///< a surface in the ranges that are measured
  vtkIdType PulsesOnPlane = 0;     ///< their beam met one plane: in closed form
  vtkIdType PulsesWithoutBins = 0; ///< their maxima were found without bins
  vtkIdType PulsesBinned = 0;
  vtkIdType SubRays = 0;         ///< traced
  vtkIdType HitsOutOfRange = 0;  ///< of sub-rays
  double LargestAmplitude = 0.0; ///< [W], detected or not

  /// Adds those of other pulses.
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
