// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosTextFile.h"

#include "heliosStatus.h"

#include <algorithm>
#include <charconv>
#include <limits>
#include <system_error>

namespace helios
{

std::string Quote(std::string_view word)
{
  constexpr std::size_t longest = 60;
  std::string text(word.substr(0, longest));
  std::replace_if(
    text.begin(), text.end(), [](unsigned char c) { return c < 32 || c == 127; }, '?');
  return '"' + text + (word.size() > longest ? "...\"" : "\"");
}

Status TextFile::Open(const std::string& path)
{
  const Status status = this->Lines.Open(path);
  if (!status.IsOk())
  {
    return status;
  }
  const auto size = this->Lines.GetSize();
  this->Lines.SetRange(0, size);
  this->Lines.SetLongestLine(std::numeric_limits<std::size_t>::max());
  this->Lines.OnBlock = [this, size](std::int64_t bytes)
  {
    const double share = static_cast<double>(bytes) / static_cast<double>(size);
    return !this->OnBlock || this->OnBlock(std::min(1.0, share));
  };
  return this->GetError().empty() ? Status() : Status::Error(this->GetError());
}

bool TextFile::Join(std::string_view& line)
{
  const std::size_t start = line.find_first_not_of(" \t");
  if (line[start] == '#')
  {
    return true;
  }
  this->Joined.clear();
  while (!line.empty() && line.back() == '\\')
  {
    line.remove_suffix(1);
    this->Joined.append(line).append(" ");
    if (!this->NextRawLine(line))
    {
      line = {};
    }
  }
  this->Joined.append(line);
  line = this->Joined;
  return this->GetError().empty() && !this->IsStopped();
}

std::string_view TextWords::NextTitle()
{
  this->HasMore();
  const char* begin = this->At;
  std::string_view word = this->ReadWord();
  while (this->HasMore())
  {
    word = this->ReadWord();
  }
  return { begin, static_cast<std::size_t>(word.data() + word.size() - begin) };
}

std::string_view TextWords::Rest()
{
  this->HasMore();
  while (this->End != this->At && IsBlank(this->End[-1]))
  {
    --this->End;
  }
  return { this->At, static_cast<std::size_t>(this->End - this->At) };
}

template <typename T>
TextWords::Number TextWords::NextNumber(T& value)
{
  if (!this->HasMore())
  {
    return Number::None;
  }
  const char* begin = this->At;
  if (*begin == '+' && begin + 1 != this->End && begin[1] != '-')
  {
    ++begin;
  }
  const auto [end, error] = std::from_chars(begin, this->End, value);
  if (error == std::errc::result_out_of_range)
  {
    return Number::Excessive;
  }
  if (error != std::errc() || (end != this->End && !IsBlank(*end)))
  {
    return Number::Malformed;
  }
  this->At = end;
  return Number::Good;
}

TextWords::Number TextWords::Next(double& value)
{
  return this->NextNumber(value);
}

TextWords::Number TextWords::Next(int& value)
{
  return this->NextNumber(value);
}

TextWords::Number TextWords::Next(std::int64_t& value)
{
  return this->NextNumber(value);
}

} // namespace helios
