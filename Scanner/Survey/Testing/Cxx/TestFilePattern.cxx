// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// File name patterns: matches, rejected expressions, and linear time.
#include "heliosFilePattern.h"

#include "heliosSurveyFiles.h"

#include <catch2/catch.hpp>

#include <string>
#include <vector>

using helios::FilePattern;
using helios::test::Files;

namespace
{

/// The names, without the folder, that a pattern finds in a folder.
std::string FindNames(const FilePattern& pattern, const std::string& folder)
{
  INFO(pattern.GetFault());
  REQUIRE(pattern.GetFault().empty());
  std::vector<std::string> files;
  REQUIRE(pattern.FindFiles(folder, files));
  std::string names;
  for (const std::string& file : files)
  {
    names += std::filesystem::path(file).filename().string() + " ";
  }
  return names;
}

std::string Repeat(const std::string& text, std::size_t count)
{
  std::string all;
  for (std::size_t i = 0; i < count; ++i)
  {
    all += text;
  }
  return all;
}

} // namespace

TEST_CASE("FilePattern: matches complete names, in alphabetical order", "[FilePattern]")
{
  const Files files;
  for (const char* name : { "b_2.xyz", "b_1.xyz", "B_1.xyz", "b_1.xyz.gz", "c-10.txt", "\xe4.xyz" })
  {
    files.Write(std::string("d/") + name, "");
  }
  files.Write("d/folder.xyz/inside", "");
  const auto find = [&files](const char* text)
  { return FindNames(FilePattern(text), files / "d"); };
  CHECK(find("d/b_.*\\.xyz") == "b_1.xyz b_2.xyz ");
  CHECK(find("d/.*[.]xyz") == "B_1.xyz b_1.xyz b_2.xyz \xe4.xyz "); // no folder; any bytes
  CHECK(find("[bB]_\\d.xyz") == "B_1.xyz b_1.xyz b_2.xyz ");
  CHECK(find("^(b|c)[_-][[:digit:]]{1,2}\\.(?:xyz|txt)$") == "b_1.xyz b_2.xyz c-10.txt ");
  CHECK(find("x.*").empty());
  CHECK(FilePattern("a/b/.*").GetFolder() == "a/b/");
  CHECK(FilePattern(".*").GetFolder().empty());
}

TEST_CASE("FilePattern: expressions that need more than linear time are refused", "[FilePattern]")
{
  const auto fault = [](const std::string& text) { return FilePattern(text).GetFault(); };
  const std::string unsupported = "lookahead and back references are not supported";
  CHECK(fault("d/[").find("missing ]") != std::string::npos);
  CHECK(fault("d/(a").find("missing )") != std::string::npos);
  CHECK(fault("d/(?=a)b").find(unsupported) != std::string::npos);
  CHECK(fault("d/(a)\\1").find(unsupported) != std::string::npos);
  CHECK(fault("d/((a{1000}){1000}){1000}") != "");
  CHECK(fault(Repeat("(", 50000) + Repeat(")", 50000)) ==
    "it has 100000 characters, and at most 1000 are allowed");
  CHECK(fault(Repeat("(", 500) + Repeat(")", 500)).empty());
}

TEST_CASE("FilePattern: every expression takes linear time", "[FilePattern]")
{
  const Files files;
  files.Write("d/" + Repeat("a", 200) + "!", "");
  CHECK(FindNames(FilePattern("d/(a+)+$"), files / "d").empty());
  CHECK(FindNames(FilePattern("(a|a|aa)*b"), files / "d").empty());
}

TEST_CASE("FilePattern: a folder that is too large is refused", "[FilePattern]")
{
  const Files files;
  for (const char* name : { "d/1", "d/2", "d/3" })
  {
    files.Write(name, "");
  }
  std::vector<std::string> found;
  CHECK_FALSE(FilePattern(".*").FindFiles(files / "d", found, 2));
  CHECK(found.empty());
  CHECK(FilePattern(".*").FindFiles(files / "d", found, 3));
  CHECK(found.size() == 3);
}
