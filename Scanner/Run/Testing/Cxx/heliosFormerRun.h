// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Journals with other contents and right checksums, such as those of version 1.

#ifndef heliosFormerRun_h
#define heliosFormerRun_h

#include "heliosChecksum.h"
#include "heliosSurveyFiles.h"

#include <catch2/catch.hpp>

#include <fstream>
#include <sstream>
#include <string>
#include <vector>

namespace helios
{
namespace test
{

inline std::vector<std::string> SplitLines(const std::string& text)
{
  std::vector<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);)
  {
    lines.push_back(line);
  }
  return lines;
}

inline std::string JoinLines(const std::vector<std::string>& lines)
{
  std::string text;
  for (const std::string& line : lines)
  {
    text += line + "\n";
  }
  return text;
}

/// A line of a journal without its checksum.
inline std::string Unseal(const std::string& line)
{
  return line.substr(0, line.rfind(",\"check\":")) + "}";
}

/// Recomputes the checksums of all lines.
inline std::string Reseal(const std::vector<std::string>& lines)
{
  std::string text;
  std::string seal;
  for (const std::string& line : lines)
  {
    std::string body = Unseal(line);
    helios::Checksum sum;
    sum.Add(seal + body);
    seal = sum.Finish();
    body.pop_back();
    text += body + ",\"check\":\"" + seal + "\"}\n";
  }
  return text;
}

/// Replaces a text that is there once.
inline void ReplaceOnce(std::string& text, const std::string& from, const std::string& to)
{
  const std::size_t at = text.find(from);
  REQUIRE(at != std::string::npos);
  text.replace(at, from.size(), to);
}

/// Converts the journal in a folder, of a run of epoch 1, to version 1, which has plays.
inline void MakeFormer(const std::string& folder)
{
  const std::string journal = folder + "/run.journal";
  std::vector<std::string> lines = SplitLines(ReadText(journal));
  ReplaceOnce(lines.front(), ",\"summary\":2", "");
  ReplaceOnce(lines.front(), "\"epoch\":1", "\"play\":1");
  std::ofstream(journal) << Reseal(lines);
}

} // namespace test
} // namespace helios

#endif
