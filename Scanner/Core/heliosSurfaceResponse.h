// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// What a surface in the beam sends back.

#ifndef heliosSurfaceResponse_h
#define heliosSurfaceResponse_h

#include "heliosScanModel.h"
#include "heliosTriangleMesh.h"
#include "vtkHeliosRayCaster.h"

#include <cmath>

namespace helios
{

/// One a thread: it remembers the surface and the range it saw last.
class SurfaceResponse
{
public:
  explicit SurfaceResponse(const ScanModel& model)
    : Model(model)
    , Transmission(model.Equation)
  {
  }

  /// The power that a sub-ray of weight 1 along a unit vector returns from a cell [W].
  double GetPower(vtkIdType cell, double range, const Vec3& direction, double& cosIncidence)
  {
    this->Visit(cell);
    cosIncidence = std::abs(this->Normal.Dot(direction));
    const LidarEquation& equation = this->Model.Equation;
    return this->Model.Power * equation.GetGain(range, this->Transmission(range)) *
      GetBackscatter(*this->Reflection, cosIncidence);
  }

  /// The unit normal of a cell's plane.
  const Vec3& GetPlaneNormal(vtkIdType cell)
  {
    this->Visit(cell);
    return this->PlaneNormal;
  }

  /// The unit normal that incidence is measured from.
  const Vec3& GetNormal(vtkIdType cell)
  {
    this->Visit(cell);
    return this->Normal;
  }

  /// The sunlight that a sub-ray of weight 1 finds on a cell [W].
  double GetBackground(vtkIdType cell, double range)
  {
    this->Visit(cell);
    return this->Model.Background * this->Reflection->Reflectance *
      std::sqrt(this->Transmission(range));
  }

  /// Forgets the range it saw last, so that a pulse does not depend on the one before it.
  void StartPulse() { this->Transmission = NearbyTransmission(this->Model.Equation); }

private:
  void Visit(vtkIdType cell)
  {
    if (cell == this->Cell)
    {
      return;
    }
    this->Cell = cell;
    const SceneSurfaces& surfaces = this->Model.Surfaces;
    this->PlaneNormal = this->Model.Caster->GetMesh().GetNormal(cell);
    this->Normal = this->PlaneNormal;
    surfaces.GetNormal(cell, this->Normal);
    this->Reflection = &surfaces.GetReflection(surfaces.GetMaterialId(cell));
  }

  const ScanModel& Model;
  NearbyTransmission Transmission;
  vtkIdType Cell = -1;
  Vec3 PlaneNormal;
  Vec3 Normal;
  const SurfaceReflection* Reflection = nullptr;
};

} // namespace helios

#endif
