// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// The pulses of a leg, and the steps of parts that they see.

#ifndef heliosPulseClock_h
#define heliosPulseClock_h

#include "heliosMotionData.h"
#include "vtkHeliosScannerSurveyModule.h" // For export macro

#include <vtkType.h>

namespace helios
{

/// Pulse times of a leg: pulse i leaves at StartTime + i / Rate, as pulse FirstShot + i of the run.
struct PulseClock
{
  vtkIdType FirstShot = 0; ///< pulses of a channel in the legs before
  double StartTime = 0.0;  ///< [s]
  double Rate = 1.0;       ///< [Hz]
};

/// Returns the motion step of a part at a pulse of a leg.
VTKHELIOSSCANNERSURVEY_EXPORT vtkIdType FindSeenStep(
  const MotionData& motion, const PulseClock& clock, vtkIdType pulse);

/// Returns the first pulse of a leg, from 0, after a step of a part.
VTKHELIOSSCANNERSURVEY_EXPORT vtkIdType FindPulseOfStep(
  const MotionData& motion, const PulseClock& clock, vtkIdType step);

} // namespace helios

#endif
