// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosMtlCutout.h"

#include "heliosImage.h"

#include <filesystem>
#include <string>
#include <system_error>
#include <vector>

namespace helios
{

namespace
{

/// Returns the words of an image: its options, and its name last.
std::vector<std::string> SplitImage(TextWords words)
{
  TextWords all = words;
  const std::string name(all.NextTitle());
  if (name.empty() || name.front() != '-')
  {
    return { name };
  }
  std::vector<std::string> split;
  for (std::string_view word = words.Next(); !word.empty(); word = words.Next())
  {
    split.emplace_back(word);
  }
  return split;
}

/// Returns whether the numbers behind an option are all the same as without it.
bool IsNeutral(const std::vector<std::string>& words, std::size_t option, double neutral)
{
  for (std::size_t i = option + 1; i + 1 < words.size() && words[i].front() != '-'; ++i)
  {
    TextWords text(words[i]);
    double value = 0.0;
    if (text.Next(value) != TextWords::Number::Good || value != neutral)
    {
      return false;
    }
  }
  return true;
}

void SetChannel(const std::string& name, Cutout& cutout)
{
  cutout.Channel = name == "m" ? MaskChannel::Alpha
    : name == "l"              ? MaskChannel::Luminance
    : name == "r"              ? MaskChannel::Red
    : name == "g"              ? MaskChannel::Green
    : name == "b"              ? MaskChannel::Blue
                               : MaskChannel::AlphaOrLuminance;
  cutout.Fault = name == "z" ? "-imfchan z is not read; give m, l, r, g or b" : cutout.Fault;
}

/// Applies the options of an image; those that change its place or values are not read.
void ReadOptions(const std::vector<std::string>& words, Cutout& cutout)
{
  for (std::size_t i = 0; i + 1 < words.size(); ++i)
  {
    const std::string& option = words[i];
    if (option == "-imfchan")
    {
      SetChannel(words[i + 1], cutout);
    }
    else if (option == "-clamp" && words[i + 1] == "on")
    {
      cutout.Wrap = { TextureWrap::Clamp, TextureWrap::Clamp };
    }
    else if ((option == "-s" && !IsNeutral(words, i, 1.0)) ||
      ((option == "-o" || option == "-t") && !IsNeutral(words, i, 0.0)) || option == "-mm")
    {
      cutout.Fault = "its option " + option +
        " is not read; change the texture coordinates or the "
        "image instead";
    }
  }
}

/// Returns whether an image has transparency. JPEG has none, and is not opened.
bool HasTransparency(const std::filesystem::path& path)
{
  const std::string ending = path.extension().string();
  std::error_code error;
  ImageHeader header;
  return ending != ".jpg" && ending != ".jpeg" && ending != ".JPG" &&
    std::filesystem::is_regular_file(path, error) &&
    ReadImageHeader({ path.string() }, header).IsOk() && header.HasAlpha;
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
  const std::vector<std::string> image = SplitImage(words);
  const std::string name = image.empty() ? std::string() : image.back();
  const std::filesystem::path path = std::filesystem::path(file.GetPath()).parent_path() / name;
  if (name.empty() || (!isMask && !HasTransparency(path)))
  {
    return;
  }
  cutout = Cutout();
  cutout.Place = file.GetPlace();
  cutout.What = (isMask ? "map_d " : "the transparency of map_Kd ") + name;
  cutout.Path = path.string();
  cutout.Channel = isMask ? MaskChannel::AlphaOrLuminance : MaskChannel::Alpha;
  ReadOptions(image, cutout);
}

} // namespace helios
