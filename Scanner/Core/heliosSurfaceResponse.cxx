// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosSurfaceResponse.h"

#include "heliosVectorLoops.h"

namespace helios
{
namespace
{

double GetCosine(const Vec3& n, const double d[3])
{
  return n[0] * d[0] + n[1] * d[1] + n[2] * d[2];
}

} // namespace

/// Returns the lidar equation for columns, as if all were Lambertian; false if a transmission is
/// too far from the start of its series.
HELIOS_CLONES
bool SurfaceResponse::Columns::Compute(std::size_t count, double gain,
  const CachedTransmission& transmission, double* powers, double* cosines) const
{
  double farthest[Lanes] = {};
  for (std::size_t i = 0; i < count; i += Lanes)
  {
    for (std::size_t k = 0; k < Lanes; ++k)
    {
      const double cosine = std::max(this->MinimumCosine[i + k], std::abs(this->CosNormal[i + k]));
      const double range = this->Range[i + k];
      const double exponent = transmission.GetExponent(range);
      farthest[k] = std::max(farthest[k], std::abs(exponent));
      const double power = gain * transmission.GetNear(exponent) / (range * range);
      powers[i + k] = power * (this->Reflectance[i + k] * cosine);
      cosines[i + k] = cosine;
    }
  }
  return CachedTransmission::IsNear(*std::max_element(farthest, farthest + Lanes));
}

/// Fills the columns, padding the lanes with a valid range.
void SurfaceResponse::FillColumns(
  const vtkHeliosRay* rays, const vtkHeliosHit* hits, std::size_t count)
{
  Columns& c = this->Batch;
  const RangeGate gate = this->Model.Gate;
  const Surface* surface = nullptr;
  vtkIdType cell = -1; // cell of the surface: the next sub-ray often hits it, too
  bool hasLobes = false;
  std::size_t silent = 0;
  double range = 1.0;
  for (std::size_t i = 0; i < count; ++i)
  {
    const vtkHeliosHit hit = hits[i];
    if (gate.IsOutsideGate(hit))
    {
      c.Reflectance[i] = 0.0;
      ++silent;
      continue;
    }
    if (hit.CellId != cell)
    {
      cell = hit.CellId;
      surface = &this->Visit(cell);
      hasLobes = hasLobes || surface->Reflection->Specularity != 0.0;
    }
    c.CosNormal[i] = GetCosine(surface->Normal, rays[i].Direction);
    c.MinimumCosine[i] = surface->MinimumCosine;
    c.Range[i] = range = hit.Range;
    c.Reflectance[i] = surface->Reflectance;
    c.Reflection[i] = surface->Reflection;
  }
  c.HasLobes = hasLobes;
  for (std::size_t i = 0; silent > 0 && i < count; ++i)
  {
    c.Range[i] = gate.IsOutsideGate(hits[i]) ? range : c.Range[i];
  }
  std::fill_n(c.Range + count, (Columns::Lanes - count % Columns::Lanes) % Columns::Lanes, range);
}

/// Computes the cases that columns do not handle, one by one: transmissions far from each other,
/// and lobes.
void SurfaceResponse::Refine(std::size_t count, double* powers, const double* cosines)
{
  const Columns& c = this->Batch;
  for (std::size_t i = 0; i < count; ++i)
  {
    if (c.Reflectance[i] > 0.0)
    {
      powers[i] = this->GetWhitePower(c.Range[i]) * GetBackscatter(*c.Reflection[i], cosines[i]);
    }
  }
}

void SurfaceResponse::GetReturns(
  const vtkHeliosRay* rays, const vtkHeliosHit* hits, std::size_t count, SurfaceReturns& returns)
{
  returns.Powers.resize(std::max(returns.Powers.size(), count + Columns::Lanes));
  returns.Cosines.resize(returns.Powers.size());
  for (std::size_t first = 0; first < count; first += Columns::Size)
  {
    const std::size_t size = std::min(Columns::Size, count - first);
    double* powers = returns.Powers.data() + first;
    double* cosines = returns.Cosines.data() + first;
    this->FillColumns(rays + first, hits + first, size);
    this->Transmission(this->Batch.Range[0]); // starts the series there, or near
    const bool isNear = this->Batch.Compute(size, this->Gain, this->Transmission, powers, cosines);
    if (!isNear || this->Batch.HasLobes)
    {
      this->Refine(size, powers, cosines);
    }
  }
}

SurfaceReturn SurfaceResponse::GetReturn(vtkIdType cell, double range, const double direction[3])
{
  const Surface& surface = this->Visit(cell);
  const double cosine =
    std::max(surface.MinimumCosine, std::abs(GetCosine(surface.Normal, direction)));
  return { this->GetWhitePower(range) * GetBackscatter(*surface.Reflection, cosine), cosine };
}

} // namespace helios
