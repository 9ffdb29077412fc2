// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Damaged images give an error or all pixels.
#include "heliosImageSeeds.h"
#include "heliosImageTesting.h"
#include "heliosMutation.h"

#include <catch2/catch.hpp>

namespace
{

/// The seeds, and one with run lengths, which no writer of VTK has.
std::map<std::string, std::string> MakeSeeds()
{
  const helios::TempFolder folder;
  std::map<std::string, std::string> files = helios::ImageSeeds(folder, 3).Files;
  helios::TestBmp runs;
  runs.Columns = 5;
  runs.Bits = 8;
  runs.Compression = 1;
  runs.Colors = 2;
  runs.Between = std::string("\1\2\3\0\4\5\6\0", 8);
  runs.Pixels = helios::ToBytes({ 3, 1, 0, 0, 0, 3, 1, 0, 1, 0, 0, 2, 1, 0, 1, 1, 0, 1 });
  files["runs.bmp"] = runs.Write();
  files["text.ppm"] = "P3 2 2 255\n0 1 2 3 4 5\n6 7 8 # last\n9 10 11\n";
  return files;
}

} // namespace

TEST_CASE("ImageMutations: damaged files give an error or a whole image", "[mutation]")
{
  const auto seeds = MakeSeeds();
  const int count = helios::GetNumberOfMutations();
  int imageCount = 0;
  for (int i = 0; i < count; ++i)
  {
    for (const auto& [name, bytes] : seeds)
    {
      helios::Mutator mutate(static_cast<unsigned>(i));
      INFO("seed " << i << " of " << name);
      const std::string read = helios::ReadBytesAsImage(mutate(bytes));
      const bool isError = read.substr(0, 5) == "image";
      REQUIRE((isError ? read.find("; ") : read.find(": ")) != std::string::npos);
      imageCount += !isError;
    }
  }
  const int all = count * static_cast<int>(seeds.size());
  CHECK(imageCount > all / 50); // both occur
  CHECK(imageCount < all - all / 50);
}
