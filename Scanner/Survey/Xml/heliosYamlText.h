// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Texts and comments in YAML.

#ifndef heliosYamlText_h
#define heliosYamlText_h

#include <string>
#include <vector>

namespace helios
{

/// Returns whether a text without quotes is that text for every reader of YAML, not a number, date,
/// word for true and false, or syntax.
bool IsPlainYaml(const std::string& text, bool isNumber);

/// Returns a text with characters escaped, those that YAML does not show and others.
std::string EscapeYaml(const std::string& text, const char* others);

/// Returns a text in quotes.
std::string QuoteYaml(const std::string& text);

/// Returns the lines of a comment without the blanks that all have. The first line may be beside the mark
/// of the comment, and has blanks of its own.
std::vector<std::string> SplitYamlComment(const std::string& text);

} // namespace helios

#endif
