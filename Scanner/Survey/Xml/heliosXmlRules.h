// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// The HELIOS dialect: every element with its attributes and children, in one table.

#ifndef heliosXmlRules_h
#define heliosXmlRules_h

#include "heliosXmlRule.h"
#include "vtkHeliosScannerSurveyModule.h" // For export macro

#include <string>
#include <vector>

namespace helios
{

/// Returns the rule of an element; null if the dialect does not know it. The parameters of a scene
/// filter are the values of "filter:<type>".
const XmlElementRule* FindXmlRule(const std::string& element);

/// Returns all rules.
VTKHELIOSSCANNERSURVEY_EXPORT const std::vector<XmlElementRule>& GetXmlRules();

/// Returns the text in lower case.
std::string ToLower(std::string text);

/// Returns the name nearest to a misspelt one by edit distance, case-insensitive; empty if none is
/// near.
std::string FindNearestName(const std::string& name, const std::vector<std::string>& names);

} // namespace helios

#endif
