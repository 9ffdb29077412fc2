// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// How a part of a scene moves during a survey.

#ifndef heliosMotionData_h
#define heliosMotionData_h

#include "heliosPartMotion.h"
#include "heliosTrajectoryFileData.h"

#include <vtkType.h>

#include <string>
#include <vector>

namespace helios
{

struct MotionData
{
  std::vector<MotionSequence> Sequences; ///< none: the part is at rest
  vtkIdType Pulses = 1;                  ///< pulses of a channel between two steps
  double Seconds = 0.0;      ///< [s], between two steps, instead of pulses; 0: not given
  int Every = 1;             ///< steps per scene update
  bool IsContinuous = false; ///< every pulse sees it between two steps
  std::string Where;         ///< place of the part
  std::string Mount;         ///< name of the part that carries it; empty: none
  TrajectoryFileData Track;  ///< that its frame follows; without a file: none

  /// Returns whether it moves by itself, or may be carried.
  bool IsMoving() const
  {
    return !this->Mount.empty() || this->HasOwn() || !this->Track.File.empty();
  }
  bool HasOwn() const { return PartMotion(this->Sequences).IsMoving(); }
};

} // namespace helios

#endif
