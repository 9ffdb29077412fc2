// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosCatalogue.h"

#include "heliosAssets.h"
#include "heliosMessages.h"
#include "heliosXmlFile.h"
#include "heliosXmlPlatform.h"
#include "heliosXmlScanner.h"

#include <algorithm>
#include <filesystem>
#include <set>

namespace fs = std::filesystem;

namespace helios
{

namespace
{

void FindXmlFiles(const fs::path& folder, std::vector<std::string>& files)
{
  std::vector<std::string> found;
  std::error_code ignored;
  for (fs::directory_iterator entry(folder, ignored), end; entry != end; entry.increment(ignored))
  {
    if (IsDocument(entry->path().string()))
    {
      found.push_back(entry->path().string());
    }
  }
  std::sort(found.begin(), found.end());
  files.insert(files.end(), found.begin(), found.end());
}

std::string MakeWhole(const std::string& path)
{
  std::error_code ignored;
  const fs::path whole = fs::weakly_canonical(fs::absolute(path), ignored);
  return whole.empty() ? path : whole.string();
}

/// The items read without error, by reference.
template <typename T, typename ReadT>
void AddEntries(const XmlElement& root, const char* tag, const std::string& reference, ReadT read,
  const Assets& assets, std::vector<std::pair<std::string, T>>& entries)
{
  Messages& log = root.GetMessages();
  for (const XmlElement& element : root.GetChildren(tag))
  {
    const int before = log.GetNumberOfErrors();
    T entry = read(element);
    FindModel(element, assets, entry.Model);
    if (log.GetNumberOfErrors() == before && element.Has("id"))
    {
      entries.emplace_back(reference + "#" + element.GetText("id"), entry);
    }
  }
}

} // namespace

//------------------------------------------------------------------------------
Catalogue ReadCatalogue(
  const std::vector<std::string>& assetDirectories, const std::vector<std::string>& files)
{
  std::vector<std::string> all;
  for (const std::string& folder : assetDirectories)
  {
    for (const char* below : { "", "Assets", "data", "data/Assets" })
    {
      FindXmlFiles(fs::path(folder) / below, all);
    }
  }
  all.insert(all.end(), files.begin(), files.end());
  Messages log(nullptr);
  Assets assets(log, assetDirectories);
  Catalogue catalogue;
  std::set<std::string> seen;
  for (const std::string& file : all)
  {
    std::error_code ignored;
    const bool isNew = fs::is_regular_file(file, ignored) && seen.insert(MakeWhole(file)).second;
    const XmlDocument* document = isNew ? assets.Load(file) : nullptr;
    if (document)
    {
      const std::string name = fs::absolute(file).lexically_normal().string();
      AddEntries(document->GetRoot(), "platform", name, ReadPlatform, assets, catalogue.Platforms);
      const auto readScanner = [&assets](const XmlElement& element)
      { return ReadScanner(element, assets); };
      AddEntries(document->GetRoot(), "scanner", name, readScanner, assets, catalogue.Scanners);
    }
  }
  return catalogue;
}

} // namespace helios
