// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Writes elements and attributes of the dialect as YAML.

#ifndef heliosYamlWriter_h
#define heliosYamlWriter_h

#include "heliosStatus.h"

#include <pugixml.hpp>

#include <string>

namespace helios
{

/// Makes the text that ReadYaml() reads as the same elements and attributes, with comments. Text of
/// elements that is no attribute becomes a comment. An error if it is not UTF-8 or too deep.
Status MakeYaml(const pugi::xml_document& tree, std::string& text);

} // namespace helios

#endif
