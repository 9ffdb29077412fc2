// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Writes a text file.

#ifndef heliosTextFileSink_h
#define heliosTextFileSink_h

#include "heliosStatus.h"

#include <charconv>
#include <cstdio>
#include <string>
#include <string_view>
#include <vector>

namespace helios
{

/**
 * Writes <path>.part, which Close renames to path: an existing file is kept until then. A file that
 * is not closed is removed.
 */
class TextFileSink
{
public:
  TextFileSink() = default;
  ~TextFileSink();
  TextFileSink(const TextFileSink&) = delete;
  void operator=(const TextFileSink&) = delete;

  /// Opens the file.
  Status Open(const std::string& path);

  void Append(std::string_view text);

  /// Writes a blank and a number with the fewest digits that restore it exactly.
  template <typename T>
  void AppendNumber(T value)
  {
    constexpr std::size_t longest = 32;
    char* at = this->Reserve(longest);
    *at++ = ' ';
    this->Used = std::to_chars(at, at + longest - 1, value).ptr - this->Buffer.data();
  }

  /// Closes the file. Returns the error since Open; without one the file is complete.
  Status Close();

private:
  char* Reserve(std::size_t count)
  {
    if (this->Used + count > this->Buffer.size())
    {
      this->Flush();
    }
    return this->Buffer.data() + this->Used;
  }
  void Flush();
  std::string Explain(int error) const;

  std::string Path;
  std::FILE* File = nullptr;
  std::vector<char> Buffer;
  std::size_t Used = 0;
  int Error = 0; // errno of the first failure
};

} // namespace helios

#endif
