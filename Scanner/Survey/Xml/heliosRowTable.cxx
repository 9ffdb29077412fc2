// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosRowTable.h"

#include "heliosMessages.h"
#include "heliosTextFile.h"
#include "heliosXmlRules.h"
#include "heliosXmlValue.h"

#include <algorithm>
#include <cstdint>

namespace helios
{

namespace
{

/// Reads the text before a separator, or in quotes; removes it and the separator. False: the last
/// one.
bool ReadCellText(std::string_view& line, char separator, std::string& cell)
{
  const std::size_t start = line.find_first_not_of(" ");
  std::size_t end = std::string_view::npos;
  cell.clear();
  if (start != std::string_view::npos && line[start] == '"')
  {
    for (std::size_t at = start + 1; at < line.size(); ++at)
    {
      const bool isDouble = line[at] == '"' && at + 1 < line.size() && line[at + 1] == '"';
      if (line[at] == '"' && !isDouble)
      {
        end = line.find(separator, at);
        cell += TextWords(line.substr(at + 1, end == line.npos ? end : end - at - 1)).Rest();
        break;
      }
      cell += line[at];
      at += isDouble ? 1 : 0;
    }
  }
  else
  {
    end = line.find(separator);
    cell = TextWords(line.substr(0, end)).Rest();
  }
  line.remove_prefix(end == std::string_view::npos ? line.size() : end + 1);
  return end != std::string_view::npos;
}

std::vector<std::string> SplitRow(std::string_view line, char separator)
{
  std::vector<std::string> cells(1);
  while (ReadCellText(line, separator, cells.back()))
  {
    cells.emplace_back();
  }
  return cells;
}

char FindSeparator(std::string_view line)
{
  return line.find('\t') != std::string_view::npos ? '\t'
    : line.find(';') != std::string_view::npos     ? ';'
                                                   : ',';
}

/// Returns the place "path:line" of a message that starts with "path:line: ".
std::string TrimPlace(const std::string& place)
{
  return place.substr(0, place.rfind(':'));
}

} // namespace

//------------------------------------------------------------------------------
RowTable::RowTable(const char* element, Messages& log)
  : Rule(*FindXmlRule(element))
  , Log(log)
{
}

//------------------------------------------------------------------------------
bool RowTable::Fail(const std::string& message)
{
  this->Log.Error(this->Where + ": " + message);
  return false;
}

//------------------------------------------------------------------------------
void RowTable::Start()
{
  this->Columns.clear();
  this->Separator = ',';
}

//------------------------------------------------------------------------------
bool RowTable::ReadFile(const std::string& path, const RowMaker& make)
{
  TextFile file;
  const Status opened = file.Open(path);
  if (!opened.IsOk())
  {
    this->Log.Error(opened.Message());
    return false;
  }
  this->Start();
  std::string_view line;
  while (file.NextLine(line))
  {
    if (!this->ReadLine(line, TrimPlace(file.GetPlace()), make))
    {
      return false;
    }
  }
  if (!file.GetError().empty())
  {
    this->Log.Error(file.GetError());
  }
  return file.GetError().empty();
}

//------------------------------------------------------------------------------
bool RowTable::ReadText(const std::string& name, std::string_view text, const RowMaker& make)
{
  this->Start();
  for (std::int64_t number = 1; !text.empty(); ++number)
  {
    const std::size_t end = text.find('\n');
    const std::string where = TrimPlace(Place(name, number));
    if (!this->ReadLine(text.substr(0, end), where, make))
    {
      return false;
    }
    text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
  }
  return true;
}

//------------------------------------------------------------------------------
bool RowTable::ReadLine(std::string_view line, const std::string& where, const RowMaker& make)
{
  if (!TextWords(line).HasMore()) // empty, or a comment
  {
    return true;
  }
  this->Where = where;
  const bool isHeader = this->Columns.empty();
  this->Separator = isHeader ? FindSeparator(line) : this->Separator;
  const std::vector<std::string> cells = SplitRow(line, this->Separator);
  return isHeader ? this->ReadHeader(cells) : this->ReadRow(cells, make);
}

//------------------------------------------------------------------------------
bool RowTable::ReadHeader(const std::vector<std::string>& names)
{
  const auto isGood = [this](const std::string& name) { return this->AddColumn(name); };
  return std::all_of(names.begin(), names.end(), isGood) && this->CheckRequired(names);
}

//------------------------------------------------------------------------------
bool RowTable::AddColumn(const std::string& name)
{
  const XmlValueRule* value = this->Rule.FindValue(name);
  if (value && std::find(this->Columns.begin(), this->Columns.end(), value) != this->Columns.end())
  {
    return this->Fail("there are two columns " + name + "; remove one");
  }
  this->Columns.push_back(value);
  if (value)
  {
    return true;
  }
  const std::string nearest = this->Rule.FindNearestValue(name);
  std::vector<std::string> known;
  for (const XmlValueRule& one : this->Rule.Values)
  {
    known.emplace_back(one.Name);
  }
  const std::string message = "column " + Quote(name) + " is unknown" +
    (this->SkipsUnknown ? " and not used; " : "; ") +
    (nearest.empty() ? "the columns are " + JoinChoices(known) : "did you mean " + nearest + "?");
  if (!this->SkipsUnknown)
  {
    return this->Fail(message);
  }
  this->Log.Warning(this->Where + ": " + message);
  return true;
}

//------------------------------------------------------------------------------
bool RowTable::CheckRequired(const std::vector<std::string>& names)
{
  for (const RequiredColumn& column : this->Required)
  {
    if (std::find(names.begin(), names.end(), column.Name) == names.end())
    {
      return this->Fail(
        std::string("there is no column ") + column.Name + "; add it, " + column.Meaning);
    }
  }
  return true;
}

//------------------------------------------------------------------------------
bool RowTable::ReadRow(const std::vector<std::string>& cells, const RowMaker& make)
{
  if (cells.size() != this->Columns.size())
  {
    return this->Fail("a row of " + std::to_string(cells.size()) + " columns, and the first has " +
      std::to_string(this->Columns.size()) + " names; correct one of them");
  }
  void* row = make(this->Where);
  for (std::size_t k = 0; row && k < cells.size(); ++k)
  {
    if (!this->ReadCell(k, cells[k], row))
    {
      return false;
    }
  }
  return row != nullptr;
}

//------------------------------------------------------------------------------
bool RowTable::ReadCell(std::size_t column, const std::string& cell, void* row)
{
  const XmlValueRule* rule = this->Columns[column];
  if (!rule)
  {
    return true;
  }
  const auto isThis = [rule](const RequiredColumn& one)
  { return std::string(one.Name) == rule->Name; };
  const auto required = std::find_if(this->Required.begin(), this->Required.end(), isThis);
  if (!cell.empty())
  {
    return ParseStored({ rule->Name, cell, this->Where }, *rule, this->Log, rule->Store.Find(row));
  }
  return required == this->Required.end() ||
    this->Fail(std::string("column ") + rule->Name + " is empty; give it, " + required->Meaning);
}

} // namespace helios
