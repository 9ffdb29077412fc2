// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// What the names of heliosXmlRules mean to people and to schemas: one line a name.

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
  const char* Text;    ///< what it is; for what is not read: why
  const char* Default = "";
  const char* Choices = ""; ///< the words that it may be, if any; '~' in front: in any letter case
};

/// The default of what must be given.
constexpr const char* Required = "required";

/// The note of a name of an element, or that of any element; an empty one where there is none.
const XmlNote& FindXmlNote(const std::string& element, const std::string& name);

/// The words that a value may be; none: any.
std::vector<std::string> GetChoices(const XmlNote& note);

bool IsRequired(const XmlNote& note);

} // namespace helios

#endif
