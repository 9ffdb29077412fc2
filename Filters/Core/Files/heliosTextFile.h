// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Reads text files by lines and words, with messages about a line.

#ifndef heliosTextFile_h
#define heliosTextFile_h

#include "heliosLineFile.h"
#include "heliosStatus.h"
#include "vtkHeliosFiltersCoreModule.h" // For export macro

#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace helios
{

/// Result of a reader: at most one error, which stops reading, and warnings.
struct TextReport
{
  std::string Error;
  std::vector<std::string> Warnings;

  bool Fail(const std::string& message)
  {
    this->Error = message;
    return false;
  }
  void Warn(const std::string& message) { this->Warnings.push_back(message); }
};

/// Formats a word for messages: quoted, truncated, without control characters.
VTKHELIOSFILTERSCORE_EXPORT std::string Quote(std::string_view word);

/// Reads a file line by line, however long the lines are.
class VTKHELIOSFILTERSCORE_EXPORT TextFile
{
public:
  TextFile() = default;
  TextFile(const TextFile&) = delete;
  void operator=(const TextFile&) = delete;

  /// Runs after every block with the fraction of the file read; false stops reading.
  std::function<bool(double)> OnBlock;

  /// Opens a file.
  Status Open(const std::string& path);

  /**
   * Reads the next line, without its end (LF or CR LF); it stays valid until the next call. A
   * backslash at the end joins the line with the next one, except in a comment. False at the end of
   * the file, after an error and when stopped.
   */
  bool NextLine(std::string_view& line)
  {
    if (!this->NextRawLine(line))
    {
      return false;
    }
    this->Line = this->RawLine;
    return line.empty() || line.back() != '\\' || this->Join(line);
  }

  const std::string& GetPath() const { return this->Lines.GetPath(); }
  /// Returns the number of the last line read, from 1; the first of joined ones.
  std::int64_t GetLine() const { return this->Line; }
  /// Returns "path:line: " of the last line read.
  std::string GetPlace() const { return Place(this->GetPath(), this->Line); }
  bool IsStopped() const { return this->Lines.IsStopped(); }
  /// Returns the error message of reading; empty after success.
  const std::string& GetError() const { return this->Lines.GetError(); }

private:
  bool NextRawLine(std::string_view& line)
  {
    const bool isLine = this->Lines.NextLine(line);
    this->RawLine += isLine;
    return isLine;
  }
  bool Join(std::string_view& line);

  LineFile Lines;
  std::int64_t Line = 0;
  std::int64_t RawLine = 0;
  std::string Joined;
};

/// Splits a line into words; a word that starts with # ends the line.
class VTKHELIOSFILTERSCORE_EXPORT TextWords
{
public:
  enum class Number
  {
    Good,
    None,      ///< end of the line
    Malformed, ///< not a number: the word is next
    Excessive  ///< out of the double range: the word is next
  };

  explicit TextWords(std::string_view line)
    : At(line.data())
    , End(line.data() + line.size())
  {
  }

  static bool IsBlank(char c) { return c == ' ' || (c >= '\t' && c <= '\r'); }

  /// Returns whether another word follows.
  bool HasMore()
  {
    while (this->At != this->End && IsBlank(*this->At))
    {
      ++this->At;
    }
    return this->At != this->End && *this->At != '#';
  }

  /// Returns the next word, empty at the end of the line.
  std::string_view Next() { return this->HasMore() ? this->ReadWord() : std::string_view(); }

  ///@{
  /// Parts of a word: an integer at the current position (None: something else), a slash, the end.
  Number ReadIndex(int& value)
  {
    const char* digits = this->At + (this->At != this->End && *this->At == '-' ? 1 : 0);
    const char* at = digits;
    std::int64_t number = 0;
    for (; at != this->End && *at >= '0' && *at <= '9' && at - digits < 18; ++at)
    {
      number = 10 * number + (*at - '0');
    }
    if (at == digits)
    {
      return Number::None;
    }
    if (number >> 31)
    {
      return Number::Excessive;
    }
    value = static_cast<int>(digits == this->At ? number : -number);
    this->At = at;
    return Number::Good;
  }
  bool ReadSlash()
  {
    const bool isSlash = this->At != this->End && *this->At == '/';
    this->At += isSlash;
    return isSlash;
  }
  bool IsAtWordEnd() const { return this->At == this->End || IsBlank(*this->At); }
  ///@}

  /// Returns the next word as a name, which may start with #.
  std::string_view NextName()
  {
    this->HasMore();
    return this->ReadWord();
  }

  /// Returns the words up to a comment as one name, blanks included; the first may start with #.
  std::string_view NextTitle();

  /// Returns the rest of the line, with its comment, without surrounding blanks.
  std::string_view Rest();

  /// Reads a decimal number, correctly rounded; NaN and Inf are accepted.
  Number Next(double& value);

  /// @{
  /// Reads a decimal integer.
  Number Next(int& value);
  Number Next(std::int64_t& value);
  ///@}

private:
  template <typename T>
  Number NextNumber(T& value);

  std::string_view ReadWord()
  {
    const char* begin = this->At;
    while (this->At != this->End && !IsBlank(*this->At))
    {
      ++this->At;
    }
    return { begin, static_cast<std::size_t>(this->At - begin) };
  }

  const char* At;
  const char* End;
};

} // namespace helios

#endif
