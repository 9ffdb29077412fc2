// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// The elements of a survey made by methods that no single value of a struct stores.

#ifndef heliosMadeElements_h
#define heliosMadeElements_h

#include "heliosElementTree.h"
#include "heliosSurveyData.h"

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

  /// Forgets the trees of parts.
  void RemoveParts();

  /// Reads all trees into the survey, and checks them as a whole.
  void Apply(SurveyData& survey, const std::vector<std::string>& assetDirectories, Messages& log);

private:
  const ElementTree* Find(const std::string& where) const;
  void Apply(
    ScannerData& scanner, const std::string& where, const Assets& assets, Messages& log) const;
  void Apply(PlatformData& platform, const std::string& where, Messages& log) const;

  std::map<std::string, ElementTree> Trees;
};

} // namespace helios

#endif
