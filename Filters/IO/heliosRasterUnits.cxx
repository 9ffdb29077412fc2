// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosRasterUnits.h"

#include "heliosCoordinateSystem.h"

#include <cpl_conv.h>
#include <ogr_srs_api.h>

#include <algorithm>
#include <cctype>
#include <memory>

namespace helios
{

namespace
{

// The letters of a name, small: "US survey foot", "us_survey_foot" and "US Survey Foot" are one.
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

bool IsMetric(const std::string& wkt)
{
  CoordinateSystem system;
  return system.Set(wkt).empty() && system.GetHeightUnit() == 1.0;
}

} // namespace

double GetUnitInMetres(const std::string& name)
{
  static constexpr struct
  {
    const char* Names; // in blanks
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

std::string MakeHeightsMetric(const std::string& wkt)
{
  if (IsMetric(wkt))
  {
    return wkt;
  }
  const std::unique_ptr<void, void (*)(OGRSpatialReferenceH)> system(
    OSRNewSpatialReference(wkt.c_str()), OSRDestroySpatialReference);
  const char* name = system ? OSRGetAttrValue(system.get(), "VERT_CS", 0) : nullptr;
  const char* datum = system ? OSRGetAttrValue(system.get(), "VERT_CS|VERT_DATUM", 0) : nullptr;
  constexpr int anyDatum = 2005;
  if (!name || !datum ||
    OSRSetVertCS(system.get(), (std::string(name) + ", in metres").c_str(),
      std::string(datum).c_str(), anyDatum) != OGRERR_NONE)
  {
    return {};
  }
  char* text = nullptr;
  static const char* const options[] = { "FORMAT=WKT2_2019", nullptr };
  OSRExportToWktEx(system.get(), &text, options);
  const std::string metric = text ? text : "";
  CPLFree(text);
  return IsMetric(metric) ? metric : std::string();
}

} // namespace helios
