// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosPlatformKind.h"

#include "heliosSurveyData.h"

#include <algorithm>
#include <cctype>
#include <iterator>
#include <string>
#include <utility>

namespace helios::viewer
{

namespace
{

constexpr double LowFlight = 4.0;    // [m], above what drives on roads
constexpr double HighFlight = 150.0; // [m], above what multicopters may fly
constexpr double FastWalk = 2.5;     // [m/s]

// The first word of a name that is here decides: "sr22_car" is a car.
constexpr std::pair<const char*, PlatformKind> Words[] = {
  { "tripod", PlatformKind::Tripod },
  { "tractor", PlatformKind::Tractor },
  { "harvester", PlatformKind::Tractor },
  { "forwarder", PlatformKind::Tractor },
  { "backpack", PlatformKind::Person },
  { "handheld", PlatformKind::Person },
  { "person", PlatformKind::Person },
  { "pedestrian", PlatformKind::Person },
  { "walk", PlatformKind::Person },
  { "copter", PlatformKind::Multicopter },
  { "drone", PlatformKind::Multicopter },
  { "rotor", PlatformKind::Multicopter },
  { "uav", PlatformKind::Multicopter },
  { "uls", PlatformKind::Multicopter },
  { "vehicle", PlatformKind::Car },
  { "truck", PlatformKind::Car },
  { "car", PlatformKind::Car },
  { "van", PlatformKind::Car },
  { "plane", PlatformKind::Aircraft },
  { "aircraft", PlatformKind::Aircraft },
  { "cirrus", PlatformKind::Aircraft },
  { "sr22", PlatformKind::Aircraft },
};

/// Returns whether a word begins or ends one of the words of a text: "multicopter", not "scar".
bool HasWord(const std::string& text, const std::string& word)
{
  const auto isLetter = [&text](std::size_t at)
  { return at < text.size() && std::isalpha(static_cast<unsigned char>(text[at])) != 0; };
  for (std::size_t at = text.find(word); at != std::string::npos; at = text.find(word, at + 1))
  {
    const bool isBegin = at == 0 || !isLetter(at - 1);
    const bool isEnd = !isLetter(at + word.size());
    if ((isBegin && isEnd) || (word.size() > 3 && (isBegin || isEnd)))
    {
      return true;
    }
  }
  return false;
}

} // namespace

//------------------------------------------------------------------------------
PlatformKind FindPlatformKind(const PlatformData& platform)
{
  const PlatformType type = platform.Type;
  if (type == PlatformType::Static)
  {
    return PlatformKind::Tripod;
  }
  std::string text = platform.Id + " " + platform.Name + " " + platform.Model.Name;
  std::transform(text.begin(), text.end(), text.begin(),
    [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  const auto* found = std::find_if(std::begin(Words), std::end(Words),
    [&text](const auto& word) { return HasWord(text, word.first); });
  if (found != std::end(Words) && found->second != PlatformKind::Tripod)
  {
    return found->second;
  }
  return type == PlatformType::GroundVehicle ? PlatformKind::Car
    : type == PlatformType::Multicopter      ? PlatformKind::Multicopter
                                             : PlatformKind::Unknown;
}

//------------------------------------------------------------------------------
PlatformKind GuessPlatformKind(double height, double speed)
{
  if (height < LowFlight)
  {
    return speed < FastWalk ? PlatformKind::Person : PlatformKind::Car;
  }
  return height < HighFlight ? PlatformKind::Multicopter : PlatformKind::Aircraft;
}

//------------------------------------------------------------------------------
bool IsOnGround(PlatformKind kind)
{
  return kind == PlatformKind::Tripod || kind == PlatformKind::Person ||
    kind == PlatformKind::Car || kind == PlatformKind::Tractor;
}

} // namespace helios::viewer
