// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// The comments of a text in YAML, which its library does not read.

#ifndef heliosYamlComments_h
#define heliosYamlComments_h

#include <pugixml.hpp>
#include <yaml.h>

#include <string>
#include <vector>

namespace helios
{

/// The lines of a text that have only a comment, in order.
class YamlComments
{
public:
  explicit YamlComments(const std::string& text);

  /// Adds to an element the next comments before a line that begin in a column or right of it; those
  /// between blank lines are one.
  void Add(pugi::xml_node parent, std::size_t end, std::size_t column = 0);

  /// Adds to the document the comments above a blank line before a line.
  void AddHead(pugi::xml_node parent, std::size_t end);

  /// Adds all others.
  void AddRest(pugi::xml_node parent) { this->Add(parent, this->Lines.size()); }

  /// Passes the lines of a text, which has no comments.
  void Pass(const yaml_node_t& scalar);

private:
  std::vector<std::string> Lines;
  std::size_t NextLine = 0;
};

} // namespace helios

#endif
