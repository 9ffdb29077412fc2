// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosTrajectoryParser.h"

#include "heliosCounted.h"

#include <algorithm>
#include <charconv>
#include <system_error>

namespace helios
{

namespace
{

constexpr int LastColumn = 999;
constexpr std::string_view ColumnNames[7] = { "t", "roll", "pitch", "yaw", "x", "y", "z" };

std::string_view Trim(std::string_view text)
{
  constexpr std::string_view blanks = " \t";
  text.remove_prefix(std::min(text.find_first_not_of(blanks), text.size()));
  return text.substr(0, text.find_last_not_of(blanks) + 1);
}

/// Removes enclosing quotes.
std::string_view Unquote(std::string_view text)
{
  const bool isQuoted =
    text.size() > 1 && (text[0] == '"' || text[0] == '\'') && text.back() == text[0];
  return isQuoted ? Trim(text.substr(1, text.size() - 2)) : text;
}

/// Returns the index of a column name, or -1.
int FindName(std::string_view name)
{
  const auto found = std::find(std::begin(ColumnNames), std::end(ColumnNames), name);
  return found == std::end(ColumnNames) ? -1 : static_cast<int>(found - ColumnNames);
}

/// Extracts the next name of a header; names are separated by commas or separators.
std::string_view ReadName(std::string_view& text, const std::string& separators)
{
  const std::size_t end = text.find_first_of("," + separators);
  const std::string_view name = Unquote(Trim(text.substr(0, end)));
  text.remove_prefix(std::min(end == std::string_view::npos ? end : end + 1, text.size()));
  return name;
}

std::string List(const TrajectoryColumns& columns, const std::vector<int>& which)
{
  std::string text;
  for (const int i : which)
  {
    text += (text.empty() ? "" : ", ") + std::string(ColumnNames[i]) + " in " +
      std::to_string(columns[static_cast<std::size_t>(i)]);
  }
  return text;
}

} // namespace

bool TrajectoryParser::IsNeeded(int column) const
{
  return this->Format.HasAttitude || column == TimeOf || column >= XOf;
}

bool TrajectoryParser::HasGivenColumns() const
{
  const TrajectoryColumns& given = this->Format.Columns;
  return std::any_of(given.begin(), given.end(), [](int column) { return column >= 0; });
}

bool TrajectoryParser::Fail(const std::string& message)
{
  return this->Report.Fail(this->File->GetPlace() + message);
}

bool TrajectoryParser::Read(LineFile& file, std::vector<TrajectoryRow>& rows)
{
  this->File = &file;
  file.SetRange(0, file.GetSize());
  std::string_view line;
  while (file.NextLine(line))
  {
    if (!this->ReadRow(line, rows))
    {
      return false;
    }
  }
  if (!file.GetError().empty() || file.IsStopped())
  {
    return this->Report.Fail(!file.GetError().empty()
        ? file.GetError()
        : file.GetPlace() + "reading was aborted here; update again to read it");
  }
  if (rows.empty())
  {
    return this->Report.Fail(
      file.GetPath() + ": has no rows; give a file with rows of time, attitude and position");
  }
  this->Sort(rows);
  return this->CheckTimes(rows) &&
    CheckRowTimes(
      rows, [this, &rows](std::size_t i) { return this->GetPlaceOf(rows[i]); }, this->Report);
}

/// Sorts rows by time, with a warning if they are not.
void TrajectoryParser::Sort(std::vector<TrajectoryRow>& rows)
{
  const auto isEarlier = [](const TrajectoryRow& a, const TrajectoryRow& b)
  { return a.Time < b.Time; };
  const auto early = std::is_sorted_until(rows.begin(), rows.end(), isEarlier);
  if (early != rows.end())
  {
    this->Report.Warn(this->GetPlaceOf(*early) + "time is " + PrintExactly(early->Time) +
      " s, before that of the row before, " + PrintExactly(std::prev(early)->Time) +
      " s; the rows are used in order of time: sort them, and remove those of other flights");
    std::stable_sort(rows.begin(), rows.end(), isEarlier);
  }
}

/// Returns the time of a row, continued over the ends of weeks and days.
double TrajectoryParser::ReadTime(double time)
{
  const double continued = this->Clock.Continue(time);
  if (this->Clock.IsFirstContinued())
  {
    this->Report.Warn(this->File->GetPlace() + this->Clock.DescribeEnd());
  }
  return continued;
}

bool TrajectoryParser::ReadRow(std::string_view line, std::vector<TrajectoryRow>& rows)
{
  if (TextRow::IsEmpty(line))
  {
    return this->ReadComment(line);
  }
  if (!this->KnowsColumns && !this->SetColumns())
  {
    return false;
  }
  const TextRow::Result result = this->Row.Read(line);
  if (result != TextRow::Good)
  {
    return result == TextRow::Short ? this->FailShort()
                                    : this->Fail(this->Row.DescribeFault("row"));
  }
  const auto get = [this](int column)
  { return this->Row.GetValue(this->Columns[static_cast<std::size_t>(column)]); };
  TrajectoryRow row{ this->ReadTime(get(TimeOf)), { get(XOf), get(YOf), get(ZOf) },
    { 0.0, 0.0, 0.0 }, this->File->GetLineStart() };
  if (this->Format.HasAttitude)
  {
    row.Angles = { get(RollOf), get(PitchOf), get(YawOf) };
  }
  rows.push_back(row);
  return true;
}

bool TrajectoryParser::FailShort()
{
  const int columns = this->Row.GetColumn();
  std::vector<int> needed;
  for (int i = 0; i < 7; ++i)
  {
    if (this->IsNeeded(i))
    {
      needed.push_back(i);
    }
  }
  return this->Fail("the row has " + Counted(columns, "column") + ", but columns are read up to " +
    std::to_string(this->Row.GetNumberOfColumns() - 1) + " from 0 (" + List(this->Columns, needed) +
    "); complete the row, or set what separates columns (Separators) and which are read");
}

//------------------------------------------------------------------------------
// "#TIME_COLUMN: 0" and "#HEADER: "t", "x" ..." define columns; other comments are ignored.
bool TrajectoryParser::ReadComment(std::string_view line)
{
  line = Trim(line);
  const std::size_t colon = line.find(':');
  const bool isPlain = line.empty() || line[0] != '#' || colon == std::string_view::npos;
  if (isPlain || this->HasGivenColumns())
  {
    return true;
  }
  const std::string_view key = Trim(line.substr(1, colon - 1));
  const bool isHeader = key == "HEADER";
  if (!isHeader && key != "TIME_COLUMN")
  {
    return true;
  }
  const std::string_view text = Trim(line.substr(colon + 1));
  if (!(isHeader ? this->ReadHeader(text) : this->ReadTimeColumn(text)))
  {
    return false;
  }
  TrajectoryColumns columns;
  if (this->KnowsColumns && (!this->FindColumns(columns) || columns != this->Columns))
  {
    return this->Fail(std::string(key) +
      " changes the columns below rows that were read; write it "
      "above the first row, the same for all");
  }
  return true;
}

bool TrajectoryParser::ReadTimeColumn(std::string_view text)
{
  const char* const end = text.data() + text.size();
  int column = -1;
  const auto [behind, error] = std::from_chars(text.data(), end, column);
  if (error != std::errc() || behind != end || column < 0 || column > LastColumn)
  {
    return this->Fail("TIME_COLUMN is " + Quote(text) +
      "; give the number of the column of times, from 0 to " + std::to_string(LastColumn));
  }
  this->TimeColumn = column;
  return true;
}

bool TrajectoryParser::ReadHeader(std::string_view text)
{
  this->HasHeader = true;
  this->Header.fill(-1);
  for (int column = 0; !text.empty() && column <= LastColumn; ++column)
  {
    const std::string_view name = ReadName(text, this->Format.Separators);
    const int which = FindName(name);
    if (which < 0)
    {
      return this->Fail("HEADER names the column " + Quote(name) +
        ", which is not one of t, roll, pitch, yaw, x, y, z; correct the name, or set the columns "
        "(TimeColumn, XColumn ...), then no header is needed");
    }
    int& known = this->Header[static_cast<std::size_t>(which)];
    if (known >= 0)
    {
      return this->Fail("HEADER names " + Quote(name) + " twice, in columns " +
        std::to_string(known) + " and " + std::to_string(column) + "; remove one");
    }
    known = column;
  }
  return true;
}

// Finds the columns: those that were set, else the columns of the header, else the default order
// with the time column.
bool TrajectoryParser::FindColumns(TrajectoryColumns& columns)
{
  const TrajectoryColumns& given = this->Format.Columns;
  const bool isGiven = this->HasGivenColumns();
  for (int i = 0; i < 7; ++i)
  {
    const auto slot = static_cast<std::size_t>(i);
    columns[slot] = i;
    if (isGiven)
    {
      columns[slot] = given[slot] >= 0 ? given[slot] : i;
    }
    else if (this->HasHeader)
    {
      columns[slot] = this->Header[slot];
    }
    else if (this->TimeColumn >= 0)
    {
      columns[slot] = i == TimeOf ? this->TimeColumn : i - (i <= this->TimeColumn ? 1 : 0);
    }
  }
  if (!isGiven && this->HasHeader && this->TimeColumn >= 0 && columns[TimeOf] >= 0 &&
    columns[TimeOf] != this->TimeColumn)
  {
    return this->Fail("TIME_COLUMN is " + std::to_string(this->TimeColumn) +
      ", but HEADER has t in column " + std::to_string(columns[TimeOf]) + "; correct one");
  }
  return true;
}

bool TrajectoryParser::SetColumns()
{
  if (!this->FindColumns(this->Columns))
  {
    return false;
  }
  for (int i = 0; i < 7; ++i)
  {
    const int column = this->Columns[static_cast<std::size_t>(i)];
    if (!this->IsNeeded(i))
    {
      continue;
    }
    if (column < 0)
    {
      return this->Fail("HEADER does not name " + Quote(ColumnNames[i]) +
        (i >= RollOf && i <= YawOf
            ? "; add it, or set Domain to POSITION to derive the heading from the flight direction"
            : "; add it, or set the columns (TimeColumn, XColumn ...)"));
    }
    for (int other = 0; other < i; ++other)
    {
      if (this->IsNeeded(other) && this->Columns[static_cast<std::size_t>(other)] == column)
      {
        return this->Fail("one column is read twice (" + List(this->Columns, { other, i }) +
          "); set TimeColumn, RollColumn, PitchColumn, YawColumn, XColumn, YColumn and ZColumn, by "
          "default 0 to 6 in this order");
      }
    }
    this->Row.Need(column);
  }
  this->KnowsColumns = true;
  return true;
}

//------------------------------------------------------------------------------
std::string TrajectoryParser::GetPlaceOf(const TrajectoryRow& row)
{
  std::string_view line;
  this->File->SetRange(row.LineStart, row.LineStart + 1);
  this->File->NextLine(line);
  return this->File->GetPlace();
}

// Checks the times: two rows at one time are a jump; the order of more rows is ambiguous.
bool TrajectoryParser::CheckTimes(const std::vector<TrajectoryRow>& rows)
{
  std::size_t jumps = 0;
  std::size_t first = 0;
  for (std::size_t i = 1; i < rows.size(); ++i)
  {
    if (rows[i].Time != rows[i - 1].Time)
    {
      continue;
    }
    if (i > 1 && rows[i].Time == rows[i - 2].Time)
    {
      std::array<char, 32> time{};
      std::to_chars(time.data(), time.data() + time.size() - 1, rows[i].Time);
      return this->Report.Fail(this->GetPlaceOf(rows[i]) + "a third row has the time " +
        time.data() +
        " s; one row per time is a sample, two are a jump: remove the others, or give the times "
        "with more digits");
    }
    if (rows[i].Position != rows[i - 1].Position)
    {
      first = jumps == 0 ? i : first;
      ++jumps;
    }
  }
  if (jumps > 0)
  {
    this->Report.Warn(this->GetPlaceOf(rows[first]) +
      "the platform jumps: " + std::to_string(jumps) + (jumps == 1 ? " time has" : " times have") +
      " two rows at different positions, the first here; give the times with more digits if it "
      "does not");
  }
  return true;
}

} // namespace helios
