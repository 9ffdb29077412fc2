// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosLegOptics.h"

#include "vtkHeliosConicMirror.h"
#include "vtkHeliosFiberArray.h"
#include "vtkHeliosOscillatingMirror.h"
#include "vtkHeliosPalmerMirror.h"
#include "vtkHeliosRisleyPrisms.h"
#include "vtkHeliosRotatingMirror.h"
#include "vtkHeliosSpinningChannels.h"

#include <algorithm>
#include <sstream>
#include <vector>

namespace helios
{

namespace
{

template <typename DeflectorT>
vtkSmartPointer<DeflectorT> MakeMirror(const ScanData& scan)
{
  auto mirror = vtkSmartPointer<DeflectorT>::New();
  mirror->SetScanFrequency(scan.ScanFrequency);
  return mirror;
}

vtkSmartPointer<vtkHeliosBeamDeflector> MakeRotating(
  const ScannerData& scanner, const ScanData& scan)
{
  auto mirror = MakeMirror<vtkHeliosRotatingMirror>(scan);
  mirror->SetMirrorAngle(scanner.ScanAngleMax);
  mirror->SetVerticalAngleMin(scan.VerticalAngleMin);
  mirror->SetVerticalAngleMax(scan.VerticalAngleMax);
  const std::vector<double>& pitches = scanner.FacetPitches;
  const std::vector<double>& rolls = scanner.FacetRolls;
  const std::size_t facets = std::max({ pitches.size(), rolls.size(), std::size_t(1) });
  mirror->SetNumberOfFacets(static_cast<int>(facets));
  for (std::size_t k = 0; k < facets; ++k)
  {
    mirror->SetFacetPitch(static_cast<int>(k), k < pitches.size() ? pitches[k] : 0.0);
    mirror->SetFacetRoll(static_cast<int>(k), k < rolls.size() ? rolls[k] : 0.0);
  }
  return mirror;
}

vtkSmartPointer<vtkHeliosBeamDeflector> MakeOscillating(
  const ScannerData& scanner, const ScanData& scan)
{
  auto mirror = MakeMirror<vtkHeliosOscillatingMirror>(scan);
  mirror->SetScanAngle(scan.ScanAngle);
  mirror->SetPattern(scanner.IsSinusoidal ? vtkHeliosOscillatingMirror::SINUSOIDAL
                                          : vtkHeliosOscillatingMirror::TRIANGULAR);
  mirror->SetTurningPulses(scanner.TurningPulses);
  return mirror;
}

vtkSmartPointer<vtkHeliosBeamDeflector> MakeFibers(const ScannerData& scanner, const ScanData& scan)
{
  auto fibers = vtkSmartPointer<vtkHeliosFiberArray>::New();
  fibers->SetNumberOfFibers(scanner.NumberOfFibers);
  fibers->SetScanAngle(scan.ScanAngle);
  return fibers;
}

vtkSmartPointer<vtkHeliosBeamDeflector> MakeConic(const ScanData& scan)
{
  auto mirror = MakeMirror<vtkHeliosConicMirror>(scan);
  mirror->SetScanAngle(scan.ScanAngle);
  return mirror;
}

vtkSmartPointer<vtkHeliosBeamDeflector> MakePalmer(const ScanData& scan)
{
  auto mirror = MakeMirror<vtkHeliosPalmerMirror>(scan);
  mirror->SetWobbleAngle(0.5 * scan.ScanAngle);
  return mirror;
}

vtkSmartPointer<vtkHeliosBeamDeflector> MakePrisms(const ScannerData& scanner)
{
  auto prisms = vtkSmartPointer<vtkHeliosRisleyPrisms>::New();
  prisms->SetAirRefractiveIndex(scanner.AirRefractiveIndex);
  prisms->SetIncidentBeam(scanner.IncidentBeam.GetData());
  for (int k = 0; k < vtkHeliosRisleyPrisms::MaximumNumberOfPrisms; ++k)
  {
    prisms->SetWedgeAngle(k, scanner.Prisms[k].WedgeAngle);
    prisms->SetRefractiveIndex(k, scanner.Prisms[k].RefractiveIndex);
    prisms->SetRotorFrequency(k, scanner.Prisms[k].RotorFrequency);
    prisms->SetRotorPhase(k, scanner.Prisms[k].RotorPhase);
  }
  return prisms;
}

vtkSmartPointer<vtkHeliosBeamDeflector> MakeSpinning(
  const ScannerData& scanner, const ScanData& scan)
{
  auto head = vtkSmartPointer<vtkHeliosSpinningChannels>::New();
  head->SetScanFrequency(scanner.IsClockwise ? -scan.ScanFrequency : scan.ScanFrequency);
  head->SetStartAngle(scanner.StartAngle);
  head->SetNumberOfChannels(static_cast<int>(scanner.Beams.size()));
  int channel = 0;
  for (const BeamData& beam : scanner.Beams)
  {
    head->SetElevation(channel, beam.Elevation);
    head->SetAzimuth(channel, beam.Azimuth);
    head->SetOriginOffset(channel, beam.OriginOffset);
    head->SetOriginHeight(channel, beam.OriginHeight);
    head->SetFiringTime(channel, beam.FiringTime);
    ++channel;
  }
  return head;
}

vtkSmartPointer<vtkHeliosBeamDeflector> MakeType(const ScannerData& scanner, const ScanData& scan)
{
  switch (scanner.Type)
  {
    case Optics::OscillatingMirror:
      return MakeOscillating(scanner, scan);
    case Optics::FiberArray:
      return MakeFibers(scanner, scan);
    case Optics::ConicMirror:
      return MakeConic(scan);
    case Optics::PalmerMirror:
      return MakePalmer(scan);
    case Optics::RisleyPrisms:
      return MakePrisms(scanner);
    case Optics::SpinningChannels:
      return MakeSpinning(scanner, scan);
    case Optics::RotatingMirror:
      break;
  }
  return MakeRotating(scanner, scan);
}

} // namespace

//------------------------------------------------------------------------------
std::string GetOpticsName(Optics type)
{
  std::istringstream names(OpticsNames);
  std::string name;
  for (int i = 0; i <= static_cast<int>(type); ++i)
  {
    names >> name;
  }
  return name;
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkHeliosBeamDeflector> MakeDeflector(
  const ScannerData& scanner, const ScanData& scan)
{
  const auto deflector = MakeType(scanner, scan);
  deflector->SetPulseFrequency(scan.PulseFrequency);
  deflector->SetWarmUpTime(scan.WarmUpTime);
  return deflector;
}

} // namespace helios
