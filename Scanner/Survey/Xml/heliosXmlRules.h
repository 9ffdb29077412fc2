// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// The HELIOS dialect: every element with its attributes and children, in one table.

#ifndef heliosXmlRules_h
#define heliosXmlRules_h

#include "vtkHeliosScannerSurveyModule.h" // For export macro

#include <string>
#include <vector>

namespace helios
{

/// The syntax of a value.
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

/// The use of a value.
enum class XmlUse
{
  Used,
  Ignored,    // irrelevant for a simulation: a title, a colour
  NotModelled // part of the dialect, causes one warning
};

/// The largest number unless a rule is narrower.
constexpr double LargestNumber = 1e12;

/// The smallest positive value of nonnegative numbers: quotients and squares stay finite.
/// Coordinates and angles may be closer to 0 through rounding.
constexpr double SmallestNumber = 1e-30;

/// The valid range of a number.
struct XmlRange
{
  double Low;
  double High;
  bool AboveLow; // Low itself is excluded

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

  /// The rule of a value or child; null if the dialect does not know it.
  const XmlValueRule* FindValue(const std::string& name) const;
  const XmlChildRule* FindChild(const std::string& name) const;

  /// The value or child with the name nearest to a misspelt one; empty if none is near.
  std::string FindNearestValue(const std::string& name) const;
  std::string FindNearestChild(const std::string& name) const;
};

/// The rule of an element; null if the dialect does not know it. The parameters of a scene filter
/// are the values of "filter:<type>".
const XmlElementRule* FindXmlRule(const std::string& element);

/// All rules.
VTKHELIOSSCANNERSURVEY_EXPORT const std::vector<XmlElementRule>& GetXmlRules();

/// The text in lower case.
std::string ToLower(std::string text);

/// The name nearest to a misspelt one by edit distance, case-insensitive; empty if none is near.
std::string FindNearestName(const std::string& name, const std::vector<std::string>& names);

} // namespace helios

#endif
