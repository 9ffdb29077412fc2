// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// The scanners and platforms of a survey, and their attributes.
#include "heliosElementPath.h"
#include "heliosItemRules.h"
#include "heliosSurveyDocument.h"
#include "heliosXmlPlatform.h"
#include "heliosXmlScanner.h"
#include "heliosXmlText.h"

#include <algorithm>
#include <exception>
#include <map>

namespace helios
{

namespace
{

/// "leg 2": a place in messages.
std::string Numbered(const std::string& what, std::size_t index)
{
  return what + " " + std::to_string(index);
}

constexpr const char* ChannelPrefix = "channel/";

} // namespace

//------------------------------------------------------------------------------
int SurveyDocument::AddScanner(const std::string& id)
{
  pugi::xml_node node =
    this->Own->GetTree().child("document").insert_child_before("scanner", this->GetSurvey());
  SetAttribute(node, "id", this->MakeId("scanner", id));
  SetAttribute(node, "optics", "rotating");
  this->Own->SetPlace(node, Numbered("scanner", this->Elements.Scanners.size()));
  this->Elements.Scanners.push_back(this->MakeElement(node));
  return static_cast<int>(this->Elements.Scanners.size()) - 1;
}

//------------------------------------------------------------------------------
int SurveyDocument::AddPlatform(const std::string& id)
{
  pugi::xml_node node =
    this->Own->GetTree().child("document").insert_child_before("platform", this->GetSurvey());
  SetAttribute(node, "id", this->MakeId("platform", id));
  this->Own->SetPlace(node, Numbered("platform", this->Elements.Platforms.size()));
  this->Elements.Platforms.push_back(this->MakeElement(node));
  return static_cast<int>(this->Elements.Platforms.size()) - 1;
}

//------------------------------------------------------------------------------
int SurveyDocument::AddFromFile(SurveyItem item, const std::string& reference)
{
  const bool isScanner = item == SurveyItem::Scanner;
  const char* tag = isScanner ? "scanner" : "platform";
  std::vector<XmlElement>& all = isScanner ? this->Elements.Scanners : this->Elements.Platforms;
  this->Log.Restart(this->Owner);
  try
  {
    const std::string where = "survey " + std::string(this->GetSurvey().attribute("name").value());
    XmlElement element = this->Files.FindElement(tag, { tag, reference, where }, *this->Own);
    if (element && isScanner)
    {
      const ScannerData scanner = ReadScanner(element, this->Files);
      this->Log.HasError() ? void() : CheckScanner(scanner, this->Log);
    }
    else if (element)
    {
      ReadPlatform(element);
    }
    if (!element || this->Log.HasError())
    {
      return -1;
    }
    const bool isKnown = std::any_of(all.begin(), all.end(),
      [&element](const XmlElement& one) { return one.GetIdentity() == element.GetIdentity(); });
    all.push_back(isKnown ? this->MakeElement(this->CopyHere(element)) : element);
  }
  catch (const std::exception& error) // standard library errors: out of memory, file system
  {
    this->Log.Error(reference + ": cannot be read: " + error.what());
    return -1;
  }
  return static_cast<int>(all.size()) - 1;
}

//------------------------------------------------------------------------------
/// A channel by its number; none: the scanner has no channels.
XmlElement SurveyDocument::GetChannel(const XmlElement& scanner, int channel) const
{
  const XmlElement list = scanner.GetChild("channels");
  const std::vector<XmlElement> all =
    list ? list.GetChildren("channel") : std::vector<XmlElement>();
  const bool exists = channel >= 0 && channel < static_cast<int>(all.size());
  return exists ? all[static_cast<std::size_t>(channel)] : XmlElement();
}

//------------------------------------------------------------------------------
int SurveyDocument::GetNumberOfChannels(int scanner)
{
  this->Log.Restart(this->Owner);
  const Found found = this->Find({ SurveyItem::Scanner, scanner });
  int count = 0;
  while (found && this->GetChannel(found.Element, count))
  {
    ++count;
  }
  return found ? std::max(1, count) : 0;
}

//------------------------------------------------------------------------------
int SurveyDocument::AddChannel(int scanner)
{
  const int count = this->GetNumberOfChannels(scanner);
  if (count == 0)
  {
    return -1;
  }
  const XmlElement whole = this->AdoptItem(SurveyItem::Scanner, scanner);
  pugi::xml_node list = whole.GetNode().child("channels");
  list = list ? list : whole.GetNode().append_child("channels");
  pugi::xml_node first = list.child("channel");
  first = first ? first : list.append_child("channel");
  pugi::xml_node channel = list.append_copy(first);
  channel.remove_attribute("id");
  for (int i = 0; i <= count; ++i)
  {
    const XmlElement one = this->GetChannel(whole, i);
    this->Own->SetPlace(
      one.GetNode(), Numbered("scanner", scanner) + ", channel " + std::to_string(i));
  }
  return count;
}

//------------------------------------------------------------------------------
bool SurveyDocument::SetScanner(
  const SurveyPlace& place, const std::string& path, const std::string& text)
{
  const int count = this->GetNumberOfChannels(place.Index);
  std::string where = "scanner " + std::to_string(place.Index);
  if (count == 0)
  {
    return false;
  }
  if (place.Channel >= count)
  {
    this->Log.Error(where + ", channel " + std::to_string(place.Channel) +
      " does not exist; there are " + std::to_string(count) + ", counted from 0");
    return false;
  }
  const std::string name = ElementPath::GetFirstName(path);
  if (!FindRule(SurveyItem::Scanner, name) && FindXmlRule("detectorSettings")->FindValue(name))
  {
    return this->SetIn({ this->MakeElement(this->GetSurvey()), where }, SurveyItem::Survey,
      "detectorSettings/" + path, text);
  }
  const XmlElement scanner = this->AdoptItem(SurveyItem::Scanner, place.Index);
  this->AdoptOverrides(name);
  const bool isOfChannel = path.compare(0, std::string(ChannelPrefix).size(), ChannelPrefix) == 0;
  if (isOfChannel && !this->GetChannel(scanner, 0))
  {
    scanner.GetNode().append_child("channels").append_child("channel");
  }
  const XmlElement one =
    this->GetChannel(scanner, isOfChannel ? std::max(0, place.Channel) : place.Channel);
  if (one)
  {
    where += ", channel " + std::to_string(std::max(0, place.Channel));
    const std::string own = isOfChannel ? path.substr(std::string(ChannelPrefix).size()) : path;
    return this->SetIn({ one, where }, SurveyItem::Scanner, own, text);
  }
  return this->SetWhole({ scanner, where }, path, text);
}

//------------------------------------------------------------------------------
/// Sets an attribute of a scanner and of its channels that do not inherit it.
bool SurveyDocument::SetWhole(
  const Found& scanner, const std::string& path, const std::string& text)
{
  bool isGood = this->SetIn(scanner, SurveyItem::Scanner, path, text);
  for (int i = 0; isGood && this->GetChannel(scanner.Element, i); ++i)
  {
    const XmlElement channel = this->GetChannel(scanner.Element, i);
    const XmlValue value{ path, text, "" };
    const XmlElementRule* rule = FindRule(SurveyItem::Scanner, ElementPath::GetFirstName(path));
    ElementPath own(channel.GetNode(), MakeFullPath(*rule, channel.GetNode(), path), value);
    Messages silent(nullptr);
    const bool hasOwn = channel.Has("optics") || (own.Follow(false, silent) && !own.Get().empty());
    isGood = !hasOwn ||
      this->SetIn({ channel, scanner.Where + ", channel " + std::to_string(i) },
        SurveyItem::Scanner, path, text);
  }
  return isGood;
}

//------------------------------------------------------------------------------
/// Moves what a survey overrides of its scanners into each of them, so that one can be changed.
void SurveyDocument::AdoptOverrides(const std::string& name)
{
  const XmlElementRule* rule = FindRule(SurveyItem::Scanner, name);
  const XmlValueRule* wanted = rule ? rule->FindValue(name) : nullptr;
  pugi::xml_node survey = this->GetSurvey();
  for (pugi::xml_node node :
    { survey.child("FWFSettings"), survey.child("detectorSettings"), survey })
  {
    for (const XmlValueRule& value : FindXmlRule(node ? node.name() : "survey")->Values)
    {
      const bool isMeant = wanted &&
        (IsSame(value, *wanted) || (IsTolerance(name) && std::string(value.Name) == FixedSubRays));
      const std::string text = node.attribute(value.Name).value();
      if (isMeant && value.Store.Owner && !text.empty())
      {
        node.remove_attribute(value.Name);
        for (std::size_t i = 0; i < this->Elements.Scanners.size(); ++i)
        {
          const XmlElement scanner = this->AdoptItem(SurveyItem::Scanner, static_cast<int>(i));
          this->SetWhole({ scanner, "scanner " + std::to_string(i) }, value.Name, text);
        }
      }
    }
  }
}

//------------------------------------------------------------------------------
/// The platform below an interpolated one, made if there is none; others as they are.
XmlElement SurveyDocument::GetBasePlatform(const XmlElement& platform)
{
  if (platform.GetIdentity() != this->GetSurvey().internal_object())
  {
    return platform;
  }
  return platform.Has("basePlatform")
    ? this->Files.FindElement("platform", platform, "basePlatform")
    : XmlElement();
}

//------------------------------------------------------------------------------
/// Makes a platform follow the trajectories of its legs.
bool SurveyDocument::SetInterpolated(const SurveyPlace& place)
{
  XmlElement& platform = this->Elements.Platforms[static_cast<std::size_t>(place.Index)];
  const XmlElement survey = this->MakeElement(this->GetSurvey());
  for (std::size_t i = 0; i < this->Elements.Platforms.size(); ++i)
  {
    if (this->Elements.Platforms[i].GetIdentity() == survey.GetIdentity())
    {
      const bool isThis = static_cast<int>(i) == place.Index;
      isThis ? void()
             : this->Log.Error("platform " + std::to_string(place.Index) +
                 ": type=\"interpolated\": a survey has one such platform, which is platform " +
                 std::to_string(i) + "; use it for the leg");
      return isThis;
    }
  }
  const std::vector<pugi::xml_attribute> references = this->FindReferences(platform);
  pugi::xml_node node = survey.GetNode();
  node.remove_attribute("basePlatform");
  SetAttribute(node, "basePlatform", this->Refer(platform));
  for (pugi::xml_attribute reference : references)
  {
    reference.set_value("interpolated");
  }
  platform = survey;
  return true;
}

//------------------------------------------------------------------------------
bool SurveyDocument::SetPlatform(
  const SurveyPlace& place, const std::string& path, const std::string& text)
{
  Found found = this->Find(place);
  if (!found || (path == "type" && text == "interpolated"))
  {
    return found && this->SetInterpolated(place);
  }
  const XmlElement platform = this->AdoptItem(SurveyItem::Platform, place.Index);
  XmlElement& entry = this->Elements.Platforms[static_cast<std::size_t>(place.Index)];
  if (path == "type" && entry.GetIdentity() != platform.GetIdentity()) // no longer interpolated
  {
    const std::vector<pugi::xml_attribute> references = this->FindReferences(entry);
    this->GetSurvey().remove_attribute("basePlatform");
    entry = platform;
    for (pugi::xml_attribute reference : references)
    {
      reference.set_value(this->Refer(platform).c_str());
    }
  }
  // An element of the survey overrides that of its platforms.
  const std::string name = ElementPath::GetFirstName(path);
  const pugi::xml_node override = this->GetSurvey().child(name.c_str());
  const bool isOfPlatform = FindXmlRule("platform")->FindChild(name) != nullptr;
  for (std::size_t i = 0; override && isOfPlatform && i < this->Elements.Platforms.size(); ++i)
  {
    const XmlElement one = this->AdoptItem(SurveyItem::Platform, static_cast<int>(i));
    const bool isInterpolated = one.GetIdentity() != this->Elements.Platforms[i].GetIdentity();
    if (name != "scannerMount" || isInterpolated)
    {
      one.GetNode().remove_child(name.c_str());
      one.GetNode().append_copy(override);
    }
  }
  override&& isOfPlatform ? this->GetSurvey().remove_child(override) : false;
  return this->SetIn({ platform, found.Where }, place.Item, path, text);
}

//------------------------------------------------------------------------------
/// A scanner or platform as an element of this document, which can be changed; of an interpolated
/// platform the one below it.
XmlElement SurveyDocument::AdoptItem(SurveyItem item, int index)
{
  const bool isScanner = item == SurveyItem::Scanner;
  std::vector<XmlElement>& all = isScanner ? this->Elements.Scanners : this->Elements.Platforms;
  XmlElement& entry = all[static_cast<std::size_t>(index)];
  const bool isInterpolated = entry.GetTag() == "survey";
  XmlElement element = this->GetBasePlatform(entry);
  pugi::xml_node survey = this->GetSurvey();
  if (!element)
  {
    pugi::xml_node node =
      this->Own->GetTree().child("document").insert_child_before("platform", survey);
    SetAttribute(node, "id", this->MakeId("platform", "interpolated"));
    element = this->MakeElement(node);
    SetAttribute(survey, "basePlatform", this->Refer(element));
  }
  if (&element.GetDocument() == this->Own.get())
  {
    return element;
  }
  const std::vector<pugi::xml_attribute> references = this->FindReferences(element);
  const XmlElement copy = this->MakeElement(this->CopyHere(element));
  entry = isInterpolated ? entry : copy;
  for (pugi::xml_attribute reference : references)
  {
    reference.set_value(this->Refer(copy).c_str());
  }
  return copy;
}

//------------------------------------------------------------------------------
/// The attributes of the survey and its legs that refer to an element; to <survey>: interpolated.
std::vector<pugi::xml_attribute> SurveyDocument::FindReferences(const XmlElement& element)
{
  const bool isSurvey = element.GetTag() == "survey";
  const std::string tag = isSurvey ? "platform" : element.GetTag();
  std::map<std::string, bool> known = { { "interpolated", isSurvey } };
  std::vector<pugi::xml_attribute> found;
  const auto add = [&](pugi::xml_attribute attribute)
  {
    const std::string text = attribute.value();
    if (attribute && known.count(text) == 0)
    {
      Messages silent(nullptr);
      const XmlValue value{ tag, text, "" };
      known[text] = this->Files.FindElement(tag.c_str(), value, *this->Own).GetIdentity() ==
        element.GetIdentity();
    }
    attribute&& known[text] ? found.push_back(attribute) : void();
  };
  add(this->GetSurvey().attribute(tag.c_str()));
  isSurvey ? void() : add(this->GetSurvey().attribute(tag == "platform" ? "basePlatform" : ""));
  for (const pugi::xml_node scan : this->GetSurvey().children("scan"))
  {
    add(scan.attribute(tag.c_str()));
  }
  for (const XmlElement& leg : this->GetLegs())
  {
    add(leg.GetNode().attribute(tag.c_str()));
  }
  return found;
}

//------------------------------------------------------------------------------
/// An id that no other element of its kind has.
std::string SurveyDocument::MakeId(const char* tag, const std::string& wanted) const
{
  std::string id = wanted;
  std::replace(id.begin(), id.end(), '#', '_');
  const std::string stem = id.empty() ? tag : id;
  id = stem;
  const pugi::xml_node root = this->Own->GetTree().child("document");
  const auto isTaken = [&root, tag](const std::string& one)
  {
    const auto all = root.children(tag);
    return std::any_of(all.begin(), all.end(),
      [&one](pugi::xml_node node) { return node.attribute("id").value() == one; });
  };
  for (int i = 2; isTaken(id); ++i)
  {
    id = stem + "_" + std::to_string(i);
  }
  return id;
}

} // namespace helios
