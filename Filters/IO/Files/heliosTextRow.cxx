// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosTextRow.h"

#include "heliosTextFile.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <system_error>

namespace helios
{

namespace
{

/// Returns the first character that is no blank, nor a quote if these are skipped, too.
const char* SkipBlanks(const char* at, const char* end, bool skipsQuotes = false)
{
  while (at != end && (*at == ' ' || *at == '\t' || (skipsQuotes && *at == '"')))
  {
    ++at;
  }
  return at;
}

bool IsComment(const char* at, const char* end)
{
  return at != end && (*at == '#' || (*at == '/' && end - at > 1 && at[1] == '/'));
}

/// Parses a number and advances past it. False without a number.
bool ParseNumber(const char*& at, const char* end, double& value)
{
  const char* begin = at;
  if (begin != end && *begin == '+' && begin + 1 != end && begin[1] != '-')
  {
    ++begin;
  }
  const auto [behind, error] = std::from_chars(begin, end, value);
  at = error == std::errc() ? behind : at;
  return error == std::errc();
}

} // namespace

TextRow::TextRow(const std::string& separators)
{
  this->Classes.fill(InWord);
  for (const char c : separators)
  {
    this->Classes[static_cast<unsigned char>(c)] = Separator;
    this->BlankSeparates = this->BlankSeparates || c == ' ' || c == '\t';
  }
  this->Classes[' '] = this->Classes['\t'] = Blank;
  this->Classes['"'] = this->BlankSeparates ? this->Classes['"'] : Blank;
}

void TextRow::Need(int column)
{
  const auto index = static_cast<std::size_t>(column);
  this->Needed.resize(std::max(this->Needed.size(), index + 1));
  this->Needed[index] = true;
  this->Values.resize(this->Needed.size());
}

const char* TextRow::SkipWord(const char* at, const char* end) const
{
  while (at != end && this->GetClass(*at) != Separator &&
    !(this->BlankSeparates && this->GetClass(*at) == Blank))
  {
    ++at;
  }
  return at;
}

// Returns whether a column ends at wordEnd; next is the first non-blank character after it.
bool TextRow::IsWordEnd(const char* wordEnd, const char* next, const char* end) const
{
  return next == end || this->GetClass(*next) == Separator ||
    (next != wordEnd && (this->BlankSeparates || IsComment(next, end)));
}

TextRow::Result TextRow::Read(std::string_view line)
{
  this->Line = line;
  return this->ReadColumns(line.data(), line.data() + line.size());
}

TextRow::Result TextRow::ReadColumns(const char* at, const char* const end)
{
  const int count = this->GetNumberOfColumns();
  for (int column = 0; column < count; ++column)
  {
    at = SkipBlanks(at, end, !this->BlankSeparates);
    if (at == end || IsComment(at, end))
    {
      this->Column = column;
      return column == 0 ? Empty : Short;
    }
    const char* const word = at;
    double& value = this->Values[static_cast<std::size_t>(column)];
    const bool isNeeded = this->Needed[static_cast<std::size_t>(column)];
    const bool isGood = !isNeeded || ParseNumber(at, end, value);
    const char* const wordEnd = isNeeded ? at : this->SkipWord(at, end);
    at = SkipBlanks(wordEnd, end, !this->BlankSeparates);
    if (!isGood || !this->IsWordEnd(wordEnd, at, end) ||
      (isNeeded && !this->KeepInvalid && !std::isfinite(value)))
    {
      this->Column = column;
      this->Word = word;
      return Bad;
    }
    at += at != end && this->GetClass(*at) == Separator;
  }
  return Good;
}

std::string TextRow::DescribeFault(const char* kind) const
{
  const char* wordEnd = this->SkipWord(this->Word, this->Line.data() + this->Line.size());
  while (wordEnd != this->Word && this->GetClass(wordEnd[-1]) == Blank)
  {
    --wordEnd;
  }
  const std::string_view text(this->Word, static_cast<std::size_t>(wordEnd - this->Word));
  const std::string column = "column " + std::to_string(this->Column + this->FirstNumber);
  double value = 0.0;
  const char* at = this->Word;
  if (text.empty())
  {
    return column + " is empty; write a number into it";
  }
  if (ParseNumber(at, wordEnd, value) && at == wordEnd)
  {
    return Quote(text) + " in " + column + " is not finite; correct the " + kind + " or remove it";
  }
  return Quote(text) + " in " + column +
    " is not a number of double precision; write numbers such as -1.5 or 2e3, set what separates "
    "columns (Separators), and begin header lines with # or //";
}

bool TextRow::IsEmpty(std::string_view line)
{
  const char* const end = line.data() + line.size();
  const char* const at = SkipBlanks(line.data(), end);
  return at == end || IsComment(at, end);
}

} // namespace helios
