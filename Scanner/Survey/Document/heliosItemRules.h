// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// The elements of the dialect that have the attributes of the items of a survey.

#ifndef heliosItemRules_h
#define heliosItemRules_h

#include "heliosSurveyDocument.h"

#include <string>
#include <vector>

namespace helios
{

/// The elements with the attributes of an item.
struct ItemRow
{
  std::vector<const char*> Own; ///< named without a prefix; the first one that knows a name is set
  std::vector<const char*> Inside; ///< with one value each, named element/attribute
};

const ItemRow& GetRow(SurveyItem item);

/// Returns the first of the elements of an item that knows a name; null: none.
const XmlElementRule* FindRule(SurveyItem item, const std::string& name);

/// Returns the path from the element of an item, which begins with the name of an element inside it.
std::string MakeFullPath(const XmlElementRule& rule, pugi::xml_node node, const std::string& path);

/// Returns whether two attributes are one value of the data.
bool IsSame(const XmlValueRule& a, const XmlValueRule& b);

///@{
/// A fixed number of sub-rays and tolerances of adaptive ones exclude each other.
bool IsTolerance(const std::string& name);
constexpr const char* FixedSubRays = "beamSampleQuality";
///@}

} // namespace helios

#endif
