// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Damaged file name patterns (efilepath) match files, or are rejected with their place, within the
// time limit.
#include "heliosMutation.h"
#include "heliosSurveyFiles.h"

#include <catch2/catch.hpp>

#include <chrono>

using namespace helios::test;

namespace
{

/// Patterns for files in the folder "trees".
const char* const Patterns[] = { "oak_.*[.]obj", "(a+)+b[0-9]{1,3}[.]obj", "[a-z_]+_[^x]?\\d*.obj",
  "(oak|ash)_(\\w)+.obj" };

/// Formats an attribute value; control characters, which are invalid in XML, become blanks.
std::string Quote(const std::string& text)
{
  std::string quoted;
  for (const char c : text)
  {
    const bool isPlain = static_cast<unsigned char>(c) >= 32 && static_cast<unsigned char>(c) < 127;
    quoted += c == '&' ? "&amp;"
      : c == '<'       ? "&lt;"
      : c == '"'       ? "&quot;"
      : isPlain        ? std::string(1, c)
                       : " ";
  }
  return quoted;
}

} // namespace

TEST_CASE(
  "PatternMutations: damaged patterns match files or are refused", "[PatternMutations][mutation]")
{
  const Files files;
  for (const std::string name :
    { "oak_1", "ash_22", "aaab7", "aaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaa" })
  {
    files.Write("trees/" + name + ".obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  }
  helios::Mutator mutate(20204);
  int errorCount = 0;
  int goodCount = 0;
  for (int i = 0; i < helios::GetNumberOfMutations(); ++i)
  {
    const std::string pattern = Patterns[static_cast<std::size_t>(i) % std::size(Patterns)];
    const std::string text = i < 4 ? pattern : mutate(pattern);
    files.Write("scene.xml",
      "<document><scene id=\"s\"><part>\n<filter type=\"objloader\">"
      "<param key=\"efilepath\" value=\"trees/" +
        Quote(text) + "\"/></filter></part></scene></document>");
    INFO("case " << i << "\n" << text);
    const auto start = std::chrono::steady_clock::now();
    const Reading reading(files, Tripod, OneLeg);
    REQUIRE(std::chrono::steady_clock::now() - start < std::chrono::seconds(10));
    (reading.Good ? goodCount : errorCount) += 1;
    REQUIRE((reading.Good || reading.Log->HasError("scene.xml:")));
    CHECK((i >= 4 || reading.Good)); // undamaged
  }
  CHECK(errorCount > 20);
  CHECK(goodCount > 10);
}
