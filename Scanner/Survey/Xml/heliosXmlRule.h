// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// The rows of the table of the HELIOS dialect: elements, attributes and children. A row gives reading,
// default, checking, writing, schema and documentation of an attribute.

#ifndef heliosXmlRule_h
#define heliosXmlRule_h

#include "heliosStatus.h"
#include "heliosXmlStore.h"
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

/// How a value names files.
enum class XmlFile
{
  None,
  Needed,   // a file, searched in the asset directories
  Optional, // likewise, or another word
  Pattern,  // a folder and a regular expression
  Beside    // a file beside the document or in the working directory, or another word
};

/// The use of a value.
enum class XmlUse
{
  Used,
  Listed,     // for lists of instruments only
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
  bool AboveLow = false; // Low itself is excluded

  bool Contains(double value) const
  {
    return (this->AboveLow ? value > this->Low : value >= this->Low) && value <= this->High &&
      (value == 0.0 || this->Low < 0.0 || value >= SmallestNumber);
  }
};

/// An attribute of an element, or a parameter of a filter: a row of the table. Its methods return
/// the row with one more property.
struct VTKHELIOSSCANNERSURVEY_EXPORT XmlValueRule
{
  const char* Name = "";
  const char* Note = ""; ///< its meaning; if not read, the reason
  XmlKind Kind = XmlKind::Text;
  XmlUse Use = XmlUse::Used;
  const char* Unit = "";
  XmlRange Range = { -LargestNumber, LargestNumber };
  const char* DefaultText = ""; ///< a phrase, if the default is not a struct's
  const char* Choices = "";     ///< the valid words, if any; '~' in front: case-insensitive
  std::vector<std::string> (*FindChoices)() = nullptr; ///< all valid words; null: Choices
  const int* Values = nullptr; ///< values of the choices in an enumeration; null: 0, 1, 2 ...
  XmlStore Store;
  double Scale = 1.0; ///< factor from the number in the file to the number in the struct
  Status (*FindFault)(const std::string& text) = nullptr; ///< the end of a message
  bool IsRequired = false;                                ///< in files
  bool IsInverted = false;                                ///< a boolean whose opposite is stored
  bool HasBlanks = false;                                 ///< blanks and tabs are part of the text
  bool IsAlias = false; ///< another name of an attribute, which overrides it
  XmlFile File = XmlFile::None;

  ///@{
  XmlValueRule In(const char* unit) const;
  XmlValueRule In(const char* unit, const XmlRange& range) const;
  XmlValueRule Default(const char* text) const;
  XmlValueRule Required() const;
  XmlValueRule Listed() const;
  XmlValueRule Ignored() const;
  XmlValueRule Later() const; ///< not modelled yet
  XmlValueRule Meaning(const int* values) const;
  XmlValueRule From(std::vector<std::string> (*findChoices)()) const;
  XmlValueRule Scaled(double scale) const;
  XmlValueRule Inverted() const;
  XmlValueRule Checked(Status (*findFault)(const std::string& text)) const;
  XmlValueRule KeepsBlanks() const;
  XmlValueRule Alias() const;
  XmlValueRule Names(XmlFile file) const;
  ///@}

  /// Stores the value in a struct at a chain of members and indices of arrays.
  template <auto First, auto... Rest>
  XmlValueRule At() const
  {
    XmlValueRule rule = *this;
    rule.Store = MakeStore<First, Rest...>();
    return rule;
  }

  /// Stores the value in a member of a struct by Set(member, value, log), and gets it by
  /// Get(member).
  template <auto Set, auto Get, auto Member>
  XmlValueRule By() const
  {
    XmlValueRule rule = *this;
    rule.Store = MakeAccess<Set, Get, Member>();
    return rule;
  }

  /// Returns the valid words; empty: any.
  std::vector<std::string> GetChoices() const;

  /// Returns whether the case of words does not matter.
  bool IsAnyCase() const { return *this->Choices == '~'; }
};

struct XmlChildRule
{
  const char* Name;
  bool Repeats = false;
  XmlUse Use = XmlUse::Used;
  const char* Note = ""; ///< if it is not an element of the table

  XmlChildRule Ignored() const;
};

struct XmlElementRule
{
  const char* Name;
  const char* Note;
  std::vector<XmlValueRule> Values;
  std::vector<XmlChildRule> Children;

  /// Returns the rule of a value or child; null if the dialect does not know it.
  const XmlValueRule* FindValue(const std::string& name) const;
  const XmlChildRule* FindChild(const std::string& name) const;

  /// Returns the value or child with the name nearest to a misspelt one; empty if none is near.
  std::string FindNearestValue(const std::string& name) const;
  std::string FindNearestChild(const std::string& name) const;

  /// Returns the values that are stored in a struct of a type, aliases first.
  std::vector<const XmlValueRule*> FindStored(const std::type_info& type) const;
};

} // namespace helios

#endif
