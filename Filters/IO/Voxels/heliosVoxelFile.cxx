// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosVoxelFile.h"

#include "heliosStatus.h"

#include <algorithm>
#include <cctype>
#include <cmath>

namespace helios
{

namespace
{

constexpr double LargestCoordinate = 1e12; // [m]

std::string ToLowerCase(std::string_view text)
{
  std::string lower(text);
  std::transform(lower.begin(), lower.end(), lower.begin(),
    [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return lower;
}

bool StartsWithNumber(std::string_view line)
{
  TextWords words(line);
  double number = 0.0;
  const TextWords::Number found = words.Next(number);
  return found == TextWords::Number::Good || found == TextWords::Number::Excessive;
}

bool IsKeys(std::string_view line)
{
  const std::size_t at = line.find_first_not_of(" \t");
  return at != std::string_view::npos && line[at] == '#';
}

bool IsBlank(std::string_view line)
{
  return line.find_first_not_of(" \t\r") == std::string_view::npos;
}

} // namespace

//------------------------------------------------------------------------------
bool VoxelFile::ReadHead(const std::string& path)
{
  const Status status = this->Text.Open(path);
  if (!status.IsOk())
  {
    return this->Report.Fail(status.Message());
  }
  std::string_view line;
  bool hasRow = false;
  while (!hasRow && this->Text.NextLine(line))
  {
    hasRow = StartsWithNumber(line);
    if (!hasRow && !(IsKeys(line) ? this->ReadKeys(line) : this->ReadNames(line)))
    {
      return false;
    }
  }
  if (!this->Text.GetError().empty())
  {
    return this->Report.Fail(this->Text.GetError());
  }
  if (!hasRow)
  {
    return this->Report.Fail(path + ": has no cells; give a file with rows i j k " +
      this->PadColumn + " ... below its #min_corner, #split and #res");
  }
  this->FirstRow = line;
  return this->FinishHead();
}

//------------------------------------------------------------------------------
/// Parses a line of "#key: values" with one or more keys.
bool VoxelFile::ReadKeys(std::string_view line)
{
  while (!line.empty())
  {
    line.remove_prefix(std::min(line.find('#') + 1, line.size()));
    const std::string_view part = line.substr(0, line.find('#'));
    line.remove_prefix(part.size());
    const std::size_t colon = part.find(':');
    if (colon != std::string_view::npos &&
      !this->ReadKey(ToLowerCase(part.substr(0, colon)), part.substr(colon + 1)))
    {
      return false;
    }
  }
  return true;
}

//------------------------------------------------------------------------------
bool VoxelFile::ReadKey(const std::string& key, std::string_view values)
{
  double numbers[3];
  if (key == "min_corner")
  {
    this->HasCorner = true;
    return this->ReadNumbers(key, values, 3, this->Layout.Corner);
  }
  if (key == "max_corner")
  {
    this->HasHighCorner = true;
    return this->ReadNumbers(key, values, 3, this->HighCorner);
  }
  if (key == "res")
  {
    return this->ReadNumbers(key, values, 1, this->Layout.Size);
  }
  if (key == "max_pad" && this->ReadNumbers(key, values, 1, numbers))
  {
    this->Layout.MaximumPad = numbers[0];
  }
  else if (key == "split" && this->ReadNumbers(key, values, 3, numbers))
  {
    std::transform(numbers, numbers + 3, this->Layout.Count,
      [](double x) { return static_cast<std::int64_t>(x); });
    return std::equal(numbers, numbers + 3, this->Layout.Count,
             [](double x, std::int64_t n) { return static_cast<double>(n) == x; }) ||
      this->Fail("#split has a number that is not whole; give the cells along x, y and z");
  }
  return this->Report.Error.empty();
}

//------------------------------------------------------------------------------
/// Reads three numbers, or one for all three if allowed.
bool VoxelFile::ReadNumbers(
  const std::string& key, std::string_view values, int minimum, double numbers[3])
{
  TextWords words(values);
  int count = 0;
  while (count < 3 && words.Next(numbers[count]) == TextWords::Number::Good)
  {
    ++count;
  }
  if (count == 1 && minimum == 1)
  {
    numbers[1] = numbers[2] = numbers[0];
    count = 3;
  }
  const bool isCorner = key == "min_corner" || key == "max_corner";
  const double low = isCorner ? -LargestCoordinate : key == "max_pad" ? 0.0 : 1e-9;
  const bool isGood = count == 3 && !words.HasMore() &&
    std::all_of(
      numbers, numbers + 3, [low](double x) { return x >= low && x <= LargestCoordinate; });
  return isGood ||
    this->Fail("#" + key + ": " + Quote(values) + " is not valid: expected " +
      (minimum == 3 ? "three numbers" : "a number") + (isCorner ? " [m]" : " greater than 0") +
      ", such as " +
      (key == "split"    ? "20 20 10"
          : minimum == 3 ? "0 0 0"
                         : "0.5"));
}

//------------------------------------------------------------------------------
/// Reads the column names; a line without i, j and k is a title.
bool VoxelFile::ReadNames(std::string_view line)
{
  std::vector<std::string> given;
  TextWords words(line);
  while (words.HasMore())
  {
    given.push_back(ToLowerCase(words.Next()));
  }
  const auto find = [&given](const std::string& name)
  { return static_cast<std::size_t>(std::find(given.begin(), given.end(), name) - given.begin()); };
  const std::size_t columns[] = { find("i"), find("j"), find("k"),
    find(ToLowerCase(this->PadColumn)), find("transmittance") };
  if (*std::max_element(columns, columns + 3) >= given.size())
  {
    return true;
  }
  if (columns[3] >= given.size())
  {
    return this->Fail("no column is called " + this->PadColumn + " in " + Quote(line) +
      "; name the one with the plant area density (PADColumn)");
  }
  this->Roles.clear();
  this->SetRole(columns[0], Role::I);
  this->SetRole(columns[1], Role::J);
  this->SetRole(columns[2], Role::K);
  this->SetRole(columns[3], Role::Pad);
  if (columns[4] < given.size())
  {
    this->SetRole(columns[4], Role::Transmittance);
  }
  return true;
}

//------------------------------------------------------------------------------
void VoxelFile::SetRole(std::size_t column, Role role)
{
  this->Roles.resize(std::max(this->Roles.size(), column + 1), Role::None);
  this->Roles[column] = role;
}

//------------------------------------------------------------------------------
bool VoxelFile::FinishHead()
{
  VoxelLayout& layout = this->Layout;
  if (!this->HasCorner || layout.Count[0] == 0)
  {
    return this->Fail(std::string("the cells come before ") +
      (this->HasCorner ? "#split" : "#min_corner") +
      "; put lines #min_corner: x y z, #split: nx ny nz and #res: r above them");
  }
  if (!this->CheckCount())
  {
    return false;
  }
  for (int axis = 0; axis < 3; ++axis)
  {
    const double count = static_cast<double>(layout.Count[axis]);
    const double extent = this->HighCorner[axis] - layout.Corner[axis];
    if (!(layout.Size[axis] > 0.0))
    {
      layout.Size[axis] = this->HasHighCorner ? extent / count : 0.0;
    }
    if (!(layout.Size[axis] > 0.0))
    {
      return this->Fail("cells have no size; put #res: r above them, or a #max_corner beyond "
                        "#min_corner");
    }
    // Grids that were cropped, or made coarser, may have the corner of the grid before.
    const double permitted = 0.5 + 0.02 * count;
    if (this->HasHighCorner && std::abs(extent / layout.Size[axis] - count) > permitted)
    {
      return this->Fail("#max_corner is not where #min_corner, #split and #res end along axis " +
        std::to_string(axis) + "; correct one of them");
    }
  }
  if (this->Roles.empty()) // default columns for a file without names
  {
    this->Roles = { Role::I, Role::J, Role::K, Role::Pad };
    this->SetRole(13, Role::Transmittance);
  }
  layout.HasTransmittance =
    std::find(this->Roles.begin(), this->Roles.end(), Role::Transmittance) != this->Roles.end();
  return true;
}

//------------------------------------------------------------------------------
bool VoxelFile::CheckCount()
{
  const std::int64_t* n = this->Layout.Count;
  const double product =
    static_cast<double>(n[0]) * static_cast<double>(n[1]) * static_cast<double>(n[2]);
  return product <= 4e9 ||
    this->Fail("#split makes " + std::to_string(n[0]) + " x " + std::to_string(n[1]) + " x " +
      std::to_string(n[2]) + " cells; the maximum is 4e9");
}

//------------------------------------------------------------------------------
bool VoxelFile::ReadRows(double* pad, double* transmittance)
{
  this->Seen.assign(static_cast<std::size_t>(this->Layout.GetNumberOfCells()), false);
  std::string_view line = this->FirstRow;
  do
  {
    if (!IsKeys(line) && !IsBlank(line) && !this->ReadRow(line, pad, transmittance))
    {
      return false;
    }
  } while (this->Text.NextLine(line));
  if (this->Text.IsStopped())
  {
    return this->Fail("reading was aborted here; update again to read it");
  }
  return this->Text.GetError().empty() || this->Report.Fail(this->Text.GetError());
}

//------------------------------------------------------------------------------
bool VoxelFile::ReadRow(std::string_view line, double* pad, double* transmittance)
{
  TextWords words(line);
  Row row{};
  if (!this->ReadColumns(words, row))
  {
    return false;
  }
  const std::int64_t* n = this->Layout.Count;
  const std::int64_t* at = row.Index;
  const auto cell = static_cast<std::size_t>((at[2] * n[1] + at[1]) * n[0] + at[0]);
  if (this->Seen[cell])
  {
    return this->Fail("cell " + std::to_string(at[0]) + ' ' + std::to_string(at[1]) + ' ' +
      std::to_string(at[2]) + " comes a second time; remove one of its rows");
  }
  this->Seen[cell] = true;
  pad[cell] = row.Pad;
  if (transmittance)
  {
    transmittance[cell] = row.Transmittance;
  }
  return true;
}

//------------------------------------------------------------------------------
bool VoxelFile::ReadColumns(TextWords& words, Row& row)
{
  for (const Role role : this->Roles)
  {
    bool good = true;
    switch (role)
    {
      case Role::None:
        good = !words.Next().empty() ||
          this->Fail("the row ends before its column " + this->GetName(this->Roles.back()) +
            "; complete it");
        break;
      case Role::I:
        good = this->ReadIndex(words, 0, row.Index[0]);
        break;
      case Role::J:
        good = this->ReadIndex(words, 1, row.Index[1]);
        break;
      case Role::K:
        good = this->ReadIndex(words, 2, row.Index[2]);
        break;
      case Role::Pad:
        good = this->ReadValue(words, role, row.Pad);
        break;
      case Role::Transmittance:
        good = this->ReadValue(words, role, row.Transmittance);
        break;
    }
    if (!good)
    {
      return false;
    }
  }
  return true;
}

//------------------------------------------------------------------------------
bool VoxelFile::ReadIndex(TextWords& words, int axis, std::int64_t& index)
{
  int number = 0;
  const char name[] = { "ijk"[axis], '\0' };
  if (words.Next(number) != TextWords::Number::Good)
  {
    return this->Fail(Quote(words.NextName()) + " in column " + name +
      " is not a whole number; give the cell's number along that axis, from 0");
  }
  index = number;
  return (number >= 0 && index < this->Layout.Count[axis]) ||
    this->Fail(std::string(name) + " is " + std::to_string(number) + ", but #split has " +
      std::to_string(this->Layout.Count[axis]) + " cells along that axis, from 0; correct one");
}

//------------------------------------------------------------------------------
bool VoxelFile::ReadValue(TextWords& words, Role role, double& value)
{
  if (words.Next(value) != TextWords::Number::Good)
  {
    return this->Fail(Quote(words.NextName()) + " in column " + this->GetName(role) +
      " is not a number of double precision; write numbers such as 0.25 or 1e-3, and NaN for what "
      "is not known");
  }
  const double maximum = role == Role::Pad ? 1e9 : 1.0 + 1e-6;
  return std::isnan(value) || (value >= 0.0 && value <= maximum) ||
    this->Fail(this->GetName(role) + " is " + std::to_string(value) + "; give 0 or more" +
      (role == Role::Pad ? " [m2/m3]" : ", up to 1") + ", and NaN for what is not known");
}

//------------------------------------------------------------------------------
std::string VoxelFile::GetName(Role role) const
{
  return role == Role::Pad ? this->PadColumn : role == Role::Transmittance ? "transmittance" : "k";
}

//------------------------------------------------------------------------------
bool ReadLeafTable(const std::string& path, TextReport& report, std::vector<double>& rows)
{
  TextFile file;
  const Status status = file.Open(path);
  if (!status.IsOk())
  {
    return report.Fail(status.Message());
  }
  std::string_view line;
  while (file.NextLine(line))
  {
    std::string text(line);
    std::replace_if(
      text.begin(), text.end(), [](char c) { return c == ',' || c == ';'; }, ' ');
    TextWords words(text);
    double row[4];
    int count = 0;
    if (!words.HasMore() || (rows.empty() && !StartsWithNumber(text)))
    {
      continue; // a comment, or column names
    }
    while (count < 4 && words.Next(row[count]) == TextWords::Number::Good)
    {
      ++count;
    }
    const bool isGood = count == 4 && !words.HasMore() &&
      std::all_of(row, row + 4, [](double x) { return std::abs(x) <= 1e9; }) &&
      (row[0] != 0.0 || row[1] != 0.0 || row[2] != 0.0) && row[3] >= 0.0;
    if (!isGood)
    {
      return report.Fail(file.GetPlace() + Quote(line) +
        " is not a row of a leaf-angle table; write x,y,z,G: a direction, and the projection of a "
        "unit of leaf area along it, 0 or more");
    }
    rows.insert(rows.end(), row, row + 4);
  }
  if (!file.GetError().empty())
  {
    return report.Fail(file.GetError());
  }
  return !rows.empty() || report.Fail(path + ": has no rows x,y,z,G; give a leaf-angle table");
}

} // namespace helios
