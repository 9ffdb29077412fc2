// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosTextFormat.h"

#include <limits>

namespace helios
{

void TextBuffer::AppendHuge(double value, int decimals)
{
  constexpr std::size_t longest = std::numeric_limits<double>::max_exponent10 + 32;
  char* at = this->Reserve(longest);
  const char* end = std::to_chars(at, at + longest, value, std::chars_format::fixed, decimals).ptr;
  this->Size += static_cast<std::size_t>(end - at);
  this->Finite = this->Finite && std::isfinite(value);
}

} // namespace helios
