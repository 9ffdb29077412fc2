// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosTextLayout.h"

#include "heliosPointColumns.h"
#include "heliosPointParser.h"
#include "heliosTextFile.h"
#include "heliosTextRow.h"
#include "vtkHeliosArrayNames.h"

#include <vtkType.h>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>

namespace names = vtkHeliosArrayNames;

namespace helios
{

namespace
{

bool IsNumber(std::string_view word)
{
  double value = 0.0;
  const char* begin = word.data() + (word.substr(0, 1) == "+" ? 1 : 0);
  const char* end = word.data() + word.size();
  return std::from_chars(begin, end, value).ptr == end && begin != end;
}

bool IsDigits(std::string_view word)
{
  return !word.empty() &&
    std::all_of(word.begin(), word.end(), [](char c) { return c >= '0' && c <= '9'; });
}

/// Returns whether a word is two runs of digits with a comma between them, such as 1,5 and -1,5e3.
bool HasDecimalComma(std::string_view word)
{
  const std::size_t comma = word.find(',');
  return comma != std::string_view::npos && comma > 0 && comma + 1 < word.size() &&
    word.find(',', comma + 1) == std::string_view::npos &&
    std::isdigit(static_cast<unsigned char>(word[comma - 1])) &&
    std::isdigit(static_cast<unsigned char>(word[comma + 1]));
}

/// Returns whether the first three words between blanks have a decimal comma each.
bool HasDecimalCommas(std::string_view row)
{
  const auto words = SplitColumns(row, " \t");
  return words.size() >= 3 && std::all_of(words.begin(), words.begin() + 3, HasDecimalComma);
}

/// Returns the separators of a row: blanks if it begins with three numbers between them, or has no
/// others.
std::string FindSeparators(std::string_view row)
{
  const auto words = SplitColumns(row, " \t");
  const bool hasNumbers =
    words.size() >= 3 && std::all_of(words.begin(), words.begin() + 3, IsNumber);
  for (const char* separator : { ";", ",", "|" })
  {
    if (!hasNumbers && row.find(separator) != std::string_view::npos)
    {
      return separator;
    }
  }
  return BlankSeparators;
}

/// Returns the first word of a line between blanks, which is empty if the line is blanks and
/// quotes.
std::string_view GetFirstWord(std::string_view line)
{
  const auto words = SplitColumns(line, BlankSeparators);
  return words.empty() ? std::string_view() : words[0];
}

bool HasNoNumbers(std::string_view line, const std::string& separators)
{
  const std::string all = separators.empty() ? " \t,;|" : separators;
  const auto words = SplitColumns(line, all);
  return !words.empty() && std::none_of(words.begin(), words.end(), IsNumber);
}

/// Returns whether a row has whole numbers in the columns where vtkHeliosPointTextWriter writes
/// them.
bool IsEchoRow(std::string_view row, int columns)
{
  TextWords words(row);
  bool isWhole = GetColumnsToRead(columns) == columns && columns > FirstArrayColumn;
  for (int column = 0; isWhole && column < NumberOfBasicColumns; ++column)
  {
    double value = 0.0;
    const bool isPart = column == PartColumn;
    isWhole = isPart ? !words.NextName().empty() : words.Next(value) == TextWords::Number::Good;
    isWhole = isWhole && (PointColumns[column].Decimals > 0 || std::trunc(value) == value);
  }
  return isWhole;
}

/// Returns the text of a comment line, without its mark.
std::string_view GetComment(std::string_view line)
{
  const std::size_t text = line.find_first_not_of(" \t#/%");
  return text == std::string_view::npos ? std::string_view() : line.substr(text);
}

/// Reads the lines before the first row and finds the layout from them and that row.
class LayoutFinder
{
public:
  LayoutFinder(
    LineFile& file, const std::string& separators, TextLayout& layout, TextReport& report)
    : File(file)
    , Separators(separators)
    , Layout(layout)
    , Report(report)
  {
  }

  Status Find()
  {
    this->ReadLines();
    if (!this->File.GetError().empty())
    {
      return Status::Error(this->File.GetError());
    }
    if (this->IsPtx())
    {
      this->Layout.Kind = TextKind::Ptx;
      return FindPtxScans(this->File, this->Layout, this->Report);
    }
    if (this->Row.empty())
    {
      return {};
    }
    if (this->IsRaster())
    {
      return Status::Error(this->RowPlace +
        "begins a raster (ESRI ASCII grid), not points; convert it: gdal_translate FILE "
        "heights.tif");
    }
    if (this->Separators.empty() && HasDecimalCommas(this->Row))
    {
      return Status::Error(this->RowPlace + Quote(GetFirstWord(this->Row)) +
        " has a decimal comma, which separates columns, too; write a point, or separate columns "
        "by semicolons");
    }
    this->Layout.Separators =
      this->Separators.empty() ? FindSeparators(this->Row) : this->Separators;
    const auto words = SplitColumns(this->Row, this->Layout.Separators);
    this->Layout.NumberOfColumns = static_cast<int>(words.size());
    TextScan all;
    all.Begin = this->RowStart;
    all.End = this->File.GetSize();
    this->Layout.Scans.push_back(all);
    this->FindKind();
    return {};
  }

private:
  /// Reads up to the first row, which is neither a header nor a number of points.
  void ReadLines()
  {
    this->File.SetRange(0, this->File.GetSize());
    std::string_view line;
    while (this->File.NextLine(line))
    {
      if (TextRow::IsEmpty(line))
      {
        this->Comment = line.find_first_of("#/") != std::string_view::npos ? line : this->Comment;
        continue;
      }
      this->Lines.emplace_back(line);
      const bool isFirst = this->Lines.size() == 1;
      if (isFirst && HasNoNumbers(line, this->Separators))
      {
        this->Header = line;
        this->HeaderPlace = this->File.GetPlace();
        continue;
      }
      if (isFirst && IsDigits(GetFirstWord(line)) && SplitColumns(line, " \t,;|").size() == 1)
      {
        this->CountStart = this->File.GetLineStart();
        continue;
      }
      if (this->Lines.size() == 2 && this->CountStart >= 0 &&
        SplitColumns(line, " \t,;|").size() == 1)
      {
        continue; // the second line of PTX
      }
      this->Row = line;
      this->RowStart = this->File.GetLineStart();
      this->RowPlace = this->File.GetPlace();
      break;
    }
    if (this->Row.empty() && this->CountStart >= 0) // a single number is a row
    {
      this->Row = this->Lines[0];
      this->RowStart = this->CountStart;
      this->CountStart = -1;
    }
  }

  /// Returns whether the file starts with a number of columns, a number of rows and the scanner's
  /// position.
  bool IsPtx()
  {
    return this->CountStart >= 0 && this->Lines.size() == 3 &&
      IsDigits(GetFirstWord(this->Lines[1])) && SplitColumns(this->Row, " \t").size() == 3;
  }

  bool IsRaster() const
  {
    std::string word(GetFirstWord(this->Row));
    std::transform(word.begin(), word.end(), word.begin(),
      [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return word == "ncols";
  }

  void FindKind()
  {
    const int count = this->Layout.NumberOfColumns;
    if (this->ReadNames(GetComment(this->Header)) ||
      (this->Header.empty() && this->ReadNames(GetComment(this->Comment))))
    {
      this->Layout.Kind = TextKind::Named;
      return;
    }
    if (!this->Header.empty())
    {
      this->Layout.HasHeader = true;
      this->Report.Warn(this->HeaderPlace + Quote(this->Header) +
        " has no numbers, and no names x, y and z of " + std::to_string(count) +
        " columns; it is left out as a header, and the first three columns are x y z");
    }
    const std::string& path = this->File.GetPath();
    const bool isPts = path.size() > 4 && path.substr(path.size() - 4) == ".pts";
    if (this->CountStart >= 0 || isPts)
    {
      this->Layout.Kind = TextKind::Pts;
      this->Layout.Scans[0].Begin = this->CountStart >= 0 ? this->CountStart : this->RowStart;
      this->AddPtsColumns(count);
    }
    else if (this->Header.empty() && this->Layout.Separators == BlankSeparators)
    {
      const int columns = CountColumns(this->Row); // names of parts may look like a comment
      this->Layout.NumberOfColumns = columns;
      this->Layout.Kind = IsEchoRow(this->Row, columns) ? TextKind::Echoes : TextKind::Plain;
    }
  }

  /// Sets the columns by their names; false if x, y or z is not among them.
  bool ReadNames(std::string_view header)
  {
    std::vector<std::string_view> words = SplitColumns(header, this->Layout.Separators);
    if (static_cast<int>(words.size()) != this->Layout.NumberOfColumns)
    {
      words = SplitColumns(header, " \t,;|");
    }
    std::vector<NamedColumn> columns;
    std::transform(words.begin(), words.end(), std::back_inserter(columns), FindNamedColumn);
    if (static_cast<int>(words.size()) != this->Layout.NumberOfColumns ||
      !this->SetCoordinates(columns))
    {
      return false;
    }
    for (std::size_t i = 0; i < columns.size(); ++i)
    {
      const bool isCoordinate = columns[i].Array && !*columns[i].Array;
      if (!isCoordinate && !this->AddColumn(static_cast<int>(i), columns[i], columns))
      {
        this->Layout.Unknown.emplace_back(words[i]);
      }
    }
    return true;
  }

  bool SetCoordinates(std::vector<NamedColumn>& columns)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      const auto isAxis = [axis](const NamedColumn& column)
      { return column.Array && !*column.Array && column.Component == axis; };
      const auto found = std::find_if(columns.begin(), columns.end(), isAxis);
      if (found == columns.end())
      {
        return false;
      }
      this->Layout.Coordinates[axis] = static_cast<int>(found - columns.begin());
      for (auto other = found + 1; other != columns.end(); ++other)
      {
        *other = isAxis(*other) ? NamedColumn() : *other; // a height beside z
      }
    }
    return true;
  }

  /// Adds a column with all others of its array; false if they are not there, or already added.
  bool AddColumn(int index, const NamedColumn& column, const std::vector<NamedColumn>& all)
  {
    if (!column.Array)
    {
      return false;
    }
    for (const TextColumn& added : this->Layout.Columns)
    {
      if (std::string_view(added.Column.Array) == column.Array &&
        added.Column.Component == column.Component)
      {
        return false;
      }
    }
    for (int k = 0; k < column.Components; ++k)
    {
      if (std::none_of(all.begin(), all.end(),
            [&column, k](const NamedColumn& other) {
              return other.Array && std::string_view(other.Array) == column.Array &&
                other.Component == k;
            }))
      {
        return false;
      }
    }
    this->Layout.Columns.push_back({ index, column });
    return true;
  }

  void AddPtsColumns(int count)
  {
    if (count == 4 || count == 7)
    {
      this->Layout.Columns.push_back({ 3, FindNamedColumn("intensity") });
    }
    for (int k = 0; k < 3 && (count == 6 || count == 7); ++k)
    {
      this->Layout.Columns.push_back({ count - 3 + k, FindNamedColumn(std::string(1, "rgb"[k])) });
    }
  }

  LineFile& File;
  const std::string& Separators;
  TextLayout& Layout;
  TextReport& Report;
  std::vector<std::string> Lines; // lines that are no comments, up to the first row
  std::string Comment;            // the last one before it
  std::string Header;
  std::string HeaderPlace;
  std::string Row;
  std::string RowPlace;
  std::int64_t RowStart = 0;
  std::int64_t CountStart = -1; // start of the number of points
};

} // namespace

std::vector<std::string_view> SplitColumns(std::string_view line, const std::string& separators)
{
  const bool hasBlanks = separators.find_first_of(" \t") != std::string::npos;
  const auto isBlank = [](char c) { return c == ' ' || c == '\t' || c == '\r'; };
  const auto isQuoted = [isBlank](char c) { return isBlank(c) || c == '"'; };
  std::vector<std::string_view> words;
  for (std::size_t at = 0; at < line.size();)
  {
    while (at < line.size() && isBlank(line[at]))
    {
      ++at;
    }
    const std::size_t begin = at;
    while (at < line.size() && !(hasBlanks && isBlank(line[at])) &&
      (isBlank(line[at]) || separators.find(line[at]) == std::string::npos))
    {
      ++at;
    }
    std::string_view word = line.substr(begin, at - begin);
    while (!word.empty() && isQuoted(word.back()))
    {
      word.remove_suffix(1);
    }
    while (!word.empty() && isQuoted(word.front()))
    {
      word.remove_prefix(1);
    }
    const bool isComment = word.substr(0, 1) == "#" || word.substr(0, 2) == "//";
    while (at < line.size() && isBlank(line[at]))
    {
      ++at;
    }
    const bool isAtSeparator = at < line.size() && separators.find(line[at]) != std::string::npos;
    if (isComment || (word.empty() && !isAtSeparator))
    {
      break;
    }
    words.push_back(word);
    at += isAtSeparator ? 1 : 0;
  }
  return words;
}

Status FindTextLayout(
  LineFile& file, const std::string& separators, TextLayout& layout, TextReport& report)
{
  return LayoutFinder(file, separators, layout, report).Find();
}

} // namespace helios
