// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosInputDigest.h"

#include "heliosInputFile.h"
#include "heliosTempFolder.h"

#include <catch2/catch.hpp>

#include <chrono>
#include <filesystem>
#include <fstream>
#include <string>
#include <thread>

TEST_CASE("InputDigest: size, SHA-256 and state of a file", "[InputDigest]")
{
  const helios::TempFolder folder;
  const std::string path = folder / "file";
  CHECK(helios::ComputeInputDigest(path).Sha256.empty());
  CHECK(helios::ComputeInputDigest(path).Stamp.empty());
  std::ofstream(path) << "abc";
  const helios::InputDigest digest = helios::ComputeInputDigest(path);
  // FIPS 180-2, appendix B.1
  CHECK(digest.Sha256 == "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
  CHECK(digest.Size == 3);
  CHECK(digest.Stamp == helios::StampFile(path));
  CHECK(helios::ComputeInputDigest(folder / ".").Sha256.empty()); // a folder
}

TEST_CASE("InputDigest: changes that keep size and time give another digest", "[InputDigest]")
{
  const helios::TempFolder folder;
  const std::string path = folder / "file";
  std::ofstream(path) << "abc";
  const auto time = std::filesystem::last_write_time(path);
  const std::string before = helios::ComputeInputDigest(path).Sha256;
  for (const int milliseconds : { 0, 2100 }) // at once, and after its digest is remembered
  {
    std::this_thread::sleep_for(std::chrono::milliseconds(milliseconds));
    CHECK(helios::ComputeInputDigest(path).Sha256 == before);
    std::ofstream(path) << "abd";
    std::filesystem::last_write_time(path, time);
    CHECK(helios::ComputeInputDigest(path).Sha256 != before);
    std::ofstream(path) << "abc";
    std::filesystem::last_write_time(path, time);
    CHECK(helios::ComputeInputDigest(path).Sha256 == before);
  }
}
