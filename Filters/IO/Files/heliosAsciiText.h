// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Text in headers that are ASCII.

#ifndef heliosAsciiText_h
#define heliosAsciiText_h

#include <string>

namespace helios
{

/// @{
/// Writes text as ASCII without backslashes, characters beyond it as \u and four hexadecimal digits
/// (in UTF-16), and reads it back. Text that is not UTF-8 is escaped byte by byte, as Latin-1.
std::string EscapeText(const std::string& text);
std::string UnescapeText(const std::string& text);
///@}

} // namespace helios

#endif
