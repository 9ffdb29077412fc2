// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosXmlMotion.h"

#include "heliosMessages.h"
#include "heliosSurveyData.h"
#include "heliosXmlRules.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

namespace helios
{

namespace
{

// Maximum distance of the shift of a glide plane from the plane, relative to its length: files
// round.
constexpr double PlaneTolerance = 1e-6;

struct KindRow
{
  const char* Name;
  MotionKind Kind;
  const char* Vector; // the required attribute; null: none
};

const std::vector<KindRow>& GetKinds()
{
  static const std::vector<KindRow> kinds = {
    { "identity", MotionKind::Identity, nullptr },
    { "translation", MotionKind::Translation, "vec" },
    { "rotation", MotionKind::Rotation, "axis" },
    { "reflection", MotionKind::Reflection, "ortho" },
    { "glideplane", MotionKind::GlidePlane, "ortho" },
    { "helical", MotionKind::Helical, "axis" },
    { "rotsym", MotionKind::RotaryReflection, "axis" },
  };
  return kinds;
}

const KindRow* FindKind(const XmlElement& element)
{
  const std::string given = element.GetText("type");
  std::vector<std::string> names;
  for (const KindRow& row : GetKinds())
  {
    if (ToLower(given) == row.Name)
    {
      return &row;
    }
    names.emplace_back(row.Name);
  }
  const std::string nearest = FindNearestName(given, names);
  element.GetMessages().Error(element.Where("type") + ": <motion> type=\"" + given +
    "\" is unknown; " + (nearest.empty() ? "" : "did you mean " + nearest + "? ") + "Types are " +
    JoinChoices(names));
  return nullptr;
}

/// Reads the required vector of a motion.
void ReadVector(const XmlElement& element, const KindRow& row, Vec3& vector)
{
  const std::string what = element.Where() + ": <motion type=\"" + row.Name + "\"> ";
  if (!element.Has(row.Vector))
  {
    element.GetMessages().Error(
      what + "has no " + row.Vector + "; give three numbers with semicolons, as in 0;0;1");
  }
  else if (element.Read(row.Vector, vector) && row.Kind != MotionKind::Translation &&
    !(vector.Norm() > 0.0))
  {
    element.GetMessages().Error(what + "has " + row.Vector + "=\"" + element.GetText(row.Vector) +
      "\", which has no direction; give one that is not 0;0;0");
  }
}

/// Reads the shift of a glide plane, which must lie in it.
void ReadShift(const XmlElement& element, Motion& motion)
{
  if (element.Read("shift", motion.Shift) &&
    std::abs(motion.Shift.Dot(motion.Vector)) >
      PlaneTolerance * motion.Shift.Norm() * motion.Vector.Norm())
  {
    element.GetMessages().Error(element.Where("shift") + ": shift=\"" + element.GetText("shift") +
      "\" is not in the plane normal to ortho=\"" + element.GetText("ortho") +
      "\"; give one perpendicular to ortho");
  }
}

bool ReadMotion(const XmlElement& element, Motion& motion)
{
  element.CheckNames();
  const KindRow* row = FindKind(element);
  if (!row)
  {
    return false;
  }
  motion.Kind = row->Kind;
  if (row->Vector)
  {
    ReadVector(element, *row, motion.Vector);
  }
  element.ReadStored(motion);
  if (motion.Kind == MotionKind::GlidePlane)
  {
    ReadShift(element, motion);
  }
  return true;
}

MotionSequence ReadSequence(const XmlElement& element)
{
  element.CheckNames();
  MotionSequence sequence;
  const std::string what = element.Where() + ": <dmotion id=\"" + element.GetText("id") + "\"> ";
  int loop = 0;
  if (!element.Has("loop"))
  {
    element.GetMessages().Error(
      what + "has no loop; give the number of steps that it lasts, 0: without end");
  }
  element.Read("loop", loop);
  sequence.Loop = loop;
  for (const XmlElement& child : element.GetChildren("motion"))
  {
    Motion motion;
    if (ReadMotion(child, motion))
    {
      sequence.Motions.push_back(motion);
    }
  }
  if (!element.GetChild("motion"))
  {
    element.GetMessages().Error(
      what + "has no <motion>; add one, <motion type=\"identity\"/> for no motion");
  }
  if (loop == 0 && !element.GetText("next").empty())
  {
    element.GetMessages().Warning(what + "never ends (loop=\"0\"), so next=\"" +
      element.GetText("next") + "\" is never reached; give a loop above 0");
  }
  return sequence;
}

/// Returns the index of each id; a duplicate is an error.
std::map<std::string, std::size_t> FindPlaces(const std::vector<XmlElement>& elements)
{
  std::map<std::string, std::size_t> places;
  for (std::size_t i = 0; i < elements.size(); ++i)
  {
    const std::string id = elements[i].GetText("id");
    if (!places.emplace(id, i).second && !id.empty())
    {
      elements[i].GetMessages().Error(elements[i].Where() + ": a second <dmotion id=\"" + id +
        "\"> in one <part>; give each an id of its own");
    }
  }
  return places;
}

/// Returns the successor of a sequence.
std::size_t FindNext(const XmlElement& element, const std::map<std::string, std::size_t>& places)
{
  const std::string next = element.GetText("next");
  const auto found = places.find(next);
  if (next.empty() || found != places.end())
  {
    return next.empty() ? MotionSequence::None : found->second;
  }
  std::vector<std::string> names;
  for (const auto& place : places)
  {
    names.push_back("\"" + place.first + "\"");
  }
  element.GetMessages().Error(element.Where("next") + ": next=\"" + next +
    "\" is not a <dmotion> of this <part>; its ids are " + JoinChoices(names));
  return MotionSequence::None;
}

/// Returns the number of steps [s] in a length [s], rounded to an integer, at least one.
int CountSteps(double length, double step)
{
  const double count = std::floor(length / step * (1.0 + 1e-12));
  return static_cast<int>(std::clamp(count, 1.0, double(std::numeric_limits<int>::max())));
}

/// Reads the step length of a part, in pulses or seconds, from part and scene.
void ReadSteps(const XmlElement& part, const XmlElement& scene, MotionData& motion)
{
  int scenePulses = 1;
  int partSteps = 1;
  double sceneTime = 0.0;
  double partTime = 0.0;
  double seenTime = 0.0;
  scene.Read("dynStep", scenePulses);
  scene.Read("dynTimeStep", sceneTime);
  part.Read("dynStep", partSteps);
  part.Read("dynTimeStep", partTime);
  part.Read("kdtDynStep", motion.Every);
  part.Read("kdtDynTimeStep", seenTime);
  if (partTime > 0.0 && sceneTime > 0.0)
  {
    motion.Seconds = CountSteps(partTime, sceneTime) * sceneTime;
  }
  else
  {
    motion.Seconds = partTime > 0.0 ? partTime : partSteps * sceneTime;
  }
  motion.Pulses = static_cast<vtkIdType>(scenePulses) * partSteps;
  if (seenTime > 0.0 && motion.Seconds > 0.0)
  {
    motion.Every = CountSteps(seenTime, motion.Seconds);
  }
  else if (seenTime > 0.0)
  {
    part.GetMessages().Warning(part.Where("kdtDynTimeStep") + ": kdtDynTimeStep=\"" +
      part.GetText("kdtDynTimeStep") +
      "\" is not used: the part steps by pulses; give it a dynTimeStep, or kdtDynStep");
  }
}

/// Reports motions of which there is no part of a step.
void CheckFractions(const XmlElement& sequence)
{
  for (const XmlElement& motion : sequence.GetChildren("motion"))
  {
    const std::string type = ToLower(motion.GetText("type"));
    if (type == "reflection" || type == "glideplane" || type == "rotsym")
    {
      motion.GetMessages().Error(motion.Where("type") + ": <motion> type=\"" + type +
        "\" mirrors the part, so there is nothing between two steps; set motion=\"steps\" of its "
        "<part>, or give a translation, rotation or helical");
    }
  }
}

/// Returns the number of the part with a name; the number of parts: none.
std::size_t FindPart(const std::vector<PartData>& parts, const std::string& name)
{
  const auto found = std::find_if(
    parts.begin(), parts.end(), [&name](const PartData& part) { return part.Name == name; });
  return static_cast<std::size_t>(found - parts.begin());
}

/// Describes the parts that carry each other from a part on, as in a on b on a; empty: no cycle.
std::string FindCycle(const std::vector<PartData>& parts, std::size_t first)
{
  std::string chain = parts[first].Name;
  std::size_t at = first;
  for (std::size_t i = 0; i < parts.size(); ++i)
  {
    const std::string& mount = parts[at].Motion.Mount;
    at = mount.empty() ? parts.size() : FindPart(parts, mount);
    if (at == parts.size())
    {
      return "";
    }
    chain += " on " + mount;
    if (at == first)
    {
      return chain;
    }
  }
  return "";
}

} // namespace

//------------------------------------------------------------------------------
void CheckMounts(const std::vector<PartData>& parts, Messages& log)
{
  for (std::size_t i = 0; i < parts.size(); ++i)
  {
    const MotionData& motion = parts[i].Motion;
    const std::string what = motion.Where + ": mount=\"" + motion.Mount + "\" ";
    if (motion.Mount.empty())
    {
      continue;
    }
    if (FindPart(parts, motion.Mount) == parts.size())
    {
      log.Error(what + "is no part of the scene; give the id of one");
    }
    else if (const std::string cycle = FindCycle(parts, i); !cycle.empty())
    {
      log.Error(what + "carries itself: " + cycle + "; remove the mount of one of them");
      return; // one error for all of the cycle
    }
  }
}

//------------------------------------------------------------------------------
MotionData ReadMotion(const XmlElement& part, const XmlElement& scene)
{
  MotionData motion;
  const std::vector<XmlElement> elements = part.GetChildren("dmotion");
  const std::map<std::string, std::size_t> places = FindPlaces(elements);
  for (const XmlElement& element : elements)
  {
    motion.Sequences.push_back(ReadSequence(element));
    motion.Sequences.back().Next = FindNext(element, places);
  }
  ReadSteps(part, scene, motion);
  scene ? scene.ReadStored(motion) : void();
  part.ReadStored(motion);
  for (std::size_t i = 0; motion.IsContinuous && i < elements.size(); ++i)
  {
    CheckFractions(elements[i]);
  }
  if (!elements.empty() && !part.GetMessages().HasError() && !motion.HasOwn())
  {
    part.GetMessages().Warning(elements.front().Where() +
      ": the <dmotion> of this <part> never move it; give other motions than identity, or "
      "remove them");
  }
  return motion;
}

} // namespace helios
