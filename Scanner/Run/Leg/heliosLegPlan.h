// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Platform positions over time, with one clock for all legs.

#ifndef heliosLegPlan_h
#define heliosLegPlan_h

#include "heliosMakePlatform.h"
#include "heliosPulseCount.h"
#include "heliosTrajectory.h"
#include "heliosWaypoints.h"

#include <vtkSmartPointer.h>

#include <vector>

class vtkHeliosPlatform;
class vtkPolyData;

namespace helios
{

class Messages;

/// A leg that fires pulses.
struct LegPlan
{
  std::size_t Leg = 0;                         ///< leg of the survey
  vtkSmartPointer<vtkHeliosPlatform> Platform; ///< makes the trajectory
  double StartTime = 0.0;                      ///< [s]
  double Duration = 0.0;                       ///< [s]
  vtkIdType FirstPulse = 0;                    ///< id, over the run
  vtkIdType NumberOfPulses = 0;
  vtkIdType FirstShot = 0; ///< pulses of one channel in the legs before

  ///@{
  /// The leg is divided into blocks; a part of a run has those from FirstBlock to EndBlock.
  vtkIdType NumberOfBlocks = 1;
  vtkIdType FirstBlock = 0;
  vtkIdType EndBlock = 1;
  ///@}

  /// Returns the pulses of the leg before a block.
  vtkIdType CountPulsesBefore(vtkIdType block) const
  {
    return SplitPulses(this->NumberOfPulses, block, this->NumberOfBlocks);
  }
};

/**
 * Returns the legs of a survey that fire pulses, with their platforms run and their times set: each
 * platform starts when the one before ends. Empty after an error.
 */
std::vector<LegPlan> PlanLegs(const SurveyData& survey, vtkPolyData* scene,
  const LegOffsetNoise& offsets, const TrajectoryInputs& inputs, Messages& log);

/**
 * Samples of the trajectory of a leg at its start, every interval [s] after that, and its end; with
 * an interval of 0 at start and end only. One sample on a static platform. Samples are returned in
 * blocks of count, starting at first.
 */
class TrajectorySampler
{
public:
  TrajectorySampler(const LegPlan& plan, double interval);

  vtkIdType GetNumberOfSamples() const { return this->NumberOfSamples; }
  vtkSmartPointer<vtkPolyData> GetSamples(vtkIdType first, vtkIdType count) const;

private:
  double GetTime(vtkIdType sample) const;

  Trajectory Path;
  double StartTime;
  double EndTime;
  double Interval;
  vtkIdType NumberOfSamples = 1;
};

} // namespace helios

#endif
