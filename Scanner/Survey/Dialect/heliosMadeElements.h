// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// The elements of a survey made by methods that no single value of a struct stores.

#ifndef heliosMadeElements_h
#define heliosMadeElements_h

#include "heliosElementTree.h"
#include "heliosSurveyData.h"

#include <cstddef>
#include <map>
#include <string>
#include <vector>

namespace helios
{

class Assets;
class Messages;

/// The trees of parts, scanners and platforms, by their places such as "part 0". What they hold
/// replaces what a file had given.
class MadeElements
{
public:
  ///@{
  /// Whether the first name of a path is kept in a tree, and the tag of its root.
  static bool Keeps(const SurveyData&, const std::string&) { return false; }
  static bool Keeps(const LegSettings&, const std::string&) { return false; }
  static bool Keeps(const ScannerData&, const std::string& path);
  static bool Keeps(const PlatformData&, const std::string& path);
  static bool Keeps(const PartData&, const std::string& path);
  static bool Keeps(const SceneData&, const std::string& path);
  static const char* GetTag(const SurveyData&) { return "survey"; }
  static const char* GetTag(const LegSettings&) { return "leg"; }
  static const char* GetTag(const ScannerData&) { return "scanner"; }
  static const char* GetTag(const PlatformData&) { return "platform"; }
  static const char* GetTag(const PartData&) { return "part"; }
  static const char* GetTag(const SceneData&) { return "scene"; }
  ///@}

  /// Sets and gets the value of a path; its place is the key of the tree.
  bool Set(const char* tag, const XmlValue& value, Messages& log);
  std::string Get(const char* tag, const XmlValue& value, Messages& log) const;

  ///@{
  /// Adds a table of parts, from a file if it is not empty; sets and gets the value of a path, and
  /// sets its rows as text in place of a file. A table that does not exist is an error; -1: none.
  int AddTable(const std::string& file);
  bool SetTable(int table, const std::string& name, const std::string& value, Messages& log);
  std::string GetTable(int table, const std::string& name, Messages& log) const;
  bool SetTableRows(int table, const std::string& text, Messages& log);
  ///@}

  /// The parts of tables, which are the last ones of the scene.
  std::size_t GetNumberOfTableParts() const { return this->NumberOfTableParts; }

  /// Removes the parts of tables until the next Apply().
  void RemoveTableParts(std::vector<PartData>& parts);

  /// Forgets the trees of parts, and the tables.
  void RemoveParts();

  /// Reads all trees into the survey, and checks them as a whole.
  void Apply(SurveyData& survey, const std::vector<std::string>& assetDirectories, Messages& log);

private:
  const ElementTree* Find(const std::string& where) const;
  void Apply(
    ScannerData& scanner, const std::string& where, const Assets& assets, Messages& log) const;
  void Apply(PlatformData& platform, const std::string& where, Messages& log) const;
  bool CheckTable(int table, Messages& log) const;
  void ApplyTables(SurveyData& survey, Assets& assets, Messages& log);

  std::map<std::string, ElementTree> Trees;
  std::vector<std::string> TableRows; ///< of the tables, as text
  std::size_t NumberOfTableParts = 0;
  bool AreTablesRead = true;
};

} // namespace helios

#endif
