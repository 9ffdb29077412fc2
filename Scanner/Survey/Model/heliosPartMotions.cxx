// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosPartMotions.h"

#include "heliosMessages.h"

#include <filesystem>
#include <map>

namespace helios
{

namespace
{

/// Describes the motion that a part has by itself.
std::string DescribeOwn(const MotionData& motion)
{
  if (motion.IsContinuous)
  {
    return "continuous";
  }
  MessageBuilder text;
  text << "in steps of ";
  motion.Seconds > 0.0 ? text << motion.Seconds << " s"
                       : text << motion.Pulses << (motion.Pulses == 1 ? " pulse" : " pulses");
  return text.str();
}

} // namespace

//------------------------------------------------------------------------------
std::set<std::size_t> FindMoving(const std::vector<PartData>& parts)
{
  std::map<std::string, std::size_t> names;
  for (std::size_t i = 0; i < parts.size(); ++i)
  {
    names.emplace(parts[i].Name, i);
  }
  std::set<std::size_t> moving;
  for (std::size_t i = 0; i < parts.size(); ++i)
  {
    std::size_t at = i; // mounts have no cycles
    while (!parts[at].Motion.HasOwn() && parts[at].Motion.Track.File.empty() &&
      !parts[at].Motion.Mount.empty() && names.count(parts[at].Motion.Mount) > 0)
    {
      at = names.at(parts[at].Motion.Mount);
    }
    if (parts[i].Frames.IsGiven() || parts[at].Motion.HasOwn() ||
      !parts[at].Motion.Track.File.empty())
    {
      moving.insert(i);
    }
  }
  return moving;
}

//------------------------------------------------------------------------------
std::string DescribeMotion(const MotionData& motion, bool doesDeform)
{
  std::string text = motion.HasOwn() || doesDeform ? DescribeOwn(motion) : std::string();
  const auto add = [&text](const std::string& more) { text += (text.empty() ? "" : ", ") + more; };
  if (doesDeform)
  {
    add("deforms");
  }
  if (!motion.Track.File.empty())
  {
    add("along " + std::filesystem::path(motion.Track.File).filename().string());
  }
  if (!motion.Mount.empty())
  {
    add("on " + motion.Mount);
  }
  return text;
}

} // namespace helios
