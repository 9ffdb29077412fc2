// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// What a run has counted.

#ifndef heliosRunCounts_h
#define heliosRunCounts_h

#include <vtkType.h>

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
};

} // namespace helios

#endif
