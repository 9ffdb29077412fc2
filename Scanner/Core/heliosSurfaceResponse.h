// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// The return of a surface in the beam.

#ifndef heliosSurfaceResponse_h
#define heliosSurfaceResponse_h

#include "heliosScanModel.h"
#include "heliosSceneGeometry.h"
#include "vtkHeliosRayCaster.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace helios
{

/// The return of a sub-ray of weight 1.
struct SurfaceReturn
{
  double Power; // [W]
  double CosIncidence;
};

/// Returns of the sub-rays of a pulse; the power is 0 outside the range gate.
struct SurfaceReturns
{
  std::vector<double> Powers;
  std::vector<double> Cosines;
};

/// One per thread: it caches surfaces and the last range.
class SurfaceResponse
{
public:
  explicit SurfaceResponse(const ScanModel& model)
    : Model(model)
    , Gain(model.Power * model.Equation.GetGain(1.0, 1.0))
    , Transmission(model.Equation)
  {
  }

  /// Returns the return of a sub-ray along a unit vector that hits a cell.
  SurfaceReturn GetReturn(vtkIdType cell, double range, const double direction[3]);

  /// Computes the returns of sub-rays along unit vectors and their hits.
  void GetReturns(
    const vtkHeliosRay* rays, const vtkHeliosHit* hits, std::size_t count, SurfaceReturns& returns);

  /// Returns the unit normal of a cell's plane; 0 of leaves, here and below.
  const Vec3& GetPlaneNormal(vtkIdType cell) { return this->Visit(cell).PlaneNormal; }

  /// Returns the unit normal from which incidence is measured.
  const Vec3& GetNormal(vtkIdType cell) { return this->Visit(cell).Normal; }

  /// Returns the sunlight received by a sub-ray of weight 1 from a cell [W].
  double GetBackground(vtkIdType cell, double range)
  {
    return this->Model.Background * this->Visit(cell).Reflection->Reflectance *
      std::sqrt(this->Transmission(range));
  }

  /// Clears what is known of surfaces that move, which are elsewhere for the next pulse.
  void ForgetMoving()
  {
    for (Surface* surface : this->Moving)
    {
      surface->Cell = -1;
    }
    this->Moving.clear();
  }

  /// Clears the last range, so that a pulse does not depend on the one before it.
  void StartPulse() { this->Transmission = CachedTransmission(this->Model.Equation); }

private:
  struct Surface
  {
    vtkIdType Cell = -1;
    Vec3 PlaneNormal;
    Vec3 Normal;
    double MinimumCosine = 0.0; // 1 of leaves, which face the beam
    double Reflectance = 0.0;
    const SurfaceReflection* Reflection = nullptr;
  };

  /// Sub-rays processed together, as a structure of arrays.
  struct Columns
  {
    static constexpr std::size_t Size = 32;
    static constexpr std::size_t Lanes = 8;
    double CosNormal[Size] = {};
    double MinimumCosine[Size] = {};
    double Range[Size] = {};
    double Reflectance[Size] = {}; // 0: no return
    const SurfaceReflection* Reflection[Size] = {};
    bool HasLobes = false;

    bool Compute(std::size_t count, double gain, const CachedTransmission& transmission,
      double* powers, double* cosines) const;
  };
  void FillColumns(const vtkHeliosRay* rays, const vtkHeliosHit* hits, std::size_t count);
  void Refine(std::size_t count, double* powers, const double* cosines);
  /// Returns the return of a white surface at normal incidence [W].
  double GetWhitePower(double range)
  {
    return this->Gain * this->Transmission(range) / (range * range);
  }

  bool IsMoving(vtkIdType cell) const
  {
    const SceneGeometry::Cell at = this->Model.Caster->GetGeometry().Find(cell);
    return at.Instance && at.Instance->Motion >= 0;
  }

  /// Returns cached data of a cell: beams hit the same few repeatedly.
  const Surface& Visit(vtkIdType cell)
  {
    Surface& surface = this->Known[static_cast<std::size_t>(cell) % this->Known.size()];
    if (surface.Cell != cell)
    {
      surface.Cell = cell;
      const bool isTurbid = this->Model.Surfaces.IsTurbid(cell);
      surface.MinimumCosine = isTurbid ? 1.0 : 0.0;
      surface.PlaneNormal =
        isTurbid ? Vec3(0.0, 0.0, 0.0) : this->Model.Caster->GetGeometry().GetNormal(cell);
      surface.Normal = surface.PlaneNormal;
      this->Model.Surfaces.GetNormal(cell, surface.Normal);
      surface.Reflection =
        &this->Model.Surfaces.GetReflection(this->Model.Surfaces.GetMaterialId(cell));
      surface.Reflectance = surface.Reflection->Reflectance;
      if (this->Model.Motions && !isTurbid && this->IsMoving(cell))
      {
        this->Moving.push_back(&surface);
      }
    }
    return surface;
  }

  const ScanModel& Model;
  const double Gain; // power of a white surface at 1 m, without extinction [W]
  CachedTransmission Transmission;
  std::array<Surface, 1024> Known; // the leaves of several beams, which overlap
  std::vector<Surface*> Moving;    // surfaces of instances that move
  Columns Batch;
};

} // namespace helios

#endif
