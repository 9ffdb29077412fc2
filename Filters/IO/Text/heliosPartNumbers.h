// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Numbers of scene parts that a text gives by name, or by number.

#ifndef heliosPartNumbers_h
#define heliosPartNumbers_h

#include <string>
#include <string_view>
#include <unordered_map>
#include <unordered_set>
#include <vector>

namespace helios
{

/**
 * A name gets the next number that no part has. A word that is a number is the part of that number,
 * unless a name has got it: then the word is a name.
 */
class PartNumbers
{
public:
  PartNumbers() = default;

  /// Starts with the names of the parts 0, 1, ... of a scene; these are also known by number.
  explicit PartNumbers(std::vector<std::string> names);

  int Get(std::string_view word);

  /// Returns the names by number; empty ones are not named.
  const std::vector<std::string>& GetNames() const { return this->Names; }

private:
  int GetNamed(const std::string& name);

  std::vector<std::string> Names;
  std::size_t NumberOfKnown = 0;
  std::unordered_map<std::string, int> Numbers; // by name
  std::unordered_set<int> Taken;                // by words that are numbers
  std::string LastWord;
  int LastNumber = 0;
};

} // namespace helios

#endif
