// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Descriptions of the names in heliosXmlRules for people and schemas: one line per name.

#ifndef heliosXmlNotes_h
#define heliosXmlNotes_h

#include <string>
#include <vector>

namespace helios
{

/// An attribute, a parameter or, without a name, an element.
struct XmlNote
{
  const char* Element; ///< empty: of any element
  const char* Name;    ///< empty: the element itself
  const char* Text;    ///< its meaning; if not read, the reason
  const char* Default = "";
  const char* Choices = ""; ///< the valid words, if any; '~' in front: case-insensitive
};

/// The default of required values.
constexpr const char* Required = "required";

/// The note of a name of an element, or that of any element; empty without a note.
const XmlNote& FindXmlNote(const std::string& element, const std::string& name);

/// The valid words of a value; empty: any.
std::vector<std::string> GetChoices(const XmlNote& note);

bool IsRequired(const XmlNote& note);

} // namespace helios

#endif
