// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosMovingModel.h"

namespace helios
{

//------------------------------------------------------------------------------
MovingModel::MovingModel(const ScanModel& atRest)
  : Caster(atRest.Caster->MakeMoving(atRest.Motions))
  , Model(atRest)
{
  const SceneGeometry& geometry = this->Caster->GetGeometry();
  this->Model.Caster = this->Caster;
  this->Model.Cones = atRest.Cones ? this->Caster->GetConeProbe() : nullptr;
  this->Model.Surfaces.SetGeometry(geometry);
  this->Model.Colors.SetGeometry(geometry);
}

//------------------------------------------------------------------------------
std::unique_ptr<MovingModel> MovingModel::Make(const ScanModel& atRest)
{
  return std::unique_ptr<MovingModel>(
    atRest.Motions && atRest.Caster ? new MovingModel(atRest) : nullptr);
}

//------------------------------------------------------------------------------
void MovingModel::MoveTo(vtkIdType index, const Pulse& pulse)
{
  this->Caster->MoveTo({ index, pulse.Time });
}

//------------------------------------------------------------------------------
Vec3 MovingModel::GetVelocity(vtkIdType cell, const Vec3& point) const
{
  const SceneGeometry& geometry = this->Caster->GetGeometry();
  const SceneGeometry::Cell at = geometry.Find(cell);
  const bool moves = at.Instance && at.Instance->Motion >= 0;
  MovedInstances& moved = *geometry.GetMoved();
  return moves ? moved.GetTrack(*at.Instance).GetVelocity(moved.GetMoment(), point)
               : Vec3(0.0, 0.0, 0.0);
}

//------------------------------------------------------------------------------
Pose MovingModel::GetPose(vtkIdType cell) const
{
  const SceneGeometry& geometry = this->Caster->GetGeometry();
  const SceneGeometry::Cell at = geometry.Find(cell);
  const bool moves = at.Instance && at.Instance->Motion >= 0;
  MovedInstances& moved = *geometry.GetMoved();
  return moves ? moved.GetTrack(*at.Instance).GetPose(moved.GetMoment()) : Pose();
}

} // namespace helios
