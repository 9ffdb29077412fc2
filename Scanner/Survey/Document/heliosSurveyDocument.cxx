// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosSurveyDocument.h"

#include "heliosElementPath.h"
#include "heliosXmlFilter.h"
#include "heliosXmlScene.h"
#include "heliosXmlText.h"

#include <algorithm>
#include <iterator>
#include <utility>

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
SurveyDocument::SurveyDocument(vtkObject* owner, const std::string& path)
  : Owner(owner)
  , Log(nullptr)
  , Files(this->Log, {})
  , Own(XmlDocument::Make(path, "<document><survey name=\"survey\"/></document>", this->Log))
{
  this->SetNeeds(AssetNeed::Optional, AssetNeed::Optional);
  this->Own->SetPlace(this->GetSurvey(), "survey survey");
}

//------------------------------------------------------------------------------
bool SurveyDocument::Load(const std::string& fileName)
{
  this->Log.Restart(this->Owner);
  return this->Use(XmlDocument::Load(fileName, this->Log));
}

//------------------------------------------------------------------------------
bool SurveyDocument::Load(const std::string& fileName, const std::string& text)
{
  this->Log.Restart(this->Owner);
  return this->Use(XmlDocument::Make(fileName, text, this->Log));
}

//------------------------------------------------------------------------------
bool SurveyDocument::Use(const std::shared_ptr<XmlDocument>& document)
{
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
  if (!this->IsFile)
  {
    data.FileName.clear();
    data.Scene.SpectraFolders = FindSpectraFolders(*this->Own, this->Files); // also for an input
  }
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
  this->HasOrigins = false;
  for (const pugi::xml_node child : this->GetSurvey().children())
  {
    const std::string tag = child.name();
    this->HasOrigins = this->HasOrigins || tag == "origin";
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
  const auto& all = item == SurveyItem::Scanner ? this->Elements.Scanners
    : item == SurveyItem::Platform              ? this->Elements.Platforms
                                                : this->Elements.Parts;
  return static_cast<int>(all.size());
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
/// Adds an element with an id before the survey.
pugi::xml_node SurveyDocument::AddBefore(
  const char* tag, const std::string& id, const std::string& where)
{
  const pugi::xml_node survey = this->GetSurvey();
  pugi::xml_node node = survey.parent().insert_child_before(tag, survey);
  SetAttribute(node, "id", id);
  this->Own->SetPlace(node, where);
  return node;
}

//------------------------------------------------------------------------------
void SurveyDocument::SetSources(
  const std::string& scene, const std::string& platform, const std::string& scanner)
{
  const std::string mesh = MakeMeshDocument(scene, "scene");
  this->SetSceneText(mesh);
  const std::string used = mesh.empty() ? scene : this->Elements.Scene.GetText("id");
  pugi::xml_node survey = this->GetSurvey();
  for (const auto& [name, reference] :
    { std::pair("scene", used), std::pair("platform", platform), std::pair("scanner", scanner) })
  {
    reference.empty() ? false : survey.remove_attribute(name);
    SetAttribute(survey, name, reference);
  }
}

//------------------------------------------------------------------------------
void SurveyDocument::AddTemplate(const std::string& id, const LegSettings& settings)
{
  for (const char* tag : { "platformSettings", "scannerSettings" })
  {
    pugi::xml_node node = this->AddBefore(tag, id, std::string(tag) + " " + id);
    SetStored(node, settings);
    node.first_attribute().next_attribute() ? false : node.parent().remove_child(node);
  }
}

//------------------------------------------------------------------------------
void SurveyDocument::AddLeg(const LegSettings& settings, const std::string& base)
{
  const pugi::xml_node root = this->GetSurvey().parent();
  const std::string where = Numbered("leg", this->GetLegs().size());
  pugi::xml_node leg = this->GetSurvey().append_child("leg");
  SetAttribute(leg, "stripId", settings.Leg.Strip);
  for (const char* tag : { "platformSettings", "scannerSettings" })
  {
    pugi::xml_node node = leg.append_child(tag);
    const bool hasBase = root.find_child_by_attribute(tag, "id", base.c_str());
    SetAttribute(node, "template", hasBase ? base : std::string());
    SetStored(node, settings);
  }
  this->Own->SetPlace(leg, where);
  this->Legs.push_back(this->MakeElement(leg));
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
  while (this->GetSurvey().remove_child("scan") || this->GetSurvey().remove_child("origin"))
  {
  }
  this->HasOrigins = false;
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
/// Adds the origins of the Java program to the positions of their legs.
void SurveyDocument::FoldOrigins()
{
  pugi::xml_node survey = this->GetSurvey();
  this->GetLegs();
  if (!std::exchange(this->HasOrigins, false))
  {
    return;
  }
  Vec3 offset(0.0, 0.0, 0.0);
  int leg = 0;
  std::vector<std::pair<int, Vec3>> moved;
  for (const pugi::xml_node child : survey.children())
  {
    const std::string tag = child.name();
    if (tag == "origin")
    {
      offset = Vec3(0.0, 0.0, 0.0);
      this->MakeElement(child).ReadVector(offset);
    }
    const auto legs = child.children("leg");
    const int count =
      tag == "scan" ? static_cast<int>(std::distance(legs.begin(), legs.end())) : tag == "leg";
    for (int i = 0; i < count; ++i)
    {
      moved.emplace_back(leg++, offset);
    }
  }
  while (survey.remove_child("origin"))
  {
  }
  for (const auto& [index, by] : moved)
  {
    const char* const names[] = { "x", "y", "z" };
    for (int k = 0; k < 3; ++k)
    {
      const SurveyPlace place{ SurveyItem::Leg, index };
      double number = 0.0;
      const XmlValueRule* rule = FindXmlRule("platformSettings")->FindValue(names[k]);
      ParseReal({ names[k], this->Get(place, names[k]), "" }, *rule, this->Log, number);
      by[k] != 0.0
        ? void(this->SetIn(this->Find(place), SurveyItem::Leg, names[k], ToXmlText(number + by[k])))
        : void();
    }
  }
}

} // namespace helios
