// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Checksums of written files.
#include "heliosChecksum.h"
#include "heliosPartFile.h"
#include "heliosTempFolder.h"

#include <catch2/catch.hpp>

#include <string>

namespace
{

std::string Sum(const std::string& text)
{
  helios::Checksum sum;
  sum.Add(text);
  return sum.Finish();
}

} // namespace

TEST_CASE("Checksum: GMAC of zeros", "[Checksum]")
{
  // Test case 1 of McGrew and Viega, The Galois/Counter Mode of Operation
  CHECK(Sum("") == "58e2fccefa7e3061367f1d57a4e7455a");
  helios::Checksum sum;
  sum.Add("some ");
  sum.Add("bytes");
  CHECK(sum.Finish() == Sum("some bytes"));
  sum.Add("again");
  CHECK(sum.Finish() == Sum("again"));
  sum.Add("others");
  sum.Reset();
  CHECK(sum.Finish() == Sum(""));
  CHECK(Sum("some bytes").size() == helios::ChecksumDigits);
}

TEST_CASE("Checksum: every bit and the length change it", "[Checksum]")
{
  const std::string text(1000, 'a');
  for (std::size_t i = 0; i < 8 * text.size(); ++i)
  {
    std::string other = text;
    other[i / 8] = static_cast<char>(other[i / 8] ^ (1 << i % 8));
    CHECK(Sum(other) != Sum(text));
  }
  CHECK(Sum(std::string(16, '\0')) != Sum(std::string(32, '\0')));
  CHECK(Sum(text + '\0') != Sum(text));
}

TEST_CASE("Checksum: checksum of a file", "[Checksum]")
{
  const helios::TempFolder folder;
  const std::string path = folder / "file";
  std::string text(3000000, ' ');
  for (std::size_t i = 0; i < text.size(); ++i)
  {
    text[i] = static_cast<char>(i * i % 251);
  }
  std::ofstream(path, std::ios::binary) << text;
  CHECK(helios::ComputeChecksum(path, 0, text.size()) == Sum(text));
  CHECK(helios::ComputeChecksum(path, 7, 2000000) == Sum(text.substr(7, 2000000 - 7)));
  CHECK(helios::ComputeChecksum(path, 5, 5) == Sum(""));
  CHECK(helios::ComputeChecksum(path, 0, text.size() + 1).empty());
  CHECK(helios::ComputeChecksum(folder / "none", 0, 1).empty());
}

TEST_CASE("PartFile: blocks of appended bytes", "[PartFile]")
{
  const helios::TempFolder folder;
  helios::PartFile file;
  REQUIRE((file.Open(folder / "a.txt") && file.Append("head", 4)));
  file.BeginBlock();
  REQUIRE((file.Append("one", 3) && file.Append("two", 3)));
  const helios::FileBlock first = file.CollectBlock();
  CHECK(first.Name == "a.txt");
  CHECK((first.Begin == 4 && first.End == 10));
  CHECK(first.Checksum == Sum("onetwo"));
  SECTION("no further bytes")
  {
    const helios::FileBlock next = file.CollectBlock();
    CHECK(next.Begin == next.End);
  }
  SECTION("truncated bytes are not included")
  {
    REQUIRE((file.Append("three", 5) && file.Append("four", 4) && file.Cut(15)));
    CHECK(file.CollectBlock().Checksum == Sum("three"));
    REQUIRE((file.Append("five", 4) && file.Cut(15) && file.Append("six", 3)));
    CHECK(file.CollectBlock().Checksum == Sum("six"));
  }
  SECTION("truncated beyond the block")
  {
    REQUIRE((file.Cut(2) && file.Append("x", 1)));
    const helios::FileBlock next = file.CollectBlock();
    CHECK((next.Begin == 2 && next.End == 3));
    CHECK(next.Checksum == Sum("x"));
  }
  SECTION("resumed")
  {
    REQUIRE((file.Abandon() && file.Reopen(folder / "a.txt", 7) && file.Append("more", 4)));
    const helios::FileBlock next = file.CollectBlock();
    CHECK((next.Begin == 7 && next.End == 11));
    CHECK(next.Checksum == Sum("more"));
  }
}

TEST_CASE("PartFile: a missing folder is an error", "[PartFile]")
{
  const helios::TempFolder folder;
  helios::PartFile file;
  CHECK_FALSE(file.Open(folder / "none/a.txt", helios::Folders::Need));
  CHECK(file.GetProblem().find("a.txt.part cannot be opened: No such file") != std::string::npos);
  CHECK_FALSE(std::filesystem::exists(folder / "none"));
}
