// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Reads YAML into the elements and attributes of the dialect.

#ifndef heliosYamlReader_h
#define heliosYamlReader_h

#include <string>

namespace helios
{

class XmlDocument;

/// The key of a list of elements whose order matters, each with its name: children: [{leg: ...}, ...].
constexpr const char* YamlChildren = "children";

/**
 * Reads a text into the tree of a document. The root is a mapping, the children of <document>; a
 * mapping is an element and a list of them several ones; a text is an attribute, as it is written.
 * Filters are named by their types, as in paths, and their parameters by their keys. False, after an
 * error with file:line, if it is not YAML or its size has no bounds; other errors are only reported.
 */
bool ReadYaml(const std::string& text, XmlDocument& document);

} // namespace helios

#endif
