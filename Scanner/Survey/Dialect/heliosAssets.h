// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Finds the files and elements that HELIOS XML refers to.

#ifndef heliosAssets_h
#define heliosAssets_h

#include "heliosXmlElement.h"

#include <map>
#include <memory>
#include <string>
#include <vector>

namespace helios
{

class Messages;

/// Whether something that a survey refers to is read.
enum class AssetNeed
{
  Required,
  Optional, // read if it is given
  Replaced  // by something else: it need not exist
};

/**
 * Relative names are searched in the asset directories (and the folder data of each), then in the
 * folder of the referring file, then in the working directory. A document is read once.
 */
class Assets
{
public:
  Assets(Messages& messages, std::vector<std::string> directories);

  /// Returns the document at exactly this path; null after an error.
  const XmlDocument* Load(const std::string& path);

  /// Adds a document under its path.
  const XmlDocument* Add(std::shared_ptr<XmlDocument> document);

  /// Returns the paths of all loaded documents, in alphabetical order.
  std::vector<std::string> GetDocumentPaths() const;

  /// Returns the path of a file; empty, after an error that lists the folders searched, if it is
  /// missing.
  std::string FindFile(const XmlValue& name, const XmlDocument& from) const;

  /// Returns the path of an optional file; empty if it is missing.
  std::string FindPath(const std::string& name, const XmlDocument& from) const;

  /// Returns the paths of all files of a folder whose whole names match a regular expression, in
  /// alphabetical order; empty after an error.
  std::vector<std::string> FindFiles(const XmlValue& pattern, const XmlDocument& from);

  /// Returns the element that an attribute refers to by file.xml#id, #id or id; none after an
  /// error.
  XmlElement FindElement(const char* tag, const XmlElement& from, const char* attribute);

  /// Finds the element for a reference that is not from a file.
  XmlElement FindElement(const char* tag, const XmlValue& reference, const XmlDocument& from);

  AssetNeed Scene = AssetNeed::Required;
  AssetNeed Trajectories = AssetNeed::Required;

  ///@{
  /// Set/Get the asset directories.
  void SetDirectories(const std::vector<std::string>& all) { this->Directories = all; }
  const std::vector<std::string>& GetDirectories() const { return this->Directories; }
  ///@}

  /// Returns the folders searched for a file named in this document.
  std::vector<std::string> GetFolders(const XmlDocument& from) const;

private:
  XmlElement FindElementById(
    const char* tag, const std::string& id, const XmlDocument& document, const std::string& where);

  Messages& Log;
  std::vector<std::string> Directories;
  std::map<std::string, std::shared_ptr<XmlDocument>> Documents;
};

} // namespace helios

#endif
