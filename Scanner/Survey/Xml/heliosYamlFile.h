// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// A text in YAML, as the library for it reads it.

#ifndef heliosYamlFile_h
#define heliosYamlFile_h

#include "heliosStatus.h"

#include <yaml.h>

#include <string>

namespace helios
{

/// The parser, and the document that it has loaded.
class YamlFile
{
public:
  explicit YamlFile(const std::string& text);
  ~YamlFile();
  YamlFile(const YamlFile&) = delete;
  void operator=(const YamlFile&) = delete;

  /// Checks a whole text before it is loaded: the library looks at all open brackets and at all anchors
  /// again and again. An error begins with the line.
  static Status Check(const std::string& text);

  /// Loads the next document, whose root is null after the last one.
  Status Load();

  /// The root of the document, and a node by its index, from 1.
  const yaml_node_t* GetRoot() { return yaml_document_get_root_node(&this->Document); }
  const yaml_node_t& Get(int index) { return *yaml_document_get_node(&this->Document, index); }

  ///@{
  /// The number of nodes of the document; the index of one, from 0.
  std::size_t GetSize() const
  {
    return static_cast<std::size_t>(this->Document.nodes.top - this->Document.nodes.start);
  }
  std::size_t GetIndex(const yaml_node_t& node) const
  {
    return static_cast<std::size_t>(&node - this->Document.nodes.start);
  }
  ///@}

private:
  Status FindFault() const;
  bool Parse(yaml_event_t& event, int& levels, int& anchors);

  const std::string& Text;
  yaml_parser_t Parser{};
  yaml_document_t Document{};
};

} // namespace helios

#endif
