// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Exports the HELIOS dialect, from the rules of the readers and their notes.

#ifndef heliosXmlSchema_h
#define heliosXmlSchema_h

#include <string>

namespace helios
{

/// Returns an XML schema (XSD 1.0) of all files with a <document>.
std::string MakeXmlSchema();

/// Returns all elements and attributes as Markdown: one heading and table per element.
std::string MakeXmlTables();

} // namespace helios

#endif
