// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosXmlKin.h"

#include "heliosXmlRules.h"

namespace helios
{

namespace
{

const std::string FilterPrefix = "filter:";

} // namespace

//------------------------------------------------------------------------------
XmlKin FindXmlKin(const XmlElementRule& rule, const std::string& name)
{
  const XmlChildRule* child = rule.FindChild(name);
  if (child && child->Use == XmlUse::Used && name != "filter")
  {
    const XmlElementRule* own = FindXmlRule(name);
    return own ? XmlKin{ own, name, "", name, child->Repeats } : XmlKin();
  }
  if (const XmlElementRule* filter = FindXmlRule(FilterPrefix + name);
      filter && rule.FindChild("filter"))
  {
    return { filter, "filter", "type", name, true };
  }
  const XmlValueRule* value = IsFilterRule(rule) ? rule.FindValue(name) : nullptr;
  return value && value->Kind == XmlKind::Rotation
    ? XmlKin{ FindXmlRule("param"), "param", "key", name, false }
    : XmlKin();
}

//------------------------------------------------------------------------------
std::vector<std::string> ListXmlNames(const XmlElementRule& rule)
{
  std::vector<std::string> names;
  for (const XmlValueRule& value : rule.Values)
  {
    names.emplace_back(value.Name);
  }
  for (const XmlChildRule& child : rule.Children)
  {
    names.emplace_back(child.Name);
  }
  for (const XmlElementRule& other : GetXmlRules())
  {
    if (rule.FindChild("filter") && IsFilterRule(other))
    {
      names.push_back(std::string(other.Name).substr(FilterPrefix.size()));
    }
  }
  return names;
}

//------------------------------------------------------------------------------
bool IsFilterRule(const XmlElementRule& rule)
{
  return std::string(rule.Name).compare(0, FilterPrefix.size(), FilterPrefix) == 0;
}

//------------------------------------------------------------------------------
const XmlElementRule* FindFilterRule(const std::string& type)
{
  return FindXmlRule(FilterPrefix + GetFilterType(type));
}

//------------------------------------------------------------------------------
std::string GetFilterType(const std::string& given)
{
  const std::string type = ToLower(given);
  return type == "crstransform" || type == "transform" ? "crs" : type;
}

} // namespace helios
