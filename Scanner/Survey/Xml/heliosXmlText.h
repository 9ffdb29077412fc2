// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Formats values for XML.

#ifndef heliosXmlText_h
#define heliosXmlText_h

#include "heliosXmlValue.h"

#include <pugixml.hpp>

#include <cmath>
#include <sstream>
#include <string>

namespace helios
{

///@{
/// Adds an attribute, unless it is NaN or empty.
inline void SetAttribute(pugi::xml_node node, const char* name, double value)
{
  if (!std::isnan(value))
  {
    node.append_attribute(name) = ToXmlText(value).c_str();
  }
}

inline void SetAttribute(pugi::xml_node node, const char* name, const std::string& value)
{
  if (!value.empty())
  {
    node.append_attribute(name) = value.c_str();
  }
}
///@}

/// Adds all attributes of an element that are stored in a struct and are not its defaults.
template <typename OwnerT>
void SetStored(pugi::xml_node node, const OwnerT& owner)
{
  OwnerT copy = owner;
  OwnerT fresh;
  for (const XmlValueRule* rule : FindXmlRule(node.name())->FindStored(typeid(OwnerT)))
  {
    const std::string value = FormatStored(*rule, rule->Store.Find(&copy));
    const bool isUsual = value == FormatStored(*rule, rule->Store.Find(&fresh));
    SetAttribute(node, rule->Name, isUsual || rule->IsAlias ? std::string() : value);
  }
}

/// Returns a document as text.
inline std::string ToXmlText(const pugi::xml_document& document)
{
  std::ostringstream text;
  document.save(text, "  ", pugi::format_default, pugi::encoding_utf8);
  return text.str();
}

} // namespace helios

#endif
