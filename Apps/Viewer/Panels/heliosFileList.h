// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// The folders and files of a folder from which one is selected.

#ifndef heliosFileList_h
#define heliosFileList_h

#include <functional>
#include <string>
#include <vector>

namespace helios::viewer
{

/// Returns what a file or folder holds, such as "survey"; empty: nothing that can be opened.
using FileKind = std::function<std::string(const std::string& path)>;

struct FileEntry
{
  std::string Name;
  std::string Kind; ///< kind of its content; empty: a folder that is only entered
  bool IsFolder = false;
};

class FileList
{
public:
  /// Sets what is listed: files that have a kind, and folders.
  void SetKind(FileKind kind) { this->Kind = std::move(kind); }

  /// Reads a folder; false, and nothing changes, if it cannot be read. Hidden files are left out.
  bool SetFolder(const std::string& folder);
  const std::string& GetFolder() const { return this->Folder; }

  /// Goes to the folder above, and selects the one it came from.
  void MoveUp();

  /// Lists only names that contain a text, in any case.
  void SetFilter(const std::string& text);

  /// Returns what is listed: folders first, by name.
  const std::vector<FileEntry>& GetEntries() const { return this->Shown; }

  /// @{
  /// Selects an entry; -1: none.
  void Select(int entry);
  void Select(const std::string& name);
  void Move(int step);
  int GetSelected() const { return this->Selected; }
  ///@}

  /// Returns the selected entry; null: none.
  const FileEntry* GetEntry() const;

  /// Returns the path of a name in the folder, of a path beginning with ~, or of a full path.
  std::string GetPath(const std::string& name) const;

private:
  void List();

  FileKind Kind;
  std::string Folder;
  std::string Filter;
  std::vector<FileEntry> All;
  std::vector<FileEntry> Shown;
  int Selected = -1;
};

} // namespace helios::viewer

#endif
