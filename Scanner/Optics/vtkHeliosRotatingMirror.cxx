// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHeliosRotatingMirror.h"

#include <vtkMath.h>
#include <vtkObjectFactory.h>

#include <algorithm>
#include <cmath>

vtkStandardNewMacro(vtkHeliosRotatingMirror);

//------------------------------------------------------------------------------
vtkHeliosRotatingMirror::vtkHeliosRotatingMirror()
  : Facets(1)
{
}

//------------------------------------------------------------------------------
void vtkHeliosRotatingMirror::SetNumberOfFacets(int facets)
{
  const int clamped = std::clamp(facets, 1, 1000);
  if (clamped != this->GetNumberOfFacets())
  {
    this->Facets.resize(static_cast<std::size_t>(clamped));
    this->Modified();
  }
}

//------------------------------------------------------------------------------
int vtkHeliosRotatingMirror::GetNumberOfFacets() const
{
  return static_cast<int>(this->Facets.size());
}

//------------------------------------------------------------------------------
vtkHeliosRotatingMirror::Facet* vtkHeliosRotatingMirror::Find(int facet)
{
  if (facet >= 0 && facet < this->GetNumberOfFacets())
  {
    return &this->Facets[static_cast<std::size_t>(facet)];
  }
  vtkErrorMacro(<< "there is no facet " << facet << "; give one from 0 to "
                << this->GetNumberOfFacets() - 1 << ", or set NumberOfFacets first");
  return nullptr;
}

//------------------------------------------------------------------------------
vtkHeliosRotatingMirror::Facet vtkHeliosRotatingMirror::GetOne(int facet) const
{
  const bool isOne = facet >= 0 && facet < this->GetNumberOfFacets();
  return isOne ? this->Facets[static_cast<std::size_t>(facet)] : Facet();
}

//------------------------------------------------------------------------------
void vtkHeliosRotatingMirror::SetFacetPitch(int facet, double pitch)
{
  if (Facet* found = this->Find(facet))
  {
    this->SetClamped(found->Pitch, std::isnan(pitch) ? 0.0 : pitch, -89.0, 89.0);
    found->SinPitch = std::sin(vtkMath::RadiansFromDegrees(found->Pitch));
    found->CosPitch = std::cos(vtkMath::RadiansFromDegrees(found->Pitch));
  }
}

//------------------------------------------------------------------------------
void vtkHeliosRotatingMirror::SetFacetRoll(int facet, double roll)
{
  if (Facet* found = this->Find(facet))
  {
    this->SetClamped(found->Roll, std::isnan(roll) ? 0.0 : roll, -180.0, 180.0);
  }
}

//------------------------------------------------------------------------------
double vtkHeliosRotatingMirror::GetFacetPitch(int facet) const
{
  return this->GetOne(facet).Pitch;
}

//------------------------------------------------------------------------------
double vtkHeliosRotatingMirror::GetFacetRoll(int facet) const
{
  return this->GetOne(facet).Roll;
}

//------------------------------------------------------------------------------
int vtkHeliosRotatingMirror::GetFacet(vtkIdType pulse) const
{
  const int facets = this->GetNumberOfFacets();
  if (facets == 1)
  {
    return 0;
  }
  // The line is the nearest integer to its phase, which ComputeBeta() measures from it.
  const double phase = this->ComputePhase(pulse, this->ScanFrequency);
  const double own = phase > 0.5 ? phase - 1.0 : phase;
  const double turn = facets * this->ComputePhase(pulse, this->ScanFrequency / facets);
  return static_cast<int>(std::lround(turn - own)) % facets;
}

//------------------------------------------------------------------------------
double vtkHeliosRotatingMirror::ComputeBeta(vtkIdType pulse) const
{
  const double phase = this->ComputePhase(pulse, this->ScanFrequency);
  return 2.0 * this->MirrorAngle * (phase > 0.5 ? phase - 1.0 : phase);
}

//------------------------------------------------------------------------------
double vtkHeliosRotatingMirror::GetScanAngle(vtkIdType pulse) const
{
  return this->ComputeBeta(pulse) + this->GetOne(this->GetFacet(pulse)).Roll;
}

//------------------------------------------------------------------------------
bool vtkHeliosRotatingMirror::IsInWindow(double beta) const
{
  return this->VerticalAngleMin < beta && beta <= this->VerticalAngleMax;
}

//------------------------------------------------------------------------------
int vtkHeliosRotatingMirror::GetScanDirectionFlag(vtkIdType) const
{
  return this->ScanFrequency > 0.0 ? 1 : 0;
}

//------------------------------------------------------------------------------
bool vtkHeliosRotatingMirror::IsEdgeOfFlightLine(vtkIdType pulse) const
{
  const double beta = this->ComputeBeta(pulse);
  if (!(this->ScanFrequency > 0.0) || !this->IsInWindow(beta))
  {
    return false;
  }
  const double next = this->ComputeBeta(pulse + 1);
  const bool skipsLines = this->ScanFrequency >= this->PulseFrequency;
  return skipsLines || next < beta || next > this->VerticalAngleMax;
}

//------------------------------------------------------------------------------
bool vtkHeliosRotatingMirror::GetDirection(vtkIdType pulse, double direction[3]) const
{
  const double angle = this->ComputeBeta(pulse);
  if (!this->IsInWindow(angle))
  {
    return false;
  }
  const Facet facet = this->GetOne(this->GetFacet(pulse));
  const double beta = vtkMath::RadiansFromDegrees(angle + facet.Roll);
  direction[0] = facet.SinPitch;
  direction[1] = facet.CosPitch * std::cos(beta);
  direction[2] = facet.CosPitch * std::sin(beta);
  return true;
}

//------------------------------------------------------------------------------
void vtkHeliosRotatingMirror::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "ScanFrequency: " << this->ScanFrequency << "\n";
  os << indent << "MirrorAngle: " << this->MirrorAngle << "\n";
  os << indent << "VerticalAngleMin: " << this->VerticalAngleMin << "\n";
  os << indent << "VerticalAngleMax: " << this->VerticalAngleMax << "\n";
  for (const Facet& facet : this->Facets)
  {
    os << indent << "Facet: pitch " << facet.Pitch << ", roll " << facet.Roll << "\n";
  }
}
