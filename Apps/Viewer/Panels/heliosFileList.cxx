// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosFileList.h"

#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <filesystem>

namespace fs = std::filesystem;

namespace helios::viewer
{

namespace
{

std::string ToLower(std::string text)
{
  std::transform(text.begin(), text.end(), text.begin(),
    [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return text;
}

/// Orders folders first, then by name in any case.
bool IsBefore(const FileEntry& a, const FileEntry& b)
{
  const std::string first = ToLower(a.Name), second = ToLower(b.Name);
  return a.IsFolder != b.IsFolder ? a.IsFolder : first != second ? first < second : a.Name < b.Name;
}

} // namespace

//------------------------------------------------------------------------------
bool FileList::SetFolder(const std::string& folder)
{
  std::error_code error;
  const fs::path path = fs::weakly_canonical(fs::absolute(folder, error), error);
  fs::directory_iterator entry(path, error);
  if (error)
  {
    return false;
  }
  std::vector<FileEntry> all;
  for (const fs::directory_iterator end; entry != end; entry.increment(error))
  {
    FileEntry one;
    std::error_code ignored;
    one.Name = entry->path().filename().string();
    one.IsFolder = entry->is_directory(ignored);
    one.Kind = this->Kind ? this->Kind(entry->path().string()) : "";
    if (one.Name.front() != '.' && (one.IsFolder || !one.Kind.empty()))
    {
      all.push_back(one);
    }
  }
  std::sort(all.begin(), all.end(), IsBefore);
  this->All = all;
  this->Folder = path.string();
  this->Filter.clear();
  this->List();
  return true;
}

//------------------------------------------------------------------------------
void FileList::MoveUp()
{
  const fs::path from = this->Folder;
  if (from.has_relative_path() && this->SetFolder(from.parent_path().string()))
  {
    this->Select(from.filename().string());
  }
}

//------------------------------------------------------------------------------
/// Selects a name; one that is not listed changes nothing.
void FileList::Select(const std::string& name)
{
  const auto found = std::find_if(this->Shown.begin(), this->Shown.end(),
    [&name](const FileEntry& entry) { return entry.Name == name; });
  this->Selected =
    found == this->Shown.end() ? this->Selected : static_cast<int>(found - this->Shown.begin());
}

//------------------------------------------------------------------------------
void FileList::SetFilter(const std::string& text)
{
  this->Filter = ToLower(text);
  this->List();
}

//------------------------------------------------------------------------------
void FileList::List()
{
  this->Shown.clear();
  for (const FileEntry& entry : this->All)
  {
    if (ToLower(entry.Name).find(this->Filter) != std::string::npos)
    {
      this->Shown.push_back(entry);
    }
  }
  this->Selected = this->Shown.empty() ? -1 : 0;
}

//------------------------------------------------------------------------------
void FileList::Select(int entry)
{
  this->Selected = entry >= 0 && entry < static_cast<int>(this->Shown.size()) ? entry : -1;
}

//------------------------------------------------------------------------------
void FileList::Move(int step)
{
  const auto count = static_cast<int>(this->Shown.size());
  this->Selected = count == 0 ? -1 : std::clamp(this->Selected + step, 0, count - 1);
}

//------------------------------------------------------------------------------
const FileEntry* FileList::GetEntry() const
{
  return this->Selected < 0 ? nullptr : &this->Shown[static_cast<std::size_t>(this->Selected)];
}

//------------------------------------------------------------------------------
std::string FileList::GetPath(const std::string& name) const
{
  const char* home = std::getenv("HOME");
  const bool isHome =
    home && !name.empty() && name[0] == '~' && (name.size() == 1 || name[1] == '/');
  return isHome ? home + name.substr(1) : (fs::path(this->Folder) / name).string();
}

} // namespace helios::viewer
