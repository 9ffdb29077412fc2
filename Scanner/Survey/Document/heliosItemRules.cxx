// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosItemRules.h"

#include "heliosElementPath.h"

#include <map>

namespace helios
{

//------------------------------------------------------------------------------
const ItemRow& GetRow(SurveyItem item)
{
  static const std::map<SurveyItem, ItemRow> rows = {
    { SurveyItem::Survey, { { "survey" }, {} } },
    { SurveyItem::Scene, { { "scene" }, {} } },
    { SurveyItem::Part, { { "part" }, {} } },
    { SurveyItem::PartTable, { { "partTable" }, {} } },
    { SurveyItem::Scanner,
      { { "scanner", "FWFSettings" },
        { "channel", "beamOrigin", "rangeError", "deflectionError", "headError",
          "panoramicError" } } },
    { SurveyItem::Platform,
      { { "platform" },
        { "scannerMount", "positionXNoise", "positionYNoise", "positionZNoise", "attitudeXNoise",
          "attitudeYNoise", "attitudeZNoise", "navigationError" } } },
    { SurveyItem::Leg, { { "platformSettings", "scannerSettings", "leg" }, {} } },
  };
  return rows.at(item);
}

//------------------------------------------------------------------------------
const XmlElementRule* FindRule(SurveyItem item, const std::string& name)
{
  for (const char* tag : GetRow(item).Own)
  {
    const XmlElementRule* rule = FindXmlRule(tag);
    if (ElementPath::Knows(*rule, name))
    {
      return rule;
    }
  }
  return nullptr;
}

//------------------------------------------------------------------------------
std::string MakeFullPath(const XmlElementRule& rule, pugi::xml_node node, const std::string& path)
{
  const bool isOwn = std::string(rule.Name) == node.name() || std::string(node.name()) == "channel";
  return isOwn && std::string(rule.Name) != "FWFSettings" ? path
                                                          : std::string(rule.Name) + "/" + path;
}

//------------------------------------------------------------------------------
bool IsSame(const XmlValueRule& a, const XmlValueRule& b)
{
  const bool isOne = static_cast<bool>(a.Store.Owner) == static_cast<bool>(b.Store.Owner);
  const bool isSameName = std::string(a.Name) == b.Name && (isOne || a.Kind == XmlKind::Real);
  return a.Use == XmlUse::Used && b.Use == XmlUse::Used &&
    (a.Store.Owner && b.Store.Owner ? a.Store.Find == b.Store.Find : isSameName);
}

//------------------------------------------------------------------------------
bool IsTolerance(const std::string& name)
{
  return name == "rangeTolerance_m" || name == "energyTolerance";
}

} // namespace helios
