// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// A temporary folder for one test, and a small file system in it.

#ifndef heliosTempFolder_h
#define heliosTempFolder_h

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include <sys/mount.h>

namespace helios
{

class TempFolder
{
public:
  TempFolder()
  {
    std::string name = (std::filesystem::temp_directory_path() / "vtkHeliosXXXXXX").string();
    this->Path = ::mkdtemp(name.data());
  }
  ~TempFolder() { std::filesystem::remove_all(this->Path); }
  TempFolder(const TempFolder&) = delete;
  void operator=(const TempFolder&) = delete;

  std::string operator/(const std::string& name) const { return (this->Path / name).string(); }

private:
  std::filesystem::path Path;
};

/// A file system of a few KiB in a new folder, if the system permits the mount.
class SmallDisk
{
public:
  SmallDisk(const std::string& path, int kibibytes)
    : Path(path)
  {
    std::filesystem::create_directory(path);
    const std::string options = "size=" + std::to_string(kibibytes) + "k";
    this->Mounted = ::mount("tmpfs", path.c_str(), "tmpfs", 0, options.c_str()) == 0;
  }
  ~SmallDisk()
  {
    if (this->Mounted)
    {
      ::umount(this->Path.c_str());
    }
  }
  SmallDisk(const SmallDisk&) = delete;
  void operator=(const SmallDisk&) = delete;

  bool IsMounted() const { return this->Mounted; }

private:
  std::string Path;
  bool Mounted;
};

inline std::string ReadText(const std::string& path)
{
  std::ifstream file(path, std::ios::binary);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

/// Reads lines as words.
inline std::vector<std::vector<std::string>> ReadRows(const std::string& path)
{
  std::vector<std::vector<std::string>> rows;
  std::ifstream file(path);
  for (std::string line; std::getline(file, line);)
  {
    std::istringstream words(line);
    rows.emplace_back();
    for (std::string word; words >> word;)
    {
      rows.back().push_back(word);
    }
  }
  return rows;
}

} // namespace helios

#endif
