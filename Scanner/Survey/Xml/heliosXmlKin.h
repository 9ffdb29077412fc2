// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// The names of elements in paths and in YAML: filters are named by their type, as in
// translate/offset instead of filter[0]/param[0]/value.

#ifndef heliosXmlKin_h
#define heliosXmlKin_h

#include "heliosXmlRule.h"

#include <string>
#include <vector>

namespace helios
{

/// The children of an element that a name stands for.
struct XmlKin
{
  const XmlElementRule* Rule = nullptr; ///< rule of the children; null: no child has the name
  std::string Tag;
  std::string Key; ///< the attribute that tells them from others of the tag; empty: none
  std::string Name;
  bool Repeats = false;
};

/// Returns the children of an element, or of a filter by its type, that a name stands for.
XmlKin FindXmlKin(const XmlElementRule& rule, const std::string& name);

/// Returns all names of attributes and children of an element, and the types of filters that it may have.
std::vector<std::string> ListXmlNames(const XmlElementRule& rule);

/// Returns whether a rule is one of a filter by its type, whose values are its parameters.
bool IsFilterRule(const XmlElementRule& rule);

/// Returns the rule of a filter by its type, whatever its case; null if the dialect does not know it.
const XmlElementRule* FindFilterRule(const std::string& type);

/// Returns the type of a filter as in FindXmlRule(), whatever its case, without aliases.
std::string GetFilterType(const std::string& given);

} // namespace helios

#endif
