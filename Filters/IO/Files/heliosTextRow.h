// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Parses the columns of a text row as numbers.

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
 * Reads the requested columns, strictly and correctly rounded. Separators is the set of characters
 * between columns: a blank or a tab stands for any run of blanks and tabs, and blanks beside a
 * separator are ignored, as are double quotes without a blank as separator. A word that starts with # or // starts a comment.
 */
class TextRow
{
public:
  explicit TextRow(const std::string& separators);

  /// Sets the number of the first column, for messages. Default: 0.
  void SetFirstNumber(int number) { this->FirstNumber = number; }
  /// Sets whether numbers that are not finite are valid. Default: off.
  void SetKeepInvalid(bool keeps) { this->KeepInvalid = keeps; }

  /// Returns whether a character is a valid separator: not a digit, letter, + - . # or /.
  static bool IsSeparator(char c)
  {
    return !std::isalnum(static_cast<unsigned char>(c)) && c != '\n' &&
      std::string_view("+-.#/").find(c) == std::string_view::npos;
  }

  /// Requests the number in a column.
  void Need(int column);
  int GetNumberOfColumns() const { return static_cast<int>(this->Needed.size()); }

  enum Result : char
  {
    Good,
    Empty, ///< only blanks and a comment
    Short, ///< columns are missing from GetColumn() on
    Bad    ///< GetColumn() is not a finite number; see DescribeFault()
  };

  Result Read(std::string_view line);

  double GetValue(int column) const { return this->Values[static_cast<std::size_t>(column)]; }
  const double* GetValues() const { return this->Values.data(); }
  int GetColumn() const { return this->Column; }

  /// Describes the error of a bad row; kind is the kind of row ("point"), for messages.
  std::string DescribeFault(const char* kind) const;

  /// Returns whether a line contains only blanks and a comment.
  static bool IsEmpty(std::string_view line);

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
  bool KeepInvalid = false;
  int FirstNumber = 0;
  std::vector<char> Needed;   // per column
  std::vector<double> Values; // values of the row, one per column
  int Column = 0;
  const char* Word = nullptr; // word of the column with the fault
  std::string_view Line;
};

} // namespace helios

#endif
