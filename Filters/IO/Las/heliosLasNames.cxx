// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosLasNames.h"

#include "vtkHeliosArrayNames.h"
#include "vtkHeliosFoliageArrayNames.h"

#include <algorithm>
#include <iterator>

namespace helios
{
namespace names = vtkHeliosArrayNames;
namespace foliage = vtkHeliosFoliageArrayNames;

namespace
{

struct KnownName
{
  const char* Array;
  const char* Name;
  const char* Description;
};

/// Names by the arrays of vtkHelios.
constexpr KnownName OwnNames[] = {
  { names::Range, names::Range, "distance [m]" },
  { names::Amplitude, names::Amplitude, "peak of the echo [W]" },
  { names::RelativeAmplitude, names::RelativeAmplitude, "above the threshold [dB]" },
  { names::Reflectance, names::Reflectance, "above a white plane [dB]" },
  { names::EchoWidth, names::EchoWidth, "full width at half maximum [ns]" },
  { names::Deviation, names::Deviation, "RMS residual over amplitude" },
  { names::IncidenceAngle, names::IncidenceAngle, "from the normal [deg]" },
  { names::PulseIds, names::PulseIds, "pulse of the run" },
  { names::WaveformIds, names::WaveformIds, "pulse with waveform, -1: none" },
  { names::PartIds, names::PartIds, "part of the scene" },
  { names::MaterialIds, names::MaterialIds, "material of the scene" },
  { names::CellIds, names::CellIds, "triangle of the scene" },
  { names::ChannelIds, names::ChannelIds, "channel of the scanner" },
  { foliage::TreeIds, foliage::TreeIds, "number of the tree, -1: none" },
  { foliage::SpeciesIds, foliage::SpeciesIds, "species of the tree" },
  { foliage::OrganIds, foliage::OrganIds, "1 leaf, 2 wood, 0 none" },
  { names::TruePoint, names::TruePoint, "without noise [m]" },
  { names::Normal, names::Normal, "of the surface, unit vector" },
};

/// Names by RIEGL, and a name for the power, since RIEGL uses its own.
constexpr KnownName RieglNames[] = {
  { names::RelativeAmplitude, "Amplitude", "Echo signal amplitude [dB]" },
  { names::Reflectance, "Reflectance", "Echo signal reflectance [dB]" },
  { names::EchoWidth, "Pulse width", "Full width at half maximum [ns]" },
  { names::Amplitude, "Received power", "peak of the echo [W]" },
};

/// Returns the unit at the end of a description, in brackets; empty: none.
std::string GetUnit(const std::string& description)
{
  const std::size_t begin = description.rfind('[');
  return begin == std::string::npos ? std::string() : description.substr(begin);
}

} // namespace

//------------------------------------------------------------------------------
LasName GetLasName(const std::string& array, bool hasDecibels)
{
  const auto isIt = [&array](const KnownName& known) { return array == known.Array; };
  const auto* riegl = std::find_if(std::begin(RieglNames), std::end(RieglNames), isIt);
  if (hasDecibels && riegl != std::end(RieglNames))
  {
    return { riegl->Name, riegl->Description };
  }
  const auto* own = std::find_if(std::begin(OwnNames), std::end(OwnNames), isIt);
  return { array, own == std::end(OwnNames) ? "" : own->Description };
}

//------------------------------------------------------------------------------
std::string GetLasArray(const std::string& name, const std::string& description)
{
  const auto* riegl = std::find_if(std::begin(RieglNames), std::end(RieglNames),
    [&](const KnownName& known)
    { return name == known.Name && GetUnit(description) == GetUnit(known.Description); });
  return riegl == std::end(RieglNames) ? name : riegl->Array;
}

} // namespace helios
