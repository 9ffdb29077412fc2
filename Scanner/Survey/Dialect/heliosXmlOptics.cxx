// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosXmlOptics.h"

#include "heliosLegOptics.h"
#include "heliosMessages.h"

#include <algorithm>
#include <iterator>

namespace helios
{

namespace
{

void ReadType(const XmlElement& element, ScannerData& scanner)
{
  std::string optics;
  if (!element.Read("optics", optics))
  {
    return;
  }
  for (const OpticsName& name : OpticsNames)
  {
    if (optics == name.Name)
    {
      scanner.Type = name.Type;
      return;
    }
  }
  element.GetMessages().Error(element.Where() + ": scanner " + scanner.Id + ": optics=\"" + optics +
    "\" is not valid: expected rotating, oscillating, line, conic, palmer or risley");
}

void ReadPattern(const XmlElement& element, ScannerData& scanner)
{
  std::string pattern;
  if (!element.Read("scanPattern", pattern))
  {
    return;
  }
  scanner.IsSinusoidal = pattern == "sinusoidal";
  if (pattern != "triangular" && !scanner.IsSinusoidal)
  {
    element.GetMessages().Error(element.Where() + ": scanner " + scanner.Id + ": scanPattern=\"" +
      pattern + "\" is not valid: expected triangular or sinusoidal");
  }
}

/// A name with the number of a prism: its index from 0, its number in the file from 1.
std::string Numbered(const char* before, int prism, const char* after = "")
{
  return before + std::to_string(prism + 1) + after;
}

void ReadPrisms(const XmlElement& element, ScannerData& scanner)
{
  element.Read("refrIndex_air", scanner.AirRefractiveIndex);
  for (int k = 0; k < 3; ++k)
  {
    PrismData& prism = scanner.Prisms[k];
    element.Read(Numbered("angle", k, "_deg").c_str(), prism.WedgeAngle);
    element.Read(Numbered("refrIndex", k).c_str(), prism.RefractiveIndex);
    element.Read(Numbered("rotorFreq", k, "_Hz").c_str(), prism.RotorFrequency);
  }
}

void ReadIncidentBeam(const XmlElement& element, ScannerData& scanner)
{
  const XmlElement beam = element.GetChild("incidentBeam");
  if (!beam)
  {
    return;
  }
  beam.CheckNames();
  Vec3 direction(0.0, 0.0, 0.0);
  beam.ReadVector(direction);
  if (!(direction[1] > 0.0))
  {
    beam.GetMessages().Error(beam.Where() +
      ": <incidentBeam> does not point at the prisms; give a direction with y above 0");
    return;
  }
  scanner.IncidentBeam = direction;
}

/// Whether a prism bends the beam.
bool Bends(const PrismData& prism, const ScannerData& scanner)
{
  return prism.WedgeAngle != 0.0 && prism.RefractiveIndex != scanner.AirRefractiveIndex;
}

void CheckPrisms(const ScannerData& scanner, Messages& log)
{
  const std::string who = scanner.Where + ": scanner " + scanner.Id + ": ";
  if (std::none_of(std::begin(scanner.Prisms), std::end(scanner.Prisms),
        [&scanner](const PrismData& prism) { return Bends(prism, scanner); }))
  {
    log.Error(who +
      "none of its prisms bends the beam; give angle1_deg, and a refrIndex1 above refrIndex_air");
    return;
  }
  for (int k = 0; k < 3; ++k)
  {
    if (scanner.Prisms[k].WedgeAngle != 0.0 && !Bends(scanner.Prisms[k], scanner))
    {
      log.Warning(who + Numbered("prism ", k) + " does not bend the beam; give a " +
        Numbered("refrIndex", k) + " above refrIndex_air");
    }
  }
}

} // namespace

//------------------------------------------------------------------------------
void ReadOptics(const XmlElement& element, ScannerData& scanner)
{
  ReadType(element, scanner);
  ReadPattern(element, scanner);
  ReadPrisms(element, scanner);
  ReadIncidentBeam(element, scanner);
  element.Read("scanProduct", scanner.ScanProduct);
  element.Read("turningPulses", scanner.TurningPulses);
  element.Read("numFibers", scanner.NumberOfFibers);
}

//------------------------------------------------------------------------------
void ForgetOptics(ScannerData& scanner)
{
  const ScannerData fresh;
  scanner.ScanProduct = fresh.ScanProduct;
  scanner.TurningPulses = fresh.TurningPulses;
  scanner.IsSinusoidal = fresh.IsSinusoidal;
  scanner.NumberOfFibers = fresh.NumberOfFibers;
  scanner.ScanAngleMax = fresh.ScanAngleMax;
  scanner.ScanAngleEffectiveMax = fresh.ScanAngleEffectiveMax;
  scanner.ScanFrequencyMin = fresh.ScanFrequencyMin;
  scanner.ScanFrequencyMax = fresh.ScanFrequencyMax;
  std::copy(std::begin(fresh.Prisms), std::end(fresh.Prisms), scanner.Prisms);
  scanner.AirRefractiveIndex = fresh.AirRefractiveIndex;
  scanner.IncidentBeam = fresh.IncidentBeam;
}

//------------------------------------------------------------------------------
void CheckOptics(const ScannerData& scanner, Messages& log)
{
  // The angle of an oscillating mirror may be given by the leg.
  const bool hasAngle = scanner.ScanAngleMax > 0.0 || scanner.Type == Optics::OscillatingMirror;
  if (scanner.Type == Optics::RisleyPrisms)
  {
    CheckPrisms(scanner, log);
  }
  else if (!hasAngle)
  {
    log.Error(scanner.Where + ": scanner " + scanner.Id +
      ": scanAngleMax_deg is missing or 0, so no beam is deflected; give half the angle that "
      "its mirror sweeps [deg]");
  }
}

} // namespace helios
