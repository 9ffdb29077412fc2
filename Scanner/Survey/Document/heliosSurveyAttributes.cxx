// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Attributes of the items of a survey, by their paths.
#include "heliosElementPath.h"
#include "heliosItemRules.h"
#include "heliosSurveyDocument.h"
#include "heliosXmlFilter.h"
#include "heliosXmlLeg.h"
#include "heliosXmlPlatform.h"
#include "heliosXmlSurvey.h"
#include "heliosXmlText.h"

#include <algorithm>
#include <filesystem>

namespace helios
{

namespace
{

constexpr const char* ChannelPrefix = "channel/";

bool StartsWith(const std::string& text, const std::string& start)
{
  return text.compare(0, start.size(), start) == 0;
}

std::string GetFolder(const XmlDocument& document)
{
  return std::filesystem::path(document.GetPath()).parent_path().string();
}

/// The attribute of an element that is the value of a rule; empty: not given.
std::string ReadSame(const XmlElement& element, const XmlValueRule& rule)
{
  for (const bool isAlias : { false, true })
  {
    for (const XmlValueRule& value : FindXmlRule(element.GetTag())->Values)
    {
      std::string text;
      if (value.IsAlias == isAlias && IsSame(value, rule) && element.Read(value.Name, text))
      {
        text = value.HasBlanks ? element.GetNode().attribute(value.Name).value() : text;
        return NormalizeValue(
          { value.Name, text, element.Where(), GetFolder(element.GetDocument()) }, value);
      }
    }
  }
  return {};
}

} // namespace

//------------------------------------------------------------------------------
std::vector<std::string> SurveyDocument::ListAttributes(SurveyItem item)
{
  std::vector<std::string> names;
  const auto add = [&names](const XmlElementRule& rule, const std::string& prefix)
  {
    for (const XmlValueRule& value : rule.Values)
    {
      const std::string name = prefix + value.Name;
      const bool isNew = std::find(names.begin(), names.end(), name) == names.end();
      value.Store.Owner && !value.IsAlias && isNew ? names.push_back(name) : void();
    }
  };
  const ItemRow& row = GetRow(item);
  for (const char* tag : row.Own)
  {
    add(*FindXmlRule(tag), "");
  }
  item == SurveyItem::Scanner ? add(*FindXmlRule("detectorSettings"), "") : void();
  for (const char* tag : row.Inside)
  {
    const XmlElementRule& rule = *FindXmlRule(tag);
    std::string(tag) == "channel" ? names.push_back("channel/id")
                                  : add(rule, std::string(tag) + "/");
  }
  for (const XmlElementRule& rule : GetXmlRules())
  {
    const std::string name = rule.Name;
    const bool isFilter = StartsWith(name, "filter:") && name != "filter:crs"; // which repeats
    item == SurveyItem::Part&& isFilter ? add(rule, name.substr(7) + "/") : void();
  }
  return names;
}

//------------------------------------------------------------------------------
bool SurveyDocument::Set(const SurveyPlace& place, const std::string& path, const std::string& text)
{
  this->Log.Restart(this->Owner);
  if (place.Item == SurveyItem::Scanner)
  {
    return this->SetScanner(place, path, text);
  }
  if (place.Item == SurveyItem::Platform)
  {
    return this->SetPlatform(place, path, text);
  }
  if (place.Item == SurveyItem::Scene)
  {
    return this->SetIn(this->MakeScene(), place.Item, path, text);
  }
  if (place.Item == SurveyItem::Part || place.Item == SurveyItem::PartTable)
  {
    this->AdoptScene();
  }
  const bool isName = place.Item == SurveyItem::Survey && path == "name";
  place.Item == SurveyItem::Leg ? this->FoldOrigins() : void();
  const Found found = this->Find(place);
  const bool isSet = found &&
    this->SetIn(
      found, place.Item, path, isName ? MakeFolderName(text.empty() ? "survey" : text) : text);
  if (isSet && isName && !this->IsFile)
  {
    this->Own->SetPlace(found.Element.GetNode(), this->Find(place).Where);
  }
  return isSet;
}

//------------------------------------------------------------------------------
bool SurveyDocument::SetIn(
  const Found& found, SurveyItem item, const std::string& path, const std::string& text)
{
  const std::string name = ElementPath::GetFirstName(path);
  const XmlValue value{ path, text, found.Where, GetFolder(*this->Own) };
  const XmlElementRule* rule = FindRule(item, name);
  if (!rule)
  {
    std::vector<std::string> names;
    for (const char* tag : GetRow(item).Own)
    {
      const std::vector<std::string> more = ListXmlNames(*FindXmlRule(tag));
      names.insert(names.end(), more.begin(), more.end());
    }
    return RefuseName(value, name, names, this->Log);
  }
  const pugi::xml_node node = found.Element.GetNode();
  ElementPath target(node, MakeFullPath(*rule, node, path), value);
  const bool isFound = target.Follow(!text.empty(), this->Log) && this->CheckLoader(found, name);
  const bool hasBlanks = isFound && target.GetRule() && target.GetRule()->HasBlanks;
  std::string given = hasBlanks ? text : TrimBlanks(text);
  const bool isGood =
    isFound && this->FindFiles(given, target.GetRule(), value) && target.Check(given, this->Log);
  if (!isGood)
  {
    return text.empty() && !this->Log.HasError();
  }
  const bool isId = path == "id" && given != node.attribute("id").value() &&
    (item == SurveyItem::Scanner || item == SurveyItem::Platform || item == SurveyItem::Scene) &&
    std::string(node.name()) != "channel";
  const std::vector<pugi::xml_attribute> references =
    isId ? this->FindReferences(found.Element) : std::vector<pugi::xml_attribute>();
  target.Set(isId ? this->MakeId(node.name(), given) : given, *this->Own);
  for (pugi::xml_attribute reference : references)
  {
    reference.set_value(this->Refer(found.Element).c_str());
  }
  target.GetRule() ? this->RemoveSame(found, item, *target.GetRule(), target.GetNode()) : void();
  this->Change(target.GetNode(), found.Where);
  return true;
}

//------------------------------------------------------------------------------
/// Removes what would override an attribute that was set.
void SurveyDocument::RemoveSame(
  const Found& found, SurveyItem item, const XmlValueRule& rule, pugi::xml_node kept)
{
  const std::string name = rule.Name;
  for (const char* tag : GetRow(item).Own)
  {
    pugi::xml_node node = found.Element.GetNode();
    node = kept == node || std::string(node.name()) == tag ? node : node.child(tag);
    for (const XmlValueRule& value : FindXmlRule(tag)->Values)
    {
      const bool isOther = node != kept || std::string(value.Name) != name;
      if (node && rule.Store.Owner && isOther && IsSame(value, rule))
      {
        node.remove_attribute(value.Name);
        node.remove_child(value.Name);
      }
    }
  }
  const auto remove = [&](const char* other)
  { item == SurveyItem::Scanner ? kept.remove_attribute(other) : false; };
  if (IsTolerance(name)) // the last setting counts, of fixed and adaptive sub-rays
  {
    remove(FixedSubRays);
  }
  else if (name == FixedSubRays)
  {
    remove("rangeTolerance_m");
    remove("energyTolerance");
  }
  else if (name == "filepath" && std::string(kept.name()) == "filter")
  {
    kept.remove_child(kept.find_child_by_attribute("param", "key", "efilepath"));
  }
}

//------------------------------------------------------------------------------
/// A part has one loader.
bool SurveyDocument::CheckLoader(const Found& found, const std::string& name)
{
  const std::vector<std::string> loaders = GetLoaders();
  const auto isLoader = [&loaders](const std::string& type)
  { return std::find(loaders.begin(), loaders.end(), type) != loaders.end(); };
  if (std::string(found.Element.GetNode().name()) == "part" && isLoader(name))
  {
    for (const XmlElement& filter : found.Element.GetChildren("filter"))
    {
      const std::string type = GetFilterType(filter.GetText("type"));
      if (isLoader(type) && type != name)
      {
        this->Log.Error(
          found.Where + ": its loader is " + type + ", not " + name + "; add another part");
        return false;
      }
    }
  }
  return true;
}

//------------------------------------------------------------------------------
/// Finds the files that a value names, and what a reference refers to; false after an error.
bool SurveyDocument::FindFiles(std::string& text, const XmlValueRule* rule, const XmlValue& value)
{
  if (!rule || text.empty())
  {
    return true;
  }
  const XmlValue given{ value.Name, text, value.Where };
  if (rule->File == XmlFile::Needed)
  {
    text = this->Files.FindFile(given, *this->Own);
  }
  else if (rule->File == XmlFile::Pattern)
  {
    const std::vector<std::string> files = this->Files.FindFiles(given, *this->Own);
    const std::string pattern = text.substr(text.rfind('/') + 1);
    text = files.empty() ? text
                         : (std::filesystem::path(files.front()).parent_path() / pattern).string();
  }
  else if (rule->Kind == XmlKind::Reference && text != "interpolated")
  {
    const std::string tag = rule->Name == std::string("basePlatform") ? "platform" : rule->Name;
    this->Files.FindElement(tag.c_str(), given, *this->Own);
  }
  return !this->Log.HasError();
}

//------------------------------------------------------------------------------
std::string SurveyDocument::Get(const SurveyPlace& place, const std::string& given)
{
  this->Log.Restart(this->Owner);
  const Found found = this->Find(place);
  if (!found)
  {
    return {};
  }
  std::vector<XmlElement> layers = this->ListLayers(found, place);
  std::string path = given;
  if (place.Item == SurveyItem::Scanner && StartsWith(path, ChannelPrefix))
  {
    const XmlElement channel = this->GetChannel(found.Element, std::max(0, place.Channel));
    layers = channel ? std::vector<XmlElement>{ channel } : std::vector<XmlElement>();
    path = path.substr(std::string(ChannelPrefix).size());
  }
  if (place.Item == SurveyItem::Platform && path == "type" && found.Element.GetTag() == "survey")
  {
    return "interpolated";
  }
  const std::string name = ElementPath::GetFirstName(path);
  const XmlValue value{ path, "", found.Where };
  const XmlElementRule* detector = FindXmlRule("detectorSettings");
  const XmlElementRule* rule = FindRule(place.Item, name);
  rule = !rule && place.Item == SurveyItem::Scanner && detector->FindValue(name) ? detector : rule;
  const XmlElementRule* channel = FindXmlRule("channel");
  rule = path != given && ElementPath::Knows(*channel, name) ? channel : rule;
  if (!rule)
  {
    const XmlElementRule& first = *FindXmlRule(GetRow(place.Item).Own.front());
    RefuseName(value, name, ListXmlNames(first), this->Log);
    return {};
  }
  const XmlValueRule* own = rule->FindValue(name);
  if (own && own->Use == XmlUse::Used && path.find('/') == std::string::npos)
  {
    for (const XmlElement& layer : layers)
    {
      const std::string text = ReadSame(layer, *own);
      if (!text.empty())
      {
        return text;
      }
    }
    return GetDefault(*own);
  }
  const XmlValueRule* last = nullptr;
  for (const XmlElement& layer : layers)
  {
    if (!FindXmlRule(layer.GetTag())->FindChild(name) && layer.GetTag() == "survey" &&
      place.Item != SurveyItem::Survey)
    {
      continue;
    }
    ElementPath target(layer.GetNode(), path, value);
    if (!ElementPath::Knows(*FindXmlRule(layer.GetTag()), name) || !target.Follow(false, this->Log))
    {
      continue;
    }
    last = target.GetRule();
    const std::string text = target.Get();
    if (!text.empty())
    {
      return last
        ? NormalizeValue({ path, text, found.Where, GetFolder(layer.GetDocument()) }, *last)
        : text;
    }
  }
  return last ? GetDefault(*last) : std::string();
}

//------------------------------------------------------------------------------
/// The elements that may give an attribute of an item, those that override others first.
std::vector<XmlElement> SurveyDocument::ListLayers(const Found& found, const SurveyPlace& place)
{
  std::vector<XmlElement> layers;
  const auto add = [&layers](const XmlElement& element)
  { element ? layers.push_back(element) : void(); };
  const XmlElement survey = this->MakeElement(this->GetSurvey());
  if (place.Item == SurveyItem::Scanner)
  {
    add(survey);
    add(survey.GetChild("detectorSettings"));
    add(survey.GetChild("FWFSettings"));
    const XmlElement channel = this->GetChannel(found.Element, std::max(0, place.Channel));
    channel ? add(channel.GetChild("FWFSettings")) : void();
    add(channel);
    add(found.Element.GetChild("FWFSettings"));
  }
  else if (place.Item == SurveyItem::Platform)
  {
    add(survey);
    add(this->GetBasePlatform(found.Element));
    return layers;
  }
  else if (place.Item == SurveyItem::Leg)
  {
    this->AddTemplates(found.Element.GetChild("scannerSettings"), layers);
    this->AddTemplates(found.Element.GetChild("platformSettings"), layers);
  }
  add(found.Element);
  return layers;
}

//------------------------------------------------------------------------------
/// Adds settings of a leg and the templates below them.
void SurveyDocument::AddTemplates(const XmlElement& settings, std::vector<XmlElement>& layers)
{
  XmlElement element = settings;
  for (int depth = 0; element && depth < DeepestTemplate; ++depth)
  {
    layers.push_back(element);
    element = element.Has("template")
      ? this->Files.FindElement(element.GetTag().c_str(), element, "template")
      : XmlElement();
  }
}

} // namespace helios
