// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// A folder for one test, gone with it.

#ifndef heliosTempFolder_h
#define heliosTempFolder_h

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

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

  std::string operator/(const std::string& name) const { return (this->Path / name).string(); }

private:
  std::filesystem::path Path;
};

inline std::string ReadText(const std::string& path)
{
  std::ifstream file(path, std::ios::binary);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

/// Lines of words.
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
