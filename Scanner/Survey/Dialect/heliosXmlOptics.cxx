// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosXmlOptics.h"

#include "heliosAssets.h"
#include "heliosBeamTable.h"
#include "heliosMessages.h"

#include <algorithm>
#include <iterator>

namespace helios
{

namespace
{

/// The maximum number of facets of a mirror.
constexpr std::size_t MaximumFacets = 1000;

/// Returns a name with the number of a prism: its index from 0, its number in the file from 1.
std::string Numbered(const char* before, int prism, const char* after = "")
{
  return before + std::to_string(prism + 1) + after;
}

/// Returns whether a prism bends the beam.
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

/// Reads the <beam> children.
void ReadBeamElements(const XmlElement& element, std::vector<BeamData>& beams)
{
  for (const XmlElement& child : element.GetChildren("beam"))
  {
    child.CheckNames();
    beams.emplace_back();
    child.ReadStored(beams.back());
    if (!child.Has("elevation_deg"))
    {
      child.GetMessages().Error(
        child.Where() + ": <beam> has no elevation_deg; give its angle above the horizon [deg]");
    }
  }
}

void CheckFacets(const ScannerData& scanner, Messages& log)
{
  const std::size_t pitches = scanner.FacetPitches.size();
  const std::size_t rolls = scanner.FacetRolls.size();
  const std::string who = scanner.Where + ": scanner " + scanner.Id;
  if (pitches > 0 && rolls > 0 && pitches != rolls)
  {
    log.Error(who + " has facetPitches_deg of " + std::to_string(pitches) +
      " facets, but facetRolls_deg of " + std::to_string(rolls) + "; give one value per facet");
  }
  const std::size_t facets = std::max(pitches, rolls);
  if (facets > MaximumFacets)
  {
    log.Error(who + " has " + std::to_string(facets) + " facets; give at most " +
      std::to_string(MaximumFacets));
  }
  if (facets > 0 && scanner.Type != Optics::RotatingMirror)
  {
    log.Warning(who + ": facetPitches_deg and facetRolls_deg are only used by rotating optics");
  }
}

void CheckBeamTable(const ScannerData& scanner, Messages& log)
{
  const std::string who = scanner.Where + ": scanner " + scanner.Id;
  if (scanner.Beams.empty())
  {
    log.Error(who + " has no beams; give <beams> with a file or with <beam> children");
  }
  else if (scanner.Beams.size() > MaximumBeams)
  {
    log.Error(who + " has " + std::to_string(scanner.Beams.size()) + " beams; give at most " +
      std::to_string(MaximumBeams));
  }
}

} // namespace

//------------------------------------------------------------------------------
void ReadBeams(const XmlElement& element, const Assets& files, ScannerData& scanner)
{
  const XmlElement table = element.GetChild("beams");
  if (!table)
  {
    return;
  }
  Messages& log = table.GetMessages();
  table.CheckNames();
  scanner.Beams.clear();
  scanner.BeamFile.clear();
  ReadBeamElements(table, scanner.Beams);
  if (table.Has("file") && !scanner.Beams.empty())
  {
    log.Error(table.Where() + ": <beams> has a file and <beam> children; give one of them");
  }
  else if (table.Has("file"))
  {
    scanner.BeamFile =
      files.FindFile({ "file", table.GetText("file"), table.Where("file") }, table.GetDocument());
    scanner.BeamFile.empty() ? void() : ReadBeamTable(scanner.BeamFile, scanner.Beams, log);
  }
}

//------------------------------------------------------------------------------
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

//------------------------------------------------------------------------------
void ResetOptics(ScannerData& scanner)
{
  const ScannerData fresh;
  scanner.ScanProduct = fresh.ScanProduct;
  scanner.TurningPulses = fresh.TurningPulses;
  scanner.IsSinusoidal = fresh.IsSinusoidal;
  scanner.NumberOfFibers = fresh.NumberOfFibers;
  scanner.ScanAngleMax = fresh.ScanAngleMax;
  scanner.ScanAngleEffectiveMax = fresh.ScanAngleEffectiveMax;
  scanner.FacetPitches = fresh.FacetPitches;
  scanner.FacetRolls = fresh.FacetRolls;
  scanner.ScanFrequencyMin = fresh.ScanFrequencyMin;
  scanner.ScanFrequencyMax = fresh.ScanFrequencyMax;
  std::copy(std::begin(fresh.Prisms), std::end(fresh.Prisms), scanner.Prisms);
  scanner.AirRefractiveIndex = fresh.AirRefractiveIndex;
  scanner.IncidentBeam = fresh.IncidentBeam;
  scanner.Beams = fresh.Beams;
  scanner.BeamFile = fresh.BeamFile;
  scanner.IsClockwise = fresh.IsClockwise;
  scanner.StartAngle = fresh.StartAngle;
}

//------------------------------------------------------------------------------
void CheckOptics(const ScannerData& scanner, Messages& log)
{
  // The angle of an oscillating mirror may be given by the leg; a single fibre points ahead.
  const bool isFiber = scanner.Type == Optics::FiberArray && scanner.NumberOfFibers == 1;
  const bool hasAngle =
    scanner.ScanAngleMax > 0.0 || scanner.Type == Optics::OscillatingMirror || isFiber;
  CheckFacets(scanner, log);
  if (scanner.Type == Optics::RisleyPrisms)
  {
    CheckPrisms(scanner, log);
  }
  else if (scanner.Type == Optics::SpinningChannels)
  {
    CheckBeamTable(scanner, log);
  }
  else if (!hasAngle)
  {
    log.Error(scanner.Where + ": scanner " + scanner.Id +
      ": scanAngleMax_deg is missing or 0, so no beam is deflected; give half the angle that "
      "its mirror sweeps [deg]");
  }
}

} // namespace helios
