// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHeliosBeamSampler.h"

#include <vtkMath.h>
#include <vtkObjectFactory.h>

#include <algorithm>
#include <cmath>

vtkStandardNewMacro(vtkHeliosBeamSampler);

namespace
{

/// The sub-rays of circle i: floor(2 pi i), one in the centre.
int CircleSize(int circle)
{
  return std::max(1, static_cast<int>(2.0 * vtkMath::Pi() * circle));
}

/// The share of the energy inside radius r of a Gaussian beam cut at radius k, both in units of w.
double EnergyInside(double r, double k)
{
  return std::expm1(-2.0 * r * r) / std::expm1(-2.0 * k * k);
}

/// The circle of a sub-ray, and its place on it.
struct Place
{
  int Circle = 0;
  int Index = 0;

  explicit Place(int subRay)
    : Index(subRay)
  {
    while (this->Index >= CircleSize(this->Circle))
    {
      this->Index -= CircleSize(this->Circle);
      ++this->Circle;
    }
  }
};

} // namespace

//------------------------------------------------------------------------------
int vtkHeliosBeamSampler::GetNumberOfSubRays() const
{
  int count = 1;
  if (this->BeamDivergence > 0.0)
  {
    for (int circle = 1; circle < this->NumberOfCircles; ++circle)
    {
      count += CircleSize(circle);
    }
  }
  return count;
}

//------------------------------------------------------------------------------
void vtkHeliosBeamSampler::GetDirection(int subRay, double direction[3]) const
{
  const Place place(subRay);
  const double w = 0.5 * this->BeamDivergence;
  const double polar = place.Circle * this->Truncation * w / (this->NumberOfCircles - 0.5);
  const double azimuth = 2.0 * vtkMath::Pi() * place.Index / CircleSize(place.Circle);
  direction[0] = std::sin(polar) * std::sin(azimuth);
  direction[1] = std::cos(polar);
  direction[2] = std::sin(polar) * std::cos(azimuth);
}

//------------------------------------------------------------------------------
double vtkHeliosBeamSampler::GetWeight(int subRay) const
{
  if (this->GetNumberOfSubRays() == 1)
  {
    return 1.0;
  }
  const Place place(subRay);
  const double spacing = this->Truncation / (this->NumberOfCircles - 0.5);
  const double inner = std::max(0.0, place.Circle - 0.5) * spacing;
  const double outer = (place.Circle + 0.5) * spacing;
  const double energy =
    EnergyInside(outer, this->Truncation) - EnergyInside(inner, this->Truncation);
  return energy / CircleSize(place.Circle);
}

//------------------------------------------------------------------------------
void vtkHeliosBeamSampler::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "BeamDivergence: " << this->BeamDivergence << "\n";
  os << indent << "NumberOfCircles: " << this->NumberOfCircles << "\n";
  os << indent << "Truncation: " << this->Truncation << "\n";
}
