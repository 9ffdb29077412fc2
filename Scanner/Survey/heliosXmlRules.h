// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// What the HELIOS dialect knows: every element with its attributes and children, in one table.

#ifndef heliosXmlRules_h
#define heliosXmlRules_h

#include "vtkHeliosScannerSurveyModule.h" // For export macro

#include <string>
#include <vector>

namespace helios
{

/// What a value is written as.
enum class XmlKind
{
  Text,
  Real,
  Integer,
  Boolean,
  RealList, // comma separated
  Vector,   // three numbers, semicolon separated
  Rotation, // <rot> children
  Reference // file.xml#id, #id or id
};

/// What becomes of a value.
enum class XmlUse
{
  Used,
  Ignored,    // means nothing for a simulation: a title, a colour
  NotModelled // belongs to the dialect, warned of once
};

/// The largest number where nothing narrower is said.
constexpr double LargestNumber = 1e12;

/// The smallest but 0 of numbers that are not negative: quotients and squares stay numbers. Coordinates
/// and angles may come as near to 0 as rounding brings them.
constexpr double SmallestNumber = 1e-30;

/// The numbers that a value may have.
struct XmlRange
{
  double Low;
  double High;
  bool AboveLow; // Low itself is not in it

  bool Contains(double value) const
  {
    return (this->AboveLow ? value > this->Low : value >= this->Low) && value <= this->High &&
      (value == 0.0 || this->Low < 0.0 || value >= SmallestNumber);
  }
};

/// An attribute of an element, or a parameter of a filter.
struct XmlValueRule
{
  const char* Name;
  XmlKind Kind = XmlKind::Text;
  XmlUse Use = XmlUse::Used;
  const char* Unit = "";
  XmlRange Range = { -LargestNumber, LargestNumber, false };
};

struct XmlChildRule
{
  const char* Name;
  bool Repeats = false;
  XmlUse Use = XmlUse::Used;
};

struct XmlElementRule
{
  const char* Name;
  std::vector<XmlValueRule> Values;
  std::vector<XmlChildRule> Children;

  /// The rule of a value or child; null where the dialect does not know it.
  const XmlValueRule* FindValue(const std::string& name) const;
  const XmlChildRule* FindChild(const std::string& name) const;

  /// The value or child whose name is nearest to a misspelt one; empty where none is near.
  std::string FindNearestValue(const std::string& name) const;
  std::string FindNearestChild(const std::string& name) const;
};

/// The rule of an element; null where the dialect does not know it. The parameters of a scene
/// filter are the values of "filter:<type>".
const XmlElementRule* FindXmlRule(const std::string& element);

/// All of them.
VTKHELIOSSCANNERSURVEY_EXPORT const std::vector<XmlElementRule>& GetXmlRules();

/// A text in lower case.
std::string ToLower(std::string text);

/// Of some names the one nearest to a misspelt one by edit distance, upper and lower case being
/// equal; empty where none is near.
std::string FindNearestName(const std::string& name, const std::vector<std::string>& names);

} // namespace helios

#endif
