// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Mutates the bytes of a file, the same way for the same seed, to test readers.

#ifndef heliosMutation_h
#define heliosMutation_h

#include <algorithm>
#include <cstdlib>
#include <iterator>
#include <random>
#include <string>

namespace helios
{

/// Number of mutated files that a test passes to a reader: HELIOS_MUTATIONS, or 200.
inline int GetNumberOfMutations()
{
  const char* text = std::getenv("HELIOS_MUTATIONS");
  const int number = text ? std::atoi(text) : 0;
  return number > 0 ? number : 200;
}

/// One to four of: truncated, bytes changed, removed, duplicated, moved, or replaced by critical
/// values.
class Mutator
{
public:
  explicit Mutator(unsigned seed)
    : Generator(seed)
  {
  }

  std::string operator()(std::string bytes)
  {
    for (std::size_t n = 1 + this->Below(4); n > 0; --n)
    {
      this->Damage(bytes);
    }
    return bytes;
  }

  /// Replaces one of the numbers; the rest of the text is unchanged.
  std::string ChangeNumber(std::string text)
  {
    static const char* const values[] = { "1e308", "-1e308", "1e-320", "1e999", "0", "-0", "-1",
      "2147483648", "9223372036854775808", "99999999999999999999", "nan", "null", "\"\"", "[]" };
    static const char* const digits = "0123456789";
    std::size_t first = text.find_first_of(digits, this->Below(text.size()));
    first = first == std::string::npos ? text.find_first_of(digits) : first;
    if (first != std::string::npos)
    {
      const std::size_t end = text.find_first_not_of(digits, first);
      text.replace(first, end - first, values[this->Below(std::size(values))]);
    }
    return text;
  }

private:
  std::size_t Below(std::size_t end) { return end > 0 ? this->Generator() % end : 0; }

  void Damage(std::string& bytes)
  {
    static const char* const traps[] = { "nan", "-inf", "1e999", "-1", "0", "4294967296",
      "99999999999999999999", "1,5", "\n", "\r", " ", "\t", "/", "//", "\\\n", "#", "<", ">", "&",
      "\"", "\xef\xbb\xbf", "\xff\xfe" };
    const std::size_t at = this->Below(bytes.size() + 1);
    const std::size_t length = std::min(1 + this->Below(16), bytes.size() - at);
    switch (this->Below(7))
    {
      case 0:
        bytes.resize(at);
        break;
      case 1:
        for (std::size_t i = at; i < at + length; ++i)
        {
          bytes[i] = static_cast<char>(this->Below(256));
        }
        break;
      case 2:
        bytes.erase(at, length);
        break;
      case 3:
        bytes.insert(at, bytes.substr(at, length));
        break;
      case 4:
        bytes.insert(this->Below(bytes.size() + 1), bytes.substr(at, length));
        break;
      case 5:
        bytes.replace(at, length, traps[this->Below(std::size(traps))]);
        break;
      default:
        bytes.insert(at, length, '\0');
    }
  }

  std::mt19937 Generator; // gives the same sequence everywhere
};

} // namespace helios

#endif
