// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosMovingModel.h"

#include "heliosTriangleMesh.h"

namespace helios
{

namespace
{

/// Returns the velocity of a point of a mesh that deforms, relative to its place [m/s].
Vec3 GetShapeVelocity(const SceneGeometry& geometry, vtkIdType cell, const Vec3& point)
{
  const SceneGeometry::Cell at = geometry.Find(cell);
  const TriangleMesh& mesh = geometry.GetPrototype(*at.Instance).GetMesh();
  double corners[3][3];
  geometry.GetCorners(cell, corners);
  const Vec3 weights = GetTriangleWeights(corners, point);
  Vec3 velocity(0.0, 0.0, 0.0);
  for (int corner = 0; corner < 3; ++corner)
  {
    velocity = velocity +
      weights[corner] *
        at.Instance->Shape->GetVelocity(mesh.GetCorners()[3 * at.Triangle + corner]);
  }
  return at.Instance->Place.Scale * at.Instance->Place.Rotate(velocity);
}

} // namespace

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
  if (!moves)
  {
    return { 0.0, 0.0, 0.0 };
  }
  const Vec3 velocity = moved.GetTrack(*at.Instance).GetVelocity(moved.GetMoment(), point);
  return at.Instance->Shape ? velocity + GetShapeVelocity(geometry, cell, point) : velocity;
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
