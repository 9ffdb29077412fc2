// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Values as text: parsed by their rules, and formatted.

#ifndef heliosXmlValue_h
#define heliosXmlValue_h

#include "heliosXmlRule.h"
#include "vtkHeliosScannerSurveyModule.h" // For export macro

#include <cmath>
#include <string>
#include <vector>

namespace helios
{

class Messages;

/// A value in a file: its name in messages, its text, its line. In a survey made without files, the
/// place is what it belongs to, such as "leg 2".
struct XmlValue
{
  std::string Name;
  std::string Text;
  std::string Where;
  std::string Folder{}; ///< folder of the file; empty: the working directory
};

/// Returns a text without blanks and line ends around it.
std::string TrimBlanks(std::string text);

/**
 * Parse a whole text; return false, after an error with file:line, the value and the fix, if the
 * text is not valid or not in the rule's range. The target is then unchanged.
 */
bool ParseReal(const XmlValue& value, const XmlValueRule& rule, Messages& log, double& target);
bool ParseInteger(const XmlValue& value, const XmlValueRule& rule, Messages& log, int& target);
bool ParseBoolean(const XmlValue& value, Messages& log, bool& target);
bool ParseRealList(
  const XmlValue& value, const XmlValueRule& rule, Messages& log, std::vector<double>& target);
VTKHELIOSSCANNERSURVEY_EXPORT bool ParseVector(const XmlValue& value, Messages& log, Vec3& target);

/// Parses a seed: an integer, a date with time, or AUTO, which is -1.
bool ParseSeed(const XmlValue& value, Messages& log, vtkIdType& target);

/// Parses the index of one of the choices of a rule.
bool ParseChoice(const XmlValue& value, const XmlValueRule& rule, Messages& log, int& target);

/// Parses a value to its place in a struct; false after an error.
bool ParseStored(
  const XmlValue& value, const XmlValueRule& rule, Messages& log, const XmlPlace& place);

/// Returns the text that is parsed to the same value; empty: not given, as a number that is NaN, or
/// a default out of range.
std::string FormatStored(const XmlValueRule& rule, const XmlPlace& place);

/// Describes the default of a value for people: its struct's, or a phrase; empty: none.
std::string DescribeDefault(const XmlValueRule& rule);

/// Returns the fewest digits that read back exactly, without an exponent: other programs read
/// 100000 as an integer, but not 1e5.
VTKHELIOSSCANNERSURVEY_EXPORT std::string ToXmlText(double value);

/// @{
/// Returns a computed length [m] or angle [degrees] to its billionth, so that 0.1 + 0.2 is saved as
/// 0.3. Numbers of 2^53 billionths and more, which a double does not hold, stay as they are.
inline double RoundComputed(double value)
{
  return std::abs(value) < 9.0e6 ? std::round(value * 1e9) / 1e9 : value;
}

inline Vec3 RoundComputed(const Vec3& v)
{
  return { RoundComputed(v[0]), RoundComputed(v[1]), RoundComputed(v[2]) };
}
///@}

} // namespace helios

#endif
