// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosRasterUnits.h"

#include "heliosCoordinateSystem.h"
#include "heliosGdal.h"

#include <algorithm>
#include <cctype>
#include <memory>

namespace helios
{

namespace
{

// Returns the lower-case letters of a name: "US survey foot", "us_survey_foot" and "US Survey Foot"
// match.
std::string Simplify(const std::string& name)
{
  std::string letters;
  for (const unsigned char c : name)
  {
    if (std::isalnum(c))
    {
      letters += static_cast<char>(std::tolower(c));
    }
  }
  return letters;
}

// Returns false for heights in feet; true also for an unknown system, which has no heights.
bool HasMetres(const std::string& wkt)
{
  CoordinateSystem system;
  return !system.Set(wkt).IsOk() || system.GetHeightUnit() == 1.0;
}

// Adds heights in metres to a map in feet without a vertical part; empty for other systems.
std::string AddMetres(const std::string& wkt)
{
  CoordinateSystem system;
  const bool isPlane = system.Set(wkt).IsOk() && !system.HasHeightUnit();
  const CoordinateSystem metric = isPlane ? system.WithHeightUnit(1.0) : CoordinateSystem();
  return metric.IsSet() ? metric.GetText() : std::string();
}

std::string GetAttribute(OGRSpatialReferenceH system, const char* name)
{
  const char* text = OSRGetAttrValue(system, name, 0);
  return text ? text : "";
}

} // namespace

double GetUnitInMetres(const std::string& name)
{
  static constexpr struct
  {
    const char* Names; // separated by blanks
    double Metres;
  } units[] = { { " m meter meters metre metres ", 1.0 },
    { " km kilometer kilometers kilometre kilometres ", 1000.0 },
    { " dm decimeter decimeters decimetre decimetres ", 0.1 },
    { " cm centimeter centimeters centimetre centimetres ", 0.01 },
    { " mm millimeter millimeters millimetre millimetres ", 0.001 },
    { " ft foot feet internationalfoot internationalfeet footinternational ", 0.3048 },
    { " usft ftus usfoot usfeet footus feetus ussurveyfoot ussurveyfeet surveyfoot surveyfeet ",
      1200.0 / 3937.0 },
    { " yd yard yards ", 0.9144 }, { " fath fathom fathoms ", 1.8288 } };
  const std::string word = ' ' + Simplify(name) + ' ';
  for (const auto& unit : units)
  {
    if (word.size() > 2 && std::string(unit.Names).find(word) != std::string::npos)
    {
      return unit.Metres;
    }
  }
  return 0.0;
}

std::string ToWkt(OGRSpatialReferenceH system)
{
  static const char* const options[] = { "FORMAT=WKT2_2019", nullptr };
  char* text = nullptr;
  OSRExportToWktEx(system, &text, options);
  std::string wkt = text ? text : "";
  CPLFree(text);
  return wkt;
}

std::string MakeHeightsMetric(const std::string& wkt)
{
  if (HasMetres(wkt))
  {
    return wkt;
  }
  if (std::string metric = AddMetres(wkt); !metric.empty())
  {
    return metric;
  }
  const std::unique_ptr<void, void (*)(OGRSpatialReferenceH)> system(
    OSRNewSpatialReference(wkt.c_str()), OSRDestroySpatialReference);
  const std::string name = GetAttribute(system.get(), "VERT_CS") + ", in metres";
  const std::string datum = GetAttribute(system.get(), "VERT_CS|VERT_DATUM");
  constexpr int anyDatum = 2005;
  if (datum.empty() || OSRStripVertical(system.get()) != OGRERR_NONE ||
    OSRSetVertCS(system.get(), name.c_str(), datum.c_str(), anyDatum) != OGRERR_NONE)
  {
    return {};
  }
  std::string metric = ToWkt(system.get());
  return HasMetres(metric) ? metric : std::string();
}

} // namespace helios
