// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosPartNumbers.h"

#include <charconv>
#include <system_error>
#include <utility>

namespace helios
{

namespace
{

bool ParseNumber(std::string_view word, int& number)
{
  const char* end = word.data() + word.size();
  const auto [behind, error] = std::from_chars(word.data(), end, number);
  return error == std::errc() && behind == end;
}

} // namespace

PartNumbers::PartNumbers(std::vector<std::string> names)
  : Names(std::move(names))
  , NumberOfKnown(this->Names.size())
{
  for (std::size_t part = 0; part < this->Names.size(); ++part)
  {
    this->Numbers.emplace(this->Names[part], static_cast<int>(part));
  }
}

int PartNumbers::Get(std::string_view word)
{
  if (word != this->LastWord || word.empty())
  {
    this->LastWord = word;
    int number = 0;
    const bool isNumber = ParseNumber(word, number);
    const auto index = static_cast<std::size_t>(number); // a negative one is beyond all names
    const bool isFree =
      index < this->NumberOfKnown || index >= this->Names.size() || this->Names[index].empty();
    if (isNumber && isFree)
    {
      this->Taken.insert(number);
    }
    this->LastNumber = isNumber && isFree ? number : this->GetNamed(this->LastWord);
  }
  return this->LastNumber;
}

int PartNumbers::GetNamed(const std::string& name)
{
  const auto known = this->Numbers.find(name);
  if (known != this->Numbers.end())
  {
    return known->second;
  }
  while (this->Taken.count(static_cast<int>(this->Names.size())) > 0)
  {
    this->Names.emplace_back();
  }
  const int number = static_cast<int>(this->Names.size());
  this->Names.push_back(name);
  this->Numbers.emplace(name, number);
  return number;
}

} // namespace helios
