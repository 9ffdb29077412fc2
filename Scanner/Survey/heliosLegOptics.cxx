// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosLegOptics.h"

#include "vtkHeliosConicMirror.h"
#include "vtkHeliosFiberArray.h"
#include "vtkHeliosOscillatingMirror.h"
#include "vtkHeliosPalmerMirror.h"
#include "vtkHeliosRisleyPrisms.h"
#include "vtkHeliosRotatingMirror.h"

#include <algorithm>
#include <iterator>

namespace helios
{

namespace
{

template <typename DeflectorT>
vtkSmartPointer<DeflectorT> MakeMirror(const LegData& leg)
{
  auto mirror = vtkSmartPointer<DeflectorT>::New();
  mirror->SetScanFrequency(leg.ScanFrequency);
  return mirror;
}

vtkSmartPointer<vtkHeliosBeamDeflector> MakeRotating(const ScannerData& scanner, const LegData& leg)
{
  auto mirror = MakeMirror<vtkHeliosRotatingMirror>(leg);
  mirror->SetMirrorAngle(scanner.ScanAngleMax);
  mirror->SetVerticalAngleMin(leg.VerticalAngleMin);
  mirror->SetVerticalAngleMax(leg.VerticalAngleMax);
  return mirror;
}

vtkSmartPointer<vtkHeliosBeamDeflector> MakeOscillating(
  const ScannerData& scanner, const LegData& leg)
{
  auto mirror = MakeMirror<vtkHeliosOscillatingMirror>(leg);
  mirror->SetScanAngle(leg.ScanAngle);
  mirror->SetPattern(scanner.IsSinusoidal ? vtkHeliosOscillatingMirror::SINUSOIDAL
                                          : vtkHeliosOscillatingMirror::TRIANGULAR);
  mirror->SetTurningPulses(scanner.TurningPulses);
  return mirror;
}

vtkSmartPointer<vtkHeliosBeamDeflector> MakeFibers(const ScannerData& scanner, const LegData& leg)
{
  auto fibers = vtkSmartPointer<vtkHeliosFiberArray>::New();
  fibers->SetNumberOfFibers(scanner.NumberOfFibers);
  fibers->SetScanAngle(leg.ScanAngle);
  return fibers;
}

vtkSmartPointer<vtkHeliosBeamDeflector> MakeConic(const LegData& leg)
{
  auto mirror = MakeMirror<vtkHeliosConicMirror>(leg);
  mirror->SetScanAngle(leg.ScanAngle);
  return mirror;
}

vtkSmartPointer<vtkHeliosBeamDeflector> MakePalmer(const LegData& leg)
{
  auto mirror = MakeMirror<vtkHeliosPalmerMirror>(leg);
  mirror->SetWobbleAngle(0.5 * leg.ScanAngle);
  return mirror;
}

vtkSmartPointer<vtkHeliosBeamDeflector> MakePrisms(const ScannerData& scanner)
{
  auto prisms = vtkSmartPointer<vtkHeliosRisleyPrisms>::New();
  prisms->SetAirRefractiveIndex(scanner.AirRefractiveIndex);
  for (int k = 0; k < vtkHeliosRisleyPrisms::MaximumNumberOfPrisms; ++k)
  {
    prisms->SetWedgeAngle(k, scanner.Prisms[k].WedgeAngle);
    prisms->SetRefractiveIndex(k, scanner.Prisms[k].RefractiveIndex);
    prisms->SetRotorFrequency(k, scanner.Prisms[k].RotorFrequency);
  }
  return prisms;
}

vtkSmartPointer<vtkHeliosBeamDeflector> MakeType(const ScannerData& scanner, const LegData& leg)
{
  switch (scanner.Type)
  {
    case Optics::OscillatingMirror:
      return MakeOscillating(scanner, leg);
    case Optics::FiberArray:
      return MakeFibers(scanner, leg);
    case Optics::ConicMirror:
      return MakeConic(leg);
    case Optics::PalmerMirror:
      return MakePalmer(leg);
    case Optics::RisleyPrisms:
      return MakePrisms(scanner);
    case Optics::RotatingMirror:
      break;
  }
  return MakeRotating(scanner, leg);
}

} // namespace

//------------------------------------------------------------------------------
const char* GetOpticsName(Optics type)
{
  const auto* found = std::find_if(std::begin(OpticsNames), std::end(OpticsNames),
    [type](const OpticsName& name) { return type == name.Type; });
  return found->Name;
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkHeliosBeamDeflector> MakeDeflector(
  const ScannerData& scanner, const LegData& leg)
{
  const auto deflector = MakeType(scanner, leg);
  deflector->SetPulseFrequency(leg.PulseFrequency);
  deflector->SetWarmUpTime(leg.WarmUpTime);
  return deflector;
}

} // namespace helios
