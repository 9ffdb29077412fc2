// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Formats values for XML.

#ifndef heliosXmlText_h
#define heliosXmlText_h

#include <pugixml.hpp>

#include <charconv>
#include <cmath>
#include <iterator>
#include <sstream>
#include <string>

namespace helios
{

/// The fewest digits that read back exactly, without an exponent: other programs read 100000 as an
/// integer, but not 1e5.
inline std::string ToXmlText(double value)
{
  char digits[400]; // of the smallest number
  return { digits, std::to_chars(digits, std::end(digits), value, std::chars_format::fixed).ptr };
}

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

/// A document as text.
inline std::string ToXmlText(const pugi::xml_document& document)
{
  std::ostringstream text;
  document.save(text, "  ", pugi::format_default, pugi::encoding_utf8);
  return text.str();
}

/// An empty <document> with a comment before it.
inline pugi::xml_node StartDocument(pugi::xml_document& document, const char* comment)
{
  pugi::xml_node declaration = document.append_child(pugi::node_declaration);
  declaration.append_attribute("version") = "1.0";
  declaration.append_attribute("encoding") = "UTF-8";
  document.append_child(pugi::node_comment).set_value(comment);
  return document.append_child("document");
}

} // namespace helios

#endif
