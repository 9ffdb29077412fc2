// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Reads tables as text, whose columns are the attributes of an element of the dialect.

#ifndef heliosRowTable_h
#define heliosRowTable_h

#include "heliosXmlRule.h"

#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace helios
{

class Messages;

/**
 * The first line names the columns; they are separated by commas, or by the semicolons or tabs that
 * are in this line. Cells may be in double quotes. Empty cells are not given. A line that starts
 * with # is a comment. Values are checked by the rules of the element.
 */
class RowTable
{
public:
  RowTable(const char* element, Messages& log);

  /// Adds a column that must be there, and its meaning.
  void AddRequired(const char* name, const char* meaning)
  {
    this->Required.push_back({ name, meaning });
  }

  /// Sets whether unknown columns are warnings; else errors. Default: false.
  void SetSkipsUnknown(bool skips) { this->SkipsUnknown = skips; }

  /// Makes the struct of a row at a place (file:line); null stops after an error.
  using RowMaker = std::function<void*(const std::string& where)>;

  /// Reads a file, or a text with the name of its place. False after an error.
  bool ReadFile(const std::string& path, const RowMaker& make);
  bool ReadText(const std::string& name, std::string_view text, const RowMaker& make);

private:
  struct RequiredColumn
  {
    const char* Name;
    const char* Meaning;
  };

  void Start();
  bool ReadLine(std::string_view line, const std::string& where, const RowMaker& make);
  bool ReadHeader(const std::vector<std::string>& names);
  bool CheckRequired(const std::vector<std::string>& names);
  bool AddColumn(const std::string& name);
  bool ReadRow(const std::vector<std::string>& cells, const RowMaker& make);
  bool ReadCell(std::size_t column, const std::string& cell, void* row);
  bool Fail(const std::string& message);

  const XmlElementRule& Rule;
  Messages& Log;
  std::vector<RequiredColumn> Required;
  bool SkipsUnknown = false;
  char Separator = ',';
  std::vector<const XmlValueRule*> Columns; ///< null: skipped
  std::string Where;                        ///< place of the current line
};

} // namespace helios

#endif
