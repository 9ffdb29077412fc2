// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHeliosRisleyPrisms.h"

#include <vtkMath.h>
#include <vtkObjectFactory.h>

#include <algorithm>
#include <cmath>

vtkStandardNewMacro(vtkHeliosRisleyPrisms);

namespace
{

/// Refracts a beam at a face by Snell's law, with the ratio of the indices before and behind;
/// false for total reflection or a missed face.
bool Refract(double ratio, const double normal[3], double d[3])
{
  const double cosIn = -vtkMath::Dot(d, normal);
  const double cosOutSquared = 1.0 - ratio * ratio * (1.0 - cosIn * cosIn);
  if (!(cosIn > 0.0 && cosOutSquared > 0.0))
  {
    return false;
  }
  const double bend = ratio * cosIn - std::sqrt(cosOutSquared);
  for (int k = 0; k < 3; ++k)
  {
    d[k] = ratio * d[k] + bend * normal[k];
  }
  return true;
}

} // namespace

//------------------------------------------------------------------------------
bool vtkHeliosRisleyPrisms::HasPrism(int prism)
{
  if (prism >= 0 && prism < MaximumNumberOfPrisms)
  {
    return true;
  }
  vtkErrorMacro(<< "there is no prism " << prism << "; give 0, 1 or 2");
  return false;
}

//------------------------------------------------------------------------------
void vtkHeliosRisleyPrisms::SetWedgeAngle(int prism, double angle)
{
  if (this->HasPrism(prism))
  {
    Prism& p = this->Prisms[prism];
    this->SetClamped(p.WedgeAngle, std::isnan(angle) ? 0.0 : angle, -89.0, 89.0);
    p.SinWedge = std::sin(vtkMath::RadiansFromDegrees(p.WedgeAngle));
    p.CosWedge = std::cos(vtkMath::RadiansFromDegrees(p.WedgeAngle));
  }
}

//------------------------------------------------------------------------------
void vtkHeliosRisleyPrisms::SetRefractiveIndex(int prism, double index)
{
  if (this->HasPrism(prism))
  {
    this->SetClamped(this->Prisms[prism].RefractiveIndex, index, 1.0, 10.0);
  }
}

//------------------------------------------------------------------------------
void vtkHeliosRisleyPrisms::SetRotorFrequency(int prism, double frequency)
{
  if (this->HasPrism(prism))
  {
    const double finite = std::isnan(frequency) ? 0.0 : frequency;
    this->SetClamped(this->Prisms[prism].RotorFrequency, finite, -1e6, 1e6);
  }
}

//------------------------------------------------------------------------------
void vtkHeliosRisleyPrisms::SetRotorPhase(int prism, double phase)
{
  if (this->HasPrism(prism))
  {
    const double finite = std::isnan(phase) ? 0.0 : phase;
    this->SetClamped(this->Prisms[prism].RotorPhase, finite, -360.0, 360.0);
  }
}

//------------------------------------------------------------------------------
double vtkHeliosRisleyPrisms::GetWedgeAngle(int prism) const
{
  return this->Prisms[std::clamp(prism, 0, MaximumNumberOfPrisms - 1)].WedgeAngle;
}

//------------------------------------------------------------------------------
double vtkHeliosRisleyPrisms::GetRefractiveIndex(int prism) const
{
  return this->Prisms[std::clamp(prism, 0, MaximumNumberOfPrisms - 1)].RefractiveIndex;
}

//------------------------------------------------------------------------------
double vtkHeliosRisleyPrisms::GetRotorFrequency(int prism) const
{
  return this->Prisms[std::clamp(prism, 0, MaximumNumberOfPrisms - 1)].RotorFrequency;
}

//------------------------------------------------------------------------------
double vtkHeliosRisleyPrisms::GetRotorPhase(int prism) const
{
  return this->Prisms[std::clamp(prism, 0, MaximumNumberOfPrisms - 1)].RotorPhase;
}

//------------------------------------------------------------------------------
void vtkHeliosRisleyPrisms::SetAirRefractiveIndex(double index)
{
  this->SetClamped(this->AirRefractiveIndex, index, 1.0, 10.0);
}

//------------------------------------------------------------------------------
void vtkHeliosRisleyPrisms::SetIncidentBeam(double x, double y, double z)
{
  double beam[3] = { x, y, z };
  const double norm = vtkMath::Normalize(beam);
  if (!(y > 0.0 && std::isfinite(norm)))
  {
    vtkErrorMacro(<< "IncidentBeam (" << x << ", " << y << ", " << z
                  << ") does not point at the prisms; give a direction with y > 0");
    return;
  }
  if (!std::equal(beam, beam + 3, this->IncidentBeam))
  {
    std::copy_n(beam, 3, this->IncidentBeam);
    this->Modified();
  }
}

//------------------------------------------------------------------------------
bool vtkHeliosRisleyPrisms::Pass(const Prism& prism, double phase, double direction[3]) const
{
  const double psi = 2.0 * vtkMath::Pi() * phase;
  const double square[3] = { 0.0, -1.0, 0.0 };
  const double inclined[3] = { std::sin(psi) * prism.SinWedge, -prism.CosWedge,
    std::cos(psi) * prism.SinWedge };
  const double ratio = this->AirRefractiveIndex / prism.RefractiveIndex;
  const bool isFirst = prism.WedgeAngle > 0.0;
  return Refract(ratio, isFirst ? inclined : square, direction) &&
    Refract(1.0 / ratio, isFirst ? square : inclined, direction);
}

//------------------------------------------------------------------------------
bool vtkHeliosRisleyPrisms::GetDirection(vtkIdType pulse, double direction[3]) const
{
  double d[3];
  std::copy_n(this->IncidentBeam, 3, d);
  for (const Prism& prism : this->Prisms)
  {
    if (prism.WedgeAngle == 0.0)
    {
      continue;
    }
    const double turned = this->ComputePhase(pulse, prism.RotorFrequency);
    if (!this->Pass(prism, turned + prism.RotorPhase / 360.0, d))
    {
      return false;
    }
  }
  vtkMath::Normalize(d);
  std::copy_n(d, 3, direction);
  return true;
}

//------------------------------------------------------------------------------
void vtkHeliosRisleyPrisms::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  for (const Prism& prism : this->Prisms)
  {
    os << indent << "Prism: " << prism.WedgeAngle << " deg, index " << prism.RefractiveIndex << ", "
       << prism.RotorFrequency << " Hz, " << prism.RotorPhase << " deg at pulse 0\n";
  }
  os << indent << "AirRefractiveIndex: " << this->AirRefractiveIndex << "\n";
  os << indent << "IncidentBeam: " << this->IncidentBeam[0] << " " << this->IncidentBeam[1] << " "
     << this->IncidentBeam[2] << "\n";
}
