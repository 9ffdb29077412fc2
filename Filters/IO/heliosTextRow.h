// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// A row of a text file as numbers in columns.

#ifndef heliosTextRow_h
#define heliosTextRow_h

#include <array>
#include <cctype>
#include <string>
#include <string_view>
#include <vector>

namespace helios
{

/**
 * Reads the columns that are needed, strictly and correctly rounded. Separators is the set of
 * characters between columns: a blank or a tab stands for any run of blanks and tabs, and blanks
 * beside a separator never count. What follows a word that starts with # or // is a comment.
 */
class TextRow
{
public:
  explicit TextRow(const std::string& separators);

  /// Whether a character may separate columns: none of digits, letters, + - . # / may.
  static bool IsSeparator(char c)
  {
    return !std::isalnum(static_cast<unsigned char>(c)) && c != '\n' &&
      std::string_view("+-.#/").find(c) == std::string_view::npos;
  }

  /// From here on the number in a column is read.
  void Need(int column);
  int GetNumberOfColumns() const { return static_cast<int>(this->Needed.size()); }

  enum Result : char
  {
    Good,
    Empty, ///< nothing but blanks and a comment
    Short, ///< columns are missing from GetColumn() on
    Bad    ///< what is in GetColumn() is no finite number; DescribeFault() says why
  };

  Result Read(std::string_view line);

  double GetValue(int column) const { return this->Values[static_cast<std::size_t>(column)]; }
  const double* GetValues() const { return this->Values.data(); }
  int GetColumn() const { return this->Column; }

  /// What is wrong with a bad row, and what kind of rows there are ("point"); for messages.
  std::string DescribeFault(const char* kind) const;

  /// Whether a line is nothing but blanks and a comment.
  static bool IsEmpty(std::string_view line);

  /// Whether any word of the line last read is a number.
  bool HasNumber() const;

private:
  enum CharacterClass : char
  {
    InWord,
    Blank,
    Separator
  };

  CharacterClass GetClass(char c) const { return this->Classes[static_cast<unsigned char>(c)]; }
  const char* SkipWord(const char* at, const char* end) const;
  bool IsWordEnd(const char* wordEnd, const char* next, const char* end) const;
  Result ReadColumns(const char* at, const char* end);

  std::array<CharacterClass, 256> Classes;
  bool BlankSeparates = false;
  std::vector<char> Needed;   // by column
  std::vector<double> Values; // of the row, by column
  int Column = 0;
  const char* Word = nullptr; // of that column
  std::string_view Line;
};

} // namespace helios

#endif
