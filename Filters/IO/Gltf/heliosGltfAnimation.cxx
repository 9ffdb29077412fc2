// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosGltfAnimation.h"

#include "heliosGltfAccessor.h"
#include "heliosGltfDocument.h"
#include "heliosTextFile.h"

#include <json/json.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace helios
{

namespace
{

/// Returns the rotation a fraction of the way from one to another, by the shorter way.
std::vector<double> Turn(const double* from, const double* to, double fraction)
{
  double cosine = 0.0;
  for (int i = 0; i < 4; ++i)
  {
    cosine += from[i] * to[i];
  }
  const double sign = cosine < 0.0 ? -1.0 : 1.0;
  const double angle = std::acos(std::min(1.0, std::abs(cosine)));
  const double sine = std::sin(angle);
  const bool isNear = sine < 1e-9;
  const double a = isNear ? 1.0 - fraction : std::sin((1.0 - fraction) * angle) / sine;
  const double b = sign * (isNear ? fraction : std::sin(fraction * angle) / sine);
  std::vector<double> q(4);
  for (std::size_t i = 0; i < 4; ++i)
  {
    q[i] = a * from[i] + b * to[i];
  }
  return q;
}

/// Returns the value of the cubic spline between two keys, a time apart: each has a tangent before it,
/// its value and one after it.
std::vector<double> Spline(const double* keys, std::size_t size, double t, double apart)
{
  const double* from = keys + size;
  const double* after = keys + 2 * size;
  const double* before = keys + 3 * size;
  const double* to = keys + 4 * size;
  const double t2 = t * t;
  const double t3 = t2 * t;
  std::vector<double> value(size);
  for (std::size_t i = 0; i < size; ++i)
  {
    value[i] = (2.0 * t3 - 3.0 * t2 + 1.0) * from[i] + apart * (t3 - 2.0 * t2 + t) * after[i] +
      (3.0 * t2 - 2.0 * t3) * to[i] + apart * (t3 - t2) * before[i];
  }
  return value;
}

} // namespace

//------------------------------------------------------------------------------
Status GltfAnimation::FindNumber(
  const GltfDocument& document, const std::string& name, std::int64_t& number)
{
  const std::int64_t count = document.GetCount("animations");
  std::string names;
  for (number = 0; number < count; ++number)
  {
    const std::string each = GetText(document.GetElement("animations", number), "name");
    if (name.empty() || each == name)
    {
      return {};
    }
    names +=
      (number > 0 ? ", " : "") + std::to_string(number) + (each.empty() ? "" : " " + Quote(each));
  }
  for (number = 0; number < count; ++number)
  {
    if (std::to_string(number) == name)
    {
      return {};
    }
  }
  return count == 0
    ? document.Fail("animations", "the file has no animation; give one that has, or numbered files")
    : document.Fail("animations", "no animation " + Quote(name) + "; the file has " + names);
}

//------------------------------------------------------------------------------
Status GltfAnimation::Read(GltfDocument& document, const std::string& name)
{
  *this = GltfAnimation();
  std::int64_t number = 0;
  const Status status = FindNumber(document, name, number);
  if (!status.IsOk())
  {
    return status;
  }
  const Json::Value& channels = GetMember(document.GetElement("animations", number), "channels");
  for (Json::ArrayIndex i = 0; channels.isArray() && i < channels.size(); ++i)
  {
    const Status read = this->ReadChannel(document, number, i);
    if (!read.IsOk())
    {
      return read;
    }
  }
  return this->Channels.empty() ? document.Fail(ElementPath("animations", number) + ".channels",
                                    "none of them moves a node; give another animation")
                                : Status();
}

//------------------------------------------------------------------------------
/// Reads a channel; one of a property that is not of a node's pose is skipped.
Status GltfAnimation::ReadChannel(GltfDocument& document, std::int64_t animation, unsigned index)
{
  const std::string list = ElementPath("animations", animation);
  const std::string where = ElementPath((list + ".channels").c_str(), index);
  const Json::Value& given = document.GetElement("animations", animation);
  const Json::Value& value = GetMember(given, "channels")[index];
  const Json::Value& target = GetMember(value, "target");
  const std::string path = GetText(target, "path");
  Channel channel;
  channel.Target = path == "translation" ? &GltfNodePose::Translation
    : path == "rotation"                 ? &GltfNodePose::Rotation
    : path == "scale"                    ? &GltfNodePose::Scale
    : path == "weights"                  ? &GltfNodePose::Weights
                                         : nullptr;
  if (!channel.Target || GetMember(target, "node").isNull())
  {
    return {};
  }
  Status status =
    document.FindIndex("nodes", GetMember(target, "node"), where + ".target.node", channel.Node);
  if (!status.IsOk())
  {
    return status;
  }
  if (path != "weights" &&
    !GetMember(document.GetElement("nodes", channel.Node), "matrix").isNull())
  {
    return document.Fail(where + ".target",
      "moves " + ElementPath("nodes", channel.Node) +
        ", which has a matrix; give it translation, rotation and scale in its place");
  }
  channel.Size = path == "rotation" ? 4 : path == "weights" ? 0 : 3;
  const Json::Value& samplers = GetMember(given, "samplers");
  const std::int64_t sampler = ReadIndex(GetMember(value, "sampler"),
    samplers.isArray() ? static_cast<std::int64_t>(samplers.size()) : 0);
  if (sampler < 0)
  {
    return document.Fail(where + ".sampler",
      "is " + Describe(GetMember(value, "sampler")) + ", which is no index of " + list +
        ".samplers; correct it");
  }
  status = ReadSampler(document, samplers[static_cast<Json::ArrayIndex>(sampler)],
    ElementPath((list + ".samplers").c_str(), sampler), channel);
  if (status.IsOk())
  {
    this->Duration = std::max(this->Duration, channel.Times.back());
    this->Channels.push_back(std::move(channel));
  }
  return status;
}

//------------------------------------------------------------------------------
Status GltfAnimation::ReadSampler(
  GltfDocument& document, const Json::Value& sampler, const std::string& where, Channel& channel)
{
  const std::string kind = GetText(sampler, "interpolation");
  if (!kind.empty() && kind != "LINEAR" && kind != "STEP" && kind != "CUBICSPLINE")
  {
    return document.Fail(where + ".interpolation",
      "is " + Quote(kind) + ", not LINEAR, STEP or CUBICSPLINE; correct it");
  }
  channel.Interpolation = kind == "STEP" ? Kind::Step
    : kind == "CUBICSPLINE"              ? Kind::Cubic
                                         : Kind::Linear;
  GltfNumbers times, values;
  const char* type = channel.Size == 4 ? "VEC4" : channel.Size == 3 ? "VEC3" : "SCALAR";
  Status status =
    ReadAccessor(document, GetMember(sampler, "input"), where + ".input", "SCALAR", times);
  status = status.IsOk()
    ? ReadAccessor(document, GetMember(sampler, "output"), where + ".output", type, values)
    : status;
  if (!status.IsOk())
  {
    return status;
  }
  channel.Times = times.Values;
  channel.Values = values.Values;
  const auto isBad = [](double a, double b) { return !(a < b); };
  const auto& t = channel.Times;
  if (t.empty() || !std::isfinite(t.back()) || t.front() < 0.0 ||
    std::adjacent_find(t.begin(), t.end(), isBad) != t.end())
  {
    return document.Fail(
      where + ".input", "has times that do not ascend from 0 or above; write the animation again");
  }
  const std::size_t parts = (channel.Interpolation == Kind::Cubic ? 3 : 1) * t.size();
  channel.Size = channel.Size == 0 ? channel.Values.size() / parts : channel.Size;
  const bool isFinite = std::all_of(
    channel.Values.begin(), channel.Values.end(), [](double x) { return std::isfinite(x); });
  return channel.Values.size() == parts * channel.Size && channel.Size > 0 && isFinite
    ? Status()
    : document.Fail(where + ".output",
        "has " + std::to_string(channel.Values.size()) + " numbers for " +
          std::to_string(t.size()) +
          " times, or some that are not finite; write the animation again");
}

//------------------------------------------------------------------------------
std::vector<double> GltfAnimation::Interpolate(const Channel& channel, double time)
{
  const std::size_t size = channel.Size;
  const bool isCubic = channel.Interpolation == Kind::Cubic;
  const auto after = std::upper_bound(channel.Times.begin(), channel.Times.end(), time);
  const auto next = static_cast<std::size_t>(after - channel.Times.begin());
  const std::size_t key = next > 0 ? next - 1 : 0;
  const double* value = channel.Values.data() + (isCubic ? 3 * key + 1 : key) * size;
  if (next == 0 || next == channel.Times.size() || channel.Interpolation == Kind::Step)
  {
    return { value, value + size };
  }
  const double apart = channel.Times[next] - channel.Times[key];
  const double t = (time - channel.Times[key]) / apart;
  if (isCubic)
  {
    return Spline(value - size, size, t, apart);
  }
  if (channel.Target == &GltfNodePose::Rotation)
  {
    return Turn(value, value + size, t);
  }
  std::vector<double> between(size);
  for (std::size_t i = 0; i < size; ++i)
  {
    between[i] = (1.0 - t) * value[i] + t * value[size + i];
  }
  return between;
}

//------------------------------------------------------------------------------
void GltfAnimation::SetTime(double time)
{
  for (const Channel& channel : this->Channels)
  {
    this->Poses[channel.Node].*channel.Target = Interpolate(channel, time);
  }
}

} // namespace helios
