// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosMtlCutout.h"

#include "heliosImage.h"

#include <filesystem>
#include <string>
#include <system_error>

namespace helios
{

namespace
{

/// Returns the name of an image: the rest of a line, or its last word behind options.
std::string ReadImageName(TextWords words)
{
  TextWords all = words;
  std::string name(all.NextTitle());
  if (name.empty() || name.front() != '-')
  {
    return name;
  }
  for (std::string_view word = words.Next(); !word.empty(); word = words.Next())
  {
    name = word;
  }
  return name;
}

/// Returns whether an image has transparency. JPEG has none, and is not opened.
bool HasTransparency(const std::filesystem::path& path)
{
  const std::string ending = path.extension().string();
  std::error_code error;
  ImageHeader header;
  return ending != ".jpg" && ending != ".jpeg" && ending != ".JPG" &&
    std::filesystem::is_regular_file(path, error) &&
    ReadImageHeader(path.string(), header).IsOk() && header.HasAlpha;
}

} // namespace

//------------------------------------------------------------------------------
void FindMtlCutout(const TextFile& file, std::string_view key, TextWords words, Cutout& cutout)
{
  const bool isMask = key == "map_d";
  if (!isMask && (key != "map_Kd" || !cutout.What.empty()))
  {
    return;
  }
  const std::string name = ReadImageName(words);
  const std::filesystem::path folder = std::filesystem::path(file.GetPath()).parent_path();
  if (!name.empty() && (isMask || HasTransparency(folder / name)))
  {
    cutout.Place = file.GetPlace();
    cutout.What = (isMask ? "map_d " : "the transparency of map_Kd ") + name;
  }
}

} // namespace helios
