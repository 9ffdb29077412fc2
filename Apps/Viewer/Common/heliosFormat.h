// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Number formatting.

#ifndef heliosFormat_h
#define heliosFormat_h

#include <cmath>
#include <cstdarg>
#include <cstdio>
#include <string>

namespace helios::viewer
{

/// Formats like printf, up to 255 characters.
__attribute__((format(printf, 1, 2))) inline std::string Format(const char* format, ...)
{
  char text[256];
  va_list arguments;
  va_start(arguments, format);
  std::vsnprintf(text, sizeof(text), format, arguments);
  va_end(arguments);
  return text;
}

} // namespace helios::viewer

#endif
