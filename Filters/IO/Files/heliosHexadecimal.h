// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Bytes as hexadecimal digits.

#ifndef heliosHexadecimal_h
#define heliosHexadecimal_h

#include <cstddef>
#include <string>

namespace helios
{

inline std::string ToHexadecimal(const unsigned char* bytes, std::size_t count)
{
  std::string text;
  for (std::size_t i = 0; i < count; ++i)
  {
    text += "0123456789abcdef"[bytes[i] >> 4];
    text += "0123456789abcdef"[bytes[i] & 15];
  }
  return text;
}

} // namespace helios

#endif
