// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// The HELIOS dialect for others, made from the rules that the readers go by and their notes.

#ifndef heliosXmlSchema_h
#define heliosXmlSchema_h

#include <string>

namespace helios
{

/// An XML schema (XSD 1.0) of all files with a <document>.
std::string MakeXmlSchema();

/// All elements and attributes as Markdown: a heading and a table an element.
std::string MakeXmlTables();

} // namespace helios

#endif
