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
#include <cstddef>
#include <vector>

namespace helios
{

/// What a sub-ray of weight 1 returns.
struct Reply
{
  double Power; // [W]
  double CosIncidence;
};

/// The same of the sub-rays of a pulse; of those that are silent the power is 0.
struct Replies
{
  std::vector<double> Powers;
  std::vector<double> Cosines;
};

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

  /// Of a sub-ray along a unit vector that meets a cell.
  Reply GetReply(vtkIdType cell, double range, const double direction[3]);

  /// Of sub-rays along unit vectors and what they meet.
  void GetReplies(
    const vtkHeliosRay* rays, const vtkHeliosHit* hits, std::size_t count, Replies& replies);

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
    double Reflectance = 0.0;
    const SurfaceReflection* Reflection = nullptr;
  };

  /// Sub-rays that are worked on together, a column for each thing they need.
  struct Columns
  {
    static constexpr std::size_t Size = 32;
    static constexpr std::size_t Lanes = 8;
    double CosNormal[Size] = {};
    double LeastCosine[Size] = {};
    double Range[Size] = {};
    double Reflectance[Size] = {}; // 0: silent
    const SurfaceReflection* Reflection[Size] = {};
    bool HasLobes = false;

    bool Compute(std::size_t count, double gain, const NearbyTransmission& transmission,
      double* powers, double* cosines) const;
  };
  void Ask(const vtkHeliosRay* rays, const vtkHeliosHit* hits, std::size_t count);
  void Refine(std::size_t count, double* powers, const double* cosines);
  /// What a white surface across the beam returns [W].
  double GetWhitePower(double range)
  {
    return this->Gain * this->Transmission(range) / (range * range);
  }

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
      surface.Reflectance = surface.Reflection->Reflectance;
    }
    return surface;
  }

  const ScanModel& Model;
  const double Gain; // of a white surface at 1 m, without air before it [W]
  NearbyTransmission Transmission;
  std::array<Surface, 64> Known;
  Columns Asked;
};

} // namespace helios

#endif
