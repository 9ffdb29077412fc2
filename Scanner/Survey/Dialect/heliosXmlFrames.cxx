// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosXmlFrames.h"

#include "heliosAssets.h"
#include "heliosMessages.h"
#include "heliosSurveyData.h"
#include "heliosXmlFilter.h"

#include <algorithm>
#include <filesystem>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace helios
{
namespace fs = std::filesystem;

namespace
{

constexpr double AnimationRate = 25.0; // frames per second of an animation, if they are not given

/// The number at the end of a file's name, before its extension.
struct FrameNumber
{
  std::string Before; ///< the name up to the number
  std::string Digits; ///< empty: none

  explicit FrameNumber(const std::string& file)
  {
    const std::string name = fs::path(file).stem().string();
    const std::size_t last = name.find_last_of("0123456789");
    const std::size_t end = last == std::string::npos ? 0 : last + 1;
    const std::size_t before = name.find_last_not_of("0123456789", end > 0 ? end - 1 : 0);
    const std::size_t begin = before == std::string::npos ? 0 : before + 1;
    this->Before = end > 0 ? name.substr(0, begin) : name;
    this->Digits = end > 0 ? name.substr(begin, end - begin) : "";
  }

  /// Returns the digits without zeros in front.
  std::string_view GetValue() const
  {
    std::string_view value = this->Digits;
    value.remove_prefix(std::min(value.find_first_not_of('0'), value.size()));
    return value;
  }
  bool operator<(const FrameNumber& other) const
  {
    const std::string_view a = this->GetValue();
    const std::string_view b = other.GetValue();
    return std::pair(a.size(), a) < std::pair(b.size(), b);
  }

  /// Returns the digits of the number after this one.
  std::string GetNext() const
  {
    std::string next = this->Digits;
    std::size_t i = next.size();
    while (i > 0 && next[i - 1] == '9')
    {
      next[--i] = '0';
    }
    i > 0 ? void(++next[i - 1]) : void(next.insert(0, 1, '1'));
    return next;
  }
};

std::string GetName(const std::string& file)
{
  return fs::path(file).filename().string();
}

/// Sorts files by their numbers; returns a fault, the end of a message.
std::string SortFrames(std::vector<std::string>& files)
{
  std::vector<std::pair<FrameNumber, std::string>> frames;
  for (const std::string& file : files)
  {
    frames.emplace_back(FrameNumber(file), file);
    if (frames.back().first.Digits.empty())
    {
      return GetName(file) + " has no number in its name; number the frames, as in walk_0001.obj";
    }
  }
  std::stable_sort(
    frames.begin(), frames.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  for (std::size_t i = 0; i < frames.size(); ++i)
  {
    const auto& [number, file] = frames[i];
    const FrameNumber next = i > 0 ? FrameNumber("x" + frames[i - 1].first.GetNext()) : number;
    if (i > 0 && number < next)
    {
      return GetName(frames[i - 1].second) + " and " + GetName(file) +
        " have the same number; give a pattern that finds one of them";
    }
    if (next < number)
    {
      return "frame " + next.Digits + " is missing between " + GetName(frames[i - 1].second) +
        " and " + GetName(file) + "; add it, or number the frames without gaps";
    }
    files[i] = file;
  }
  return "";
}

/// Returns the fault of a filter, the end of a message.
std::string FindFault(PartData& part)
{
  const bool isAnimation = part.Type == Loader::Gltf;
  if (!isAnimation && part.Type != Loader::Obj && part.Type != Loader::Ply)
  {
    return "works with objloader, plyloader and gltfloader, and this part has " +
      GetLoaderName(part.Type) + "; convert its files";
  }
  if (part.Repair || part.SimplifyDistance > 0.0)
  {
    return std::string("does not work with filter ") + (part.Repair ? "repair" : "simplify") +
      ", which changes the triangles of each frame; remove it, and repair the files";
  }
  if (isAnimation && part.Files.size() != 1)
  {
    return "plays the animation of one file, and the loader has " +
      std::to_string(part.Files.size()) + "; give a part for each";
  }
  if (!isAnimation && !part.Frames.Animation.empty())
  {
    return "has an animation, \"" + part.Frames.Animation +
      "\", which only gltfloader plays; remove it";
  }
  if (!isAnimation && part.Frames.Rate == 0.0)
  {
    return "has no framesPerSecond; add <param key=\"framesPerSecond\" value=\"25\">";
  }
  if (!isAnimation && part.Files.size() < 2)
  {
    return "needs at least two files; add <param key=\"efilepath\" "
           "value=\"folder/walk_\\d+\\.obj\">";
  }
  return isAnimation ? "" : SortFrames(part.Files);
}

} // namespace

//------------------------------------------------------------------------------
void ReadFrames(const XmlFilter& filter, Assets& files, PartData& part)
{
  part.Frames = FramesData();
  part.Frames.Where = filter.Where();
  filter.ReadStored(part.Frames);
  if (filter.Has("efilepath"))
  {
    part.Files = files.FindFiles(filter.GetValue("efilepath"), filter.GetElement().GetDocument());
  }
}

//------------------------------------------------------------------------------
void CheckFrames(PartData& part, Messages& log)
{
  FramesData& frames = part.Frames;
  if (!frames.IsGiven() || log.HasError())
  {
    return;
  }
  const std::string fault = FindFault(part);
  if (!fault.empty())
  {
    log.Error(frames.Where + ": filter frames" +
      (part.Name.empty() ? "" : " of part " + part.Name) + " " + fault);
  }
  frames.Rate = frames.Rate == 0.0 ? AnimationRate : frames.Rate;
}

} // namespace helios
