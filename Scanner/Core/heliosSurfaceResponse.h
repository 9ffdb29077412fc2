// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// What a surface in the beam sends back.

#ifndef heliosSurfaceResponse_h
#define heliosSurfaceResponse_h

#include "heliosScanModel.h"
#include "heliosTriangleMesh.h"
#include "vtkHeliosRayCaster.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace helios
{

/// One a thread: it remembers surfaces, and the range it saw last.
class SurfaceResponse
{
public:
  explicit SurfaceResponse(const ScanModel& model)
    : Model(model)
    , Gain(model.Power * model.Equation.GetGain(1.0, 1.0))
    , Transmission(model.Equation)
  {
  }

  /// The power that a sub-ray of weight 1 along a unit vector returns from a cell [W].
  double GetPower(vtkIdType cell, double range, const double direction[3], double& cosIncidence)
  {
    const Surface& surface = this->Visit(cell);
    const Vec3& n = surface.Normal;
    const double cosNormal = n[0] * direction[0] + n[1] * direction[1] + n[2] * direction[2];
    cosIncidence = std::max(surface.LeastCosine, std::abs(cosNormal));
    return this->Gain * this->Transmission(range) / (range * range) *
      GetBackscatter(*surface.Reflection, cosIncidence);
  }

  /// The unit normal of a cell's plane; 0 of leaves, here and below.
  const Vec3& GetPlaneNormal(vtkIdType cell) { return this->Visit(cell).PlaneNormal; }

  /// The unit normal that incidence is measured from.
  const Vec3& GetNormal(vtkIdType cell) { return this->Visit(cell).Normal; }

  /// The sunlight that a sub-ray of weight 1 finds on a cell [W].
  double GetBackground(vtkIdType cell, double range)
  {
    return this->Model.Background * this->Visit(cell).Reflection->Reflectance *
      std::sqrt(this->Transmission(range));
  }

  /// Forgets the range it saw last, so that a pulse does not depend on the one before it.
  void StartPulse() { this->Transmission = NearbyTransmission(this->Model.Equation); }

private:
  struct Surface
  {
    vtkIdType Cell = -1;
    Vec3 PlaneNormal;
    Vec3 Normal;
    double LeastCosine = 0.0; // 1 of leaves: they face the beam
    const SurfaceReflection* Reflection = nullptr;
  };

  /// What is known of a cell: beams meet the same few again and again.
  const Surface& Visit(vtkIdType cell)
  {
    Surface& surface = this->Known[static_cast<std::size_t>(cell) % this->Known.size()];
    if (surface.Cell != cell)
    {
      surface.Cell = cell;
      const bool isTurbid = this->Model.Surfaces.IsTurbid(cell);
      surface.LeastCosine = isTurbid ? 1.0 : 0.0;
      surface.PlaneNormal =
        isTurbid ? Vec3(0.0, 0.0, 0.0) : this->Model.Caster->GetMesh().GetNormal(cell);
      surface.Normal = surface.PlaneNormal;
      this->Model.Surfaces.GetNormal(cell, surface.Normal);
      surface.Reflection =
        &this->Model.Surfaces.GetReflection(this->Model.Surfaces.GetMaterialId(cell));
    }
    return surface;
  }

  const ScanModel& Model;
  const double Gain; // of a white surface at 1 m, without air before it [W]
  NearbyTransmission Transmission;
  std::array<Surface, 64> Known;
};

} // namespace helios

#endif
