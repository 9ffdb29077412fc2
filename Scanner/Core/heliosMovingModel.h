// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// The model of a scan in which instances move, at the time of a pulse.

#ifndef heliosMovingModel_h
#define heliosMovingModel_h

#include "heliosScanModel.h"

#include <vtkSmartPointer.h>
#include <vtkType.h>

#include <memory>

namespace helios
{

/// One per thread: its ray caster, cone probe, surfaces and colours have the instances where they
/// are.
class MovingModel
{
public:
  /// Makes it; null if no instance moves. The other model must outlive it.
  static std::unique_ptr<MovingModel> Make(const ScanModel& atRest);

  const ScanModel& Get() const { return this->Model; }

  /// Moves the instances to where they are when a pulse is emitted.
  void MoveTo(vtkIdType index, const Pulse& pulse);

  /// Returns the velocity of a point of a cell [m/s].
  Vec3 GetVelocity(vtkIdType cell, const Vec3& point) const;

  /// Returns the displacement of the part of a cell.
  Pose GetPose(vtkIdType cell) const;

private:
  explicit MovingModel(const ScanModel& atRest);

  vtkSmartPointer<vtkHeliosRayCaster> Caster;
  ScanModel Model;
};

} // namespace helios

#endif
