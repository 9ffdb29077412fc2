// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosPulseClock.h"

#include "heliosPulseCount.h"

#include <algorithm>
#include <cmath>

namespace helios
{

//------------------------------------------------------------------------------
vtkIdType FindPulseOfStep(const MotionData& motion, const PulseClock& clock, vtkIdType step)
{
  if (motion.Seconds > 0.0)
  {
    const double time = static_cast<double>(step) * motion.Seconds - clock.StartTime;
    return CountPulses(time, clock.Rate);
  }
  const bool isNever = step > VTK_ID_MAX / motion.Pulses;
  return isNever ? VTK_ID_MAX : std::max<vtkIdType>(0, step * motion.Pulses - clock.FirstShot);
}

//------------------------------------------------------------------------------
vtkIdType FindSeenStep(const MotionData& motion, const PulseClock& clock, vtkIdType pulse)
{
  vtkIdType step = 0;
  if (motion.Seconds > 0.0)
  {
    const double time = clock.StartTime + static_cast<double>(pulse) / clock.Rate;
    step = static_cast<vtkIdType>(std::max(0.0, std::round(time / motion.Seconds)));
    while (step > 0 && FindPulseOfStep(motion, clock, step) > pulse)
    {
      --step; // the pulse counts, not the rounded time
    }
  }
  else
  {
    step = (clock.FirstShot + pulse) / motion.Pulses;
  }
  return step / motion.Every * motion.Every;
}

} // namespace helios
