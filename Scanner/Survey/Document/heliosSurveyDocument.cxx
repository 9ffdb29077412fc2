// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosSurveyDocument.h"

#include "heliosElementPath.h"
#include "heliosPartTable.h"
#include "heliosRowTable.h"
#include "heliosXmlFilter.h"
#include "heliosXmlPart.h"
#include "heliosXmlPlatform.h"
#include "heliosXmlScanner.h"
#include "heliosXmlText.h"

#include <vtkObject.h>

#include <algorithm>
#include <exception>

namespace helios
{

namespace
{

std::string Numbered(const std::string& what, std::size_t index)
{
  return what + " " + std::to_string(index);
}

/// Numbers the places of items that have one, such as "leg 3", anew.
void Number(const std::vector<XmlElement>& all, const std::string& what, XmlDocument& document)
{
  const auto number = [&](pugi::xml_node node, std::size_t index)
  {
    const std::string* place = document.GetPlace(node);
    if (place && place->compare(0, what.size() + 1, what + " ") == 0)
    {
      const std::size_t end = place->find_first_not_of("0123456789", what.size() + 1);
      const std::string rest = end == std::string::npos ? "" : place->substr(end);
      document.SetPlace(node, Numbered(what, index) + rest);
    }
  };
  for (std::size_t i = 0; i < all.size(); ++i)
  {
    number(all[i].GetNode(), i);
    for (const pugi::xml_node child : all[i].GetNode().children())
    {
      number(child, i);
    }
  }
}

} // namespace

//------------------------------------------------------------------------------
SurveyDocument::SurveyDocument(vtkObject* owner)
  : Owner(owner)
  , Log(nullptr)
  , Files(this->Log, {})
  , Own(XmlDocument::Make("survey", "<document><survey name=\"survey\"/></document>", this->Log))
{
  this->SetNeeds(AssetNeed::Optional, AssetNeed::Optional);
  this->Own->SetPlace(this->GetSurvey(), "survey survey");
}

//------------------------------------------------------------------------------
bool SurveyDocument::Load(const std::string& fileName)
{
  this->Log.Restart(this->Owner);
  std::shared_ptr<XmlDocument> document = XmlDocument::Load(fileName, this->Log);
  if (document)
  {
    this->IsFile = true;
    this->Own = document;
    this->Files.Add(document);
    this->Elements = SurveyElements();
    this->AreLegsListed = false;
  }
  this->IsBadFile = this->Log.HasError();
  return document != nullptr;
}

//------------------------------------------------------------------------------
void SurveyDocument::SetNeeds(AssetNeed scene, AssetNeed trajectories)
{
  this->Files.Scene = scene;
  this->Files.Trajectories = trajectories;
}

//------------------------------------------------------------------------------
void SurveyDocument::SetAssetDirectories(const std::vector<std::string>& directories)
{
  this->Files.SetDirectories(directories);
}

//------------------------------------------------------------------------------
const std::vector<std::string>& SurveyDocument::GetAssetDirectories() const
{
  return this->Files.GetDirectories();
}

//------------------------------------------------------------------------------
pugi::xml_node SurveyDocument::GetSurvey() const
{
  return this->Own->GetTree().child("document").child("survey");
}

//------------------------------------------------------------------------------
SurveyData SurveyDocument::Resolve(vtkObject* owner)
{
  this->Log.Restart(owner);
  Number(this->GetLegs(), "leg", *this->Own);
  Number(this->ListOwn("part"), "part", *this->Own);
  Number(this->ListOwn("partTable"), "part table", *this->Own);
  SurveyData data = ReadSurvey(this->Own.get(), this->Files, this->Log, &this->Elements);
  data.FileName = this->IsFile ? data.FileName : std::string();
  this->IsBad = this->IsBadFile || this->Log.HasError();
  return data;
}

//------------------------------------------------------------------------------
/// The parts or tables of the scene of this document.
std::vector<XmlElement> SurveyDocument::ListOwn(const char* tag) const
{
  const XmlElement& scene = this->Elements.Scene;
  return scene && &scene.GetDocument() == this->Own.get() ? scene.GetChildren(tag)
                                                          : std::vector<XmlElement>();
}

//------------------------------------------------------------------------------
const std::vector<XmlElement>& SurveyDocument::GetLegs()
{
  if (this->AreLegsListed)
  {
    return this->Legs;
  }
  this->Legs.clear();
  for (const pugi::xml_node child : this->GetSurvey().children())
  {
    const std::string tag = child.name();
    if (tag == "leg")
    {
      this->Legs.push_back(this->MakeElement(child));
    }
    for (const pugi::xml_node leg : child.children(tag == "scan" ? "leg" : ""))
    {
      this->Legs.push_back(this->MakeElement(leg));
    }
  }
  this->AreLegsListed = true;
  return this->Legs;
}

//------------------------------------------------------------------------------
int SurveyDocument::GetNumberOfLegs()
{
  return static_cast<int>(this->GetLegs().size());
}

//------------------------------------------------------------------------------
int SurveyDocument::GetNumberOf(SurveyItem item) const
{
  const bool isScanner = item == SurveyItem::Scanner;
  return static_cast<int>((isScanner ? this->Elements.Scanners : this->Elements.Platforms).size());
}

//------------------------------------------------------------------------------
/// One of several; none after an error if it does not exist.
SurveyDocument::Found SurveyDocument::FindIn(
  const std::vector<XmlElement>& all, int index, const std::string& what)
{
  const std::string where = what + " " + std::to_string(index);
  if (index >= 0 && index < static_cast<int>(all.size()))
  {
    return { all[static_cast<std::size_t>(index)], where };
  }
  this->Log.Error(
    where + " does not exist; there are " + std::to_string(all.size()) + ", counted from 0");
  return {};
}

//------------------------------------------------------------------------------
/// The element of an item, which may be in another document; of a channel, that of its scanner.
SurveyDocument::Found SurveyDocument::Find(const SurveyPlace& place)
{
  const XmlElement survey = this->MakeElement(this->GetSurvey());
  switch (place.Item)
  {
    case SurveyItem::Survey:
      return { survey, "survey " + survey.GetText("name") };
    case SurveyItem::Scene:
      return { this->Elements.Scene, "scene" };
    case SurveyItem::Part:
      return this->FindIn(this->Elements.Parts, place.Index, "part");
    case SurveyItem::PartTable:
      return this->FindIn(this->Elements.Scene ? this->Elements.Scene.GetChildren("partTable")
                                               : std::vector<XmlElement>(),
        place.Index, "part table");
    case SurveyItem::Scanner:
      return this->FindIn(this->Elements.Scanners, place.Index, "scanner");
    case SurveyItem::Platform:
      return this->FindIn(this->Elements.Platforms, place.Index, "platform");
    case SurveyItem::Leg:
      break;
  }
  return this->FindIn(this->GetLegs(), place.Index, "leg");
}

//------------------------------------------------------------------------------
/// A place in messages for an element that is made or changed.
void SurveyDocument::Change(pugi::xml_node node, const std::string& where)
{
  const std::string tag = node.name();
  const bool isItem = tag == "leg" || tag == "platformSettings" || tag == "scannerSettings" ||
    tag == "FWFSettings" || tag == "scanner" || tag == "channel" || tag == "platform" ||
    tag == "part" || tag == "partTable" || tag == "scene" || tag == "survey";
  pugi::xml_node from = node;
  for (const char* item :
    { "leg", "channel", "scanner", "platform", "part", "partTable", "survey" })
  {
    for (pugi::xml_node above = node; above && from == node; above = above.parent())
    {
      from = above.name() == std::string(item) ? above : from;
    }
  }
  this->Own->SetPlace(node, isItem ? where : where + ", " + MakePath(node, from));
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

//------------------------------------------------------------------------------
int SurveyDocument::AddScanner(const std::string& id)
{
  pugi::xml_node node =
    this->Own->GetTree().child("document").insert_child_before("scanner", this->GetSurvey());
  SetAttribute(node, "id", this->MakeId("scanner", id));
  SetAttribute(node, "name", id);
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
  SetAttribute(node, "name", id);
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
  const XmlElement whole = this->TakeOver(SurveyItem::Scanner, scanner);
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
int SurveyDocument::AddLeg(int scanner, int platform)
{
  this->Log.Restart(this->Owner);
  const Found scans = this->Find({ SurveyItem::Scanner, scanner });
  const Found carries = scans ? this->Find({ SurveyItem::Platform, platform }) : Found();
  if (!carries)
  {
    return -1;
  }
  this->FoldOrigins();
  this->GetLegs();
  pugi::xml_node survey = this->GetSurvey();
  pugi::xml_node leg = survey.append_child("leg");
  for (const auto& [name, element] :
    { std::pair("scanner", scans.Element), std::pair("platform", carries.Element) })
  {
    const std::string reference = this->Refer(element);
    const bool isFirst = this->Legs.empty() && !survey.attribute(name);
    if (isFirst)
    {
      SetAttribute(survey, name, reference);
    }
    else if (survey.attribute(name).value() != reference)
    {
      SetAttribute(leg, name, reference);
    }
  }
  this->Own->SetPlace(leg, Numbered("leg", this->Legs.size()));
  this->Legs.push_back(this->MakeElement(leg));
  return static_cast<int>(this->Legs.size()) - 1;
}

//------------------------------------------------------------------------------
void SurveyDocument::RemoveLeg(int leg)
{
  if (leg >= 0 && leg < this->GetNumberOfLegs())
  {
    this->FoldOrigins();
    pugi::xml_node node = this->GetLegs()[static_cast<std::size_t>(leg)].GetNode();
    this->Own->ForgetPlaces(node);
    node.parent().remove_child(node);
    this->Legs.erase(this->Legs.begin() + leg);
  }
}

//------------------------------------------------------------------------------
void SurveyDocument::RemoveAllLegs()
{
  for (const XmlElement& leg : this->GetLegs())
  {
    this->Own->ForgetPlaces(leg.GetNode());
    leg.GetNode().parent().remove_child(leg.GetNode());
  }
  this->Legs.clear();
}

//------------------------------------------------------------------------------
bool SurveyDocument::MoveLeg(int leg, int to)
{
  this->Log.Restart(this->Owner);
  const Found moved = this->Find({ SurveyItem::Leg, leg });
  const Found there = moved ? this->Find({ SurveyItem::Leg, to }) : Found();
  if (!there)
  {
    return false;
  }
  this->FoldOrigins();
  pugi::xml_node parent = there.Element.GetNode().parent();
  leg < to ? parent.insert_move_after(moved.Element.GetNode(), there.Element.GetNode())
           : parent.insert_move_before(moved.Element.GetNode(), there.Element.GetNode());
  this->AreLegsListed = false;
  return true;
}

//------------------------------------------------------------------------------
/// The scene of this document, made if there is none.
SurveyDocument::Found SurveyDocument::MakeScene()
{
  this->TakeOverScene();
  if (!this->Elements.Scene)
  {
    pugi::xml_node node =
      this->Own->GetTree().child("document").insert_child_before("scene", this->GetSurvey());
    SetAttribute(node, "id", this->MakeId("scene", "scene"));
    this->Own->SetPlace(node, "scene");
    this->Elements.Scene = this->MakeElement(node);
    SetAttribute(this->GetSurvey(), "scene", this->Refer(this->Elements.Scene));
    this->Files.Scene =
      this->Files.Scene == AssetNeed::Replaced ? AssetNeed::Optional : this->Files.Scene;
  }
  return { this->Elements.Scene, "scene" };
}

//------------------------------------------------------------------------------
int SurveyDocument::AddPart(const std::string& loader, const std::string& file)
{
  this->Log.Restart(this->Owner);
  const std::string where = Numbered("part", this->Elements.Parts.size());
  XmlValueRule rule;
  std::string loaders;
  for (const std::string& each : GetLoaders())
  {
    loaders += (loaders.empty() ? "" : " ") + each;
  }
  rule.Choices = loaders.c_str();
  int type = 0;
  const std::string path = ParseChoice({ "filter", loader, where }, rule, this->Log, type)
    ? this->Files.FindFile({ "filepath", file, where }, *this->Own)
    : std::string();
  if (this->Log.HasError())
  {
    return -1;
  }
  pugi::xml_node part = this->MakeScene().Element.GetNode().append_child("part");
  pugi::xml_node filter = part.append_child("filter");
  SetAttribute(filter, "type", loader);
  pugi::xml_node parameter = filter.append_child("param");
  SetAttribute(parameter, "key", "filepath");
  SetAttribute(parameter, "value", path);
  this->Own->SetPlace(part, where);
  this->Elements.Parts.push_back(this->MakeElement(part));
  return static_cast<int>(this->Elements.Parts.size()) - 1;
}

//------------------------------------------------------------------------------
bool SurveyDocument::RemovePart(int part)
{
  this->Log.Restart(this->Owner);
  this->TakeOverScene();
  const Found found = this->Find({ SurveyItem::Part, part });
  if (found)
  {
    this->Own->ForgetPlaces(found.Element.GetNode());
    this->Elements.Scene.GetNode().remove_child(found.Element.GetNode());
    this->Elements.Parts.erase(this->Elements.Parts.begin() + part);
  }
  return static_cast<bool>(found);
}

//------------------------------------------------------------------------------
void SurveyDocument::RemoveAllParts()
{
  this->TakeOverScene();
  for (const char* tag : { "part", "partTable" })
  {
    for (const XmlElement& element : this->ListOwn(tag))
    {
      this->Own->ForgetPlaces(element.GetNode());
      this->Elements.Scene.GetNode().remove_child(element.GetNode());
    }
  }
  this->Elements.Parts.clear();
}

//------------------------------------------------------------------------------
int SurveyDocument::AddPartTable(const std::string& file)
{
  this->Log.Restart(this->Owner);
  const std::string path =
    file.empty() ? file : this->Files.FindFile({ "file", file, "part table" }, *this->Own);
  if (this->Log.HasError())
  {
    return -1;
  }
  const std::size_t index = this->ListOwn("partTable").size();
  pugi::xml_node table = this->MakeScene().Element.GetNode().append_child("partTable");
  SetAttribute(table, "file", path);
  this->Own->SetPlace(table, Numbered("part table", index));
  return static_cast<int>(this->ListOwn("partTable").size()) - 1;
}

//------------------------------------------------------------------------------
bool SurveyDocument::SetPartTableRows(int table, const std::string& text)
{
  this->Log.Restart(this->Owner);
  this->TakeOverScene();
  const Found found = this->Find({ SurveyItem::PartTable, table });
  std::vector<TableRow> rows;
  RowTable reader("row", this->Log);
  reader.AddRequired("x", "the place of the part [m]");
  reader.AddRequired("y", "the place of the part [m]");
  reader.SetSkipsUnknown(true);
  const auto addRow = [&rows](const std::string& where) -> void*
  {
    rows.emplace_back().Where = where;
    return &rows.back();
  };
  if (!found || !reader.ReadText(found.Where + ", rows", text, addRow))
  {
    return false;
  }
  pugi::xml_node node = found.Element.GetNode();
  for (const XmlElement& row : found.Element.GetChildren("row"))
  {
    this->Own->ForgetPlaces(row.GetNode());
    node.remove_child(row.GetNode());
  }
  for (const TableRow& row : rows)
  {
    pugi::xml_node element = node.append_child("row");
    SetStored(element, row);
    this->Own->SetPlace(element, row.Where);
  }
  return true;
}

//------------------------------------------------------------------------------
bool SurveyDocument::RotatePart(int part, const std::string& axis, double angle)
{
  this->Log.Restart(this->Owner);
  this->TakeOverScene();
  const Found found = this->Find({ SurveyItem::Part, part });
  const XmlElementRule* rule = FindXmlRule("rot");
  const XmlValue turn{ "angle_deg", ToXmlText(angle), found.Where };
  const bool isGood = found && CheckValue(turn, *rule->FindValue("angle_deg"), this->Log) &&
    CheckValue({ "axis", axis, found.Where }, *rule->FindValue("axis"), this->Log);
  if (isGood)
  {
    pugi::xml_node filter = found.Element.GetNode().append_child("filter");
    SetAttribute(filter, "type", "rotate");
    pugi::xml_node parameter = filter.append_child("param");
    SetAttribute(parameter, "key", "rotation");
    pugi::xml_node rot = parameter.append_child("rot");
    SetAttribute(rot, "axis", axis);
    SetAttribute(rot, "angle_deg", turn.Text);
  }
  return isGood;
}

} // namespace helios
