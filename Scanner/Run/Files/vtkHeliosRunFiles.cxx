// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHeliosRunFiles.h"

#include <vtkObjectFactory.h>

#include <algorithm>
#include <charconv>
#include <filesystem>
#include <iterator>
#include <string_view>

vtkStandardNewMacro(vtkHeliosRunFiles);

namespace
{

constexpr const char* Formats[] = { "xyz", "las", "laz", "copc", "vtp" };
constexpr int NumberOfFormats = 5;

struct KindOfFile
{
  std::string_view Word;
  std::string_view Endings[NumberOfFormats]; ///< by format
};

/// Kinds in the order of FileKind.
constexpr KindOfFile Kinds[] = {
  { "_points", { ".xyz", ".las", ".laz", ".copc.laz", ".pvtp" } },
  { "_fullwave", { ".txt", ".las", ".laz", ".laz", ".pvtt" } },
  { "_pulse", { ".txt", ".txt", ".txt", ".txt", ".pvtp" } },
  { "_hits", { ".pvtp", ".pvtp", ".pvtp", ".pvtp", ".pvtp" } },
  { "_trajectory", { ".txt", ".txt", ".txt", ".txt", ".pvtp" } },
};
constexpr std::string_view Leg = "leg";
constexpr std::string_view Strip = "strip";
constexpr std::string_view EpochFolder = "epoch";
constexpr std::string_view FormerEpochFolder = "play"; // before version 0.3
constexpr std::string_view RunPartFolder = "part";
constexpr std::string_view PartCount = "of";
constexpr std::string_view Channel = "_dev";
constexpr std::size_t MinimumWidth = 3; // width of numbers and names of strips

std::string Pad(std::string_view start, const std::string& word)
{
  const std::size_t zeros = MinimumWidth - std::min(MinimumWidth, word.size());
  return std::string(start) + std::string(zeros, '0') + word;
}

bool StartsWith(std::string_view text, std::string_view start)
{
  return text.substr(0, start.size()) == start;
}

/// Parses a number without a sign; -1 for any other text.
int ParseNumber(std::string_view text)
{
  int number = -1;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  return error == std::errc() && end == text.data() + text.size() && text[0] != '-' ? number : -1;
}

/// The parts of a file's name.
struct NameParts
{
  std::string_view Stem; ///< legNNN or stripS
  int Kind = -1;
  std::string_view Rest; ///< after the word of the kind
};

/// Splits at the last word of a kind: a strip may be named like one. Without any: no kind.
NameParts Split(std::string_view name)
{
  NameParts parts;
  for (int kind = 0; kind < static_cast<int>(std::size(Kinds)); ++kind)
  {
    const std::size_t at = name.rfind(Kinds[kind].Word);
    if (at != std::string_view::npos && (parts.Kind < 0 || at > parts.Stem.size()))
    {
      parts = { name.substr(0, at), kind, name.substr(at + Kinds[kind].Word.size()) };
    }
  }
  return parts;
}

/// Returns the number or name of a leg or strip; empty of another stem.
std::string_view GetId(std::string_view stem)
{
  const bool isLeg = StartsWith(stem, Leg);
  const std::size_t begin = isLeg ? Leg.size() : Strip.size();
  if ((!isLeg && !StartsWith(stem, Strip)) || stem.size() < begin + MinimumWidth)
  {
    return {};
  }
  const std::string_view id = stem.substr(begin);
  const bool isNumber = id.find_first_not_of("0123456789") == std::string_view::npos;
  return isLeg && !isNumber ? std::string_view() : id;
}

/// Returns whether a channel, if any, and an ending follow the kind.
bool IsFinished(const NameParts& parts)
{
  std::string_view rest = parts.Rest;
  if (StartsWith(rest, Channel))
  {
    rest.remove_prefix(std::min(rest.size(), rest.find('.')));
  }
  const auto& endings = Kinds[parts.Kind].Endings;
  return std::find(std::begin(endings), std::end(endings), rest) != std::end(endings);
}

/// Splits names of finished files of legs and strips only.
NameParts SplitFinished(std::string_view name)
{
  const NameParts parts = Split(name);
  return parts.Kind >= 0 && !GetId(parts.Stem).empty() && IsFinished(parts) ? parts : NameParts();
}

} // namespace

//------------------------------------------------------------------------------
const char* vtkHeliosRunFiles::GetSummaryName()
{
  return "run_summary.json";
}

//------------------------------------------------------------------------------
const char* vtkHeliosRunFiles::GetJournalName()
{
  return "run.journal";
}

//------------------------------------------------------------------------------
std::string vtkHeliosRunFiles::GetEpochName(int epoch)
{
  return Pad(EpochFolder, std::to_string(epoch));
}

//------------------------------------------------------------------------------
int vtkHeliosRunFiles::GetEpoch(const std::string& folder)
{
  for (const std::string_view start : { EpochFolder, FormerEpochFolder })
  {
    const int epoch = StartsWith(folder, start) ? ParseNumber(folder.substr(start.size())) : -1;
    if (epoch >= 0 && Pad(start, std::to_string(epoch)) == folder)
    {
      return epoch;
    }
  }
  return -1;
}

//------------------------------------------------------------------------------
std::string vtkHeliosRunFiles::FindEpoch(const std::string& folder, int epoch)
{
  namespace fs = std::filesystem;
  const fs::path found = fs::path(folder) / vtkHeliosRunFiles::GetEpochName(epoch);
  const fs::path former = fs::path(folder) / Pad(FormerEpochFolder, std::to_string(epoch));
  std::error_code ignored;
  const bool isFormer = !fs::exists(found, ignored) && fs::is_directory(former, ignored);
  return (isFormer ? former : found).string();
}

//------------------------------------------------------------------------------
std::string vtkHeliosRunFiles::GetPartName(int part, int parts)
{
  return Pad(RunPartFolder, std::to_string(part)) + Pad(PartCount, std::to_string(parts));
}

//------------------------------------------------------------------------------
int vtkHeliosRunFiles::GetNumberOfFormats()
{
  return NumberOfFormats;
}

//------------------------------------------------------------------------------
const char* vtkHeliosRunFiles::GetFormat(int index)
{
  return index >= 0 && index < NumberOfFormats ? Formats[index] : nullptr;
}

//------------------------------------------------------------------------------
bool vtkHeliosRunFiles::IsLas(const std::string& format)
{
  return format == "las" || vtkHeliosRunFiles::IsCompressed(format);
}

//------------------------------------------------------------------------------
bool vtkHeliosRunFiles::IsCompressed(const std::string& format)
{
  return format == "laz" || format == "copc";
}

//------------------------------------------------------------------------------
std::string vtkHeliosRunFiles::GetLegStem(int leg)
{
  return Pad(Leg, std::to_string(leg));
}

//------------------------------------------------------------------------------
std::string vtkHeliosRunFiles::GetStripStem(const std::string& strip)
{
  return Pad(Strip, strip);
}

//------------------------------------------------------------------------------
std::string vtkHeliosRunFiles::GetFileName(
  const std::string& stem, int kind, const std::string& format, const std::string& channel)
{
  const auto index = std::find(std::begin(Formats), std::end(Formats), format) - Formats;
  if (kind < 0 || kind >= static_cast<int>(std::size(Kinds)) || index == NumberOfFormats)
  {
    return {};
  }
  std::string name = stem;
  name += Kinds[kind].Word;
  name += channel.empty() ? std::string() : std::string(Channel) + channel;
  return name.append(Kinds[kind].Endings[index]);
}

//------------------------------------------------------------------------------
std::string vtkHeliosRunFiles::GetBeside(
  const std::string& fileName, int kind, const std::string& format)
{
  const NameParts parts = Split(fileName);
  return parts.Kind < 0 ? std::string()
                        : vtkHeliosRunFiles::GetFileName(std::string(parts.Stem), kind, format);
}

//------------------------------------------------------------------------------
int vtkHeliosRunFiles::GetKind(const std::string& fileName)
{
  return SplitFinished(fileName).Kind;
}

//------------------------------------------------------------------------------
std::string vtkHeliosRunFiles::GetStem(const std::string& fileName)
{
  return std::string(SplitFinished(fileName).Stem);
}

//------------------------------------------------------------------------------
int vtkHeliosRunFiles::GetNumber(const std::string& fileName)
{
  return ParseNumber(GetId(SplitFinished(fileName).Stem));
}

//------------------------------------------------------------------------------
bool vtkHeliosRunFiles::IsOfLeg(const std::string& fileName)
{
  return !GetId(Split(fileName).Stem).empty();
}
