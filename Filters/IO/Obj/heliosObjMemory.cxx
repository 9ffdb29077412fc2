// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosObjMemory.h"

#include "heliosInputFile.h"
#include "heliosMemoryCheck.h"
#include "heliosStatus.h"
#include "heliosTextFile.h"

#include <algorithm>
#include <filesystem>

namespace helios
{

namespace
{

constexpr double ShortestCorner = 2.0; // [bytes], one triangle each: a blank and a digit

bool IsBlankAt(std::string_view line, std::size_t at)
{
  return at < line.size() && TextWords::IsBlank(line[at]);
}

/// Counts the words of a line after its first letter.
double CountWords(std::string_view line)
{
  double words = 0.0;
  for (std::size_t i = 1; i < line.size(); ++i)
  {
    words += IsBlankAt(line, i) && i + 1 < line.size() && !IsBlankAt(line, i + 1);
  }
  return words;
}

} // namespace

ObjCounts CountObj(const std::string& path, const std::function<bool(double)>& onBlock)
{
  ObjCounts counts;
  TextFile file;
  file.OnBlock = onBlock;
  std::string_view line;
  for (bool good = file.Open(path).IsOk(); good && file.NextLine(line);)
  {
    if (IsBlankAt(line, 1))
    {
      counts.Vertices += line[0] == 'v';
      counts.Triangles += line[0] == 'f' ? std::max(0.0, CountWords(line) - 2.0) : 0.0;
    }
  }
  return counts;
}

Status CheckObjMemory(const std::string& path, const std::function<bool(double)>& onBlock)
{
  std::error_code error;
  const double size = CheckInputFile(path).IsOk()
    ? static_cast<double>(std::filesystem::file_size(path, error))
    : 0.0;
  if (error || CheckMemory("bytes", size, BytesPerTriangle / ShortestCorner).IsOk())
  {
    return {};
  }
  const ObjCounts counts = CountObj(path, onBlock);
  const double triangles = std::max(1.0, counts.Triangles);
  const Status status = CheckMemory("triangles with their vertices", triangles,
    BytesPerTriangle + BytesPerVertex * counts.Vertices / triangles);
  return status.IsOk() ? status : Status::Error(path + ": " + status.Message());
}

} // namespace helios
